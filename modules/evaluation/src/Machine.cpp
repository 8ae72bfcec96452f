// SPDX-License-Identifier: BSD-3-Clause
#include "Machine.h"

#include "SvgChart.h"

#include <palpate/session/Recording.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <thread>

namespace palpate::evaluation {

namespace {

constexpr double kNoError_mm = 1e-6; // the bound on the product's residual: less counts as none

constexpr double kTiny_mm = 3.0; // no anatomy to touch: most likely a file in metres

std::string processorName()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return "unknown processor";
}

} // namespace

Machine thisMachine()
{
    Machine machine;
    machine.cpu = processorName();
#ifdef __clang__
    machine.compiler = "clang " __clang_version__;
#else
    machine.compiler = "gcc " __VERSION__;
#endif
    machine.build = session::buildId();
    machine.cores = static_cast<int>(std::thread::hardware_concurrency());
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm utc{};
    gmtime_r(&now, &utc);
    char stamp[32];
    std::strftime(stamp, sizeof stamp, "%Y-%m-%dT%H:%M:%SZ", &utc);
    machine.startedUtc = stamp;
    return machine;
}

void markFront(std::vector<Trial>& trials, const std::string& subject)
{
    const auto takesPart = [&](const Trial& t) {
        return t.subject == subject && !t.isReference && t.knob != Knob::Rate && t.position_mm.count > 0 &&
               t.popThroughs == 0;
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
        const Trial* full = nullptr;
        const Trial* cheapest = nullptr; // fewest triangles that feel the same
        const Trial* half = nullptr;     // most triangles of the decimated ones
        for (const Trial& t : evaluation.trials) {
            if (t.subject != subject.name || t.solver != "Palpate" || t.position_mm.count == 0) {
                continue;
            }
            if (t.knob == Knob::Solver) {
                full = &t;
            } else if (t.knob == Knob::Decimated) {
                half = half == nullptr || t.triangles > half->triangles ? &t : half;
                if (t.forcePercent.count > 0 && t.forcePercent.p99 <= kForceJnd_percent / 10.0 && t.popThroughs == 0 &&
                    (cheapest == nullptr || t.triangles < cheapest->triangles)) {
                    cheapest = &t;
                }
            }
        }
        if (full == nullptr) {
            continue;
        }
        Advice a;
        a.subject = subject.name;
        a.setting = "All " + std::to_string(full->triangles) + " triangles, 1 kHz, converged within the tick";
        a.why = "Costs " + shortNumber(full->time_us.p50) + " µs a tick (99.9 % within " +
                shortNumber(full->time_us.p999) + " µs, " + shortNumber(full->time_us.p999 / 10.0) +
                " % of the 1 ms there is) and " + shortNumber(static_cast<double>(subject.bytes) / 1e6) +
                " MB. Position error " + shortNumber(full->position_mm.p50) + " mm, 99 % within " +
                shortNumber(full->position_mm.p99) + " mm. ";
        const Trial* other = cheapest != nullptr ? cheapest : half;
        if (other != nullptr) {
            const double saved_us = full->time_us.p50 - other->time_us.p50;
            const std::string effect =
                other->setting + (saved_us > 0.02 * full->time_us.p50 ? " save " + shortNumber(saved_us) + " µs"
                                                                      : std::string(" save no time"));
            const bool isBelowJnd = other->forcePercent.p99 <= kForceJnd_percent;
            a.why += cheapest != nullptr ? "Where memory is short: " + effect + " and stay below a tenth of"
                     : isBelowJnd        ? "Decimating is not worth it: " + effect + " and cost more than a tenth of"
                                         : "Decimating is not worth it: " + effect + " and cost more than";
            a.why += " what a hand can tell: " + shortNumber(other->position_mm.p50) + " mm or " +
                     shortNumber(other->forcePercent.p50) + " % of the force as a rule, " +
                     shortNumber(other->forcePercent.p99) + " % in the worst hundredth of the ticks.";
        }
        if (subject.extent_mm < kTiny_mm) {
            a.why += " It is only " + shortNumber(subject.extent_mm) +
                     " mm long: if its numbers are metres, run again with --unit m.";
        }
        advice.push_back(std::move(a));
    }
    return advice;
}

} // namespace palpate::evaluation
