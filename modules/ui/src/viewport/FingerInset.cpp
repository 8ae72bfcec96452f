// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/FingerInset.h"

#include "palpate/ui/VtkViewport.h"

#include <palpate/view/ScaleBar.h>
#include <palpate/view/TextStyle.h>

#include <QColor>
#include <QEvent>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace palpate::ui {

using core::Vec3;

namespace {

constexpr int kMargin_px = 8; // from the edges of the view
constexpr QSize kSize_px(240, 190);
constexpr int kPause_ms = 50;
constexpr double kAbove = 0.35;            // share of the height above the surface
constexpr double kHalfWidth_mm = 25.0;     // an organ's surroundings of a fingertip
constexpr double kHalfWidthOfScene = 0.25; // of the diagonal, in small scenes
constexpr double kTurn = 0.3;              // share of the way to the newest normal, against flicker from facet to facet
constexpr double kRim = 0.45;              // brightness of the outline of a filled area

QColor colourOf(const view::Colour& colour, double brightness)
{
    const auto part = [brightness](double one) { return static_cast<float>(std::clamp(brightness * one, 0.0, 1.0)); };
    return QColor::fromRgbF(part(colour[0]), part(colour[1]), part(colour[2]));
}

} // namespace

FingerInset::FingerInset(VtkViewport& viewport)
    : QWidget(&viewport)
    , m_viewport(viewport)
{
    setObjectName(QStringLiteral("fingerInset"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAccessibleName(tr("Section along the finger"));
    resize(kSize_px);
    hide();
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause_ms);
    connect(&m_pause, &QTimer::timeout, this, &FingerInset::follow);
    connect(&viewport, &QOpenGLWidget::frameSwapped, this, &FingerInset::follow);
    viewport.installEventFilter(this);
}

/// Takes the state of the cursor if it has changed.
void FingerInset::follow()
{
    const view::TouchState& now = m_viewport.view().cursor().state();
    const bool isSame = now.p_WH == m_touch.p_WH && now.p_WG == m_touch.p_WG && now.n_W == m_touch.n_W &&
                        now.isInContact == m_touch.isInContact && now.isPresent == m_touch.isPresent;
    if (isVisible() && !m_pause.isActive()) {
        if (isInTheWay(geometry())) { // of a legend that has appeared, or of the hand
            const QPoint before = pos();
            place();
            if (pos() != before) {
                m_viewport.update(); // places the labels again
            }
        }
        if (!isSame) {
            take();
            m_pause.start();
        }
    }
}

void FingerInset::take()
{
    view::SceneView& view = m_viewport.view();
    const bool wasInContact = m_touch.isInContact;
    m_touch = view.cursor().state();
    if (m_touch.isPresent && m_touch.isInContact && !m_touch.n_W.isZero()) {
        const Vec3 n_W = wasInContact ? Vec3(m_plane.v_W + kTurn * (m_touch.n_W - m_plane.v_W)) : m_touch.n_W;
        const Vec3 up_W = n_W.isZero() ? m_touch.n_W : n_W.normalized();
        const Vec3 forward_W(view.camera().GetDirectionOfProjection()), cameraUp_W(view.camera().GetViewUp());
        const auto across = [&](const Vec3& d_W) { return Vec3(d_W - up_W.dot(d_W) * up_W); };
        constexpr double kAlong = 0.1; // sine of an angle to the normal that is too small for a direction
        Vec3 right_W = across(forward_W.cross(cameraUp_W).normalized());
        if (right_W.norm() < kAlong) {
            right_W = across(cameraUp_W.normalized());
        }
        m_plane.p_W = m_touch.onSurface_W();
        m_plane.u_W = right_W.normalized();
        m_plane.v_W = up_W;
        m_plane.n_W = m_plane.u_W.cross(m_plane.v_W);
        m_cuts = view.cutsAt(m_plane);
    } else if (!m_touch.isPresent) {
        m_cuts.clear();
    }
    update();
}

double FingerInset::halfWidth_mm() const
{
    const core::Box box = m_viewport.view().bounds();
    const double scene_mm = box.isEmpty() ? kHalfWidth_mm : kHalfWidthOfScene * box.diagonal().norm();
    return std::min(scene_mm, std::max(kHalfWidth_mm, 2.0 * m_touch.fingertip_mm));
}

void FingerInset::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    const double scale = 0.5 * width() / halfWidth_mm();
    const auto place = [&](const Eigen::Vector2d& q) {
        return QPointF(0.5 * width() + scale * q.x(), kAbove * height() - scale * q.y());
    };
    const auto areaOf = [&](const geometry::SectionStrip& strip) {
        return QPolygonF({place({strip.leftLow, strip.low}), place({strip.rightLow, strip.low}),
                          place({strip.rightHigh, strip.high}), place({strip.leftHigh, strip.high})});
    };
    for (const view::SectionCut& cut : m_cuts) {
        painter.setRenderHint(QPainter::Antialiasing, false); // no seams between strips
        painter.setPen(Qt::NoPen);
        painter.setBrush(colourOf(cut.colour, 1.0));
        for (const geometry::SectionStrip& strip : cut.strips) {
            painter.drawPolygon(areaOf(strip));
        }
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colourOf(cut.colour, cut.strips.empty() ? 1.0 : kRim), 1.5));
        for (const geometry::SectionContour& contour : cut.contours) {
            QPolygonF line;
            for (const Eigen::Vector2d& q : contour.points) {
                line << place(q);
            }
            contour.isClosed ? painter.drawPolygon(line) : painter.drawPolyline(line);
        }
    }
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor ink = palette().color(QPalette::Text), back = palette().color(QPalette::Base);
    if (m_touch.isPresent && !m_cuts.empty()) {
        const QPointF hand = place(m_plane.inPlane(m_touch.p_WH)),
                      onSurface = place(m_plane.inPlane(m_touch.onSurface_W()));
        const double radius = std::max(3.0, scale * m_touch.fingertip_mm);
        for (const auto& [colour, width] : {std::pair(back, 4.0), std::pair(ink, 2.0)}) { // a halo on any colour
            painter.setPen(QPen(colour, width));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(hand, radius, radius);
            if (m_touch.isInContact) {
                painter.drawLine(hand, onSurface);
                painter.setBrush(colour);
                painter.drawEllipse(onSurface, 2.0, 2.0);
            }
        }
    }
    painter.setPen(ink);
    const double bar_mm = view::roundScaleLength(0.5 * halfWidth_mm());
    const std::string barText = view::shortText(bar_mm, 6, QLocale().decimalPoint().toStdString());
    const QFontMetrics metrics = painter.fontMetrics();
    const double y = height() - kMargin_px;
    painter.fillRect(QRectF(kMargin_px, y - 3.0, scale * bar_mm, 3.0), ink);
    const auto write = [&](const QPointF& at, const QString& text) { // readable on any colour
        QPainterPath path;
        path.addText(at, font(), text);
        painter.strokePath(path, QPen(back, 3.0));
        painter.fillPath(path, ink);
    };
    write({static_cast<double>(kMargin_px), y - 6.0}, tr("%1 mm").arg(QString::fromStdString(barText)));
    write({static_cast<double>(kMargin_px), static_cast<double>(metrics.ascent() + 4)},
          m_cuts.empty() ? tr("Along the finger: touch a structure") : tr("Along the finger"));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

