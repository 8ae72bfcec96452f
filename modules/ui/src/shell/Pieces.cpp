// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Pieces.h"

#include "palpate/ui/ActionList.h"
#include "palpate/ui/Theme.h"

#include <QAbstractSlider>
#include <QApplication>
#include <QGridLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace palpate::ui {

namespace {

constexpr int kSide_px = 9; // horizontal padding of the text
constexpr int kDot_px = 8;

bool isQuiet(Chip::Tone tone)
{
    return tone == Chip::Tone::Quiet || tone == Chip::Tone::Good;
}

} // namespace

Chip::Chip(const QString& what, QWidget* parent)
    : QLabel(parent)
{
    setAccessibleDescription(what); // the accessible name is the text itself
    setTextFormat(Qt::PlainText);
    setContentsMargins(kSide_px, 3, kSide_px, 3);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    hide(); // until a text is set
}

void Chip::say(const QString& text, Tone tone, const QString& shortForm)
{
    if (text == m_said && tone == m_tone) {
        return;
    }
    m_shortForm = shortForm;
    m_tone = tone;
    m_said = text;
    setContentsMargins(kSide_px + (tone == Tone::Good ? kDot_px + 5 : 0), 3, kSide_px, 3);
    takeInk();
    setAccessibleName(m_said);
    setText(m_isShort ? shortText() : m_said);
    setVisible(!text.isEmpty());
    Q_EMIT changed();
}

QString Chip::shortText() const
{
    if (m_tone == Tone::Good) {
        return {};
    }
    return m_shortForm.isEmpty() ? m_said.section(QStringLiteral(", "), 0, 0) : m_shortForm;
}

void Chip::setShort(bool isShort)
{
    if (isShort != m_isShort) {
        m_isShort = isShort;
        setText(m_isShort ? shortText() : m_said);
    }
}

int Chip::widthFor(bool isShort) const
{
    const QMargins margins = contentsMargins();
    return fontMetrics().horizontalAdvance(isShort ? shortText() : m_said) + margins.left() + margins.right() + 2;
}

void Chip::takeInk()
{
    const QPalette base = QApplication::palette();
    QPalette colours = base;
    colours.setColor(QPalette::WindowText, isQuiet(m_tone)           ? base.color(QPalette::Text)
                                           : m_tone == Tone::Warning ? warningColour()
                                                                     : recordColour());
    if (colours != palette()) {
        setPalette(colours);
    }
}

void Chip::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::ApplicationPaletteChange || event->type() == QEvent::StyleChange) {
        takeInk();
    }
    QLabel::changeEvent(event);
}

void Chip::paintEvent(QPaintEvent* event)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(QPen(isQuiet(m_tone) ? palette().color(QPalette::Mid) : palette().color(QPalette::WindowText), 1.0));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(frame, 0.5 * frame.height(), 0.5 * frame.height());
    if (m_tone == Tone::Good) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(goodColour());
        painter.drawEllipse(QRectF(kSide_px, 0.5 * (height() - kDot_px), kDot_px, kDot_px));
    }
    painter.end();
    QLabel::paintEvent(event);
}

void Chip::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && rect().contains(event->pos())) {
        Q_EMIT clicked();
    }
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
    keepFont(*title, 1.4, QFont::Bold);
    layout->addWidget(title);
    m_scroll = new QScrollArea(this);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setFocusPolicy(Qt::NoFocus); // the card handles the keys
    m_scroll->setWidgetResizable(true);
    m_scroll->viewport()->setBackgroundRole(QPalette::Base);
    layout->addWidget(m_scroll);
    hide();
}

void KeysCard::fill()
{
    auto* table = new QWidget;
    table->setBackgroundRole(QPalette::Base);
    auto* grid = new QGridLayout(table);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(18);
    grid->setVerticalSpacing(5);
    QFont bold = font();
    bold.setBold(true);
    const std::vector<ActionList::KeyLine> lines = m_actions.keyLines();
    const bool isWide = parentWidget()->width() > 64 * fontMetrics().averageCharWidth() * 2;
    const int half = static_cast<int>(isWide ? lines.size() + 1 : 2 * lines.size()) / 2;
    for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
        const ActionList::KeyLine& line = lines[static_cast<std::size_t>(i)];
        auto* keys = new QLabel(line.keys, table);
        keys->setFont(bold);
        const int column = i < half ? 0 : 2;
        grid->addWidget(keys, i % half, column, Qt::AlignTop);
        auto* does =
            new QLabel(line.group == ActionGroup::InList ? tr("in the list: %1").arg(line.does) : line.does, table);
        does->setWordWrap(true);
        does->setMinimumWidth(std::min(300, parentWidget()->width() / 3));
        grid->addWidget(does, i % half, column + 1, Qt::AlignTop);
    }
    m_scroll->setWidget(table); // deletes the previous table
}

void KeysCard::toggle()
{
    if (isVisible()) {
        hide();
        return;
    }
    m_before = window()->focusWidget();
    fill();
    const QSize table = m_scroll->widget()->sizeHint() + QSize(m_scroll->verticalScrollBar()->sizeHint().width(), 2);
    const QSize whole = table + sizeHint() - m_scroll->sizeHint();
    resize(whole.boundedTo(parentWidget()->size() - QSize(24, 24)));
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

void KeysCard::keyPressEvent(QKeyEvent* event)
{
    QScrollBar& bar = *m_scroll->verticalScrollBar();
    switch (event->key()) {
    case Qt::Key_Up:
        bar.triggerAction(QAbstractSlider::SliderSingleStepSub);
        break;
    case Qt::Key_Down:
        bar.triggerAction(QAbstractSlider::SliderSingleStepAdd);
        break;
    case Qt::Key_PageUp:
        bar.triggerAction(QAbstractSlider::SliderPageStepSub);
        break;
    case Qt::Key_PageDown:
        bar.triggerAction(QAbstractSlider::SliderPageStepAdd);
        break;
    default:
        hide();
    }
}

void KeysCard::focusOutEvent(QFocusEvent*)
{
    hide();
}

} // namespace palpate::ui

#include "palpate/ui/moc_Pieces.cpp"
