// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/TriangleMesh.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace palpate::evaluation {

using core::Vec3;

/// A case in which god-object solvers fail: one row of a table. CONTRIBUTING.md says how to add one.
struct HardCase
{
    std::string name;
    std::function<geometry::TriangleMesh()> mesh;
    /// Makes the source of the hand's path, one HIP a call. [mm]
    std::function<std::function<Vec3()>()> motion;
    std::int64_t ticks = 0;
    /// Compares with the exact solver at every so many ticks; what the product gives is checked at each.
    std::int64_t checkEvery = 1;
    /// In how many ticks it may rest elsewhere than the exact solver; 0 means 0.1 %, of a ball 1 %. More is for paths
    /// that jump across the scene in each tick: there ways part all the time.
    double mostElsewhere_percent = 0.0;
    double fingertip_mm = 0.0; ///< radius of the ball that touches, which grows with `scale`; 0 is a point
    /// Coulomb's mu, at rest and sliding. With it a point is compared with the exact solver with friction, and must be
    /// within the cone of the facet that holds it; a ball must be within the cone.
    double friction = 0.0;
    /// How large the scene is compared with one of some 10 mm, where bounds in mm must grow with it.
    double scale = 1.0;
    /// For surfaces without an inside: how deep a point lies where the god-object must never be; <= 0 elsewhere. [mm]
    std::function<double(const Vec3&)> intrusion_mm;
    /// The case again with mesh and motion mapped by this; the answers must map into each other. May be empty.
    std::function<Vec3(const Vec3&)> twin;
    double twinBound_mm = 0.0;
    /// A surface in a layer around this one, hidden and shown in turns of `otherEvery` ticks, hidden at first. May be
    /// empty; not mapped by `twin`.
    std::function<geometry::TriangleMesh()> other;
    std::int64_t otherEvery = 0;
    /// A structure in the same layer that is felt with `besideStiffness_N_per_mm`, where this one has 0.5 N/mm.
    /// May be empty; not mapped by `twin`.
    std::function<geometry::TriangleMesh()> beside;
    double besideStiffness_N_per_mm = 0.5;
    /// With `beside`, on a path that ends where it began: by how much the force may change by the hand's way in a tick,
    /// and how much work the hand may get or give on the whole path.
    double mostSlope_N_per_mm = 0.0, mostWork_mJ = 0.0;
    /// More facets meet in one place than a tick has work for: it may stop at its bound, where only its place is
    /// judged.
    bool mayReachBound = false;
    bool isLong = false; ///< left to the nightly run
};

/// One thing that is required of a case.
struct HardCaseFigure
{
    std::string what;
    double measured = 0.0;
    double bound = 0.0;
    std::int64_t worstTick = -1; ///< where it was measured, -1 when nowhere in particular
    [[nodiscard]] bool passed() const { return measured <= bound; }
};

struct HardCaseResult
{
    std::string name;
    std::int64_t ticks = 0;
    std::size_t triangles = 0;
    std::vector<HardCaseFigure> figures;
    std::vector<std::int64_t> iterations; ///< how many ticks took i iterations; the last entry holds all above

    [[nodiscard]] bool passed() const;
    /// The first figure that fails, else the one nearest to its bound; null without figures.
    [[nodiscard]] const HardCaseFigure* tightest() const;
};

/// All rows.
[[nodiscard]] const std::vector<HardCase>& hardCases();

/// Runs the product on a case. Required: no pop-through, nothing non-finite, converged in every tick, the force k (g -
/// p) and none only at the HIP, the same bits after a restored state, the layers' forces added up whichever come and
/// go, the spring never more than 1e-3 mm longer than the exact solver's from the same place, residual <= 1e-6 mm, no
/// jump larger than the exact solver's by more than 1e-3 mm, and the twin's answer the same. Where two structures hold
/// the god-object, the force lies between what either would answer alone, no tick changes it by more than the row's
/// slope, and the closed path makes or takes no more work than the row says. Where it rests (residual)
/// in another local minimum than the exact solver, that tick is counted instead: at most 0.1 %, or what the row says. A
/// ball that is nearer than its radius to what faces its centre counts as a pop-through. Lengths are for a scene of
/// some 10 mm and scale with it.
/// @param keepGoing  asked now and then; false cancels
[[nodiscard]] HardCaseResult run(const HardCase& hardCase, const std::function<bool()>& keepGoing = {});

} // namespace palpate::evaluation
