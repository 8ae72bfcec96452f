// SPDX-License-Identifier: BSD-3-Clause
// Hard cases with a spherical fingertip.
#include "cases/HardCaseRows.h"

#include "palpate/evaluation/Shapes.h"

#include <array>

namespace palpate::evaluation {

namespace {

constexpr std::array kFingertips_mm{0.1, 1.0, 4.0};
constexpr std::int64_t kMostTicks = 5000;
constexpr std::int64_t kCheckEvery = 4; // in addition to the row's own interval, because the exact sphere is slow

/// Adds spheres much larger than the facets: many facets are in contact at once, and only iteration limits bound the
/// work.
void addLargeBallRows(std::vector<HardCase>& rows)
{
    for (const double radius_mm : {4.0, 10.0, 20.0}) {
        const double over = 50.0 + radius_mm;
        HardCase ball = row(
            formatted("bumpy sphere of 45,000 facets, ball of %g mm", radius_mm),
            [] { return shapes::bumpySphere(47, 50.0, 0.02); },
            HandPath({0.1, 0.2, over + 2})
                .to({0.1, 0.2, over - 2}, 0.2)
                .to({0.2 * over, 0.1 * over, 0.95 * over}, 0.1) // 100 mm/s, about 2 mm deep
                .to({0.1 * over, -0.1 * over, 0.85 * over}, 0.3)
                .to({0.15 * over, 0.1 * over, 0.97 * over}, 0.1)
                .to({0, 0, over + 2}, 0.5));
        ball.fingertip_mm = radius_mm;
        ball.checkEvery = 50;
        rows.push_back(std::move(ball));
    }
    // At a depth equal to its radius, a sphere can rotate about the HIP: all surrounding places are equally close.
    for (const double radius_mm : {1.0, 4.0, 20.0}) {
        const auto mesh = [] { return shapes::bumpySphere(20, 20.0, 0.0); };
        RandomSource dice(95);
        HandPath path({0.1, 0.2, 25.0 + radius_mm});
        const geometry::TriangleMesh sphere = mesh();
        for (std::size_t i = 0; i < 150; ++i) {
            const geometry::Triangle& t = sphere.triangles[(37 * (i / 5)) % sphere.triangles.size()];
            const Vec3 &a = sphere.vertices[t[0]], &b = sphere.vertices[t[1]];
            path.jump((i % 3 == 0 ? a : i % 3 == 1 ? Vec3(0.5 * (a + b)) : Vec3(a + 1e-5 * dice.normal3())));
        }
        HardCase ball =
            row(formatted("HIPs on the vertices of a sphere of 8,000 facets, ball of %g mm", radius_mm), mesh, path);
        ball.fingertip_mm = radius_mm;
        // The exact sphere converges slowly here (minutes at 20 mm, half a minute at 4 mm); the adversary covers those
        // positions.
        ball.checkEvery = radius_mm > 4.0 ? 1000 : radius_mm > 1.0 ? 100 : 50;
        ball.maxElsewhere_percent = 100.0;
        ball.mayReachBound = true; // for a large sphere, whose cell holds a thousand facets, at each jump
        rows.push_back(std::move(ball));
    }
}

} // namespace

void addFingertipRows(std::vector<HardCase>& rows)
{
    const std::vector<HardCase> points = rows;
    for (const HardCase& point : points) {
        if (point.isLong || point.fingertip_mm > 0.0) {
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
    addLargeBallRows(rows);
}

} // namespace palpate::evaluation
