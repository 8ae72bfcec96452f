// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Pieces.h"

#include "palpate/ui/ActionList.h"
#include "palpate/ui/Theme.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace palpate::ui {

Chip::Chip(const QString& accessibleName, QWidget* parent)
    : QLabel(parent)
{
    setAccessibleName(accessibleName);
    setContentsMargins(9, 3, 9, 3);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    hide(); // until it has something to say
}

void Chip::say(const QString& text, Tone tone)
{
    const QColor ink = tone == Tone::Quiet     ? palette().color(QPalette::Text)
                       : tone == Tone::Warning ? warningColour()
                                               : recordColour();
    if (text == this->text() && tone == m_tone) {
        return;
    }
    m_tone = tone;
    QPalette colours = palette();
    colours.setColor(QPalette::WindowText, ink);
    setPalette(colours);
    setText(text);
    setVisible(!text.isEmpty());
}

void Chip::paintEvent(QPaintEvent* event)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(
        QPen(m_tone == Tone::Quiet ? palette().color(QPalette::Mid) : palette().color(QPalette::WindowText), 1.0));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(frame, 0.5 * frame.height(), 0.5 * frame.height());
    painter.end();
    QLabel::paintEvent(event);
}

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent)
    , m_symbol(new QLabel(this))
    , m_text(new QLabel(this))
{
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    m_symbol->setPixmap(icon(Symbol::Warning).pixmap(22, 22));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_text->setAccessibleName(tr("Message"));
    m_button = new QPushButton(this);
    m_button->hide();
    connect(m_button, &QPushButton::clicked, this, [this] {
        hide();
        m_act();
    });
    m_otherButton = new QPushButton(this);
    m_otherButton->hide();
    connect(m_otherButton, &QPushButton::clicked, this, [this] {
        hide();
        m_otherAct();
    });
    auto* close = new QToolButton(this);
    close->setText(QStringLiteral("✕"));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close this message"));
    close->setAccessibleName(tr("Close this message"));
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 6, 6, 6);
    layout->addWidget(m_symbol, 0, Qt::AlignTop);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_button, 0, Qt::AlignTop);
    layout->addWidget(m_otherButton, 0, Qt::AlignTop);
    layout->addWidget(close, 0, Qt::AlignTop);
    hide();
}

void MessageBar::offer(const QString& text, const QString& button, std::function<void()> act, Symbol symbol)
{
    showError(text);
    m_symbol->setPixmap(icon(symbol).pixmap(22, 22));
    m_act = std::move(act);
    m_button->setText(button);
    m_button->show();
}

void MessageBar::ask(const QString& text, const QString& button, std::function<void()> act, const QString& otherButton,
                     std::function<void()> otherAct)
{
    offer(text, button, std::move(act), Symbol::Open);
    m_otherAct = std::move(otherAct);
    m_otherButton->setText(otherButton);
    m_otherButton->show();
}

void MessageBar::showError(const QString& text)
{
    m_button->hide();
    m_otherButton->hide();
    m_text->setText(text);
    m_symbol->setPixmap(icon(Symbol::Warning).pixmap(22, 22));
    show();
}

KeysCard::KeysCard(const ActionList& actions, QWidget* parent)
    : QFrame(parent)
    , m_actions(actions)
{
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("All keys"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(26, 20, 26, 20);
    auto* title = new QLabel(tr("All keys"), this);
    QFont large = font();
    large.setPointSizeF(font().pointSizeF() * 1.4);
    large.setBold(true);
    title->setFont(large);
    layout->addWidget(title);
    hide();
}

void KeysCard::fill()
{
    delete m_table;
    m_table = new QWidget(this);
    layout()->addWidget(m_table);
    auto* grid = new QGridLayout(m_table);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(18);
    grid->setVerticalSpacing(5);
    QFont bold = font();
    bold.setBold(true);
    const std::vector<ActionList::KeyLine> lines = m_actions.keyLines();
    const int half = static_cast<int>(lines.size() + 1) / 2;
    for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
        const ActionList::KeyLine& line = lines[static_cast<std::size_t>(i)];
        auto* keys = new QLabel(line.keys, m_table);
        keys->setFont(bold);
        const int column = i < half ? 0 : 2;
        grid->addWidget(keys, i % half, column, Qt::AlignTop);
        auto* does =
            new QLabel(line.group == ActionGroup::InList ? tr("in the list: %1").arg(line.does) : line.does, m_table);
        does->setWordWrap(true);
        does->setMinimumWidth(300);
        grid->addWidget(does, i % half, column + 1, Qt::AlignTop);
    }
}

void KeysCard::toggle()
{
    if (isVisible()) {
        hide();
        return;
    }
    m_before = window()->focusWidget();
    fill();
    adjustSize();
    move((parentWidget()->width() - width()) / 2, (parentWidget()->height() - height()) / 2);
    show();
    raise();
    setFocus();
}

void KeysCard::hideEvent(QHideEvent*)
{
    if (m_before != nullptr && (hasFocus() || window()->focusWidget() == this)) {
        m_before->setFocus();
    }
}

void KeysCard::mousePressEvent(QMouseEvent*)
{
    hide();
}

void KeysCard::keyPressEvent(QKeyEvent*)
{
    hide();
}

void KeysCard::focusOutEvent(QFocusEvent*)
{
    hide();
}

} // namespace palpate::ui
