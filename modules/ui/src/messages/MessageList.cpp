// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/MessageList.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QKeyEvent>
#include <QModelIndexList>
#include <QShowEvent>
#include <QTimer>

#include <algorithm>

namespace palpate::ui {

MessageList::MessageList(Messages& messages, QWidget* parent)
    : QListView(parent)
{
    setModel(&messages);
    setAccessibleName(tr("Messages"));
    setFrameShape(QFrame::NoFrame);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setWordWrap(true);
    setAlternatingRowColors(true);
    setMinimumHeight(3 * fontMetrics().height());
    setContextMenuPolicy(Qt::ActionsContextMenu);
    auto* copy = new QAction(tr("Copy (Ctrl+C)"), this);
    connect(copy, &QAction::triggered, this, &MessageList::copySelection);
    addAction(copy);
    connect(&messages, &QAbstractItemModel::rowsInserted, this, &MessageList::scrollLater);
}

/// Scrolls to the end once, after the last of a burst of messages and when the list is visible. Scrolling lays out
/// every row, and opening files can add hundreds of messages at once.
void MessageList::scrollLater()
{
    if (!isVisible() || m_isScrollPending) {
        return;
    }
    m_isScrollPending = true;
    QTimer::singleShot(0, this, [this] {
        m_isScrollPending = false;
        scrollToBottom();
    });
}

void MessageList::showEvent(QShowEvent* event)
{
    QListView::showEvent(event);
    scrollLater();
}

void MessageList::copySelection() const
{
    QModelIndexList chosen = selectionModel()->selectedIndexes();
    std::sort(chosen.begin(), chosen.end());
    QStringList lines;
    for (const QModelIndex& index : chosen) {
        lines << index.data(Qt::DisplayRole).toString();
    }
    QApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

void MessageList::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Copy)) {
        copySelection();
    } else {
        QListView::keyPressEvent(event);
    }
}

} // namespace palpate::ui

#include "palpate/ui/moc_MessageList.cpp"
