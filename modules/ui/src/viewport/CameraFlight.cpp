// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/CameraFlight.h"

#include <Eigen/Geometry>
#include <QEasingCurve>

#include <cmath>

namespace palpate::ui {

using core::Vec3;

core::ViewPose viewPose(VtkViewport& viewport)
{
    vtkCamera& camera = viewport.view().camera();
    return {Vec3(camera.GetPosition()), Vec3(camera.GetFocalPoint()), Vec3(camera.GetViewUp()), camera.GetViewAngle()};
}

namespace {

/// Rotation by a fraction of the angle from `from` to `to` (unit vectors). Opposite vectors have no unique axis; `up`
/// is used, so that a flight from front to back passes the patient's side.
core::Quaternion partOfTurn(const Vec3& from, const Vec3& to, const Vec3& up, double share)
{
    constexpr double kOpposite_rad = 1e-6; // below this, rounding errors would determine the axis
    Vec3 axis = from.cross(to);
    const double angle_rad = std::atan2(axis.norm(), from.dot(to));
    if (axis.norm() < kOpposite_rad) {
        axis = up - up.dot(from) * from;
    }
    return core::Quaternion(Eigen::AngleAxisd(share * angle_rad, axis.normalized()));
}

} // namespace

core::ViewPose poseBetween(const core::ViewPose& from, const core::ViewPose& to, double share)
{
    const Vec3 back[2] = {from.position_W - from.focus_W, to.position_W - to.focus_W};
    const double length[2] = {back[0].norm(), back[1].norm()};
    if (!(length[0] > 0.0 && length[1] > 0.0)) {
        return share < 1.0 ? from : to;
    }
    const auto part = partOfTurn(back[0] / length[0], back[1] / length[1], from.up_W, share);
    core::ViewPose pose;
    pose.focus_W = from.focus_W + share * (to.focus_W - from.focus_W);
    // Geometric interpolation of the distance: a constant zoom factor per step.
    pose.position_W =
        pose.focus_W + part * (back[0] / length[0]) * (length[0] * std::pow(length[1] / length[0], share));
    const Vec3 up = (1.0 - share) * (part * from.up_W) + share * to.up_W;
    pose.up_W = up.norm() > 1e-6 ? up.normalized() : to.up_W;
    pose.viewAngle_deg = from.viewAngle_deg + share * (to.viewAngle_deg - from.viewAngle_deg);
    return pose;
}

CameraFlight::CameraFlight(VtkViewport& viewport, QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
{
    m_clock.setStartValue(0.0);
    m_clock.setEndValue(1.0);
    m_clock.setDuration(kTime_ms);
    m_clock.setEasingCurve(QEasingCurve::InOutCubic);
    connect(&m_clock, &QVariantAnimation::valueChanged, this,
            [this](const QVariant& share) { show(poseBetween(m_from, m_to, share.toDouble())); });
    connect(&m_clock, &QVariantAnimation::finished, this, [this] { show(m_to); });
}

void CameraFlight::flyTo(const core::ViewPose& to)
{
    m_clock.stop();
    m_from = viewPose(m_viewport);
    m_to = to;
    m_clock.start();
}

void CameraFlight::show(const core::ViewPose& pose)
{
    vtkCamera& camera = m_viewport.view().camera();
    camera.SetPosition(pose.position_W.data());
    camera.SetFocalPoint(pose.focus_W.data());
    camera.SetViewUp(pose.up_W.data());
    camera.SetViewAngle(pose.viewAngle_deg);
    m_viewport.update();
}

} // namespace palpate::ui

#include "palpate/ui/moc_CameraFlight.cpp"
