// SPDX-License-Identifier: BSD-3-Clause
// The hard cases felt with a ball.
#include "HardCaseRows.h"

#include <array>

namespace palpate::evaluation {

namespace {

constexpr std::array kFingertips_mm{0.1, 1.0, 4.0};
constexpr std::int64_t kMostTicks = 5000;
constexpr std::int64_t kCheckEvery = 4; // beyond the row's own: the exact ball takes its time

} // namespace

void addFingertipRows(std::vector<HardCase>& rows)
{
    const std::vector<HardCase> points = rows;
    for (const HardCase& point : points) {
        if (point.isLong) {
            continue;
        }
        for (const double radius_mm : kFingertips_mm) {
            HardCase ball = point;
            ball.fingertip_mm = radius_mm;
            ball.name += formatted(", ball of %g mm", radius_mm);
            if (point.ticks > 4 * kMostTicks) {
                ball.name = formatted("random motion at 300 to 500 mm/s, ball of %g mm", radius_mm);
                ball.ticks = kMostTicks;
            }
            ball.checkEvery *= kCheckEvery;
            rows.push_back(std::move(ball));
        }
    }
}

} // namespace palpate::evaluation
