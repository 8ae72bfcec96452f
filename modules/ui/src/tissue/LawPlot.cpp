// SPDX-License-Identifier: BSD-3-Clause
#include "tissue/LawPlot.h"

#include "palpate/ui/Theme.h"
#include "palpate/ui/TouchHistory.h"
#include "palpate/ui/TouchPanel.h"
#include "palpate/ui/Translated.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace palpate::ui {

namespace {

constexpr double kGrab_px = 10.0;

QString plotText(double value)
{
    return numberText(value, 3);
}

} // namespace

LawPlot::LawPlot(QWidget* parent)
    : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Force in newtons over depth in millimetres"));
}

void LawPlot::show(const core::Tissue& tissue, double greatest_N_per_mm)
{
    m_tissue = tissue;
    m_greatest = greatest_N_per_mm;
    m_held.reset();
    takeLaw(tissue.law);
    fitAxes();
    const bool hasPoints = tissue.law.kind == core::LawKind::Points;
    setFocusPolicy(hasPoints ? Qt::StrongFocus : Qt::NoFocus);
    setMouseTracking(hasPoints);
    setToolTip(hasPoints ? tr("Force [N] over depth [mm]. Drag a point, or select one with ← → and move with ↑ ↓")
                         : tr("Force [N] over depth [mm]"));
}

void LawPlot::takeLaw(const core::ForceLaw& law)
{
    m_tissue.law = law;
    m_table = haptics::ForceTable::build(m_tissue);
    m_felt =
        std::isfinite(m_greatest) && m_greatest > 0.0 ? haptics::ForceTable::bounded(m_table, m_greatest) : m_table;
    m_chosen = std::clamp<std::size_t>(m_chosen, 1, std::max<std::size_t>(law.points.size(), 2) - 1);
    update();
}

/// Fits the axes to the usual range of penetration depths, or to the extent of the law.
void LawPlot::fitAxes()
{
    constexpr double kPress_mm = 12.0;
    const core::ForceLaw& law = m_tissue.law;
    m_reach_mm = kPress_mm;
    if (law.kind == core::LawKind::Points && law.points.size() > 1) {
        m_reach_mm = 1.1 * law.points.back()[0];
    } else if (law.kind == core::LawKind::Click && m_table != nullptr) {
        m_reach_mm = 1.6 * m_table->knots().back().depth_mm;
    }
    m_top_N = 0.0;
    for (int i = 0; i <= 100; ++i) {
        m_top_N = std::max(m_top_N, forceAt(0.01 * i * m_reach_mm));
    }
    m_top_N = axisTop(std::max(0.1, m_top_N));
}

void LawPlot::setTouch(double depth_mm, double scale)
{
    if (depth_mm != m_depth_mm || scale != m_scale) {
        m_depth_mm = depth_mm;
        m_scale = scale;
        update();
    }
}

QSize LawPlot::sizeHint() const
{
    constexpr int kCurve_px = 100;
    return {220, kCurve_px + 2 * fontMetrics().height()};
}

double LawPlot::forceAt(double depth_mm) const
{
    return m_table == nullptr ? m_tissue.stiffness_N_per_mm * depth_mm : m_table->force(depth_mm);
}

QString LawPlot::limitText() const
{
    return tr("– – device %1 N/mm").arg(plotText(m_greatest));
}

/// True when the device limit needs a line of its own because the space next to the axis title is too small.
bool LawPlot::isLimitAbove() const
{
    const QFontMetricsF metrics(font());
    const double beside = metrics.horizontalAdvance(QStringLiteral("0.05") + tr("Force [N]") + QStringLiteral("  "));
    return std::isfinite(m_greatest) && beside + metrics.horizontalAdvance(limitText()) + 8.0 > width();
}

QRectF LawPlot::area() const
{
    const QFontMetricsF metrics(font());
    const double left = metrics.horizontalAdvance(QStringLiteral("0.05")) + 6.0;
    const double head = (isLimitAbove() ? 2.0 : 1.0) * metrics.height() + 4.0;
    return {left, head, width() - left - 8.0, height() - head - metrics.height() - 3.0};
}

