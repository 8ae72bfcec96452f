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

/// What is said between host and firmware, report by report; no I/O, no clock of its own.
///
/// All numbers are little-endian int16. Protocol 2 (14 bytes each way): encoders a to f and info (1: the calibration
/// button was pressed) / currents a, b, c [mA], command, three attributes. Command 1 sets the counters: the attributes
/// are a, b, c, the currents d, e, f. Protocol 1 (8 bytes): encoders a, b, c in the opposite sense and a spare /
/// currents and a spare; its counters cannot be set, so the offset is kept here. What is written has report id 0 in
/// front. The length of what is read tells the protocol. The firmware sends one report and waits for one: each is
/// answered.
class Conversation
{
  public:
    /// @param isTrusted  the counters count from the calibration pose, as after power-on there
    Conversation(const Config& config, bool isTrusted);

    /// Takes a report of any length and content.
    /// @return true when it gave a new state
    bool take(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept;
    /// Answers the newest report: currents for the force [N], or a calibration that is due. Valid until the next call.
    [[nodiscard]] std::span<const std::uint8_t> answer(const core::Vec3& f_D, std::int64_t now_ns) noexcept;
    /// A report without current, to start the firmware or to end with.
    [[nodiscard]] std::span<const std::uint8_t> zero() noexcept;

    /// Takes the pose as the calibration pose, with the next answer.
    void calibrate() noexcept;

    [[nodiscard]] const device::DeviceState& state() const noexcept { return m_state; }
    /// 1 or 2; 0 until enough reports agreed.
    [[nodiscard]] int protocol() const noexcept { return m_protocol; }
    [[nodiscard]] bool isCalibrated() const noexcept { return m_isCalibrated; }
    /// Reports that were not believed.
    [[nodiscard]] std::uint64_t refused() const noexcept { return m_refused; }
    /// Length of the newest report that was too long or too short; 0: none yet.
    [[nodiscard]] std::size_t strangeLength() const noexcept { return m_strangeLength; }

  private:
    bool refuse() noexcept;
    void sense(std::int64_t now_ns) noexcept;
    std::span<const std::uint8_t> pack(const std::array<std::int16_t, 7>& fields) noexcept;

    Config m_config;
    Kinematics m_kinematics;
    Counters m_counters;
    core::Vec3 m_offset = core::Vec3::Zero(); // counts are counters + this
    core::Vec3 m_q = core::Vec3::Zero();
    device::DeviceState m_state;
    std::array<std::uint8_t, 15> m_out{};
    std::uint64_t m_refused = 0;
    std::size_t m_strangeLength = 0;
    std::size_t m_guess = 0; // zero() before the protocol is known
    int m_length = 0;        // of the newest reports of a known length, in bytes
    int m_protocol = 0;
    int m_pressed = 0;                    // reports in a row with the button down
    std::int64_t m_calibrateUntil_ns = 0; // 0: none under way
    std::int64_t m_calibrateNext_ns = 0;
    bool m_isCalibrationWanted = false;
    bool m_isCalibrated;
};

} // namespace palpate::woodenhaptics
