// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Tour.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

namespace palpate::ui {

namespace {

constexpr int kGap_px = 8; // between callout, part and window edges

/// Frame that ignores the pointer.
class PartFrame final : public QWidget
{
  public:
    explicit PartFrame(QWidget* parent)
        : QWidget(parent)
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        hide();
    }

  protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 4.0));
        painter.drawRect(rect().adjusted(2, 2, -2, -2));
    }
};

/// Central part of a rectangle, scaled by `share`.
QRect middleOf(const QRect& all, double share)
{
    QRect middle(QPoint(), all.size() * share);
    middle.moveCenter(all.center());
    return middle;
}

} // namespace

Tour::Tour(QWidget* window)
    : QFrame(window)
    , m_title(new QLabel(this))
    , m_text(new QLabel(this))
    , m_next(new QPushButton(this))
    , m_back(new QPushButton(tr("Back"), this))
    , m_frame(new PartFrame(window))
{
    setObjectName(QStringLiteral("tour"));
    setFrameShape(QFrame::Box);
    setLineWidth(2);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setWordWrap(true);
    m_text->setWordWrap(true);
    auto* close = new QPushButton(tr("End (Esc)"), this);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(6);
    for (QPushButton* one : {close, m_back, m_next}) {
        one->setAutoDefault(true); // enter presses the focused button
        buttons->addWidget(one);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 10, 12, 10);
    layout->setSpacing(8);
    layout->addWidget(m_title);
    layout->addWidget(m_text);
    layout->addStretch(1);
    layout->addLayout(buttons);
    connect(close, &QPushButton::clicked, this, &Tour::end);
    connect(m_back, &QPushButton::clicked, this, [this] { go(m_at - 1); });
    connect(m_next, &QPushButton::clicked, this, [this] { go(m_at + 1); });
    window->installEventFilter(this);
    hide();
}

void Tour::start(std::vector<Stop> stops)
{
    if (!isVisible()) {
        m_before = window()->focusWidget();
    }
    m_stops = std::move(stops);
    for (const Stop& stop : m_stops) { // parts are also resized when panels change
        if (stop.part != nullptr) {
            stop.part->installEventFilter(this);
        }
    }
    go(0);
}

bool Tour::end()
{
    if (isHidden()) {
        return false;
    }
    const bool hadKeys = isAncestorOf(window()->focusWidget());
    hide();
    m_frame->hide();
    for (const Stop& stop : m_stops) {
        if (stop.part != nullptr) {
            stop.part->removeEventFilter(this);
        }
    }
    if (hadKeys && m_before != nullptr) {
        m_before->setFocus();
    }
    Q_EMIT ended();
    return true;
}

void Tour::go(int stop)
{
    if (stop >= static_cast<int>(m_stops.size())) {
        end();
        return;
    }
    m_at = std::max(0, stop);
    const Stop& now = m_stops[static_cast<std::size_t>(m_at)];
    Q_EMIT coming(now.part);
    m_title->setText(tr("%1 of %2: %3").arg(m_at + 1).arg(m_stops.size()).arg(now.title));
    m_text->setText(now.text);
    setAccessibleName(m_title->text());
    setAccessibleDescription(now.text);
    m_back->setEnabled(m_at > 0);
    m_next->setText(m_at + 1 == static_cast<int>(m_stops.size()) ? tr("Done") : tr("Next"));
    m_next->setAccessibleDescription(QStringLiteral("%1. %2").arg(m_title->text(), now.text));
    place();
    show();
    m_next->setFocus(Qt::OtherFocusReason);
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

/// Places the callout beside the part and the frame around it. For a part that fills the window, only its centre is
/// highlighted.
void Tour::place()
{
    const QWidget& all = *parentWidget();
    const QWidget* part = m_stops[static_cast<std::size_t>(m_at)].part;
    if (part == nullptr || !part->isVisible()) {
        m_frame->hide();
        m_target = {};
        const QSize size = sizeHint().boundedTo(all.size());
        setGeometry(QRect(all.rect().center() - QPoint(size.width(), size.height()) / 2, size));
        return;
    }
    const QRect whole = QRect(part->mapTo(&all, QPoint()), part->size()).intersected(all.rect());
    m_target = whole;
    for (const double share : {1.0, 0.75, 0.5, 0.25, 0.1}) {
        m_target = middleOf(whole, share);
        if (isPlacedBeside(m_target)) {
            break;
        }
    }
    constexpr int kAround_px = 4; // width of the frame, drawn outside the part
    m_frame->setGeometry(m_target.adjusted(-kAround_px, -kAround_px, kAround_px, kAround_px) & all.rect());
    m_frame->show();
    m_frame->raise();
    raise();
}

/// Places the callout next to the target. Returns false when no side has enough space.
bool Tour::isPlacedBeside(const QRect& target)
{
    const QRect all = parentWidget()->rect().adjusted(kGap_px, kGap_px, -kGap_px, -kGap_px);
    const std::array sides{
        QRect(QPoint(target.right() + 1 + kGap_px, all.top()), all.bottomRight()),
        QRect(all.topLeft(), QPoint(target.left() - 1 - kGap_px, all.bottom())),
        QRect(all.topLeft(), QPoint(all.right(), target.top() - 1 - kGap_px)),
        QRect(QPoint(all.left(), target.bottom() + 1 + kGap_px), all.bottomRight()),
    };
    const int wanted_px = 44 * fontMetrics().averageCharWidth();
    const int least_px = layout()->totalMinimumSize().width();
    for (const QRect& side : sides) {
        const int width_px = std::min(std::max(wanted_px, least_px), side.width());
        const int height_px = width_px < least_px ? 0
                                                  : std::max(layout()->totalHeightForWidth(width_px),
                                                             layout()->totalMinimumSize().height());
        if (width_px >= least_px && height_px <= side.height()) {
            QRect at(QPoint(), QSize(width_px, height_px));
            at.moveCenter(target.center());
            at.moveLeft(std::clamp(at.left(), side.left(), side.right() + 1 - width_px));
            at.moveTop(std::clamp(at.top(), side.top(), side.bottom() + 1 - height_px));
            setGeometry(at);
            return true;
        }
    }
    return false;
}

void Tour::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::FontChange && isVisible()) {
        place();
    }
    QFrame::changeEvent(event);
}

bool Tour::eventFilter(QObject* watched, QEvent* event)
{
    const bool isMoved = event->type() == QEvent::Resize || event->type() == QEvent::Move ||
                         event->type() == QEvent::Show || event->type() == QEvent::Hide;
    if (isMoved && isVisible()) {
        // After the window has laid out its parts.
        QTimer::singleShot(0, this, [this] {
            if (isVisible()) {
                place();
            }
        });
    }
    return QFrame::eventFilter(watched, event);
}

} // namespace palpate::ui

#include "palpate/ui/moc_Tour.cpp"
