// SPDX-License-Identifier: BSD-3-Clause
#include "run/CostOnSphere.h"

#include "cases/Interruptions.h"
#include "palpate/evaluation/PaperSolver.h"
#include "palpate/evaluation/ProductSolver.h"
#include "palpate/evaluation/RaySolver.h"
#include "palpate/evaluation/Shapes.h"
#include "run/TrialRun.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <cmath>

namespace palpate::evaluation {

namespace {

constexpr double kSphere_mm = 50.0, kDepth_mm = 5.0, kStep_mm = 0.1;
constexpr int kApproach = 50, kTicks = 2000, kTurn = 50;
constexpr std::uint32_t kMostForPaper = 100000; // triangles; brute force on larger meshes adds no information

/// One solver and its progress over the sphere.
struct Slide
{
    std::unique_ptr<ReferenceSolver> solver;
    double seconds; ///< remaining time budget
    int tick = -kApproach;
    std::vector<double> time_us;
};

/// @return false when finished
bool advance(Slide& slide)
{
    const TimeLimit limit(slide.seconds);
    const auto started = core::monotonicNow_ns();
    for (int i = 0; i < kTurn && slide.tick < kTicks && !limit.isOver(); ++i, ++slide.tick) {
        const double a = kStep_mm / kSphere_mm * std::max(slide.tick, 0);
        const double r = kSphere_mm - kDepth_mm + 0.2 * std::max(0, -slide.tick);
        const Vec3 hip = r * Vec3(std::sin(a), 0.3 * std::sin(0.7 * a), std::cos(a)).normalized();
        const long interruptionsBefore = interruptions();
        const auto before = core::monotonicNow_ns();
        (void)slide.solver->step(hip);
        const double took_us = 1e-3 * static_cast<double>(core::monotonicNow_ns() - before);
        if (slide.tick >= 0 && interruptions() == interruptionsBefore) {
            slide.time_us.push_back(took_us);
        }
    }
    slide.seconds -= 1e-9 * static_cast<double>(core::monotonicNow_ns() - started);
    return slide.tick < kTicks && slide.seconds > 0.0;
}

/// Runs all slides interleaved and returns their tick times.
std::vector<SizePoint> runInterleaved(std::vector<Slide> slides, std::uint32_t triangles)
{
    for (bool isGoing = true; isGoing;) {
        isGoing = false;
        for (Slide& slide : slides) {
            isGoing = advance(slide) || isGoing;
        }
    }
    std::vector<SizePoint> points;
    for (Slide& slide : slides) {
        if (!slide.time_us.empty()) {
            const std::size_t ticks = slide.time_us.size();
            points.push_back({slide.solver->name(), triangles, ticks, percentilesOf(std::move(slide.time_us))});
        }
    }
    return points;
}

void makeRough(haptics::HapticStructure& on)
{
    on.tissue.friction_static = 0.15;
    on.tissue.friction_dynamic = 0.1;
}

void addLaw(haptics::HapticStructure& on)
{
    on.tissue.law = core::usualLaw(core::LawKind::Exponential);
}

/// Adds a stiffness map with a gradient of 1 % per millimetre across the sphere.
void addMap(haptics::HapticStructure& on)
{
    auto corners = std::make_shared<std::vector<std::array<float, 3>>>(on.surface->triangleCount());
    for (std::uint32_t i = 0; i < corners->size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            (*corners)[i][k] = static_cast<float>(1.0 + 0.01 * on.surface->vertex(on.surface->triangle(i)[k]).x());
        }
    }
    on.maps.stiffness.corners = std::move(corners);
}

/// Adds a buried lump below one side: 30 % stiffer at the surface, twice as stiff at full depth.
void addLump(haptics::HapticStructure& on)
{
    for (std::size_t j = 0; j < on.maps.felt.size(); ++j) {
        auto corners = std::make_shared<std::vector<std::array<float, 3>>>(on.surface->triangleCount());
        const double added = 0.3 + 0.7 * haptics::kFeltPress_mm[j] / haptics::kFeltPress_mm.back();
        for (std::uint32_t i = 0; i < corners->size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const double along = on.surface->vertex(on.surface->triangle(i)[k]).x() / kSphere_mm;
                (*corners)[i][k] = static_cast<float>(1.0 + added * std::exp(-4.0 * (1.0 - along) * (1.0 - along)));
            }
        }
        on.maps.felt[j].corners = std::move(corners);
    }
}

} // namespace

std::vector<SizePoint> costOnSphere(int n, double seconds, double bruteForceSeconds)
{
    const Surface surface(geometry::repair(shapes::bumpySphere(n, kSphere_mm, 0.0), geometry::Facing::AsGiven));
    const std::uint32_t triangles = surface.triangleCount();
    std::vector<Slide> slides;
    const auto add = [&](std::unique_ptr<ReferenceSolver> solver, double limit) {
        solver->start(Vec3(0, 0, 1.1 * kSphere_mm));
        slides.push_back({std::move(solver), limit, -kApproach, {}});
    };
    add(std::make_unique<ProductSolver>(sceneOf(surface.repaired()), "Palpate"), seconds);
    add(std::make_unique<RaySolver>(surface, makeVtkCaster(surface)), seconds);
    if (auto caster = makeEmbreeCaster(surface)) {
        add(std::make_unique<RaySolver>(surface, std::move(caster)), seconds);
    }
    if (triangles <= kMostForPaper) {
        add(std::make_unique<PaperSolver>(surface), bruteForceSeconds);
    }
    return runInterleaved(std::move(slides), triangles);
}

std::vector<SizePoint> costOfTissue(int n, double seconds)
{
    const Surface surface(geometry::repair(shapes::bumpySphere(n, kSphere_mm, 0.0), geometry::Facing::AsGiven));
    const auto plain = sceneOf(surface.repaired());
    using Change = void (*)(haptics::HapticStructure&);
    std::vector<Slide> slides;
    const auto add = [&](const char* name, std::initializer_list<Change> changes) {
        haptics::HapticStructure structure = plain->structures()[0];
        for (const Change change : changes) {
            change(structure);
        }
        const auto scene = std::make_shared<haptics::HapticScene>(std::vector{std::move(structure)});
        auto solver = std::make_unique<ProductSolver>(scene, name);
        solver->start(Vec3(0, 0, 1.1 * kSphere_mm));
        slides.push_back({std::move(solver), seconds, -kApproach, {}});
    };
    add("plain", {});
    add("with friction", {makeRough});
    add("with a law", {addLaw});
    add("with a map", {addMap});
    add("with lumps below", {addLump});
    add("with all", {makeRough, addLaw, addMap});
    return runInterleaved(std::move(slides), surface.triangleCount());
}

std::vector<Ratio> ratiosOf(const std::vector<SizePoint>& sizes)
{
    // Required ratios; the bound for the paper's solver applies to 20,000 triangles.
    constexpr std::size_t kPaperTriangles = 20480;
    std::vector<Ratio> ratios;
    for (const SizePoint& own : sizes) {
        for (const SizePoint& other : sizes) {
            if (own.solver != "Palpate" || other.solver == own.solver || other.triangles != own.triangles ||
                own.time_us.p50 <= 0.0) {
                continue;
            }
            const double wanted = other.solver.starts_with("VTK")                                         ? 5.0
                                  : other.solver == "Embree"                                              ? 1.0
                                  : other.solver.starts_with("paper") && own.triangles == kPaperTriangles ? 1000.0
                                                                                                          : 0.0;
            ratios.push_back({other.solver, own.triangles, other.time_us.p50 / own.time_us.p50, wanted});
        }
    }
    return ratios;
}

} // namespace palpate::evaluation
