// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/PuckCamera.h"

#include <palpate/core/Clock.h>

#include <vtkCamera.h>

namespace palpate::ui {

namespace {

constexpr int kStep_ms = 16;
constexpr double kUsualDistance_mm = 250.0; // at which a millimetre of the hand is one of the anatomy

core::Vec3 vec(const double* v)
{
    return {v[0], v[1], v[2]};
}

} // namespace

void moveWithHand(vtkCamera& camera, const device::DeviceState& from, const device::DeviceState& to)
{
    const core::Vec3 focus = vec(camera.GetFocalPoint());
    const core::Vec3 position = vec(camera.GetPosition());
    const core::Vec3 away = (focus - position).normalized();
    const core::Vec3 right = away.cross(vec(camera.GetViewUp())).normalized();
    const core::Vec3 up = right.cross(away);
    Eigen::Matrix3d axes; // of the hand, in world coordinates
    axes << right, away, up;

    const double gain = camera.GetDistance() / kUsualDistance_mm;
    const core::Vec3 shift = axes * (to.p_D - from.p_D) * gain;
    const Eigen::Matrix3d turn = axes * (to.q_D * from.q_D.conjugate()).toRotationMatrix() * axes.transpose();
    // The anatomy stands still: the camera makes the opposite move.
    const Eigen::Matrix3d back = turn.transpose();
    const core::Vec3 movedFocus = focus - axes.col(0) * shift.dot(axes.col(0)) - axes.col(2) * shift.dot(axes.col(2));
    core::Vec3 arm = position - focus;
    const double least = 0.05 * arm.norm();
    arm *= std::max(arm.norm() + shift.dot(away), least) / arm.norm();
    const core::Vec3 movedPosition = movedFocus + back * arm;
    const core::Vec3 movedUp = back * up;
    camera.SetFocalPoint(movedFocus.x(), movedFocus.y(), movedFocus.z());
    camera.SetPosition(movedPosition.x(), movedPosition.y(), movedPosition.z());
    camera.SetViewUp(movedUp.x(), movedUp.y(), movedUp.z());
}

PuckCamera::PuckCamera(VtkViewport& viewport, QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
{
    m_timer.setInterval(kStep_ms);
    connect(&m_timer, &QTimer::timeout, this, &PuckCamera::step);
}

PuckCamera::~PuckCamera()
{
    (void)use(nullptr);
}

core::Status PuckCamera::use(std::unique_ptr<device::HapticDevice> device)
{
    if (m_device != nullptr) {
        m_timer.stop();
        m_device->stop();
        m_device.reset();
    }
    if (device == nullptr) {
        return {};
    }
    if (core::Status started = device->start(); !started.isOk()) {
        return started;
    }
    m_device = std::move(device);
    m_last = m_device->read(core::monotonicNow_ns());
    m_timer.start();
    return {};
}

void PuckCamera::step()
{
    const device::DeviceState state = m_device->read(core::monotonicNow_ns());
    // A hand that was put back to its origin has not moved there: the view stays.
    const bool isSameHand = state.isPresent && m_last.isPresent;
    if (isSameHand && (state.p_D != m_last.p_D || state.q_D.coeffs() != m_last.q_D.coeffs())) {
        moveWithHand(m_viewport.view().camera(), m_last, state);
        m_viewport.update();
    }
    m_last = state;
    if (state.p_D.norm() > 0.5 * m_device->info().workspaceRadius_mm) {
        (void)m_device->calibrate(); // the view can go on for ever, the hand's reach ends
    }
}

} // namespace palpate::ui
