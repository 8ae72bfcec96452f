// SPDX-License-Identifier: BSD-3-Clause
#include "OpenDevice.h"

#include "Models.h"

#include <cmath>
#include <utility>

namespace palpate::forcedimension {

namespace {

// 9 ms in units of 125 us: with one late exchange, the motors are off within 10 ms of the host's silence.
constexpr unsigned char kWatchdog = 72;
constexpr double kFarthest_mm = 1000.0; // no device of the maker reaches half of it
constexpr double kFrameTolerance = 1e-2;

} // namespace

DeviceIdentity identify(const Dhd& dhd, char id)
{
    DeviceIdentity identity;
    identity.id = id;
    identity.type = dhd.getSystemType(id);
    unsigned short serial = 0;
    identity.serial = dhd.getSerialNumber(&serial, id) >= 0 ? serial : 0;
    const char* const name = dhd.getSystemName(id);
    identity.name = name != nullptr && name[0] != '\0' ? name : std::string(modelOf(identity.type).name);
    identity.hasWrist = dhd.hasWrist(id);
    identity.hasGripper = dhd.hasGripper(id);
    return identity;
}

OpenDevice::OpenDevice(std::shared_ptr<const Dhd> dhd, DeviceIdentity identity)
    : m_dhd(std::move(dhd))
    , m_identity(std::move(identity))
{
}

OpenDevice::~OpenDevice()
{
    letGo();
    m_dhd->close(m_identity.id);
}

void OpenDevice::letGo() noexcept
{
    if (!std::exchange(m_isLetGo, true)) {
        (void)push(core::Vec3::Zero());
        m_dhd->stop(m_identity.id);
    }
}

double OpenDevice::reportedForce_N() const noexcept
{
    return m_dhd->getMaxForce != nullptr ? m_dhd->getMaxForce(m_identity.id) : 0.0;
}

void OpenDevice::enableForces(double maxForce_N) noexcept
{
    const char id = m_identity.id;
    if (m_dhd->setMaxForce != nullptr) {
        m_dhd->setMaxForce(maxForce_N, id);
    }
    if (m_identity.hasGripper && m_dhd->emulateButton != nullptr) {
        m_dhd->emulateButton(1, id);
    }
    m_dhd->setGravityCompensation(1, id);
    (void)push(core::Vec3::Zero());
    m_dhd->enableForce(1, id);
    (void)push(core::Vec3::Zero());
}

bool OpenDevice::setWatchdog() noexcept
{
    // The velocity threshold, which expert mode would also change, stays: above it the device brakes itself.
    return m_dhd->enableExpertMode != nullptr && m_dhd->setWatchdog != nullptr && m_dhd->enableExpertMode() >= 0 &&
           m_dhd->setWatchdog(kWatchdog, m_identity.id) >= 0;
}

OpenDevice::Reading OpenDevice::sense(core::Vec3& p_mm, core::Quaternion& q) noexcept
{
    core::Vec3 p_m = core::Vec3::Zero();
    double frame[3][3]{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const int result = m_identity.hasWrist
                           ? m_dhd->getPositionAndOrientationFrame(&p_m.x(), &p_m.y(), &p_m.z(), frame, m_identity.id)
                           : m_dhd->getPosition(&p_m.x(), &p_m.y(), &p_m.z(), m_identity.id);
    if (result < 0) {
        return Reading::Failed;
    }
    if (result == Dhd::kTimeGuard) {
        return Reading::Same;
    }
    p_m *= 1000.0;
    if (!p_m.allFinite() || p_m.cwiseAbs().maxCoeff() > kFarthest_mm) {
        return Reading::Implausible;
    }
    p_mm = p_m;
    if (m_identity.hasWrist) {
        const Eigen::Matrix3d R{{frame[0][0], frame[0][1], frame[0][2]},
                                {frame[1][0], frame[1][1], frame[1][2]},
                                {frame[2][0], frame[2][1], frame[2][2]}};
        // Of an invalid frame the last valid orientation stays; only the force has to be right.
        if (R.allFinite() &&
            (R * R.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < kFrameTolerance &&
            R.determinant() > 0.0) {
            q = core::Quaternion(R).normalized();
        }
    }
    return Reading::New;
}

bool OpenDevice::push(const core::Vec3& f_N) noexcept
{
    const bool hasMore = m_identity.hasWrist || m_identity.hasGripper;
    return (hasMore
                ? m_dhd->setForceAndTorqueAndGripperForce(f_N.x(), f_N.y(), f_N.z(), 0.0, 0.0, 0.0, 0.0, m_identity.id)
                : m_dhd->setForce(f_N.x(), f_N.y(), f_N.z(), m_identity.id)) >= 0;
}

std::uint32_t OpenDevice::buttons() noexcept
{
    return m_dhd->getButtonMask(m_identity.id);
}

bool OpenDevice::status(std::array<int, Dhd::kStatusCount>& status) noexcept
{
    return m_dhd->getStatus(status.data(), m_identity.id) >= 0;
}

} // namespace palpate::forcedimension
