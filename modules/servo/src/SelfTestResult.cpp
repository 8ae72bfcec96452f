// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/servo/SelfTestResult.h"

#include "PulseResponse.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace palpate::servo {

namespace {

using Samples = std::vector<SelfTestSample>;

double quantile(std::vector<double> values, double share)
{
    if (values.empty()) {
        return 0.0;
    }
    const double last = static_cast<double>(values.size() - 1);
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::ceil(share * last));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

std::optional<RestMeasure> restOf(const Samples& samples, double rate_Hz)
{
    constexpr double kLine_s = 0.05;
    const auto length = static_cast<std::size_t>(std::max(8.0, kLine_s * rate_Hz));
    Samples all;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(all),
                 [](const SelfTestSample& s) { return s.step == SelfTestStep::Rest; });
    if (all.size() < 4 * length) {
        return std::nullopt;
    }
    RestMeasure rest;
    std::size_t states = 0;
    for (std::size_t i = 1; i < all.size(); ++i) {
        states += all[i].measured_s != all[i - 1].measured_s ? 1 : 0;
    }
    rest.states_per_s = static_cast<double>(states) / (all.back().time_s - all.front().time_s);
    for (int axis = 0; axis < 3; ++axis) {
        double sum = 0.0;
        std::size_t count = 0;
        for (std::size_t from = 0; from + length <= all.size(); from += length) {
            double mean = 0.0, slope = 0.0, spread = 0.0;
            const double middle = 0.5 * static_cast<double>(length - 1);
            for (std::size_t i = 0; i < length; ++i) {
                const double t = static_cast<double>(i) - middle;
                mean += all[from + i].p_D[axis] / static_cast<double>(length);
                slope += t * all[from + i].p_D[axis];
                spread += t * t;
            }
            double low = 0.0, high = 0.0;
            for (std::size_t i = 0; i < length; ++i) {
                const double d = all[from + i].p_D[axis] - mean - slope / spread * (static_cast<double>(i) - middle);
                sum += d * d;
                low = std::min(low, d);
                high = std::max(high, d);
            }
            count += length;
            rest.noisePeak_mm = std::max(rest.noisePeak_mm, high - low);
        }
        rest.noise_mm = std::max(rest.noise_mm, std::sqrt(sum / static_cast<double>(count)));
    }
    return rest;
}

/// Moves from one state to the next, over the whole test: a sensor moves by whole steps, a fast handle by several.
double resolutionOf(const Samples& samples)
{
    constexpr double kNothing_mm = 1e-7;
    constexpr std::size_t kEnough = 50;
    std::vector<double> moves;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const double d = std::abs(samples[i].p_D[axis] - samples[i - 1].p_D[axis]);
            if (d > kNothing_mm) {
                moves.push_back(d);
            }
        }
    }
    constexpr double kShare = 0.05;
    return moves.size() < kEnough ? 0.0 : quantile(std::move(moves), kShare);
}

std::optional<double> heldOf(const std::vector<SelfTestWall>& walls, bool isControlled)
{
    std::optional<double> held;
    for (const SelfTestWall& wall : walls) {
        if (wall.isControlled == isControlled) {
            held = std::max(held.value_or(0.0), wall.isHeld ? wall.stiffness_N_per_mm : 0.0);
        }
    }
    return held;
}

/// Positions at the end of a wall, from its fall on, relative to the first.
WallTrace traceOf(const SelfTestRecord& record, const SelfTestWall& wall, std::uint16_t part)
{
    constexpr double kLength_s = 1.6;
    const SelfTestStep step = wall.isControlled ? SelfTestStep::ControlledWalls : SelfTestStep::Walls;
    double end_s = 0.0;
    for (const SelfTestSample& s : record.samples) {
        end_s = s.step == step && s.part == part ? s.time_s : end_s;
    }
    WallTrace trace{wall, {}};
    double from_s = 0.0, from_mm = 0.0;
    for (const SelfTestSample& s : record.samples) {
        if (s.step == step && s.part == part && s.time_s >= end_s - kLength_s) {
            const double x_mm = record.u_D.dot(s.p_D);
            from_s = trace.way_mm.empty() ? s.time_s : from_s;
            from_mm = trace.way_mm.empty() ? x_mm : from_mm;
            trace.way_mm.push_back({1000.0 * (s.time_s - from_s), x_mm - from_mm});
        }
    }
    return trace;
}