QPointF LawPlot::placeOf(double depth_mm, double force_N) const
{
    const QRectF in = area();
    return {in.left() + depth_mm / m_reach_mm * in.width(), in.bottom() - force_N / m_top_N * in.height()};
}

QPointF LawPlot::touchedPlace() const
{
    const double force_N = m_scale * (m_felt == nullptr ? forceAt(m_depth_mm) : m_felt->force(m_depth_mm));
    return placeOf(std::min(m_depth_mm, m_reach_mm), std::min(force_N, m_top_N));
}

QString LawPlot::touchText() const
{
    constexpr double kSeen = 0.01; // smallest difference from 1 that is shown
    if (m_depth_mm <= 0.0) {
        return {};
    }
    return std::abs(m_scale - 1.0) < kSeen ? tr("now %1 mm").arg(depthText(m_depth_mm))
                                           : tr("now %1 mm, here × %2").arg(depthText(m_depth_mm), plotText(m_scale));
}

QPolygonF LawPlot::curve(const haptics::ForceTable* table) const
{
    QPolygonF line;
    const auto add = [&](double d) {
        line << placeOf(d, table == nullptr ? m_tissue.stiffness_N_per_mm * d : table->force(d));
    };
    constexpr int kPieces = 240;
    std::size_t knot = 0; // inserts the knots, so that corners stay sharp
    for (int i = 0; i <= kPieces; ++i) {
        const double d = m_reach_mm * i / kPieces;
        for (; table != nullptr && knot < table->knots().size() && table->knots()[knot].depth_mm < d; ++knot) {
            add(table->knots()[knot].depth_mm);
        }
        add(d);
    }
    return line;
}

void LawPlot::paintFrame(QPainter& painter) const
{
    const QRectF in = area();
    const QFontMetricsF metrics(font());
    painter.fillRect(in, palette().color(QPalette::Base));
    painter.setPen(QPen(palette().color(QPalette::Midlight), 1.0));
    for (const double share : {0.0, 0.5, 1.0}) {
        painter.drawLine(placeOf(0.0, share * m_top_N), placeOf(m_reach_mm, share * m_top_N));
        painter.drawLine(placeOf(share * m_reach_mm, 0.0), placeOf(share * m_reach_mm, m_top_N));
    }
    painter.setPen(mutedColour());
    const QRectF scale(0.0, in.top() - 0.5 * metrics.height(), in.left() - 4.0, metrics.height());
    painter.drawText(scale, Qt::AlignRight | Qt::AlignVCenter, plotText(m_top_N));
    painter.drawText(scale.translated(0.0, in.height()), Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("0"));
    const QRectF foot(in.left(), in.bottom() + 2.0, in.width() + 6.0, metrics.height());
    const QString end = tr("%1 mm deep").arg(plotText(m_reach_mm)), now = touchText();
    // In a narrow plot the live contact replaces the axis label.
    if (metrics.horizontalAdvance(now + QStringLiteral("  ") + end) < foot.width()) {
        painter.drawText(foot, Qt::AlignRight, end);
    }
    painter.setPen(palette().color(QPalette::Text));
    const double over = std::max(0.0, metrics.horizontalAdvance(now) - foot.width());
    painter.drawText(foot.adjusted(-over, 0.0, 0.0, 0.0), Qt::AlignLeft, now);
    painter.drawText(QPointF(in.left(), in.top() - metrics.descent() - 3.0), tr("Force [N]"));
}

void LawPlot::paintLimit(QPainter& painter) const
{
    if (!std::isfinite(m_greatest)) {
        return;
    }
    const QRectF in = area();
    painter.setPen(QPen(mutedColour(), 1.5, Qt::DashLine));
    painter.save();
    painter.setClipRect(in);
    painter.drawLine(placeOf(0.0, 0.0), placeOf(m_reach_mm, m_greatest * m_reach_mm));
    painter.restore();
    painter.setPen(mutedColour());
    const QFontMetricsF metrics(font());
    painter.drawText(QRectF(0.0, 0.0, in.right() + 6.0, metrics.height() + 2.0), Qt::AlignRight | Qt::AlignVCenter,
                     limitText());
}

