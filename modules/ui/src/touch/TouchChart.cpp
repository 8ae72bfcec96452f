// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/TouchChart.h"

#include "palpate/ui/Theme.h"
#include "palpate/ui/TouchPanel.h"
#include "palpate/ui/Translated.h"

#include <palpate/view/ColourMap.h>

#include <QPainter>
#include <QPainterPath>
#include <QPalette>

#include <algorithm>

namespace palpate::ui {

namespace {

constexpr int kLane_px = 40; // least height of a lane

QString axisText(double value)
{
    return numberText(value, 3);
}

} // namespace

TouchChart::TouchChart(const TouchHistory& history, QWidget* parent)
    : QWidget(parent)
    , AccessibleReadout(this)
    , m_history(history)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Chart of force and depth over the last ten seconds"));
    setToolTip(tr("Force [N] and depth [mm] over the last 10 s"));
}

QString TouchChart::accessibleText() const
{
    if (m_history.samples().empty()) {
        return tr("no contact yet");
    }
    const TouchSample& newest = m_history.samples().back();
    const QString values = tr("now %1 N, %2 mm deep; maximum %3 N, %4 mm")
                               .arg(forceText(newest.force_N), depthText(newest.depth_mm),
                                    forceText(m_history.peakForce_N()), depthText(m_history.peakDepth_mm()));
    return newest.over.isEmpty() ? values : values + QStringLiteral("; ") + newest.over;
}

QSize TouchChart::minimumSizeHint() const
{
    return {180, 2 * kLane_px - (m_isLow ? kLowSaves_px : 0) + 4 * fontMetrics().height()};
}

void TouchChart::setLow(bool isLow)
{
    m_isLow = isLow;
    updateGeometry();
}

void TouchChart::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetricsF metrics(font());
    const double title = metrics.height() + 4.0;
    const double foot = metrics.height() + 2.0;
    const double left = metrics.horizontalAdvance(QStringLiteral("0.05")) + 6.0;
    const double each = std::max(20.0, 0.5 * (height() - 2.0 * title - foot - 6.0));
    const QRectF force(left, title, width() - left - 4.0, each);
    const QRectF depth(left, 2.0 * title + each + 6.0, width() - left - 4.0, each);
    paintLane(painter, force, true);
    paintLane(painter, depth, false);
    painter.setPen(mutedColour());
    const QRectF times(left, depth.bottom() + 1.0, depth.width(), foot);
    painter.drawText(times, Qt::AlignLeft | Qt::AlignVCenter, tr("−10 s"));
    painter.drawText(times, Qt::AlignHCenter | Qt::AlignVCenter, tr("−5 s"));
    painter.drawText(times, Qt::AlignRight | Qt::AlignVCenter, tr("now"));
}

