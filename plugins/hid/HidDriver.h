// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "HidBus.h"

#include <palpate/device/DevicePlugin.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace palpate::hid {

/// Base class of HID device drivers: runs an I/O thread that serves the device and, after a loss, reconnects when the
/// device is back.
///
/// A derived class calls `open` and `run` in `start` and `stop` in its destructor, and implements the virtual
/// functions below.
class HidDriver : public device::HapticDevice
{
  public:
    struct Kind
    {
        const char* id;              ///< "spacemouse": prefix of each message
        core::MessageText<> missing; ///< message for a missing device, with a remedy; one sentence
        std::int64_t findEvery_ns;   ///< interval between attempts to reconnect
    };

    void stop() noexcept override;

  protected:
    /// @param kind  must outlive the driver
    /// @param address  path of the device to open first; empty: any
    HidDriver(const device::PluginServices& services, const Kind& kind, std::string address);

    /// Opens the device for `run`. @return the device, or an error with the reason
    [[nodiscard]] core::Result<HidDevice> open();
    /// Starts the thread and resets all counters. @pre The thread is not running.
    void run(HidDevice device);
    [[nodiscard]] bool isRunning() const noexcept { return m_thread.joinable(); }
    [[nodiscard]] bool isStopWanted() const noexcept { return m_isStopWanted; }
    [[nodiscard]] const std::string& path() const noexcept { return m_path; } ///< of the device that `open` opened

    // Called on the I/O thread.
    virtual void prepareThread() noexcept = 0;
    /// Serves the device until the device is lost or `isStopWanted`.
    virtual void serve(HidDevice& device) noexcept = 0;
    /// Called when the device was lost.
    virtual void onDeviceLost() noexcept = 0;

    /// Lists candidate interfaces on the bus. Called on any thread. May throw bad_alloc.
    [[nodiscard]] virtual std::vector<HidEntry> list(std::mutex& bus) const = 0;

    // Counters for `report`, incremented on the I/O thread.
    std::atomic<std::uint64_t> m_states{0};
    std::atomic<std::uint64_t> m_refused{0};
    std::atomic<std::uint64_t> m_losses{0};

  private:
    void talk(HidDevice first) noexcept;
    [[nodiscard]] std::optional<HidDevice> find() noexcept;

    std::mutex& m_bus;
    const Kind& m_kind;
    std::string m_address;
    std::string m_path;
    std::thread m_thread;
    std::atomic<bool> m_isStopWanted{false};
};

} // namespace palpate::hid