void FingerInset::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    place();
    take();
}

void FingerInset::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_viewport.view().setCovered({});
    m_viewport.update();
}

bool FingerInset::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize && isVisible()) {
        place();
    }
    return QWidget::eventFilter(watched, event);
}

/// Box of a place for the view, whose labels avoid the picture.
Eigen::AlignedBox2d FingerInset::boxOf(const QRect& place) const
{
    const Eigen::Vector2d half(0.5 * m_viewport.width(), 0.5 * m_viewport.height());
    return {Eigen::Vector2d(place.left(), m_viewport.height() - place.bottom() - 1) - half,
            Eigen::Vector2d(place.right() + 1, m_viewport.height() - place.top()) - half};
}

/// Returns true if a place hides the hand, the legend or another widget of the view.
bool FingerInset::isInTheWay(const QRect& place) const
{
    constexpr int kAboutHand_px = 30;
    view::SceneView& view = m_viewport.view();
    const Eigen::AlignedBox2d box = boxOf(place), legend = view.legend().box();
    if (!legend.isEmpty() && box.intersects(legend)) {
        return true;
    }
    const auto isHidden = [&](const Vec3& p_W) {
        return place.adjusted(-kAboutHand_px, -kAboutHand_px, kAboutHand_px, kAboutHand_px)
            .contains(m_viewport.placeOf(p_W).toPoint());
    };
    const view::TouchState& touch = view.cursor().state();
    if (touch.isPresent && (isHidden(touch.p_WG) || isHidden(touch.p_WH))) {
        return true;
    }
    const auto others = m_viewport.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly);
    return std::any_of(others.begin(), others.end(), [&](const QWidget* one) {
        return one != this && one->isVisible() && !one->testAttribute(Qt::WA_TransparentForMouseEvents) &&
               one->geometry().intersects(place);
    });
}

/// Moves the picture to the corner where it hides the least, if it is in the way where it is.
void FingerInset::place()
{
    view::SceneView& view = m_viewport.view();
    const double ratio = m_viewport.devicePixelRatioF();
    const int above = m_viewport.coveredAbove_px() + kMargin_px;
    const int right = m_viewport.width() - width() - kMargin_px;
    // The lower corners have the orientation cube and the scale bar.
    const int aboveCube = m_viewport.height() - height() - kMargin_px - qRound(view.cube().top_px());
    const int aboveScale = m_viewport.height() - height() - kMargin_px - qRound(view.scaleBar().top() / ratio);
    QRect best;
    std::size_t least = 0;
    bool isBestFree = false;
    for (const QPoint& corner :
         {QPoint(kMargin_px, aboveCube), QPoint(kMargin_px, above), QPoint(right, above), QPoint(right, aboveScale)}) {
        const QRect place(corner, size());
        const bool isFree = !isInTheWay(place);
        const std::size_t hidden = view.tissueIn(boxOf(place), ratio);
        if (best.isNull() || (isFree && !isBestFree) || (isFree == isBestFree && hidden < least)) {
            best = place;
            least = hidden;
            isBestFree = isFree;
        }
    }
    move(best.topLeft());
    view.setCovered(boxOf(geometry()));
}

} // namespace palpate::ui

#include "palpate/ui/moc_FingerInset.cpp"