void TouchChart::paintLane(QPainter& painter, const QRectF& lane, bool isForce) const
{
    const QColor colour = isForce ? forceColour() : depthColour();
    const double top =
        axisTop(std::max(isForce ? m_history.peakForce_N() : m_history.peakDepth_mm(), isForce ? 0.5 : 1.0));
    const QFontMetricsF metrics(font());
    painter.fillRect(lane, palette().color(QPalette::Base));
    painter.setPen(QPen(palette().color(QPalette::Midlight), 1.0));
    for (const double share : {0.0, 0.5, 1.0}) {
        const double y = lane.bottom() - share * lane.height();
        painter.drawLine(QPointF(lane.left(), y), QPointF(lane.right(), y));
    }
    painter.setPen(mutedColour());
    const QRectF scale(0.0, lane.top() - 0.5 * metrics.height(), lane.left() - 4.0, metrics.height());
    painter.drawText(scale, Qt::AlignRight | Qt::AlignVCenter, axisText(top));
    painter.drawText(scale.translated(0.0, lane.height()), Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("0"));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QPointF(lane.left(), lane.top() - metrics.descent() - 3.0),
                     isForce ? tr("Force [N]") : tr("Depth [mm]"));
    // Not by colour alone: the lane titles include a sample of the line style, solid for force, dashed for depth.
    QPen pen(colour, 2.0, isForce ? Qt::SolidLine : Qt::DashLine);
    const auto& samples = m_history.samples();
    painter.setPen(pen);
    const double keyY = lane.top() - 0.5 * metrics.height() - 1.0;
    const double keyX = lane.left() + metrics.horizontalAdvance(isForce ? tr("Force [N]") : tr("Depth [mm]")) + 8.0;
    painter.drawLine(QPointF(keyX, keyY), QPointF(keyX + 22.0, keyY));
    if (samples.size() < 2) {
        return;
    }
    const QPainterPath line = curve(lane, top, isForce ? &TouchSample::force_N : &TouchSample::depth_mm);
    painter.save();
    painter.setClipRect(lane.adjusted(-1, -2, 1, 2));
    QPainterPath area = line;
    area.lineTo(lane.right(), lane.bottom());
    area.lineTo(line.elementAt(0).x, lane.bottom());
    if (isForce && m_history.hasLayers()) {
        paintLayers(painter, lane, top);
    } else {
        QColor wash = colour;
        wash.setAlpha(36);
        painter.fillPath(area, wash);
    }
    pen.setStyle(isForce ? Qt::SolidLine : Qt::CustomDashLine);
    if (!isForce) {
        pen.setDashPattern({4.0, 1.5});
    }
    painter.setPen(pen);
    painter.drawPath(line);
    if (isForce && m_history.hasFriction()) {
        painter.setPen(QPen(palette().color(QPalette::Text), 1.5, Qt::DotLine));
        painter.drawPath(curve(lane, top, &TouchSample::along_N));
    }
    painter.restore();
    if (isForce && !samples.back().over.isEmpty()) {
        paintOver(painter, lane);
    }
    if (isForce && m_history.hasFriction()) {
        const QString text = tr("along the surface");
        const QRectF head(lane.left(), lane.top() - metrics.height() - 4.0, lane.width(), metrics.height());
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, text);
        painter.setPen(QPen(palette().color(QPalette::Text), 1.5, Qt::DotLine));
        const double x = lane.right() - metrics.horizontalAdvance(text) - 6.0;
        painter.drawLine(QPointF(x - 18.0, keyY), QPointF(x, keyY));
    }
}

/// Names the lump under the contact in the upper right corner of the force.
void TouchChart::paintOver(QPainter& painter, const QRectF& lane) const
{
    const QFontMetricsF metrics(font());
    const QString text =
        metrics.elidedText(m_history.samples().back().over, Qt::ElideMiddle, std::max(40.0, lane.width() - 8.0));
    const double wide = metrics.horizontalAdvance(text) + 8.0;
    const QRectF ground(lane.right() - wide, lane.top() + 1.0, wide, metrics.height() + 2.0);
    QColor base = palette().color(QPalette::Base);
    base.setAlpha(220); // readable over the stacked forces
    painter.fillRect(ground, base);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(ground, Qt::AlignCenter, text);
}

QPainterPath TouchChart::curve(const QRectF& lane, double top, double TouchSample::*value) const
{
    const auto& samples = m_history.samples();
    const double now = samples.back().time_s;
    QPainterPath line;
    for (const TouchSample& sample : samples) {
        const QPointF p(lane.right() - (now - sample.time_s) / TouchHistory::kLength_s * lane.width(),
                        lane.bottom() - std::min(1.0, sample.*value / top) * lane.height());
        line.elementCount() == 0 ? line.moveTo(p) : line.lineTo(p);
    }
    return line;
}

