// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Channel.h"

#include <palpate/device/DevicePlugin.h>

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace palpate::openhaptics {

/// The library's scheduler and its devices. One callback serves all devices, each in a frame of its own, and is the
/// clock of their forces. Devices are opened, closed and opened again only while the scheduler stands still: the hands
/// of the other devices are away for some milliseconds, and their forces are eased in afterwards.
///
/// Never destroyed: the library may call back at any time, and must not be unloaded.
/// @par Thread Any thread except the servo thread.
class Scheduler
{
  public:
    explicit Scheduler(std::shared_ptr<const Hd> hd);
    ~Scheduler() = delete;

    /// Lists the configured devices. Each is opened for its model and serial number and closed again, without forces;
    /// not while this process has a device open.
    [[nodiscard]] std::vector<device::FoundDevice> list();
    /// Opens a device, without forces.
    /// @param wanted  name of a configuration or serial number; empty: the default device
    /// @return NotFound, Mismatch or DeviceLost with the next step
    [[nodiscard]] core::Result<std::shared_ptr<Channel>> open(const std::string& wanted, const Settings& settings);
    /// Begins to drive an open device, opened again after a loss until `close`.
    /// @return DeviceLost: the scheduler does not call
    [[nodiscard]] core::Status drive(const std::shared_ptr<Channel>& channel);
    /// Drives zero and closes the device. Returns after 2 s at most: a device of a library that hangs stays at zero
    /// force and is not closed.
    void close(const std::shared_ptr<Channel>& channel) noexcept;

    /// Whether the library has not called for 0.1 s although it should.
    [[nodiscard]] bool isSilent() const noexcept;

  private:
    static constexpr std::size_t kMostDevices = 4;

    static unsigned callback(void* scheduler) noexcept;
    void serve() noexcept;

    // With the lock held.
    [[nodiscard]] core::Result<std::shared_ptr<Channel>> openNamed(const std::string& name, const Settings& settings);
    [[nodiscard]] core::Result<std::shared_ptr<Channel>> openHalted(const std::string& name, const Settings& settings);
    /// Closes a device, while the scheduler stands still.
    void release(const std::shared_ptr<Channel>& channel) noexcept;
    void recover();
    void reopen(Channel& channel);
    void begin() noexcept;
    /// Drives zero and stops the scheduler. @return false: a callback hangs in the library; nothing may be changed
    [[nodiscard]] bool halt() noexcept;
    void holdAll(bool isHeld) noexcept;
    void waitForZero() noexcept;
    [[nodiscard]] bool isDriving() const noexcept;

    void supervise() noexcept;
    [[nodiscard]] bool lockWithin(std::int64_t wait_ns) noexcept;

    /// A device that is driven, and when the next attempt to open it again is due.
    struct Driven
    {
        std::shared_ptr<Channel> channel;
        std::int64_t due_ns = 0;
        std::int64_t pause_ns = 0;
    };

    std::shared_ptr<const Hd> m_hd;
    std::mutex m_lock; ///< guards the calls of the library outside of the callback
    std::vector<std::shared_ptr<Channel>> m_open;
    std::array<Driven, kMostDevices> m_driven; ///< changed only while the scheduler stands still
    unsigned long m_scheduled = 0;
    bool m_isRunning = false;    ///< guarded by `m_lock`
    bool m_isSupervised = false; ///< guarded by `m_lock`

    // The library may call late, twice at once, or after it was stopped.
    std::atomic<bool> m_isOpen{false};
    std::atomic<bool> m_isInside{false};
    std::atomic<std::int64_t> m_called_ns{0}; ///< of the last callback; 0: none is expected
};

} // namespace palpate::openhaptics
