// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/SessionPanel.h"

#include "palpate/ui/Theme.h"
#include "palpate/ui/TouchHistory.h"
#include "palpate/ui/TouchPanel.h"
#include "palpate/ui/Translated.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace palpate::ui {

namespace {

constexpr double kLiveBin_s = 0.05;
constexpr double kStep_s = 0.1; // step of an arrow key

/// Tick interval of the time axis in seconds, wide enough for the labels.
double axisStep(double duration_s, double width_px)
{
    const double room = duration_s * 70.0 / std::max(1.0, width_px);
    for (const double step : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0}) {
        if (step >= room) {
            return step;
        }
    }
    return 1800.0;
}

} // namespace

ForceTimeline::ForceTimeline(QWidget* parent)
    : QWidget(parent)
    , AccessibleReadout(this)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Force timeline of the recording"));
    setToolTip(tr("Force [N] during the recording. Click or drag to seek; ← and → step by 0.1 s, Home and End jump to "
                  "the ends."));
}

QSize ForceTimeline::minimumSizeHint() const
{
    constexpr int kLane_px = 64; // a force of a tenth of the largest one is visible
    constexpr int kLaneOfTwo_px = 32;
    return {100, (m_leastAxis_s > 0.0 ? kLaneOfTwo_px : kLane_px) + (m_hasTimes ? fontMetrics().height() : 0)};
}

void ForceTimeline::setPeaks(std::vector<float> peaks_N, double duration_s)
{
    m_peaks_N = std::move(peaks_N);
    m_greatest_N = m_peaks_N.empty() ? 0.0f : *std::max_element(m_peaks_N.begin(), m_peaks_N.end());
    m_duration_s = duration_s;
    m_isLive = false;
    update();
}

void ForceTimeline::setMarks(std::vector<std::pair<double, QString>> marks)
{
    m_marks = std::move(marks);
    update();
}

void ForceTimeline::setPosition(double position_s)
{
    if (position_s != m_position_s) {
        m_position_s = position_s;
        update();
        announceValue();
    }
}

void ForceTimeline::setLeastAxes(double duration_s, double force_N)
{
    m_leastAxis_s = duration_s;
    m_leastAxis_N = force_N;
    updateGeometry();
    update();
}

void ForceTimeline::setTimeShown(bool isShown)
{
    m_hasTimes = isShown;
    updateGeometry();
    update();
}

QString ForceTimeline::accessibleText() const
{
    if (m_duration_s <= 0.0) {
        return tr("no recording");
    }
    const auto bins = static_cast<double>(m_peaks_N.size());
    const QLocale locale;
    const QString time =
        tr("%1 of %2 s").arg(locale.toString(m_position_s, 'f', 1), locale.toString(m_duration_s, 'f', 1));
    if (m_peaks_N.empty()) { // overview not yet read
        return time;
    }
    const double bin = std::clamp(m_position_s / m_duration_s * bins, 0.0, bins - 1.0);
    return tr("%1, %2 N").arg(time, forceText(m_peaks_N[static_cast<std::size_t>(bin)]));
}

std::optional<AccessibleReadout::Scale> ForceTimeline::accessibleScale() const
{
    return Scale{m_position_s, 0.0, m_duration_s, kStep_s};
}

void ForceTimeline::setAccessibleValue(double value)
{
    if (m_duration_s > 0.0 && !m_isLive) {
        Q_EMIT seekWanted(std::clamp(value, 0.0, m_duration_s));
    }
}

void ForceTimeline::addLive(double time_s, double force_N)
{
    if (!m_isLive) {
        clear();
        m_isLive = true;
        m_drawnTenths = -1;
    }
    const auto bin = static_cast<std::size_t>(std::max(0.0, time_s) / kLiveBin_s);
    if (bin >= m_peaks_N.size()) {
        // A slow frame skips bins. Fill them with the current force; a gap would look like a loss of contact.
        m_peaks_N.resize(bin + 1, static_cast<float>(force_N));
    }
    m_peaks_N[bin] = std::max(m_peaks_N[bin], static_cast<float>(force_N));
    m_greatest_N = std::max(m_greatest_N, static_cast<float>(force_N));
    m_duration_s = static_cast<double>(m_peaks_N.size()) * kLiveBin_s;
    m_position_s = m_duration_s;
    // Every update composes the whole window again, pictures of the scene included. The clocks beside change with the
    // same tenth, so that all need one composition.
    if (const long long tenths = std::llround(time_s * 10.0); tenths != m_drawnTenths) {
        m_drawnTenths = tenths;
        update();
        announceValue();
    }
}

void ForceTimeline::clear()
{
    m_peaks_N.clear();
    m_greatest_N = 0.0f;
    m_marks.clear();
    m_duration_s = 0.0;
    m_position_s = 0.0;
    m_isLive = false;
    update();
}

/// Place of the bars, right of the force axis and above the time axis.
QRectF ForceTimeline::lane() const
{
    const QFontMetricsF metrics(font());
    constexpr double kGap_px = 6.0;
    const double axis = m_duration_s > 0.0 ? metrics.horizontalAdvance(topText()) + kGap_px : 0.0;
    return {axis, 0.0, std::max(10.0, width() - axis),
            std::max(10.0, height() - (m_hasTimes ? metrics.height() + 2.0 : 0.0))};
}

/// Force at the top of the axis. [N]
double ForceTimeline::top_N() const
{
    return axisTop(std::max({0.5, static_cast<double>(m_greatest_N), m_leastAxis_N}));
}

/// Time at the right end of the axis. [s]
double ForceTimeline::axis_s() const
{
    return std::max(m_duration_s, m_leastAxis_s);
}