/// Stiffest held and softest lost wall.
void addTraces(std::vector<WallTrace>& traces, const SelfTestRecord& record, bool isControlled)
{
    std::uint16_t heldPart = 0, lostPart = 0, part = 0;
    SelfTestWall held, lost;
    for (const SelfTestWall& wall : record.walls) {
        if (wall.isControlled != isControlled) {
            continue;
        }
        ++part;
        if (wall.isHeld && (heldPart == 0 || wall.stiffness_N_per_mm > held.stiffness_N_per_mm)) {
            held = wall;
            heldPart = part;
        }
        if (!wall.isHeld && (lostPart == 0 || wall.stiffness_N_per_mm < lost.stiffness_N_per_mm)) {
            lost = wall;
            lostPart = part;
        }
    }
    for (const auto& [wall, at] : {std::pair(held, heldPart), std::pair(lost, lostPart)}) {
        if (at != 0) {
            traces.push_back(traceOf(record, wall, at));
        }
    }
}

void addFriction(SelfTestResult& result)
{
    double sum_N = 0.0, least_N = 0.0, most_N = 0.0;
    int moved = 0;
    for (const SelfTestRamp& ramp : result.ramps) {
        const double force_N = std::abs(ramp.force_N);
        result.frictionBound_N = std::max(result.frictionBound_N, force_N);
        if (ramp.hasMoved) {
            sum_N += force_N;
            least_N = moved == 0 ? force_N : std::min(least_N, force_N);
            most_N = std::max(most_N, force_N);
            ++moved;
        }
    }
    if (moved >= 2) {
        result.friction_N = sum_N / moved;
        result.frictionSpread_N = std::max(most_N - *result.friction_N, *result.friction_N - least_N);
    }
}

} // namespace

SelfTestResult evaluate(const SelfTestRecord& record, const core::TimingSummary& driverLatency)
{
    SelfTestResult result;
    static_cast<SelfTestFacts&>(result) = record;
    result.driverLatency = driverLatency;
    result.limit_N_per_mm = heldStiffness_N_per_mm(record.device, record.rate_Hz, true, record.delayTicks);
    const Samples& samples = record.samples;
    if (samples.size() > 1) {
        result.duration_s = samples.back().time_s;
        result.ticks_per_s = static_cast<double>(samples.size() - 1) / (samples.back().time_s - samples.front().time_s);
    }
    result.rest = restOf(samples, result.rate_Hz);
    if (result.rest) {
        result.rest->resolution_mm = resolutionOf(samples);
    }
    addFriction(result);
    if (result.stopped != SelfTestStop::NoResponse && result.stopped != SelfTestStop::Reversed) {
        result.roundTrip = roundTripOf(record, result.friction_N.value_or(0.0));
    }
    if (result.stopped == SelfTestStop::None || result.lastStep == SelfTestStep::ControlledWalls) {
        result.held_N_per_mm = heldOf(result.walls, false);
    }
    if (result.stopped == SelfTestStop::None) {
        result.heldControlled_N_per_mm = heldOf(result.walls, true);
    }
    for (const bool isControlled : {false, true}) {
        addTraces(result.traces, record, isControlled);
    }
    return result;
}

bool SelfTestResult::isComplete() const noexcept
{
    return rest && friction_N && roundTrip && held_N_per_mm && heldControlled_N_per_mm;
}

bool SelfTestResult::isFailed() const noexcept
{
    return stopped == SelfTestStop::Fault || stopped == SelfTestStop::Cancelled || stopped == SelfTestStop::NoPosition;
}

std::vector<core::Message> unmeasured(const SelfTestResult& result)
{
    std::vector<core::Message> lines;
    if (result.stopped == SelfTestStop::Fault) {
        lines.push_back(text(result.fault));
    } else if (result.stopped != SelfTestStop::None) {
        lines.push_back(text(result.stopped));
    }
    if (!result.rest) {
        lines.push_back(core::Message(PALPATE_TEXT("noise and resolution were not measured")));
    }
    if (!result.friction_N && result.stopped != SelfTestStop::NoMotors) {
        if (result.ramps.empty()) {
            lines.push_back(core::Message(PALPATE_TEXT("friction was not measured: the handle did not rest")));
        } else {
            lines.push_back(core::Message(PALPATE_TEXT("friction was not measured: %1 N did not move the handle"),
                                          core::Rounded{result.frictionBound_N, 2}));
        }
    }
    if (!result.roundTrip && result.stopped != SelfTestStop::NoMotors) {
        lines.push_back(core::Message(PALPATE_TEXT("the round trip was not measured")));
    }
    if ((!result.held_N_per_mm || !result.heldControlled_N_per_mm) && result.stopped != SelfTestStop::NoMotors) {
        lines.push_back(core::Message(PALPATE_TEXT("the held stiffness was not measured")));
    }
    return lines;
}

} // namespace palpate::servo
