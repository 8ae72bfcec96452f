// SPDX-License-Identifier: BSD-3-Clause
#include "reports/SessionReport.h"

#include "shared/Console.h"

#include <algorithm>
#include <map>

namespace palpate::app {

void printRecording(const std::filesystem::path& file, const session::RecordingReader& reader)
{
    const session::RecordingInfo& info = reader.info();
    const session::RecordingExtent& extent = reader.extent();
    print("%s: recording of version %d\n", file.string().c_str(), info.version);
    print("  made %s by Palpate %s (%s)\n", info.startedUtc.c_str(), info.palpate.c_str(), info.build.c_str());
    print("  %s\n", session::endingText(extent).english().c_str());
    print("  %s ticks (%lld to %lld) at %g Hz, %.3f s\n", grouped(extent.ticks).c_str(),
          static_cast<long long>(extent.firstTick), static_cast<long long>(extent.lastTick), info.rate_Hz,
          extent.duration_s);
    const std::string late = extent.late ? grouped(*extent.late) + " late, " : std::string();
    print("  %s%s lost between the first and the last\n", late.c_str(), grouped(extent.dropped).c_str());
    print("  device: %s, up to %g N\n", info.device.name.c_str(), info.device.maxForce_N);
    print("  scene: %s, %zu generation%s\n", info.scene.empty() ? "not stated" : info.scene.c_str(),
          reader.scenes().size(), reader.scenes().size() == 1 ? "" : "s");
    if (!reader.scenes().empty()) {
        constexpr std::size_t kShown = 4;
        const auto& structures = reader.scenes().front().structures;
        for (std::size_t i = 0; i < std::min(kShown, structures.size()); ++i) {
            const session::StructureRecord& structure = structures[i];
            print("    %s: %g N/mm, %g N s/mm, layer %u%s%s, geometry %.12s\n", structure.name.c_str(),
                  structure.tissue.stiffness_N_per_mm, structure.tissue.damping_Ns_per_mm, structure.layer,
                  structure.palpable ? "" : ", not palpable", structure.motion == nullptr ? "" : ", moving",
                  structure.source.sha256.c_str());
        }
        if (structures.size() > kShown) {
            print("    and %zu more\n", structures.size() - kShown);
        }
    }
    std::map<std::string, int> kinds;
    for (const session::RecordingEvent& event : reader.events()) {
        ++kinds[event.kind];
    }
    std::string list;
    for (const auto& [kind, count] : kinds) {
        list += (list.empty() ? "" : ", ") + std::to_string(count) + " " + kind;
    }
    print("  events: %s\n", list.empty() ? "none" : list.c_str());
}

int reportDamage(const std::filesystem::path& file, const std::vector<core::Message>& faults, int code)
{
    constexpr std::size_t kShown = 10;
    if (faults.empty()) {
        return code;
    }
    if (faults.size() == 1) {
        printError(PALPATE_TEXT("%1: DAMAGED, or changed after it was recorded, in 1 place: ticks that do not match "
                                "their checksum were left out, and figures are those of the rest"),
                   file);
    } else {
        printError(PALPATE_TEXT("%1: DAMAGED, or changed after it was recorded, in %2 places: ticks that do not match "
                                "their checksum were left out, and figures are those of the rest"),
                   file, core::Count(faults.size()));
    }
    for (std::size_t i = 0; i < std::min(kShown, faults.size()); ++i) {
        printError(PALPATE_TEXT("%1: %2"), file, faults[i]);
    }
    if (faults.size() > kShown) {
        printError(PALPATE_TEXT("%1: and %2 more"), file, core::Count(faults.size() - kShown));
    }
    return code == kDone ? kSomeLost : code;
}

int reportAgreement(const std::filesystem::path& file, const session::RecordingInfo& info,
                    const session::Resimulation& again)
{
    const std::string ticks = grouped(again.compared);
    if (again.isSame()) {
        print("%s ticks computed again: every god-object and force is the same bit for bit\n", ticks.c_str());
        return kDone;
    }
    const std::string here = session::buildId();
    if (!again.isWithinRounding()) {
        info.build == here ? printError(PALPATE_TEXT("%1: %2; recorded by this build (%3)"), file, again.beyond, here)
                           : printError(PALPATE_TEXT("%1: %2; recorded by another build (%3), this one is %4"), file,
                                        again.beyond, info.build, here);
        return kFailed;
    }
    if (info.build == here && session::isExactBuild(here)) {
        printError(PALPATE_TEXT("%1: %2; recorded by this build (%3), which should give the same bits"), file,
                   again.difference, here);
        return kFailed;
    }
    const std::string builds = info.build == here
                                   ? "; recorded by this build (" + here + ")"
                                   : "; recorded by another build (" + info.build + "), this one is " + here;
    print("%s ticks computed again: %s differ, by rounding: by at most %.2g mm (up to %.2g mm is rounding) and %.2g N, "
          "first at %s%s\n",
          ticks.c_str(), grouped(again.differing).c_str(), again.farthest_mm, again.rounding_mm, again.farthest_N,
          again.difference.english().c_str(), builds.c_str());
    return kDone;
}

} // namespace palpate::app