void LawPlot::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintFrame(painter);
    paintLimit(painter);
    painter.setClipRect(area().adjusted(-4, -4, 4, 4));
    if (m_felt != m_table) { // requested law; the limited law is drawn on top
        painter.setPen(QPen(forceColour(), 1.5, Qt::DotLine));
        painter.drawPolyline(curve(m_table.get()));
    }
    painter.setPen(QPen(forceColour(), 2.0));
    painter.drawPolyline(curve(m_felt.get()));
    painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
    for (std::size_t i = 0; i < m_tissue.law.points.size(); ++i) {
        const QPointF place = placeOf(m_tissue.law.points[i][0], m_tissue.law.points[i][1]);
        const bool isChosen = m_held == i || (hasFocus() && i == m_chosen);
        painter.setBrush(isChosen ? palette().color(QPalette::Highlight) : palette().color(QPalette::Base));
        painter.drawRect(QRectF(place - QPointF(3.5, 3.5), QSizeF(7.0, 7.0)));
    }
    if (m_depth_mm > 0.0) {
        const QPointF dot = touchedPlace();
        painter.setClipping(false);
        painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
        painter.setBrush(palette().color(QPalette::Text));
        painter.drawEllipse(dot, 5.5, 5.5);
    }
}

void LawPlot::mousePressEvent(QMouseEvent* event)
{
    double nearest_px = kGrab_px;
    for (std::size_t i = 1; i < m_tissue.law.points.size(); ++i) { // the first point is fixed at (0, 0)
        const QPointF away = placeOf(m_tissue.law.points[i][0], m_tissue.law.points[i][1]) - event->position();
        const double distance_px = std::hypot(away.x(), away.y());
        if (distance_px < nearest_px) {
            nearest_px = distance_px;
            m_held = m_chosen = i;
        }
    }
    update();
}

void LawPlot::mouseMoveEvent(QMouseEvent* event)
{
    if (m_held) {
        const QRectF in = area();
        movePoint((event->position().x() - in.left()) / in.width() * m_reach_mm,
                  (in.bottom() - event->position().y()) / in.height() * m_top_N);
    }
}

void LawPlot::mouseReleaseEvent(QMouseEvent*)
{
    if (m_held) {
        m_held.reset();
        Q_EMIT moved(m_tissue.law);
    }
}

void LawPlot::keyPressEvent(QKeyEvent* event)
{
    const std::vector<core::ForceLaw::Point>& points = m_tissue.law.points;
    const int key = event->key();
    if (points.size() < 2 ||
        (key != Qt::Key_Left && key != Qt::Key_Right && key != Qt::Key_Up && key != Qt::Key_Down)) {
        QWidget::keyPressEvent(event);
    } else if (key == Qt::Key_Left || key == Qt::Key_Right) {
        m_chosen =
            key == Qt::Key_Right ? std::min(m_chosen + 1, points.size() - 1) : std::max<std::size_t>(m_chosen - 1, 1);
        update();
    } else {
        m_held = m_chosen;
        const auto [depth_mm, force_N] = points[m_chosen];
        movePoint(depth_mm, force_N + (key == Qt::Key_Up ? 0.02 : -0.02) * m_top_N);
        m_held.reset();
        Q_EMIT moved(m_tissue.law);
    }
}

/// Moves the held point between its neighbours, as long as the points form a valid law.
void LawPlot::movePoint(double depth_mm, double force_N)
{
    core::ForceLaw law = m_tissue.law;
    const double step_mm = std::max(2.0 * core::ForceLaw::kMinPointSpacing_mm, 0.005 * m_reach_mm);
    const double low = law.points[*m_held - 1][0] + step_mm;
    const double high = *m_held + 1 < law.points.size() ? law.points[*m_held + 1][0] - step_mm : m_reach_mm;
    law.points[*m_held] = {std::max(low, std::min(depth_mm, high)), std::clamp(force_N, 0.0, m_top_N)};
    if (core::check(law).isOk()) {
        takeLaw(law);
    }
}

} // namespace palpate::ui

#include "moc_LawPlot.cpp"
