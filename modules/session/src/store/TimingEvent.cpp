// SPDX-License-Identifier: BSD-3-Clause
#include "store/TimingEvent.h"

namespace palpate::session {

std::string timingJson(const servo::TimingReport& timing, bool isRealtime, std::uint64_t late)
{
    std::string out = "{";
    const auto number = [&out](const char* name, auto value) {
        out += '"';
        out += name;
        out += "\": ";
        out += std::to_string(value);
    };
    const auto summary = [&](const char* name, const core::TimingSummary& s) {
        out += '"';
        out += name;
        out += "\": {";
        number("count", s.count);
        out += ", ";
        number("p50_ns", s.p50_ns);
        out += ", ";
        number("p99_ns", s.p99_ns);
        out += ", ";
        number("p999_ns", s.p999_ns);
        out += ", ";
        number("max_ns", s.max_ns);
        out += "}, ";
    };
    summary("period", timing.period);
    summary("periodError", timing.periodError);
    summary("lateness", timing.lateness);
    summary("latency", timing.latency);
    summary("solve", timing.solve);
    number("ticks", timing.ticks);
    out += ", ";
    number("overruns", timing.overruns);
    out += ", ";
    number("skipped", timing.skipped);
    out += ", ";
    number("late", late);
    out += ", \"realtime\": ";
    out += isRealtime ? "true}" : "false}";
    return out;
}

} // namespace palpate::session
