// SPDX-License-Identifier: BSD-3-Clause
#include "reports/ExerciseReport.h"

#include "shared/Console.h"

#include <palpate/core/Quantity.h>

namespace palpate::app {

namespace {

void printTarget(const study::ScoredTarget& one)
{
    if (!one.found_s) {
        print("  %s: missed\n", one.name.c_str());
    } else if (*one.distance_mm > 0.0) {
        print("  %s: found after %.1f s, %.3g mm from the ball around it\n", one.name.c_str(), *one.found_s,
              *one.distance_mm);
    } else {
        print("  %s: found after %.1f s, in the ball around it\n", one.name.c_str(), *one.found_s);
    }
}

} // namespace

void printExercise(const study::ExerciseScore& s)
{
    const std::size_t wrong = s.count(study::FindingVerdict::FalseAlarm);
    const std::size_t late = s.count(study::FindingVerdict::Late);
    print("%zu of %zu target%s found within %.3g mm, %zu missed; %zu false alarm%s\n", s.found(), s.targets.size(),
          s.targets.size() == 1 ? "" : "s", s.within_mm, s.targets.size() - s.found(), wrong, wrong == 1 ? "" : "s");
    for (const study::ScoredTarget& one : s.targets) {
        printTarget(one);
    }
    for (const study::ScoredFinding& one : s.findings) {
        if (one.verdict == study::FindingVerdict::FalseAlarm) {
            print("  %s at %.1f s: false alarm\n", one.finding.name.c_str(), one.marked_s);
        }
    }
    if (late > 0) {
        print("%zu finding%s after the time limit, not counted\n", late, late == 1 ? "" : "s");
    }
    print("time %.3f s", s.duration_s);
    if (s.exercise.time_s) {
        print(" of a limit of %.6g s", *s.exercise.time_s);
    }
    print("\n");
    if (const auto coverage = s.coverage()) {
        print("%.3g %% of %s searched (within %.3g mm)", 100.0 * *coverage,
              core::areaText(s.searched_mm2).english().c_str(), s.coverageDistance_mm);
        if (s.exercise.coverage_goal) {
            print(", goal %.3g %%: %s", 100.0 * *s.exercise.coverage_goal,
                  *coverage >= *s.exercise.coverage_goal ? "reached" : "not reached");
        }
        print("\n");
    }
    print("force: peak %.4g N", s.peakForce_N);
    if (s.above) {
        print("; above the ceiling of %.4g N for %.3f s, impulse above it %.4g N s", *s.exercise.force_ceiling_N,
              s.above->time_s, s.above->impulse_Ns);
    }
    print("\n");
    if (s.lostTicks > 0) {
        print("ticks lost %s\n", grouped(s.lostTicks).c_str());
    }
}

} // namespace palpate::app
