// SPDX-License-Identifier: BSD-3-Clause
#include "Conversation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace palpate::woodenhaptics {

namespace {

constexpr double kFastestJoint_rad_per_s = 60.0; // 10 m/s at the tip of the kit's arm
constexpr double kOriginalHostLimit_A = 2.0;     // amplifier limit of the original host program
// The hand counts as present slightly beyond the nominal workspace; the safety gate refuses from 1.5 times the radius
// on.
constexpr double kReach = 1.4;
constexpr int kButtonReports = 20;              // a single invalid report must not count as a pressed button
constexpr double kCalibrationTolerance = 500.0; // counts that the arm may turn while the counters are being set
constexpr std::int64_t kCalibrationTimeout_ns = 1'000'000'000;
constexpr std::int64_t kCalibrationRepeat_ns = 20'000'000;
constexpr std::size_t kLengths[] = {14, 8};

std::int16_t fieldAt(std::span<const std::uint8_t> report, std::size_t index) noexcept
{
    return static_cast<std::int16_t>(report[2 * index] | report[2 * index + 1] << 8);
}

core::Vec3 fastestCounts(const Config& config)
{
    core::Vec3 fastest;
    for (std::size_t i = 0; i < 3; ++i) {
        fastest[static_cast<Eigen::Index>(i)] = kFastestJoint_rad_per_s * config.countsPerTurn[i] /
                                                (2.0 * std::numbers::pi) * config.bodyDiameter_m[i] /
                                                config.capstanDiameter_m[i];
    }
    return fastest;
}

} // namespace

Conversation::Conversation(const Config& config, bool isTrusted)
    : m_config(config)
    , m_kinematics(config)
    , m_counters(fastestCounts(config))
    , m_isCalibrated(isTrusted)
{
}

bool Conversation::refuse() noexcept
{
    ++m_refused;
    return false;
}

bool Conversation::take(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept
{
    const bool isKnown = report.size() == kLengths[0] || report.size() == kLengths[1];
    if (!isKnown || (m_protocol != 0 && report.size() != kLengths[m_protocol == 2 ? 0 : 1])) {
        m_unexpectedLength = report.size();
        return refuse();
    }
    if (m_protocol == 0 && m_length != static_cast<int>(report.size())) {
        m_length = static_cast<int>(report.size()); // if lengths differ, the latest length in use is the device's
        m_counters = Counters(fastestCounts(m_config));
    }
    const bool isTwo = report.size() == kLengths[0];
    RawCounts raw{};
    for (std::size_t i = 0; i < raw.size(); ++i) {
        const auto bits = static_cast<std::uint16_t>(fieldAt(report, i));
        raw[i] = static_cast<std::int16_t>(isTwo ? bits : static_cast<std::uint16_t>(-bits));
    }
    if (m_calibrateUntil_ns != 0) { // reports are ignored until the counters have been set
        bool isSet = true;
        for (std::size_t i = 0; i < raw.size(); ++i) {
            isSet = isSet && std::abs(raw[i] - m_config.calibrationCounts[i]) < kCalibrationTolerance;
        }
        if (isSet) {
            m_counters.restart(raw, now_ns);
            m_offset.setZero();
            m_isCalibrated = true;
            m_calibrateUntil_ns = 0;
        } else if (now_ns > m_calibrateUntil_ns) {
            m_calibrateUntil_ns = 0;
        }
        sense(now_ns);
        return true;
    }
    switch (m_counters.take(raw, now_ns)) {
    case Counters::Answer::Refused:
        return refuse();
    case Counters::Answer::Restarted:
        m_isCalibrated = false;
        break;
    case Counters::Answer::Taken:
        break;
    }
    m_protocol = isTwo ? 2 : 1;
    m_pressed = isTwo && fieldAt(report, 6) == 1 ? m_pressed + 1 : 0;
    if (m_pressed == kButtonReports) {
        calibrate();
    }
    sense(now_ns);
    return true;
}

void Conversation::sense(std::int64_t now_ns) noexcept
{
    m_q = m_kinematics.angles(m_counters.counts() + m_offset);
    const core::Vec3 p_m = m_kinematics.position_m(m_q);
    m_state.p_D = p_m * 1000.0;
    m_state.time_ns = now_ns;
    m_state.isLost = false;
    m_state.isPresent = m_isCalibrated && m_calibrateUntil_ns == 0 && p_m.norm() < kReach * m_config.workspaceRadius_m;
}

void Conversation::calibrate() noexcept
{
    m_isCalibrationWanted = true;
}

std::span<const std::uint8_t> Conversation::answer(const core::Vec3& f_D, std::int64_t now_ns) noexcept
{
    std::array<std::int16_t, 7> fields{};
    if (m_isCalibrationWanted && m_protocol != 0) {
        m_isCalibrationWanted = false;
        m_isCalibrated = false;
        if (m_protocol == 1) {
            const auto& pose = m_config.calibrationCounts;
            m_offset = core::Vec3(pose[0], pose[1], pose[2]) - m_counters.counts();
            m_isCalibrated = true;
        } else {
            m_calibrateUntil_ns = now_ns + kCalibrationTimeout_ns;
            m_calibrateNext_ns = now_ns;
        }
    }
    if (m_calibrateUntil_ns != 0) {
        if (now_ns >= m_calibrateNext_ns) {
            m_calibrateNext_ns = now_ns + kCalibrationRepeat_ns;
            const auto pose = [this](std::size_t i) {
                return static_cast<std::int16_t>(m_config.calibrationCounts[i]);
            };
            fields = {pose(3), pose(4), pose(5), 1, pose(0), pose(1), pose(2)};
        }
        return pack(fields);
    }
    if (!m_state.isPresent || !f_D.allFinite()) {
        return pack(fields);
    }
    const double force_N = f_D.norm();
    const core::Vec3 bounded = force_N > m_config.maxForce_N ? core::Vec3(f_D * (m_config.maxForce_N / force_N)) : f_D;
    core::Vec3 currents_A = m_kinematics.currents(m_kinematics.torques(m_q, bounded));
    // Scaling all three currents keeps the direction of the force.
    const double limit_A = std::min(kOriginalHostLimit_A, m_config.fullScale_A);
    const double largest_A = currents_A.cwiseAbs().maxCoeff();
    if (largest_A > limit_A) {
        currents_A *= limit_A / largest_A;
    }
    if (currents_A.allFinite()) {
        for (std::size_t i = 0; i < 3; ++i) {
            fields[i] = static_cast<std::int16_t>(std::lround(currents_A[static_cast<Eigen::Index>(i)] * 1000.0));
        }
    }
    return pack(fields);
}

std::span<const std::uint8_t> Conversation::zero() noexcept
{
    return pack({});
}

std::span<const std::uint8_t> Conversation::pack(const std::array<std::int16_t, 7>& fields) noexcept
{
    // Before the device has sent a report, either length may be right; zeros are harmless with both protocols.
    const std::size_t length = m_protocol == 0 ? kLengths[m_guess++ % 2] : kLengths[m_protocol == 2 ? 0 : 1];
    m_out[0] = 0;
    for (std::size_t i = 0; i < length / 2; ++i) {
        const auto bits = static_cast<std::uint16_t>(fields[i]);
        m_out[1 + 2 * i] = static_cast<std::uint8_t>(bits & 0xff);
        m_out[2 + 2 * i] = static_cast<std::uint8_t>(bits >> 8);
    }
    return {m_out.data(), 1 + length};
}

} // namespace palpate::woodenhaptics
