// SPDX-License-Identifier: BSD-3-Clause
#include "CostOnSphere.h"

#include "TrialRun.h"
#include "palpate/evaluation/PaperSolver.h"
#include "palpate/evaluation/ProductSolver.h"
#include "palpate/evaluation/RaySolver.h"
#include "palpate/evaluation/Shapes.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <cmath>

namespace palpate::evaluation {

namespace {

constexpr double kRadius_mm = 50.0, kPress_mm = 45.0;
constexpr int kApproach = 50, kTicks = 2000;
constexpr std::uint32_t kMostForPaper = 100000; // triangles: beyond, a tick of brute force says nothing new

void measure(ReferenceSolver& solver, std::uint32_t triangles, double seconds, std::vector<SizePoint>& points)
{
    const TimeLimit limit(seconds);
    std::vector<double> time_us;
    solver.start(Vec3(0, 0, 1.1 * kRadius_mm));
    for (int i = -kApproach; i < kTicks && !limit.isOver(); ++i) {
        const double a = 2e-3 * std::max(i, 0), r = i < 0 ? kPress_mm - 0.2 * i : kPress_mm;
        const Vec3 hip = r * Vec3(std::sin(a), 0.3 * std::sin(0.7 * a), std::cos(a)).normalized();
        const auto before = core::monotonicNow_ns();
        (void)solver.step(hip);
        if (i >= 0) {
            time_us.push_back(1e-3 * static_cast<double>(core::monotonicNow_ns() - before));
        }
    }
    if (!time_us.empty()) {
        const std::size_t ticks = time_us.size();
        points.push_back({solver.name(), triangles, ticks, percentilesOf(std::move(time_us))});
    }
}

} // namespace

std::vector<SizePoint> costOnSphere(int n, double seconds, double bruteForceSeconds)
{
    std::vector<SizePoint> points;
    const Surface surface(geometry::repair(shapes::bumpySphere(n, kRadius_mm, 0.0)));
    const std::uint32_t triangles = surface.triangleCount();
    ProductSolver product(sceneOf(surface.repaired()), "Palpate");
    measure(product, triangles, seconds, points);
    RaySolver vtk(surface, makeVtkCaster(surface));
    measure(vtk, triangles, seconds, points);
    if (auto caster = makeEmbreeCaster(surface)) {
        RaySolver embree(surface, std::move(caster));
        measure(embree, triangles, seconds, points);
    }
    if (triangles <= kMostForPaper) {
        PaperSolver paper(surface);
        measure(paper, triangles, 0.5 * bruteForceSeconds, points);
    }
    return points;
}

} // namespace palpate::evaluation
