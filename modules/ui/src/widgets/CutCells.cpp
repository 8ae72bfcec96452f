// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/CutCells.h"

#include <QEvent>
#include <QHelpEvent>
#include <QModelIndex>
#include <QToolTip>

namespace palpate::ui {

CutCells::CutCells(QAbstractItemView& view)
    : QObject(&view)
    , m_view(view)
{
    setObjectName(QLatin1String(kName));
    view.setTextElideMode(Qt::ElideMiddle);
    view.viewport()->installEventFilter(this);
}

bool CutCells::isCut(const QModelIndex& index) const
{
    return m_view.sizeHintForIndex(index).width() > m_view.visualRect(index).width();
}

bool CutCells::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const QModelIndex index = m_view.indexAt(help->pos());
        const QString text = index.data(Qt::DisplayRole).toString(), tip = index.data(Qt::ToolTipRole).toString();
        if (!text.isEmpty() && !tip.contains(text) && isCut(index)) {
            QToolTip::showText(help->globalPos(), tip.isEmpty() ? text : text + QLatin1Char('\n') + tip,
                               m_view.viewport(), m_view.visualRect(index));
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

} // namespace palpate::ui
