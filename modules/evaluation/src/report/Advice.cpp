// SPDX-License-Identifier: BSD-3-Clause
#include "report/Advice.h"

#include "report/ChartAxis.h"

#include <palpate/core/Text.h>

#include <algorithm>
#include <utility>

namespace palpate::evaluation {

namespace {

constexpr double kNoError_mm = 1e-6; // bound on the product's residual: smaller errors count as zero
constexpr double kTiny_mm = 3.0;     // too small for anatomy: most likely a file in metres
constexpr double kWorthSaving = 0.1; // fraction of the time

/// Trials of the product on one subject; null if skipped because of the time limit.
struct Found
{
    const Trial* full = nullptr;
    const Trial* onePass = nullptr;
    const Trial* standardRate = nullptr; ///< 1 kHz
    const Trial* fastRate = nullptr;     ///< 4 kHz
    const Trial* ball = nullptr;         ///< median radius
    const Trial* same = nullptr;         ///< fewest triangles without a perceptible difference
    const Trial* half = nullptr;         ///< most triangles among the decimated copies
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
            if (t.pathForcePercent.medianHigh <= kForceJnd_percent / 10.0 && t.popThroughs == 0 &&
                (found.same == nullptr || t.triangles < found.same->triangles)) {
                found.same = &t;
            }
            break;
        }
    }
    return found;
}

/// Median over the paths with its confidence interval: "0.067 (0.05 to 1.5)".
std::string median(const Spread& spread)
{
    const std::string low = shortNumber(spread.medianLow), high = shortNumber(spread.medianHigh);
    return shortNumber(spread.median) + (low == high ? "" : " (" + low + " to " + high + ")");
}

std::string share(std::size_t part, std::size_t of)
{
    return core::grouped(part) + " of " + core::grouped(of) + " ticks in contact" +
           (part > 0 ? " (" + shortNumber(100.0 * static_cast<double>(part) / static_cast<double>(of)) + " %)" : "");
}

/// "99.9 % of them at most 3 µs", using the highest percentile that the number of ticks supports.
std::string tailOfTime(const Trial& t)
{
    const Tail tail = tailOf(t.time_us);
    const std::string value = shortNumber(tail.value) + " µs";
    return std::string(tail.name) == "most" ? "the slowest " + value
                                            : std::string(tail.name) + " of them at most " + value;
}

/// Describes the time saved by a setting relative to `full`. Counts only if the confidence intervals do not overlap.
std::string savedBy(const Trial& other, const Trial& full)
{
    const double saved_us = full.pathTime_us.median - other.pathTime_us.median;
    if (other.pathTime_us.medianHigh < full.pathTime_us.medianLow &&
        saved_us > kWorthSaving * full.pathTime_us.median) {
        return "saves " + shortNumber(saved_us) + " µs a tick";
    }
    return "saves no time beyond the spread between paths";
}

std::string forceError(const Trial& t)
{
    return "99th percentile of the force error within a path: " + median(t.pathForcePercent) + " %";
}

std::string onSolver(const Trial& full)
{
    const SameState& same = full.sameState;
    std::string text = "From the same hand position and state, the result differs from the exact solver in " +
                       share(same.parted, same.ticks);
    if (same.parted > 0) {
        text += ", by at most " + shortNumber(same.parted_mm) + " mm, with a spring longer by at most " +
                shortNumber(same.longer_mm) + " mm";
    }
    text += "; in all other ticks by at most " + shortNumber(same.together_mm) + " mm. ";
    text += "When each solver continues from its own state, the results differ in " +
            share(full.elsewhere, full.position_mm.count);
    if (full.elsewhere > 0) {
        text += ", by a median of " + shortNumber(full.elsewhere_mm.p50) + " mm and at most " +
                shortNumber(full.elsewhere_mm.max) + " mm";
    }
    return text + ". The smallest difference that a hand can notice is " +
           shortNumber(full.spring_mm * kForceJnd_percent / 100.0) + " mm (7 % of the mean force).";
}

std::string onRate(const Trial& slow, const Trial& fast)
{
    std::string text =
        "The servo rate matters more: compared with a hand sampled at 4 kHz, the force held between ticks has a "
        "mean error of " +
        median(slow.pathPosition_mm) + " mm at 1 kHz and " + median(fast.pathPosition_mm) +
        " mm at 4 kHz. At 1 kHz the god-object takes a different path than at 4 kHz in " +
        share(slow.elsewhere, slow.position_mm.count);
    if (slow.elsewhere > 0) {
        text += ", with a distance of " + shortNumber(slow.elsewhere_mm.p50) + " mm (median) and at most " +
                shortNumber(slow.elsewhere_mm.max) + " mm, and a force error of " +
                shortNumber(slow.elsewhereForcePercent.p50) + " % (median) and at most " +
                shortNumber(slow.elsewhereForcePercent.max) + " %";
    }
    return text + ".";
}

