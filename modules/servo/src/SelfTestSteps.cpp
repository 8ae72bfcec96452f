// SPDX-License-Identifier: BSD-3-Clause
#include "SelfTestSteps.h"

#include "PulseResponse.h"

#include <algorithm>
#include <cmath>

namespace palpate::servo {

namespace {

constexpr double kRampRate_N_per_s = 0.2;
constexpr double kRampPause_s = 0.3;
constexpr double kShortestPause_s = 0.06; // from pulse to pulse
constexpr double kPauseStep_s = 0.008;
constexpr double kProbe_s = 0.5;
constexpr double kProbePause_s = 0.5;
constexpr double kFree_mm = 10.0; // a hand does not give way so far under the force of the probe
constexpr double kRest_s = 2.0;
constexpr double kRestMargin_s = 0.5; // the end of the rest decides the noise
constexpr double kStill_mm = 0.3;
constexpr double kInside = 0.8; // of the workspace
constexpr double kInsideTime_s = 0.3;
constexpr double kNoPosition_s = 20.0;
constexpr double kMostSmall_N = 1.0;
constexpr double kMostSmallShare = 0.2; // of the device's maximum
constexpr double kMostForce = 2.5;      // of the resting force

/// Resting force of the hand, as in `palpate stability` (study::restingPush_N).
double restingForce_N(double maxForce_N) noexcept
{
    return std::min(3.0, 0.4 * maxForce_N);
}

GateLimits limitsOf(const device::DeviceInfo& info) noexcept
{
    GateLimits limits = GateLimits::forDevice(info);
    limits.maxForce_N = mostTestForce_N(info);
    return limits;
}

} // namespace

double mostTestForce_N(const device::DeviceInfo& info) noexcept
{
    return std::min(std::max(0.0, info.maxForce_N), kMostForce * restingForce_N(info.maxForce_N));
}

void BreakAway::start(double dt_s, double most_N, double least_mm) noexcept
{
    *this = {};
    m_dt_s = dt_s;
    m_most_N = most_N;
    m_least_mm = least_mm;
}

std::uint16_t BreakAway::part() const noexcept
{
    return isDone() || m_isPausing ? std::uint16_t{0} : static_cast<std::uint16_t>(m_count + 1);
}

double BreakAway::tick(double x_mm) noexcept PALPATE_NONBLOCKING
{
    if (isDone()) {
        return 0.0;
    }
    m_passed_s += m_dt_s;
    if (m_isPausing) {
        m_isPausing = m_passed_s < kRampPause_s;
        if (!m_isPausing) {
            m_passed_s = 0.0;
            m_from_mm = x_mm;
        }
        return 0.0;
    }
    const double sign = m_count % 2 == 0 ? 1.0 : -1.0;
    const double force_N = std::min(m_most_N, kRampRate_N_per_s * m_passed_s);
    const bool hasMoved = std::abs(x_mm - m_from_mm) >= m_least_mm;
    if (hasMoved || force_N >= m_most_N) {
        m_ramps[m_count++] = {sign * force_N, hasMoved};
        m_isPausing = true;
        m_passed_s = 0.0;
        return 0.0;
    }
    return sign * force_N;
}

double BreakAway::friction_N() const noexcept
{
    double sum = 0.0;
    int count = 0;
    for (const SelfTestRamp& ramp : m_ramps) {
        sum += ramp.hasMoved ? std::abs(ramp.force_N) : 0.0;
        count += ramp.hasMoved ? 1 : 0;
    }
    return count > 0 ? sum / count : m_most_N;
}

void Pulses::start(double dt_s, double force_N, int count) noexcept
{
    *this = {};
    m_dt_s = dt_s;
    m_force_N = force_N;
    m_count = count;
}

double Pulses::tick() noexcept PALPATE_NONBLOCKING
{
    if (isDone()) {
        return 0.0;
    }
    const double now_s = m_passed_s;
    m_passed_s += m_dt_s;
    if (now_s >= m_length_s - 0.5 * m_dt_s) {
        ++m_index;
        m_passed_s = m_dt_s;
        // xorshift, Marsaglia 2003
        m_random ^= m_random << 13U;
        m_random ^= m_random >> 17U;
        m_random ^= m_random << 5U;
        m_force_N = std::copysign(m_force_N, (m_random >> 31U) != 0 ? 1.0 : -1.0);
        m_length_s = kShortestPause_s + kPauseStep_s * static_cast<double>((m_random >> 8U) & 7U);
        return isDone() ? 0.0 : m_force_N;
    }
    const double half = (now_s + 0.5 * m_dt_s) / kPulse_s;
    return m_index == 0 || half >= 2.0 ? 0.0 : half < 1.0 ? m_force_N : -m_force_N;
}

void HandProbe::start(double dt_s, double force_N, double timeout_s) noexcept
{
    *this = {};
    m_dt_s = dt_s;
    m_force_N = force_N;
    m_timeout_s = timeout_s;
    m_passed_s = kProbe_s; // begin with the pause
}

double HandProbe::tick(double x_mm) noexcept PALPATE_NONBLOCKING
{
    m_total_s += m_dt_s;
    m_passed_s += m_dt_s;
    if (m_passed_s >= kProbe_s + kProbePause_s) {
        m_passed_s = 0.0;
        m_from_mm = x_mm;
        m_sign = -m_sign;
        m_isGone = false;
    }
    if (m_passed_s >= kProbe_s || m_isGone) {
        return 0.0;
    }
    m_isGone = std::abs(x_mm - m_from_mm) > kFree_mm;
    if (!m_isGone && m_passed_s + m_dt_s >= kProbe_s) {
        m_isFound = true;
    }
    return m_isGone ? 0.0 : m_sign * m_force_N * std::min(1.0, 2.0 * m_passed_s / kProbe_s);
}

SelfTestSteps::SelfTestSteps(const device::DeviceInfo& info, const SelfTestOptions& options)
    : m_options(options)
    , m_gate(limitsOf(info), 1.0 / options.rate_Hz)
    , m_limits(PassivityLimits::forDevice(info))
    , m_passivity(m_limits, 1.0 / options.rate_Hz)
    , m_dt_s(1.0 / options.rate_Hz)
    , m_small_N(std::min(kMostSmall_N, kMostSmallShare * info.maxForce_N))
{
    constexpr int kLeastPulses = 40; // fewer cannot be judged
    constexpr std::size_t kWalls = 256;
    m_options.pulses = std::clamp(options.pulses, kLeastPulses, SelfTestOptions::kMostPulses);
    m_record.device = info;
    m_record.rate_Hz = options.rate_Hz;
    m_record.u_D = info.q_UD.inverse() * Vec3::UnitZ();
    m_record.press_N = restingForce_N(info.maxForce_N);
    m_record.samples.reserve(static_cast<std::size_t>(options.longest_s * options.rate_Hz) + 1);
    m_record.walls.reserve(kWalls);
    m_record.ramps.reserve(m_breakAway.ramps().size());
}

void SelfTestSteps::noteOverrun(bool isOverrun) noexcept PALPATE_NONBLOCKING
{
    m_record.overruns += isOverrun ? 1 : 0;
    if (m_record.step != SelfTestStep::Wait) {
        m_gate.noteOverrun(isOverrun);
    }
}

void SelfTestSteps::setDelay(int ticks) noexcept PALPATE_NONBLOCKING
{
    m_record.delayTicks = std::clamp(ticks, 0, PassivityController::kMaxDelayTicks);
    m_passivity.setDelay(m_record.delayTicks);
}

double SelfTestSteps::progress() const noexcept
{
    constexpr double kUsual_s = 60.0; // rest, friction and pulses 20 s, walls 40 s
    const double share = m_elapsed_s / (kUsual_s + 2.0 * m_options.lead_s);
    return m_record.step == SelfTestStep::Done ? 1.0 : std::clamp(share, 0.0, 1.0);
}

void SelfTestSteps::stop(SelfTestStop why) noexcept PALPATE_NONBLOCKING
{
    if (!m_isEnding) {
        m_isEnding = true;
        m_record.stopped = why;
        m_record.lastStep = m_record.step;
        m_record.step = SelfTestStep::Done;
        m_record.fault = m_gate.fault();
        m_gate.beginStop();
    }
}

void SelfTestSteps::go(SelfTestStep next) noexcept
{
    if (next == SelfTestStep::Done) {
        m_record.step = next;
        stop(SelfTestStop::None);
    }
    m_record.step = next;
    m_inStep_s = 0.0;
    m_part = 0;
}

void SelfTestSteps::goToWalls(bool isControlled, double softest_N_per_mm) noexcept
{
    constexpr double kSoftest_N_per_mm = 0.1;
    const device::DeviceInfo& info = m_record.device;
    m_limits.isOn = isControlled;
    m_limits.delayTicks = m_record.delayTicks;
    m_passivity = PassivityController(m_limits, m_dt_s);
    WallSeries::Setup setup;
    setup.dt_s = m_dt_s;
    setup.press_N = m_record.press_N;
    setup.softest_N_per_mm = std::max(kSoftest_N_per_mm, softest_N_per_mm);
    setup.stiffest_N_per_mm = m_options.stiffest_N_per_mm;
    setup.reach_mm = info.workspaceRadius_mm > 0.0 ? std::min(30.0, 0.5 * info.workspaceRadius_mm) : 30.0;
    setup.resolution_mm = info.resolution_mm;
    setup.delay_s = (m_record.delayTicks + 0.5) * m_dt_s;
    setup.isControlled = isControlled;
    m_series = WallSeries(setup);
    go(isControlled ? SelfTestStep::ControlledWalls : SelfTestStep::Walls);
}

/// Waits, without force, for a position that is not at the edge of the workspace.
void SelfTestSteps::wait(const device::DeviceState& state) noexcept
{
    const double radius_mm = m_record.device.workspaceRadius_mm;
    const bool isInside = state.isPresent && !state.isLost && state.p_D.allFinite() &&
                          (radius_mm <= 0.0 || state.p_D.norm() <= kInside * radius_mm);
    m_inside_s = isInside ? m_inside_s + m_dt_s : 0.0;
    if (state.isLost) {
        m_gate.raise(FaultKind::DeviceLost);
        stop(SelfTestStop::Fault);
    } else if (m_inside_s >= std::max(kInsideTime_s, m_options.lead_s)) {
        go(SelfTestStep::Rest); // the gate begins here
    } else if (m_inStep_s > kNoPosition_s + m_options.lead_s) {
        stop(SelfTestStop::NoPosition);
    }
}

void SelfTestSteps::rest(double x_mm) noexcept
{
    const device::DeviceInfo& info = m_record.device;
    if (m_inStep_s < kRest_s - kRestMargin_s) {
        m_low_mm = m_high_mm = x_mm;
    }
    m_low_mm = std::min(m_low_mm, x_mm);
    m_high_mm = std::max(m_high_mm, x_mm);
    if (m_inStep_s < kRest_s) {
        return;
    }
    m_noise_mm = m_high_mm - m_low_mm;
    if (info.actuatedAxes == 0 || !(info.maxForce_N > 0.0)) {
        stop(SelfTestStop::NoMotors);
        return;
    }
    m_breakAway.start(m_dt_s, m_small_N, std::max({0.05, 2.0 * info.resolution_mm, 3.0 * m_noise_mm}));
    go(SelfTestStep::Friction);
}

double SelfTestSteps::frictionForce_N(double x_mm) noexcept
{
    const bool isStill = m_noise_mm <= kStill_mm; // otherwise a hand moves the handle
    const double f_N = isStill ? m_breakAway.tick(x_mm) : 0.0;
    m_part = m_breakAway.part();
    if (!isStill || m_breakAway.isDone()) {
        if (m_breakAway.isDone()) {
            m_record.ramps.assign(m_breakAway.ramps().begin(), m_breakAway.ramps().end());
            m_friction_N = m_breakAway.friction_N();
        }
        m_pulses.start(m_dt_s, std::min(m_small_N + m_friction_N, m_record.press_N), m_options.pulses);
        m_pulsesFrom = m_record.samples.size();
        go(SelfTestStep::RoundTrip);
    }
    return f_N;
}

double SelfTestSteps::pulseForce_N() noexcept
{
    const double f_N = m_pulses.tick();
    m_part = m_pulses.part();
    if (m_pulses.isDone()) {
        const std::span<const SelfTestSample> samples(m_record.samples);
        const PulseVerdict verdict = verdictOf(samples.subspan(std::min(m_pulsesFrom, samples.size())), m_record.u_D);
        if (verdict == PulseVerdict::Follows) {
            m_probe.start(m_dt_s, std::min(0.5 * m_small_N + m_friction_N, m_record.press_N), m_options.handTimeout_s);
            go(SelfTestStep::Hand);
        } else {
            stop(verdict == PulseVerdict::Reversed ? SelfTestStop::Reversed : SelfTestStop::NoResponse);
        }
    }
    return f_N;
}

double SelfTestSteps::probeForce_N(double x_mm) noexcept
{
    if (m_inStep_s < m_options.lead_s) {
        return 0.0;
    }
    const double f_N = m_probe.tick(x_mm);
    if (m_probe.isFound()) {
        goToWalls(false, 0.0);
    } else if (m_probe.isOutOfTime()) {
        stop(SelfTestStop::NoHand);
    }
    return f_N;
}

double SelfTestSteps::wallForce_N(double x_mm) noexcept
{
    const WallTick wall = m_series.tick(x_mm);
    m_passivity.noteWork(wall.work_mJ);
    m_part = m_series.part();
    SelfTestWall result;
    if (m_series.fetch(result) && m_record.walls.size() < m_record.walls.capacity()) {
        m_record.walls.push_back(result);
    }
    if (m_series.isLetGo()) {
        stop(SelfTestStop::LetGo);
    } else if (m_series.isDone() && m_record.step == SelfTestStep::Walls) {
        goToWalls(true, 0.5 * m_series.held_N_per_mm());
    } else if (m_series.isDone()) {
        go(SelfTestStep::Done);
    }
    return wall.force_N;
}

/// Force of the step, along the direction of the test [N]
double SelfTestSteps::force_N(double x_mm) noexcept
{
    switch (m_record.step) {
    case SelfTestStep::Wait:
    case SelfTestStep::Done:
        break;
    case SelfTestStep::Rest:
        rest(x_mm);
        break;
    case SelfTestStep::Friction:
        return frictionForce_N(x_mm);
    case SelfTestStep::RoundTrip:
        return pulseForce_N();
    case SelfTestStep::Hand:
        return probeForce_N(x_mm);
    case SelfTestStep::Walls:
    case SelfTestStep::ControlledWalls:
        return wallForce_N(x_mm);
    }
    return 0.0;
}

Vec3 SelfTestSteps::tick(const device::DeviceState& state, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING
{
    m_start_ns = m_start_ns == 0 ? now_ns : m_start_ns;
    m_elapsed_s = static_cast<double>(now_ns - m_start_ns) * 1e-9;
    m_inStep_s += m_dt_s;
    if (!m_isEnding && m_elapsed_s > m_options.longest_s) {
        stop(SelfTestStop::OutOfTime);
    }
    const SelfTestStep now = m_record.step;
    if (now == SelfTestStep::Wait) {
        wait(state);
        return Vec3::Zero();
    }
    const GatedInput input = m_gate.admit(state, now_ns);
    ForceRequest request;
    if (input.isPresent) {
        m_passivity.follow(input.p_D);
        const double f_N = m_isEnding || input.isFirst ? 0.0 : force_N(m_record.u_D.dot(input.p_D));
        const bool isWall = now == SelfTestStep::Walls || now == SelfTestStep::ControlledWalls;
        request.f_D = f_N * m_record.u_D;
        request.isInContact = isWall && f_N > 0.0;
        if (isWall) {
            request.f_D += m_passivity.damping(m_gate.eased(request.f_D), request.isInContact);
        }
    }
    const Vec3 sent_D = m_gate.release(request);
    m_passivity.noteSent(sent_D);
    if (m_gate.fault() != FaultKind::None) {
        stop(SelfTestStop::Fault);
    } else if (!input.isPresent) {
        stop(SelfTestStop::NoPosition);
    }
    if (m_record.samples.size() < m_record.samples.capacity()) {
        m_record.samples.push_back({m_elapsed_s, static_cast<double>(state.time_ns - m_start_ns) * 1e-9, input.p_D,
                                    m_record.u_D.dot(sent_D), now, m_part});
    }
    return sent_D;
}

} // namespace palpate::servo
