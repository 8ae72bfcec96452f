// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Dhd.h"

#include <palpate/core/Types.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>

namespace palpate::forcedimension {

/// An open device and what the library states about it.
struct DeviceIdentity
{
    char id = -1;     ///< handle in the library
    int type = -1;    ///< system type
    int serial = 0;   ///< 0: unknown
    std::string name; ///< "omega.3"
    bool hasWrist = false;
    bool hasGripper = false;
};

[[nodiscard]] DeviceIdentity identify(const Dhd& dhd, char id);

/// Calls of the library for one open device. Removes all forces and closes the device at the end of its life.
/// @par Thread One thread at a time; every call may block on USB.
class OpenDevice
{
  public:
    OpenDevice(std::shared_ptr<const Dhd> dhd, DeviceIdentity identity);
    ~OpenDevice();
    OpenDevice(const OpenDevice&) = delete;
    OpenDevice& operator=(const OpenDevice&) = delete;

    [[nodiscard]] const DeviceIdentity& identity() const noexcept { return m_identity; }
    /// Force limit that the library reports [N]; 0: none.
    [[nodiscard]] double reportedForce_N() const noexcept;

    /// Enables forces at zero force, gravity compensation and, on devices with a gripper,
    /// the gripper as a button.
    /// @param maxForce_N  limit for the library, where the library has one
    void enableForces(double maxForce_N) noexcept;
    /// Removes all forces for good.
    void letGo() noexcept;
    /// Sets the device's watchdog. @return false: the last force would outlast a crash of the program
    [[nodiscard]] bool setWatchdog() noexcept;

    enum class Reading : std::uint8_t
    {
        New,
        Same, ///< too early: still the last position
        Failed,
        Implausible, ///< not finite, or farther away than any device reaches
    };
    /// Reads position [mm] and orientation in the device's frame. Unless the result is `New`, both are unchanged.
    [[nodiscard]] Reading sense(core::Vec3& p_mm, core::Quaternion& q) noexcept;
    /// Sends the force [N]; torque and gripper force are zero. @return false: failed
    [[nodiscard]] bool push(const core::Vec3& f_N) noexcept;
    [[nodiscard]] std::uint32_t buttons() noexcept;
    /// @return false: failed, and `status` is not valid
    [[nodiscard]] bool status(std::array<int, Dhd::kStatusCount>& status) noexcept;

  private:
    std::shared_ptr<const Dhd> m_dhd;
    DeviceIdentity m_identity;
    bool m_isLetGo = false;
};

} // namespace palpate::forcedimension
