// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "OpenDevice.h"

#include <palpate/device/DevicePlugin.h>

#include <mutex>
#include <vector>

namespace palpate::forcedimension {

/// Finds and opens devices. Devices are told apart by serial number, because the library's order changes when one is
/// plugged in again.
///
/// @par Thread Any thread except the servo thread.
class Bus
{
  public:
    Bus(std::shared_ptr<const Dhd> dhd, std::mutex& mutex)
        : m_dhd(std::move(dhd))
        , m_mutex(mutex)
    {
    }

    /// Lists the devices. Each is opened for its serial number and closed again, without forces; not while this
    /// process has a device open, because the library may then return the open device a second time.
    [[nodiscard]] std::vector<device::FoundDevice> list();
    /// Opens the device with this serial number; 0: the only device.
    /// @return NotFound or Mismatch with the next step
    [[nodiscard]] core::Result<std::unique_ptr<OpenDevice>> open(int serial);
    /// Removes all forces and closes the device.
    void close(std::unique_ptr<OpenDevice> device) noexcept;

  private:
    std::shared_ptr<const Dhd> m_dhd;
    std::mutex& m_mutex;                ///< guards opening and closing
    std::vector<DeviceIdentity> m_open; ///< of this process
};

} // namespace palpate::forcedimension
