// SPDX-License-Identifier: BSD-3-Clause
#include "Advice.h"

#include "ChartAxis.h"

#include <palpate/core/Text.h>

#include <algorithm>

namespace palpate::evaluation {

namespace {

constexpr double kNoError_mm = 1e-6; // the bound on the product's residual: less counts as none
constexpr double kTiny_mm = 3.0;     // no anatomy to touch: most likely a file in metres
constexpr double kWorthSaving = 0.1; // of the time: less is noise

/// The product's trials on one subject; null where there was no time for one.
struct Found
{
    const Trial* full = nullptr;
    const Trial* onePass = nullptr;
    const Trial* standardRate = nullptr; ///< 1 kHz
    const Trial* fastRate = nullptr;     ///< 4 kHz
    const Trial* ball = nullptr;         ///< the middle one
    const Trial* same = nullptr;         ///< fewest triangles that feel the same
    const Trial* half = nullptr;         ///< most triangles of the decimated ones
};

Found find(const Evaluation& evaluation, const std::string& subject)
{
    Found found;
    std::vector<const Trial*> balls; // by radius
    for (const Trial& t : evaluation.trials) {
        if (t.subject != subject || t.solver != "Palpate" || t.position_mm.count == 0) {
            continue;
        }
        switch (t.knob) {
        case Knob::Solver:
            found.full = &t;
            break;
        case Knob::OnePass:
            found.onePass = &t;
            break;
        case Knob::Rate:
            found.standardRate = t.rate_Hz == 1000.0 ? &t : found.standardRate;
            found.fastRate = t.rate_Hz == 4000.0 ? &t : found.fastRate;
            break;
        case Knob::Radius:
            balls.push_back(&t);
            found.ball = balls[balls.size() / 2];
            break;
        case Knob::Decimated:
            found.half = found.half == nullptr || t.triangles > found.half->triangles ? &t : found.half;
            if (t.forcePercent.count > 0 && t.forcePercent.p99 <= kForceJnd_percent / 10.0 && t.popThroughs == 0 &&
                (found.same == nullptr || t.triangles < found.same->triangles)) {
                found.same = &t;
            }
            break;
        }
    }
    return found;
}

std::string savedBy(const Trial& other, const Trial& full)
{
    const double saved_us = full.time_us.p50 - other.time_us.p50;
    return saved_us > kWorthSaving * full.time_us.p50 ? "saves " + shortNumber(saved_us) + " µs a tick"
                                                      : std::string("saves no time");
}

std::string forceError(const Trial& t)
{
    return shortNumber(t.forcePercent.p50) + " % of the force as a rule, " + shortNumber(t.forcePercent.p99) +
           " % in the worst hundredth of the ticks";
}

std::string onDecimation(const Found& found)
{
    if (found.same != nullptr) {
        return "Where memory is short: going down to " + found.same->setting + " " + savedBy(*found.same, *found.full) +
               " and stays below a tenth of what a hand can tell (" + forceError(*found.same) + ").";
    }
    if (found.half == nullptr) {
        return {};
    }
    const bool isBelow = found.half->forcePercent.p99 <= kForceJnd_percent;
    return "Fewer triangles are not worth it: going down to " + found.half->setting + " " +
           savedBy(*found.half, *found.full) + " and is off by " + (isBelow ? "more than a tenth of" : "more than") +
           " what a hand can tell (" + forceError(*found.half) + ").";
}

} // namespace

void markFront(std::vector<Trial>& trials, const std::string& subject)
{
    const auto takesPart = [&](const Trial& t) {
        return t.subject == subject && !t.isReference && t.knob != Knob::Rate && t.knob != Knob::Radius &&
               t.position_mm.count > 0 && t.time_us.count > 0 && t.popThroughs == 0;
    };
    const auto error = [](const Trial& t) { return std::max(kNoError_mm, t.position_mm.mean); };
    for (Trial& t : trials) {
        if (!takesPart(t)) {
            continue;
        }
        t.isOnFront = true;
        for (const Trial& o : trials) {
            const bool isNoWorse = o.time_us.p50 <= t.time_us.p50 && error(o) <= error(t);
            const bool isBetter = o.time_us.p50 < t.time_us.p50 || error(o) < error(t);
            t.isOnFront = t.isOnFront && !(takesPart(o) && isNoWorse && isBetter);
        }
    }
}

std::vector<Advice> adviceFor(const Evaluation& evaluation)
{
    std::vector<Advice> advice;
    for (const SubjectInfo& subject : evaluation.subjects) {
        const Found found = find(evaluation, subject.name);
        if (found.full == nullptr) {
            continue;
        }
        const Trial& full = *found.full;
        Advice a;
        a.subject = subject.name;
        a.setting = "All " + core::grouped(full.triangles) + " triangles, 1 kHz, converged within the tick";
        a.why.push_back("A tick costs " + shortNumber(full.time_us.p50) + " µs, 99.9 % of them at most " +
                        shortNumber(full.time_us.p999) + " µs: " + shortNumber(full.time_us.p999 / 10.0) +
                        " % of the 1 ms there is. " + shortNumber(static_cast<double>(subject.bytes) / 1e6) +
                        " MB of memory, ready in " + shortNumber(subject.build_ms) + " ms.");
        a.why.push_back("The god-object is at most " + shortNumber(full.position_mm.p99) +
                        " mm from the exact one in 99 % of the ticks; a hand can tell from " +
                        shortNumber(full.spring_mm * kForceJnd_percent / 100.0) + " mm on (7 % of the mean force).");
        if (found.standardRate != nullptr && found.fastRate != nullptr) {
            a.why.push_back("What is left is the servo rate: the force held between ticks lags by " +
                            shortNumber(found.standardRate->position_mm.mean) + " mm at 1 kHz, by " +
                            shortNumber(found.fastRate->position_mm.mean) + " mm at 4 kHz.");
        }
        if (std::string text = onDecimation(found); !text.empty()) {
            a.why.push_back(std::move(text));
        }
        if (found.onePass != nullptr) {
            a.why.push_back("One pass a tick, as in the paper, " + savedBy(*found.onePass, full) + " and is off by " +
                            forceError(*found.onePass) + ".");
        }
        if (found.ball != nullptr) {
            const Trial& ball = *found.ball;
            a.why.push_back("A fingertip of " + shortNumber(ball.fingertip_mm) +
                            " mm radius instead of a point costs " + shortNumber(ball.time_us.p50) +
                            " µs a tick, 99.9 % of them at most " + shortNumber(ball.time_us.p999) + " µs, the worst " +
                            shortNumber(ball.time_us.max) + " µs, and is at most " + shortNumber(ball.position_mm.p99) +
                            " mm from the exact ball in 99 % of them.");
        }
        if (subject.extent_mm < kTiny_mm) {
            a.warning = subject.name + " is only " + shortNumber(subject.extent_mm) +
                        " mm long. If its numbers are metres, run again with --unit m: all lengths below are then "
                        "1,000 times larger.";
        }
        advice.push_back(std::move(a));
    }
    return advice;
}

} // namespace palpate::evaluation
