// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/TriangleMesh.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace palpate::evaluation {

using core::Vec3;

/// Case in which god-object solvers tend to fail, one row of the table. CONTRIBUTING.md explains how to add a row.
struct HardCase
{
    std::string name;
    std::function<geometry::TriangleMesh()> mesh;
    /// Creates the generator of the HIP path; each call of the generator returns the next HIP. [mm]
    std::function<std::function<Vec3()>()> motion;
    std::int64_t ticks = 0;
    /// Interval in ticks of the comparison with the exact solver; the product's results are checked in every tick.
    std::int64_t checkEvery = 1;
    /// Largest percentage of ticks in which the god-object may rest elsewhere than the exact one; 0: 0.1 %, or 1 % for
    /// a spherical fingertip. Larger values are for paths that jump across the scene in every tick, where the solvers
    /// often reach different local minima.
    double maxElsewhere_percent = 0.0;
    double fingertip_mm = 0.0; ///< fingertip radius, multiplied by `scale`; 0: point contact
    /// Coulomb coefficient, static and dynamic. With friction, a point is compared with the exact solver with friction
    /// and must be within the cone of the constraining facet; a sphere must be within the cone.
    double friction = 0.0;
    /// Scene size relative to one of about 10 mm; bounds in mm are multiplied by this factor.
    double scale = 1.0;
    /// For surfaces without an inside: depth of a point in the region forbidden to the god-object; <= 0 outside. [mm]
    std::function<double(const Vec3&)> intrusion_mm;
    /// Maps mesh and motion for a second run; the results must map into each other. May be empty.
    std::function<Vec3(const Vec3&)> twin;
    double twinBound_mm = 0.0;
    /// Surface in a layer around this one, alternately hidden and shown for `otherEvery` ticks, starting hidden. May
    /// be empty; not mapped by `twin`.
    std::function<geometry::TriangleMesh()> other;
    std::int64_t otherEvery = 0;
    /// Structure in the same layer with a stiffness of `neighbourStiffness_N_per_mm`; the main structure has 0.5 N/mm.
    /// May be empty; not mapped by `twin`.
    std::function<geometry::TriangleMesh()> beside;
    double neighbourStiffness_N_per_mm = 0.5;
    /// With `beside`, on a closed path: bounds on the change of the force per HIP displacement in a tick and on the
    /// absolute work on the hand over the whole path.
    double maxSlope_N_per_mm = 0.0, maxWork_mJ = 0.0;
    /// True if more facets meet at one place than a tick can process: the solver may stop at its iteration limit, and
    /// then only its position is checked.
    bool mayReachBound = false;
    bool isLong = false; ///< reserved for the nightly run
};

/// One requirement of a case, with its measured value.
struct HardCaseFigure
{
    std::string what;
    double measured = 0.0;
    double bound = 0.0;
    std::int64_t worstTick = -1; ///< tick of the largest value, -1 if not tied to a tick
    [[nodiscard]] bool passed() const { return measured <= bound; }
};

/// Figures of one case.
struct HardCaseResult
{
    std::string name;
    std::int64_t ticks = 0;
    std::size_t triangles = 0;
    std::vector<HardCaseFigure> figures;
    std::vector<std::int64_t> iterations; ///< ticks by iteration count; the last entry includes all higher counts

    [[nodiscard]] bool passed() const;
    /// The first failed figure, or else the one closest to its bound; null without figures.
    [[nodiscard]] const HardCaseFigure* tightest() const;
};

/// The table of all cases.
[[nodiscard]] const std::vector<HardCase>& hardCases();

/// Runs the product on a case. Requirements:
/// - no pop-through, no non-finite values, convergence in every tick;
/// - force k (g - p), zero only at the HIP; bit-identical results after restoring a state;
/// - total force equal to the sum over the layers while layers are hidden and shown;
/// - spring at most 1e-3 mm longer than the exact solver's from the same position, residual <= 1e-6 mm;
/// - no jump more than 1e-3 mm larger than the exact solver's;
/// - the same result for the twin.
///
/// Where two structures hold the god-object, the force must be between the forces of either alone, change per tick by
/// at most the row's slope, and do no more work over the closed path than the row allows. A tick in which the
/// god-object rests (by its residual) in another local minimum than the exact one is counted instead, up to 0.1 % or
/// the row's limit. A sphere closer than its radius to a facet that faces its centre counts as a pop-through. Lengths
/// apply to a scene of about 10 mm and scale with its size.
/// @param keepGoing  polled occasionally; return false to cancel
[[nodiscard]] HardCaseResult run(const HardCase& hardCase, const std::function<bool()>& keepGoing = {});

} // namespace palpate::evaluation
