// SPDX-License-Identifier: BSD-3-Clause
#include "reports/MeasuresReport.h"

#include "shared/Console.h"

#include <palpate/core/Numbers.h>
#include <palpate/core/Quantity.h>

#include <optional>
#include <string>

namespace palpate::app {

namespace {

std::string percentText(const std::optional<double>& percent)
{
    return percent ? (*percent < 0.0 ? "" : "+") + core::shortNumber(*percent, 3) + " %" : "none";
}

void printLump(const session::LumpSearch& one)
{
    print("  %s in %s: largest recorded change under the hand %s\n", one.lump.c_str(), one.organ.c_str(),
          percentText(one.recorded_percent).c_str());
    if (!one.predicted_percent) {
        print("    model of felt lumps (felt.md): no prediction, the stiffness ratio is unknown\n");
    } else if (!one.share()) {
        print("    model of felt lumps (felt.md), an estimate: %s predicted; not palpable by hand\n",
              percentText(one.predicted_percent).c_str());
    } else {
        print("    model of felt lumps (felt.md), an estimate: %s predicted; pressed hard enough on %.3g %% "
              "of the %.3g cm² where a trained hand can feel the lump\n",
              percentText(one.predicted_percent).c_str(), 100.0 * *one.share(), 0.01 * one.detectable_mm2);
    }
}

} // namespace

void printMeasures(const session::SessionMeasures& m)
{
    const session::ContactMeasures& all = m.sums.contact;
    print("duration %.3f s, contact %.3f s in %s contact%s\n", m.sums.duration_s, all.time_s,
          grouped(m.sums.contact.contacts).c_str(), m.sums.contact.contacts == 1 ? "" : "s");
    if (m.lostTicks > 0 || m.lateTicks.value_or(0) > 0) {
        print("ticks late %s, lost %s\n", m.lateTicks ? grouped(*m.lateTicks).c_str() : "not stated",
              grouped(m.lostTicks).c_str());
    }
    print("path of the hand %s, on the surface %s\n", core::pathText(m.sums.pathLength_mm).english().c_str(),
          core::pathText(m.sums.contactPath_mm).english().c_str());
    print("force in contact: peak %.4g N, mean %.4g N, median %.4g N, 95th percentile %.4g N\n", all.peakForce_N,
          all.meanForce_N, all.medianForce_N, all.p95Force_N);
    print("depth in contact: peak %.4g mm, mean %.4g mm, 95th percentile %.4g mm\n", all.peakDepth_mm, all.meanDepth_mm,
          all.p95Depth_mm);
    for (const auto kind : {session::Phase::Kind::Search, session::Phase::Kind::Press}) {
        const session::PhaseSummary sum = session::summary(m.phases, kind);
        print("%s: %.3f s in %lld phases, force mean %.4g N, peak %.4g N\n",
              kind == session::Phase::Kind::Search ? "search" : "press", sum.time_s, static_cast<long long>(sum.phases),
              sum.meanForce_N, sum.peakForce_N);
    }
    for (const auto& [name, part] : m.sums.structures) {
        const auto phases = m.structurePhases.find(name);
        const std::int64_t presses = phases == m.structurePhases.end()
                                         ? 0
                                         : session::summary(phases->second, session::Phase::Kind::Press).phases;
        print("  %s: contact %.3f s, pressed %lld times, force of its layer peak %.4g N, mean %.4g N, 95th percentile "
              "%.4g N, peak depth %.4g mm\n",
              name.c_str(), part.time_s, static_cast<long long>(presses), part.peakForce_N, part.meanForce_N,
              part.p95Force_N, part.peakDepth_mm);
    }
    for (const session::SurfaceMeasures& surface : m.surfaces) {
        print("  %s: %.3g %% of %s covered (within %.3g mm), longest dwell at a point %.3f s\n",
              surface.structure.c_str(), 100.0 * surface.coverage(), core::areaText(surface.area_mm2).english().c_str(),
              m.distance_mm, surface.longestDwell_s);
    }
    for (const session::LumpSearch& one : m.lumps) {
        printLump(one);
    }
    for (const session::FindingMeasures& one : m.findings) {
        if (!one.finding.hasPlace) {
            print("  note at %.1f s: %s\n", one.marked_s, one.finding.note.c_str());
            continue;
        }
        print("  finding \"%s\" at (%.1f %.1f %.1f), marked at %.1f s: dwell %.3f s in %lld visits, force mean %.4g N, "
              "peak %.4g N\n",
              one.finding.name.c_str(), one.finding.p_W.x(), one.finding.p_W.y(), one.finding.p_W.z(), one.marked_s,
              one.dwell_s, static_cast<long long>(one.visits), one.meanForce_N, one.peakForce_N);
        for (const core::FindingLayer& layer : one.finding.layers) {
            print("    %s: %.4g N at %.4g mm at the time of marking\n", layer.structure.c_str(), layer.force_N,
                  layer.depth_mm);
        }
    }
}

} // namespace palpate::app
