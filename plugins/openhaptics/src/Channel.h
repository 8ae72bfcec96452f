// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Hd.h"
#include "Models.h"

#include <vendor/HandExchange.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

namespace palpate::openhaptics {

inline constexpr std::int64_t kMillisecond_ns = 1'000'000;
inline constexpr int kButtons = 4;

/// Reason why an open device does not work as a hand.
enum class Trouble : std::uint8_t
{
    None,
    Starting,     ///< no state yet
    NeedsUpdate,  ///< the library is asked to calibrate by itself
    NeedsInkwell, ///< calibrates when the stylus is put into the inkwell
    NeedsReset,   ///< calibrates on request, in the reset pose
    TooFast,      ///< moved faster than the library permits
    TooMuchForce, ///< the library refuses forces
    NoLicence,    ///< the licence has expired
};

/// One open device: its frames in the library, and the data that cross threads.
class Channel
{
  public:
    /// @param name  of the configuration; empty: the default device of the library
    /// @param device  handle; not yet in the scheduler
    Channel(std::shared_ptr<const Hd> hd, std::string name, Hd::Device device, Statement statement, Limits limits);

    // Not while the scheduler is running.
    [[nodiscard]] Hd::Device device() const noexcept { return m_device; }
    /// Takes another handle, after the device was opened again; `Hd::kNoDevice`: none.
    void setDevice(Hd::Device device) noexcept;
    /// Enables forces. The device is the current one.
    void enableForces() noexcept;
    /// Forgets counters and states. The servo thread is not running either.
    void reset();

    [[nodiscard]] const std::string& name() const noexcept { return m_name; }
    [[nodiscard]] const Statement& statement() const noexcept { return m_statement; }
    [[nodiscard]] const Limits& limits() const noexcept { return m_limits; }
    [[nodiscard]] vendor::HandExchange& exchange() noexcept { return m_exchange; }
    [[nodiscard]] const vendor::HandExchange& exchange() const noexcept { return m_exchange; }

    /// Reads the device and drives it, in a frame of its own.
    /// @param isEnding  the process is about to end: zero force
    /// @par Thread Callback of the library's scheduler.
    /// @par Real-time No allocation, no lock, except in the library.
    void frame(bool isEnding) noexcept;

    // Any thread.
    /// Holds the device at zero force without a hand, or lets it work.
    void hold(bool isHeld) noexcept;
    /// Holds the device for good, because it is being closed.
    void retire() noexcept { m_isRetired = true; }
    [[nodiscard]] bool isRetired() const noexcept { return m_isRetired; }
    /// Number of frames in which the device was driven with zero since `hold(true)`.
    [[nodiscard]] unsigned heldFrames() const noexcept { return m_heldFrames; }
    void requestCalibration() noexcept { m_isCalibrationWanted = true; }
    /// Time since which the device does not answer; 0: it answers.
    [[nodiscard]] std::int64_t lostSince_ns() const noexcept { return m_lostSince_ns; }
    /// Marks the device as lost, when the library does not call any more.
    void markLost(std::int64_t now_ns) noexcept;
    [[nodiscard]] Trouble trouble() const noexcept { return m_trouble; }
    [[nodiscard]] bool isWarm() const noexcept { return m_isWarm; }
    [[nodiscard]] double rate_Hz() const noexcept { return m_rate_Hz; } ///< of frames; 0: not measured yet
    [[nodiscard]] std::uint64_t states() const noexcept { return m_states; }
    [[nodiscard]] std::uint64_t refused() const noexcept { return m_refused; }
    [[nodiscard]] std::uint64_t losses() const noexcept { return m_losses; }

  private:
    [[nodiscard]] bool sense() noexcept;
    /// Takes all pending errors. @return false: the reading or the force of this frame does not count
    [[nodiscard]] bool heedErrors(std::int64_t now_ns) noexcept;
    [[nodiscard]] Trouble troubleAt(std::int64_t now_ns) noexcept;
    void checkCalibration() noexcept;
    void updateCalibration(std::int64_t now_ns) noexcept;
    [[nodiscard]] double limitAt(std::int64_t now_ns) noexcept;
    void measureRate(std::int64_t now_ns) noexcept;
    void publish(bool isPresent, bool isLost) noexcept;

    std::shared_ptr<const Hd> m_hd;
    std::string m_name;
    Hd::Device m_device;
    Statement m_statement;
    Limits m_limits;
    vendor::HandExchange m_exchange;

    std::atomic<bool> m_isHeld{true};
    std::atomic<bool> m_isRetired{false};
    std::atomic<unsigned> m_heldFrames{0};
    std::atomic<bool> m_isCalibrationWanted{false};

    // Callback only.
    device::DeviceState m_sensed;
    Trouble m_calibration = Trouble::None; ///< the part of the trouble that concerns calibration
    Trouble m_force = Trouble::None;       ///< the part that the library caused by an error
    std::int64_t m_forceOffUntil_ns = 0;
    std::int64_t m_warmUntil_ns = 0;
    std::int64_t m_calibrated_ns = 0; ///< of the last attempt to calibrate
    std::int64_t m_frame_ns = 0;      ///< of the last frame
    std::int64_t m_rateFrom_ns = 0;
    std::int64_t m_failedSince_ns = 0; ///< of reading; 0: the last reading was valid
    bool m_isFrameClosed = false;      ///< before its end, after an error
    int m_rateFrames = 0;
    int m_goodFrames = 0; ///< consecutive
    unsigned m_frames = 0;
    double m_limit_N = 0.0; ///< between the continuous force and the maximum

    // Written by the callback for reports.
    std::atomic<std::int64_t> m_lostSince_ns{0};
    std::atomic<Trouble> m_trouble{Trouble::Starting};
    std::atomic<bool> m_isWarm{false};
    std::atomic<double> m_rate_Hz{0.0};
    std::atomic<std::uint64_t> m_states{0};
    std::atomic<std::uint64_t> m_refused{0};
    std::atomic<std::uint64_t> m_losses{0};
};

} // namespace palpate::openhaptics
