// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/CameraFlight.h"

#include <Eigen/Geometry>

#include <cmath>

namespace palpate::ui {

using core::Vec3;

core::ViewPose viewPose(VtkViewport& viewport)
{
    vtkCamera& camera = viewport.view().camera();
    return {Vec3(camera.GetPosition()), Vec3(camera.GetFocalPoint()), Vec3(camera.GetViewUp()), camera.GetViewAngle()};
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
            [this](const QVariant& share) { show(between(share.toDouble())); });
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

/// Turns about the focus rather than straight through the anatomy.
core::ViewPose CameraFlight::between(double share) const
{
    const Vec3 back[2] = {m_from.position_W - m_from.focus_W, m_to.position_W - m_to.focus_W};
    const double length[2] = {back[0].norm(), back[1].norm()};
    if (!(length[0] > 0.0 && length[1] > 0.0)) {
        return share < 1.0 ? m_from : m_to;
    }
    const auto turn = Eigen::Quaterniond::FromTwoVectors(back[0], back[1]);
    const auto part = Eigen::Quaterniond::Identity().slerp(share, turn);
    core::ViewPose pose;
    pose.focus_W = m_from.focus_W + share * (m_to.focus_W - m_from.focus_W);
    pose.position_W =
        pose.focus_W + part * (back[0] / length[0]) * (length[0] * std::pow(length[1] / length[0], share));
    const Vec3 up = (1.0 - share) * (part * m_from.up_W) + share * m_to.up_W;
    pose.up_W = up.norm() > 1e-6 ? up.normalized() : m_to.up_W;
    pose.viewAngle_deg = m_from.viewAngle_deg + share * (m_to.viewAngle_deg - m_from.viewAngle_deg);
    return pose;
}

} // namespace palpate::ui

#include "palpate/ui/moc_CameraFlight.cpp"