std::string onDecimation(const Found& found)
{
    if (found.same != nullptr) {
        return "If memory is limited: reducing the mesh to " + found.same->setting + " " +
               savedBy(*found.same, *found.full) + " and keeps the error below a tenth of the noticeable difference (" +
               forceError(*found.same) + ").";
    }
    if (found.half == nullptr) {
        return {};
    }
    const Spread& percent = found.half->pathForcePercent;
    const std::string off = percent.medianLow > kForceJnd_percent ? "causes an error above the noticeable difference"
                            : percent.medianLow > kForceJnd_percent / 10.0
                                ? "causes an error above a tenth of the noticeable difference"
                                : "causes an error that exceeds a tenth of the noticeable difference on some paths";
    return "Fewer triangles are not recommended: reducing the mesh to " + found.half->setting + " " +
           savedBy(*found.half, *found.full) + " and " + off + " (" + forceError(*found.half) + ").";
}

std::string onBall(const Trial& ball)
{
    return "A fingertip of " + shortNumber(ball.fingertip_mm) + " mm radius instead of a point costs " +
           median(ball.pathTime_us) + " µs a tick, " + tailOfTime(ball) +
           ", and the result differs from the exact ball in " + share(ball.elsewhere, ball.position_mm.count) + ".";
}

/// Explains the intervals in brackets.
std::string onIntervals(const SubjectInfo& subject, const Spread& spread)
{
    if (subject.paths.size() < 2) {
        return "These results come from a single path of the hand; the variation between paths is unknown.";
    }
    return "The numbers are medians of " + std::to_string(subject.paths.size()) + " paths of the hand, with the " +
           shortNumber(100.0 * spread.confidence) + " % confidence interval of the median in brackets.";
}

} // namespace

void markParetoFront(std::vector<Trial>& trials, const std::string& subject)
{
    const auto takesPart = [&](const Trial& t) {
        return t.subject == subject && !t.isReference && t.knob != Knob::Rate && t.knob != Knob::Radius &&
               t.position_mm.count > 0 && t.time_us.count > 0 && t.popThroughs == 0;
    };
    const auto error = [](const Trial& t) { return std::max(kNoError_mm, t.pathPosition_mm.median); };
    for (Trial& t : trials) {
        if (!takesPart(t)) {
            continue;
        }
        t.isParetoOptimal = true;
        for (const Trial& o : trials) {
            // Faster or slower only if the confidence intervals of the medians do not overlap.
            const bool isSlower = o.pathTime_us.medianLow > t.pathTime_us.medianHigh;
            const bool isFaster = o.pathTime_us.medianHigh < t.pathTime_us.medianLow;
            const bool isNoWorse = !isSlower && error(o) <= error(t);
            const bool isBetter = isFaster || error(o) < error(t);
            t.isParetoOptimal = t.isParetoOptimal && !(takesPart(o) && isNoWorse && isBetter);
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
        a.why.push_back("A tick costs " + median(full.pathTime_us) + " µs, " + tailOfTime(full) + ": " +
                        shortNumber(tailOf(full.time_us).value / 10.0) + " % of the 1 ms available. " +
                        shortNumber(static_cast<double>(subject.bytes) / 1e6) + " MB of memory, ready in " +
                        shortNumber(subject.build_ms) + " ms.");
        a.why.push_back(onSolver(full));
        if (found.standardRate != nullptr && found.fastRate != nullptr) {
            a.why.push_back(onRate(*found.standardRate, *found.fastRate));
        }
        if (std::string text = onDecimation(found); !text.empty()) {
            a.why.push_back(std::move(text));
        }
        if (found.onePass != nullptr) {
            a.why.push_back("One pass a tick, as in the paper, " + savedBy(*found.onePass, full) + "; " +
                            forceError(*found.onePass) + ".");
        }
        if (found.ball != nullptr) {
            a.why.push_back(onBall(*found.ball));
        }
        a.why.push_back(onIntervals(subject, full.pathTime_us));
        if (subject.extent_mm < kTiny_mm) {
            a.warning =
                subject.name + " is only " + shortNumber(subject.extent_mm) +
                " mm long. If the coordinates are in metres, run again with --unit m: all lengths below are then "
                "1,000 times larger.";
        }
        advice.push_back(std::move(a));
    }
    return advice;
}

} // namespace palpate::evaluation
