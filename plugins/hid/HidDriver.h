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

/// What a driver of a HID device is besides what it says to it: a thread that talks to the device and, when it is lost,
/// looks for it until it is back.
///
/// A driver derives from it, calls `begin` in its `start` and `stop` in its destructor, and says the rest in the
/// functions below.
class HidDriver : public device::HapticDevice
{
  public:
    struct Kind
    {
        const char* id;            ///< "spacemouse": begins each message
        const char* missing;       ///< what is not on the bus and what to do, one sentence
        std::int64_t findEvery_ns; ///< how often a lost one is looked for
    };

    void stop() noexcept override;

  protected:
    /// @param kind     lives as long as the driver
    /// @param address  path of the one to open at first; empty: any
    HidDriver(const device::PluginServices& services, const Kind& kind, std::string address);

    /// Opens the device for `run`. @return a line that says why not
    [[nodiscard]] core::Result<HidDevice> open();
    /// Starts the thread, with all counters at zero. @pre it is not running
    void run(HidDevice device);
    [[nodiscard]] bool isRunning() const noexcept { return m_thread.joinable(); }
    [[nodiscard]] bool isStopWanted() const noexcept { return m_isStopWanted; }
    [[nodiscard]] const std::string& path() const noexcept { return m_path; } ///< of what `open` opened

    // On the thread.
    virtual void makeThreadReady() noexcept = 0;
    /// Talks to the device until it is lost or `isStopWanted`.
    virtual void serve(HidDevice& device) noexcept = 0;
    /// The device was lost.
    virtual void tellLost() noexcept = 0;

    /// On any thread: what is on the bus and might be it. May throw bad_alloc.
    [[nodiscard]] virtual std::vector<HidEntry> list(std::mutex& bus) const = 0;

    // For `report`, counted on the thread.
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
