// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Pieces.h"

#include "palpate/ui/Theme.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>

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
    layout->addWidget(close, 0, Qt::AlignTop);
    hide();
}

void MessageBar::offer(const QString& text, const QString& button, std::function<void()> act)
{
    showError(text);
    m_act = std::move(act);
    m_button->setText(button);
    m_button->show();
}

void MessageBar::showError(const QString& text)
{
    m_button->hide();
    m_text->setText(text);
    m_symbol->setPixmap(icon(Symbol::Warning).pixmap(22, 22));
    show();
}

KeysCard::KeysCard(QWidget* parent)
    : QFrame(parent)
{
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("All keys"));
    const std::initializer_list<std::pair<QString, QString>> keys{
        {tr("P"), tr("palpate or move the camera")},
        {tr("hold Space"), tr("palpate while it is held")},
        {tr("drag"), tr("camera: rotate · palpate: press and slide")},
        {tr("right drag"), tr("camera: zoom · palpate: rotate")},
        {tr("middle drag"), tr("pan")},
        {tr("wheel"), tr("camera: zoom · palpate: depth in mm (with Ctrl: zoom)")},
        {tr("Esc"), tr("let go, then back to the camera")},
        {tr("1  3  7"), tr("from the front, the left, the head (with Ctrl: the opposite)")},
        {tr("0"), tr("from the front, left and above")},
        {tr("F"), tr("fit everything into the view")},
        {tr("double-click"), tr("centre the view on the point")},
        {tr("C"), tr("clutch: move the device without the hand in the scene")},
        {tr("W  O  L"), tr("fit to the device: all, the organ or the lump that is touched or pointed at")},
        {tr("R"), tr("record, stop recording")},
        {tr("M  N"), tr("mark a finding, write a note into the recording")},
        {tr("I"), tr("what the session says: forces, coverage, findings")},
        {tr("K"), tr("play, pause")},
        {tr("Home"), tr("to the start of the recording")},
        {tr("S"), tr("save a picture of the view")},
        {tr("Tab"), tr("in the view: hide or show the panels")},
        {tr("V  H"), tr("in the list: show or hide, feel or not")},
        {tr("Ctrl+↓  ↑"), tr("in the list: felt a layer deeper, farther out")},
        {tr("Ctrl+O"), tr("open files; or drop them on the window")},
        {tr("Ctrl+S"), tr("save the scene; with Shift: to another file")},
        {tr("Ctrl+Z"), tr("undo; with Shift: redo")},
        {tr("?"), tr("this card")},
    };
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(26, 20, 26, 20);
    grid->setHorizontalSpacing(22);
    grid->setVerticalSpacing(6);
    auto* title = new QLabel(tr("All keys"), this);
    QFont large = font();
    large.setPointSizeF(font().pointSizeF() * 1.4);
    large.setBold(true);
    title->setFont(large);
    grid->addWidget(title, 0, 0, 1, 2);
    QFont bold = font();
    bold.setBold(true);
    int row = 1;
    for (const auto& [key, does] : keys) {
        auto* name = new QLabel(key, this);
        name->setFont(bold);
        grid->addWidget(name, row, 0);
        grid->addWidget(new QLabel(does, this), row++, 1);
    }
    hide();
}

void KeysCard::toggle()
{
    if (isVisible()) {
        hide();
        return;
    }
    m_before = window()->focusWidget();
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
