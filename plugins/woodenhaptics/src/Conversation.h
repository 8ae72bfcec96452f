// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Counters.h"
#include "Kinematics.h"

#include <palpate/device/HapticDevice.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace palpate::woodenhaptics {

/// Protocol between host and firmware, report by report. No I/O and no clock.
///
/// All numbers are little-endian int16. The length of incoming reports identifies the protocol. Outgoing reports are
/// preceded by report id 0. The firmware sends one report and waits for an answer, so each report is answered.
/// - Protocol 2, 14 bytes in each direction. In: encoders a to f and info (1: calibration button pressed). Out:
///   currents a, b, c [mA], command, three attributes. Command 1 sets the counters: the attributes are a, b, c, the
///   currents d, e, f.
/// - Protocol 1, 8 bytes. In: encoders a, b, c with opposite sign, and an unused field. Out: currents and an unused
///   field. Counters cannot be set, so the host stores the offset.
class Conversation
{
  public:
    /// @param isTrusted  true: the counters are relative to the calibration pose, as after switching on in that pose
    Conversation(const Config& config, bool isTrusted);

    /// Processes a report of any length and content.
    /// @return true when the report gave a new state
    bool take(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept;
    /// Builds the answer to the latest report: currents for the force [N], or a pending calibration. Valid until the
    /// next call.
    [[nodiscard]] std::span<const std::uint8_t> answer(const core::Vec3& f_D, std::int64_t now_ns) noexcept;
    /// Builds a report with zero currents, to start the firmware or to finish.
    [[nodiscard]] std::span<const std::uint8_t> zero() noexcept;

    /// Makes the current pose the calibration pose, with the next answer.
    void calibrate() noexcept;

    [[nodiscard]] const device::DeviceState& state() const noexcept { return m_state; }
    /// Protocol 1 or 2; 0 until enough reports agree.
    [[nodiscard]] int protocol() const noexcept { return m_protocol; }
    [[nodiscard]] bool isCalibrated() const noexcept { return m_isCalibrated; }
    /// Number of rejected reports.
    [[nodiscard]] std::uint64_t refused() const noexcept { return m_refused; }
    /// Length of the latest report of unexpected length; 0: none so far.
    [[nodiscard]] std::size_t unexpectedLength() const noexcept { return m_unexpectedLength; }

  private:
    bool refuse() noexcept;
    void sense(std::int64_t now_ns) noexcept;
    std::span<const std::uint8_t> pack(const std::array<std::int16_t, 7>& fields) noexcept;

    Config m_config;
    Kinematics m_kinematics;
    Counters m_counters;
    core::Vec3 m_offset = core::Vec3::Zero(); // counts = counters + m_offset
    core::Vec3 m_q = core::Vec3::Zero();
    device::DeviceState m_state;
    std::array<std::uint8_t, 15> m_out{};
    std::uint64_t m_refused = 0;
    std::size_t m_unexpectedLength = 0;
    std::size_t m_guess = 0; // alternates the length in zero() while the protocol is unknown
    int m_length = 0;        // length of the latest valid reports, in bytes
    int m_protocol = 0;
    int m_pressed = 0;                    // consecutive reports with the button down
    std::int64_t m_calibrateUntil_ns = 0; // 0: no calibration in progress
    std::int64_t m_calibrateNext_ns = 0;
    bool m_isCalibrationWanted = false;
    bool m_isCalibrated;
};

} // namespace palpate::woodenhaptics