QString ForceTimeline::topText() const
{
    return tr("%1 N").arg(numberText(top_N(), 3));
}

double ForceTimeline::timeAt(double x) const
{
    const QRectF bars = lane();
    return std::clamp((x - bars.left()) / bars.width() * axis_s(), 0.0, m_duration_s);
}

double ForceTimeline::placeOf(double time_s) const
{
    const QRectF bars = lane();
    return bars.left() + time_s / axis_s() * bars.width();
}

/// Shows the label of a mark in the tool tip, or the help text elsewhere.
bool ForceTimeline::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip && m_duration_s > 0.0) {
        constexpr double kNear_px = 5.0;
        const auto* help = static_cast<QHelpEvent*>(event);
        QStringList near;
        for (const auto& [time_s, text] : m_marks) {
            if (std::abs(placeOf(time_s) - help->pos().x()) <= kNear_px) {
                near << tr("%1 s: %2").arg(QLocale().toString(time_s, 'f', 1), text);
            }
        }
        if (!near.isEmpty()) {
            QToolTip::showText(help->globalPos(), near.join(QLatin1Char('\n')), this);
            return true;
        }
    }
    return QWidget::event(event);
}

void ForceTimeline::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QRectF bars = lane();
    painter.fillRect(bars, palette().color(QPalette::Base));
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(bars.adjusted(0, 0, -1, -1));
    if (m_duration_s <= 0.0) {
        painter.setPen(mutedColour());
        painter.drawText(bars, Qt::AlignCenter, tr("The force of a recording appears here"));
        return;
    }
    paintBars(painter, bars);
    paintAxes(painter, bars);
    painter.setPen(QPen(depthColour(), 1.5));
    for (const auto& mark : m_marks) {
        const double x = placeOf(mark.first);
        painter.drawLine(QPointF(x, bars.top() + 1.0), QPointF(x, bars.top() + 9.0));
    }
    const double head = std::clamp(placeOf(m_position_s), bars.left() + 1.0, bars.right() - 2.0);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Text), 2.0));
    painter.drawLine(QPointF(head, bars.top()), QPointF(head, bars.bottom()));
    painter.setBrush(palette().color(QPalette::Text));
    painter.drawPolygon(QPolygonF({{head - 5.0, bars.top()}, {head + 5.0, bars.top()}, {head, bars.top() + 7.0}}));
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
        painter.drawRect(bars.adjusted(1, 1, -2, -2));
    }
}

/// Paints one column per pixel with the maximum of its interval, so that short peaks remain visible at any width.
void ForceTimeline::paintBars(QPainter& painter, const QRectF& bars) const
{
    const double top = top_N();
    const auto bins = static_cast<double>(m_peaks_N.size());
    const int columns = static_cast<int>(placeOf(m_duration_s) - bars.left());
    const double head = placeOf(m_position_s);
    QColor done = forceColour();
    QColor coming = done;
    coming.setAlpha(110);
    for (int x = 0; x < columns && bins > 0.0; ++x) {
        const auto first = static_cast<std::size_t>(bins * x / columns);
        const auto last = std::max(first + 1, static_cast<std::size_t>(bins * (x + 1) / columns));
        float peak = 0.0f;
        for (std::size_t i = first; i < std::min(last, m_peaks_N.size()); ++i) {
            peak = std::max(peak, m_peaks_N[i]);
        }
        if (peak > 0.0f) {
            const double high = std::max(1.0, peak / top * (bars.height() - 4.0));
            const double left = bars.left() + x;
            painter.fillRect(QRectF(left, bars.bottom() - 1.0 - high, 1.0, high), left <= head ? done : coming);
        }
    }
}

void ForceTimeline::paintAxes(QPainter& painter, const QRectF& bars) const
{
    const QFontMetricsF metrics(font());
    painter.setPen(mutedColour());
    const double step = axisStep(axis_s(), bars.width());
    for (double t = 0.0; t <= axis_s(); t += step) {
        const double x = placeOf(t);
        painter.drawLine(QPointF(x, bars.bottom() - 4.0), QPointF(x, bars.bottom()));
        if (!m_hasTimes) {
            continue;
        }
        const QString text = step < 1.0 ? QLocale().toString(t, 'f', 1) : QLocale().toString(t, 'f', 0);
        const double wide = metrics.horizontalAdvance(text + tr(" s"));
        painter.drawText(
            QPointF(std::clamp(x - 0.5 * wide, 0.0, std::max(0.0, width() - wide)), height() - metrics.descent()),
            text + tr(" s"));
    }
    const QRectF axis(0.0, bars.top(), bars.left() - 4.0, bars.height());
    painter.drawText(axis, Qt::AlignRight | Qt::AlignTop, topText());
    painter.drawText(axis, Qt::AlignRight | Qt::AlignBottom, QStringLiteral("0"));
}

void ForceTimeline::mousePressEvent(QMouseEvent* event)
{
    mouseMoveEvent(event);
}

void ForceTimeline::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons().testFlag(Qt::LeftButton) && m_duration_s > 0.0 && !m_isLive) {
        Q_EMIT seekWanted(timeAt(event->position().x()));
    }
}

void ForceTimeline::keyPressEvent(QKeyEvent* event)
{
    const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? 1.0 : kStep_s;
    switch (event->key()) {
    case Qt::Key_Left:
        Q_EMIT seekWanted(m_position_s - step);
        break;
    case Qt::Key_Right:
        Q_EMIT seekWanted(m_position_s + step);
        break;
    case Qt::Key_Home:
        Q_EMIT seekWanted(0.0);
        break;
    case Qt::Key_End:
        Q_EMIT seekWanted(m_duration_s);
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace palpate::ui
