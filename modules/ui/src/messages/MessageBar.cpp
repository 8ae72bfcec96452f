// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/MessageBar.h"

#include "palpate/ui/Theme.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace palpate::ui {

namespace {

/// First lines of a long text; the message list shows the full text.
QString shortened(const QString& text)
{
    constexpr int kLines = 3;
    const QStringList lines = text.split(QLatin1Char('\n'));
    return lines.size() <= kLines ? text
                                  : lines.mid(0, kLines).join(QLatin1Char('\n')) +
                                        MessageBar::tr(" … and %1 more lines (F4)").arg(lines.size() - kLines);
}

} // namespace

MessageRow::MessageRow(Messages::Kind kind, const QString& text, const QStringList& buttons, QWidget* parent)
    : QFrame(parent)
    , m_kind(kind)
    , m_text(text)
    , m_symbol(new QLabel(this))
    , m_line(new QLabel(shortened(text), this))
{
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    setAccessibleName(QStringLiteral("%1: %2").arg(Messages::word(kind), text));
    m_symbol->setAccessibleName(Messages::word(kind));
    m_symbol->setToolTip(Messages::word(kind));
    drawIcon();
    m_line->setWordWrap(true);
    m_line->setMinimumWidth(80);
    m_line->setTextFormat(Qt::PlainText);
    m_line->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 5, 6, 5);
    layout->addWidget(m_symbol, 0, Qt::AlignTop);
    layout->addWidget(m_line, 1, Qt::AlignVCenter);
    for (int i = 0; i < buttons.size(); ++i) {
        auto* act = new QPushButton(buttons[i], this);
        connect(act, &QPushButton::clicked, this, [this, i] { Q_EMIT answered(i); });
        layout->addWidget(act, 0, Qt::AlignTop);
    }
    auto* close = new QToolButton(this);
    close->setText(QStringLiteral("✕"));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close this message; still listed under Messages (F4)"));
    close->setAccessibleName(tr("Close this message"));
    connect(close, &QToolButton::clicked, this, &MessageRow::closed);
    layout->addWidget(close, 0, Qt::AlignTop);
}

/// Cuts the text off where it would cover too much of a small view; the tool tip and the list of messages have it all.
void MessageRow::fit()
{
    constexpr int kMostShare = 5, kLeastLines = 2; // of the height of the view
    const QString whole = shortened(m_text);
    const int width = m_line->width(), line = m_line->fontMetrics().lineSpacing();
    const int most = std::max(kLeastLines * line, window()->height() / (2 * kMostShare));
    const auto heightOf = [&](const QString& text) {
        return m_line->fontMetrics().boundingRect(QRect(0, 0, width, 0), Qt::TextWordWrap, text).height();
    };
    QString shown = whole;
    for (qsizetype end = whole.size(); width > 0 && end > 0 && heightOf(shown) > most;) {
        end = whole.lastIndexOf(QLatin1Char(' '), end - 1);
        shown = end > 0 ? whole.left(end) + QStringLiteral(" …") : shown;
    }
    if (shown != m_line->text()) {
        m_line->setText(shown);
        m_line->setAccessibleName(shown == whole ? QString() : m_text);
        m_line->setToolTip(shown == whole ? QString() : m_text);
    }
}

void MessageRow::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    fit();
}

void MessageRow::drawIcon()
{
    const int side_px = withText_px(22);
    m_symbol->setPixmap(Messages::iconOf(m_kind).pixmap(side_px, side_px));
}

void MessageRow::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        drawIcon(); // uses the palette's text colour
        fit();
    }
    QFrame::changeEvent(event);
}

MessageBar::MessageBar(Messages& messages, QWidget* parent)
    : QWidget(parent)
    , m_messages(messages)
    , m_rows(new QVBoxLayout(this))
    , m_more(new QPushButton(this))
{
    m_rows->setContentsMargins(0, 0, 0, 0);
    m_rows->setSpacing(0);
    m_rows->addWidget(m_more);
    m_more->setFlat(true);
    m_more->setAutoFillBackground(true); // the view behind may be as dark as the text
    m_more->setToolTip(tr("Show the list of messages (F4)"));
    connect(m_more, &QPushButton::clicked, this, &MessageBar::listWanted);
    hide();
}

void MessageBar::showError(const QString& text)
{
    put(Messages::Kind::Error, text, {}, Keep::WithScene);
}

void MessageBar::offer(const QString& text, const QString& button, std::function<void()> act, Keep keep)
{
    MessageRow* row = put(Messages::Kind::Offer, text, {button}, keep);
    connect(row, &MessageRow::answered, this, [this, row, act = std::move(act)] {
        remove(row); // before acting, which may add further messages
        act();
    });
}

void MessageBar::ask(const QString& text, const QString& button, std::function<void()> act, const QString& otherButton,
                     std::function<void()> otherAct)
{
    MessageRow* row = put(Messages::Kind::Offer, text, {button, otherButton}, Keep::WithScene);
    connect(row, &MessageRow::answered, this,
            [this, row, act = std::move(act), otherAct = std::move(otherAct)](int chosen) {
                remove(row);
                (chosen == 0 ? act : otherAct)();
            });
}

void MessageBar::withdraw(const QString& text)
{
    const auto same =
        std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& entry) { return entry.row->text() == text; });
    if (same != m_entries.end()) {
        remove(same->row);
    }
}

void MessageBar::withdrawIf(const std::function<bool(const QString& text)>& matches)
{
    const std::vector<Entry> before = m_entries;
    for (const Entry& entry : before) {
        if (matches(entry.row->text())) {
            remove(entry.row);
        }
    }
}

MessageRow* MessageBar::put(Messages::Kind kind, const QString& text, const QStringList& buttons, Keep keep)
{
    withdraw(text); // a repeated message is replaced, since its buttons may have changed
    m_messages.add(kind, text);
    auto* row = new MessageRow(kind, text, buttons, this);
    connect(row, &MessageRow::closed, this, [this, row] { remove(row); });
    m_entries.insert(m_entries.begin(), {row, keep});
    m_rows->insertWidget(0, row);
    arrange();
    QAccessibleEvent alert(row, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
    return row;
}

void MessageBar::remove(MessageRow* row)
{
    m_entries.erase(
        std::remove_if(m_entries.begin(), m_entries.end(), [row](const Entry& entry) { return entry.row == row; }),
        m_entries.end());
    m_rows->removeWidget(row);
    row->hide();
    row->setParent(nullptr);
    row->deleteLater(); // a button of the row may be the sender of the current signal
    arrange();
}

void MessageBar::arrange()
{
    const auto waiting = static_cast<int>(m_entries.size()) - kShown;
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        m_entries[i].row->setVisible(i < static_cast<std::size_t>(kShown));
    }
    m_more->setText(waiting == 1 ? tr("1 older message (F4 shows all)")
                                 : tr("%1 older messages (F4 shows all)").arg(waiting));
    m_more->setVisible(waiting > 0);
    setVisible(!m_entries.empty());
}

void MessageBar::forgetScene()
{
    const std::vector<Entry> before = m_entries;
    for (const Entry& entry : before) {
        if (entry.keep == Keep::WithScene) {
            remove(entry.row);
        }
    }
}

QString MessageBar::text() const
{
    QStringList texts;
    for (const Entry& entry : m_entries) {
        texts << entry.row->text();
    }
    return texts.join(QLatin1Char('\n'));
}

} // namespace palpate::ui

#include "palpate/ui/moc_MessageBar.cpp"
