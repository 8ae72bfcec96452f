// SPDX-License-Identifier: BSD-3-Clause
// The hard cases felt with a ball.
#include "HardCaseRows.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace palpate::evaluation {

namespace {

constexpr double kFingertip_mm = 1.0;
constexpr std::int64_t kMostTicks = 5000;
constexpr std::int64_t kCheckEvery = 4; // beyond the row's own: the exact ball takes its time

// Open: the product does not hold these with a ball yet. Where the pull goes straight through an edge it stays standing
// on the very top; and which of an edge's two triangles is met, a matter of rounding, can decide where it rolls to.
constexpr std::array<std::string_view, 6> kOpen{"non-manifold fin on a box", "exactly along mesh edges",
                                                "exactly through vertices",  "exactly in the plane of triangles",
                                                "the scene 1e6 mm away",     "the scene scaled by 1e3"};

} // namespace

void addFingertipRows(std::vector<HardCase>& rows)
{
    const std::vector<HardCase> points = rows;
    for (const HardCase& point : points) {
        if (point.isLong || std::find(kOpen.begin(), kOpen.end(), point.name) != kOpen.end()) {
            continue;
        }
        HardCase ball = point;
        ball.fingertip_mm = kFingertip_mm;
        ball.name += formatted(", ball of %g mm", kFingertip_mm);
        if (point.ticks > 4 * kMostTicks) {
            ball.name = formatted("random motion at 300 to 500 mm/s, ball of %g mm", kFingertip_mm);
            ball.ticks = kMostTicks;
        }
        ball.checkEvery *= kCheckEvery;
        rows.push_back(std::move(ball));
    }
}

} // namespace palpate::evaluation
