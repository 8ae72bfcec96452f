// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Bus.h"
#include "Models.h"

#include <vendor/HandExchange.h>

#include <atomic>
#include <thread>

namespace palpate::forcedimension {

/// What keeps an open device from working as a hand.
enum class Trouble : std::uint8_t
{
    None,
    Starting,  ///< state not known yet
    NoPower,   ///< connected by USB only
    Reset,     ///< not calibrated since it was switched on
    Fault,     ///< reported by the device itself
    TooFast,   ///< braked itself above its velocity threshold
    ForcesOff, ///< by the force button, or by another program
    DeadMan,   ///< the grip's sensor feels no hand
    Watchdog,  ///< the host was silent, or the USB link was; forces are enabled again by the driver
};

/// Device of Force Dimension as device "forcedimension". An I/O thread makes all calls of the maker's library, which
/// block on USB, and exchanges the latest state and force with the servo thread. After a loss the driver opens the
/// device with the same serial number again.
class Driver final : public device::HapticDevice
{
  public:
    /// @param serial  serial number of the device to open; 0: the only device
    Driver(std::shared_ptr<Bus> bus, Settings settings, int serial);
    ~Driver() override;

    /// Limits of the device if connected at construction; otherwise cautious limits until `start`.
    [[nodiscard]] device::DeviceInfo info() const override;
    core::Status start() override;
    void stop() noexcept override;
    [[nodiscard]] device::DeviceState read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING override;
    void write(const core::Vec3& f_D) noexcept PALPATE_NONBLOCKING override;
    [[nodiscard]] device::DeviceReport report() const override;
    /// Refuses with instructions: a device of this maker is calibrated at the device.
    core::Status calibrate() override;

  private:
    /// Takes identity and limits of an open device.
    void adopt(const OpenDevice& device);

    // I/O thread.
    void run(std::unique_ptr<OpenDevice> device) noexcept;
    void serve(OpenDevice& device) noexcept;
    [[nodiscard]] std::unique_ptr<OpenDevice> reopen() noexcept;
    void checkStatus(OpenDevice& device) noexcept;
    [[nodiscard]] core::Vec3 wantedForce(std::int64_t now_ns) noexcept;
    void publish(bool isPresent, bool isLost) noexcept;

    std::shared_ptr<Bus> m_bus;
    Settings m_settings;
    int m_serial;
    DeviceIdentity m_identity;           ///< written before the thread starts
    vendor::DeviceModel m_model;         ///< written before the thread starts
    std::unique_ptr<OpenDevice> m_ready; ///< opened at construction, until `start`
    std::thread m_thread;
    std::atomic<bool> m_isStopWanted{false};

    vendor::HandExchange m_exchange; // between I/O thread and servo thread

    // I/O thread only.
    device::DeviceState m_sensed;
    std::int64_t m_enabled_ns = 0; ///< of the last attempt to enable forces
    int m_watchdogAttempts = 0;    ///< to set the device's watchdog, since the device was opened

    // Written by the I/O thread for report().
    std::atomic<bool> m_isLost{false};
    std::atomic<bool> m_isWatched{true};
    std::atomic<Trouble> m_trouble{Trouble::Starting};
    std::atomic<std::uint64_t> m_states{0};
    std::atomic<std::uint64_t> m_refused{0};
    std::atomic<std::uint64_t> m_losses{0};
};

} // namespace palpate::forcedimension
