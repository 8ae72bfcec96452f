// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/PuckReader.h"

#include <palpate/core/Clock.h>

#include <vtkCamera.h>

#include <algorithm>
#include <utility>

namespace palpate::ui {

namespace {

constexpr int kStep_ms = 16;
constexpr double kUsualDistance_mm = 250.0; // camera distance for a motion scale of 1
constexpr double kFull_mm_per_s = 60.0;     // 6-axis mouse at full deflection
constexpr int kRecentring = 8;              // maximum steps for recentring; longer means the device is lost
constexpr double kRests = 0.02;             // fraction of full speed, above the rounding of positions within a step

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
    Eigen::Matrix3d axes; // axes of the hand in world coordinates
    axes << right, away, up;

    const double gain = camera.GetDistance() / kUsualDistance_mm;
    const core::Vec3 shift = axes * (to.p_D - from.p_D) * gain;
    const Eigen::Matrix3d turn = axes * (to.q_D * from.q_D.conjugate()).toRotationMatrix() * axes.transpose();
    // The anatomy is fixed: the camera performs the inverse motion.
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

double pushOf(const device::DeviceState& from, const device::DeviceState& to, double passed_s) noexcept
{
    if (!from.isPresent || !to.isPresent || !(passed_s > 0.0)) {
        return 0.0;
    }
    const double share = (from.p_D.z() - to.p_D.z()) / passed_s / kFull_mm_per_s;
    return share > kRests ? std::min(1.0, share) : 0.0;
}

PuckReader::PuckReader(QObject* parent)
    : QObject(parent)
{
    m_timer.setInterval(kStep_ms);
    connect(&m_timer, &QTimer::timeout, this, &PuckReader::step);
}

PuckReader::~PuckReader()
{
    (void)use(nullptr);
}

core::Status PuckReader::use(std::unique_ptr<device::HapticDevice> device)
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
    m_last_ns = core::monotonicNow_ns();
    m_last = m_device->read(m_last_ns);
    m_timer.start();
    return {};
}

void PuckReader::step()
{
    const std::int64_t now_ns = core::monotonicNow_ns();
    const device::DeviceState state = m_device->read(now_ns);
    const device::DeviceState last = std::exchange(m_last, state);
    const double passed_s = static_cast<double>(now_ns - std::exchange(m_last_ns, now_ns)) * 1e-9;
    if (m_recentring > 0) { // the jump to the origin is not a motion of the hand
        const bool isBack = state.isPresent && state.p_D.norm() < 0.25 * m_device->info().workspaceRadius_mm;
        m_recentring = isBack ? 0 : m_recentring - 1;
    } else {
        Q_EMIT moved(last, state, passed_s);
    }
    if (m_recentring == 0 && state.p_D.norm() > 0.5 * m_device->info().workspaceRadius_mm) {
        (void)m_device->calibrate(); // a rate-controlled device moves without end, but its workspace is limited
        m_recentring = kRecentring;
    }
}

} // namespace palpate::ui

#include "palpate/ui/moc_PuckReader.cpp"