/// Fills the stacked layer components between successive samples.
void TouchChart::paintLayers(QPainter& painter, const QRectF& lane, double top_N) const
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false); // avoids seams between samples
    const auto& samples = m_history.samples();
    const double now = samples.back().time_s;
    const auto x = [&](const TouchSample& sample) {
        return lane.right() - (now - sample.time_s) / TouchHistory::kLength_s * lane.width();
    };
    const auto y = [&](double force_N) {
        return lane.bottom() - std::clamp(force_N / top_N, 0.0, 1.0) * lane.height();
    };
    const QColor edge(24, 30, 36); // contrasts with the light colours of structures
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const TouchSample& a = samples[i - 1];
        const TouchSample& b = samples[i];
        double below_a = 0.0;
        double below_b = 0.0;
        for (std::size_t k = 0; k < std::max(a.layers.size(), b.layers.size()); ++k) {
            const double top_a = below_a + (k < a.layers.size() ? a.layers[k].force_N : 0.0);
            const double top_b = below_b + (k < b.layers.size() ? b.layers[k].force_N : 0.0);
            const QColor& colour = k < b.layers.size() ? b.layers[k].colour : a.layers[k].colour;
            const QPointF corners[4] = {{x(a), y(below_a)}, {x(a), y(top_a)}, {x(b), y(top_b)}, {x(b), y(below_b)}};
            painter.setPen(Qt::NoPen);
            painter.setBrush(colour);
            painter.drawConvexPolygon(corners, 4);
            if (k > 0) { // hatching, to avoid distinction by colour alone
                painter.setBrush(QBrush(edge, Qt::BDiagPattern));
                painter.drawConvexPolygon(corners, 4);
                painter.setPen(QPen(edge, 1.0));
                painter.drawLine(corners[0], corners[3]);
            }
            below_a = top_a;
            below_b = top_b;
        }
    }
    painter.restore();
}

ForceBar::ForceBar(QWidget* parent)
    : QWidget(parent)
    , AccessibleReadout(this)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFocusPolicy(Qt::TabFocus); // reachable by keyboard, so that a screen reader can read the force
    setAccessibleName(tr("Force in newtons"));
}

QString ForceBar::accessibleText() const
{
    return tr("%1 N of %2 N").arg(forceText(m_force_N), axisText(m_limit_N));
}

void ForceBar::setLimit(double force_N)
{
    m_limit_N = force_N > 0.0 ? force_N : m_limit_N;
    setToolTip(tr("Force of the model [N]; the bar ends at the device's limit of %1 N").arg(axisText(m_limit_N)));
    update();
}

void ForceBar::setForce(double force_N)
{
    if (force_N == m_force_N) {
        return;
    }
    m_force_N = force_N;
    update();
    announceValue();
}

double ForceBar::share() const noexcept
{
    return std::clamp(m_force_N / m_limit_N, 0.0, 1.0);
}

QSize ForceBar::sizeHint() const
{
    constexpr int kBar_px = 12;
    return {220, kBar_px + 4 + fontMetrics().height()};
}

void ForceBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetricsF metrics(font());
    const QRectF bar(0.5, 0.5, width() - 1.0, std::max(6.0, height() - metrics.height() - 4.0));
    painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(bar, 3, 3);
    if (share() > 0.0) {
        const view::Colour c = view::cividis(share());
        QRectF filled = bar.adjusted(1, 1, -1, -1);
        filled.setWidth(std::max(2.0, filled.width() * share()));
        painter.setPen(QPen(palette().color(QPalette::Text), 1.0));
        painter.setBrush(
            QColor::fromRgbF(static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])));
        painter.drawRoundedRect(filled, 2, 2);
    }
    painter.setPen(mutedColour());
    const QRectF text(0.0, bar.bottom() + 2.0, width(), metrics.height());
    painter.drawText(text, Qt::AlignLeft, QStringLiteral("0"));
    painter.drawText(text, Qt::AlignRight, tr("limit %1 N").arg(axisText(m_limit_N)));
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
        painter.drawRoundedRect(bar.adjusted(1, 1, -1, -1), 3, 3);
    }
}

} // namespace palpate::ui

#include "palpate/ui/moc_TouchChart.cpp"
