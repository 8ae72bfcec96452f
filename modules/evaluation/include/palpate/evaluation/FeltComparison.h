// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/buried/Stiffening.h>
#include <palpate/core/Status.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// Validation of buried::stiffening for lumps below a press against two independent solutions: the exact punch on a
/// layer and finite elements. Lengths are in contact radii; stiffness is relative to that without a lump (k/k0).
namespace palpate::evaluation::felt {

/// Layer on a half-space of another modulus.
struct LayerCase
{
    double thickness = 0.0, ratio = 0.0; ///< ratio: infinite for a rigid half-space
    double exact = 0.0;                  ///< k/k0 of the punch by layeredPunch
    double punch = 0.0, bell = 0.0;      ///< k/k0 by finite elements
    buried::Stiffening model;            ///< computed from the bell's energy share
};

/// Sphere below a cover.
struct SphereCase
{
    double sphereRadius = 0.0, cover = 0.0, ratio = 0.0;
    double share = 0.0;                       ///< energy share S of the bell by the model's density
    double shareOfBell = 0.0;                 ///< energy share of the bell by finite elements
    double shareOfPunch = 0.0;                ///< energy share under the pressure of the punch
    double bell = 0.0, punch = 0.0;           ///< k/k0 by finite elements
    buried::Stiffening model, modelWithPunch; ///< from `share` and from `shareOfPunch`
};

/// Results of all cases.
struct Comparison
{
    std::vector<LayerCase> layers;
    std::vector<SphereCase> spheres;
    std::size_t elements = 0; ///< in the largest case
    double farError = 0.0;    ///< largest error of the finite-element stiffness without a lump [1]
    double duration_s = 0.0;
    bool isQuick = false, isWhole = true; ///< isWhole: false after cancelling; the results present are valid
};

/// Extent of a comparison.
struct Options
{
    bool isQuick = false; ///< 30 spheres instead of 100
    /// Progress callback: fraction done (0 to 1) and current activity. Return false to cancel. May be empty. Called on
    /// the calling thread.
    std::function<bool(double, const std::string&)> progress;
};

/// Solves all cases on all cores. The result does not depend on the number of cores.
[[nodiscard]] Comparison compare(const Options& options);

/// @return true if `stiffness` is within the bounds
[[nodiscard]] bool isWithin(const buried::Stiffening& bounds, double stiffness) noexcept;
/// @return |(estimate - 1) / (truth - 1) - 1|: the relative error of the excess stiffness caused by the lump
[[nodiscard]] double excessError(double estimate, double truth) noexcept;

/// Maximum and median; both 0 for an empty series.
struct Spread
{
    double largest = 0.0, median = 0.0;
};
[[nodiscard]] Spread spreadOf(std::vector<double> values);

/// Counts and errors that the validation checks.
struct Verdict
{
    std::size_t bellWithin = 0;       ///< spheres whose k/k0 under the bell is within the bounds
    std::size_t punchWithinOwn = 0;   ///< under the punch, within the bounds from the punch's own share
    std::size_t punchWithinBell = 0;  ///< under the punch, within the bounds from the bell's share; not required
    double layerError = 0.0;          ///< largest finite-element error on layers [1]
    double shareError = 0.0;          ///< largest difference between the bell's shares [1]
    Spread bell, punchOwn, punchBell; ///< excessError of the estimates
    [[nodiscard]] bool isProved(std::size_t spheres) const;
};
[[nodiscard]] Verdict verdictOf(const Comparison& comparison);

/// Writes `felt.html` (self-contained), `felt.csv` (one row per case) and the figures `felt-cover.svg` and
/// `felt-estimate.svg` to an existing folder. Files are replaced atomically.
[[nodiscard]] core::Status writeReport(const std::filesystem::path& folder, const Comparison& comparison);
/// Content of the individual files.
[[nodiscard]] std::string html(const Comparison& comparison);
[[nodiscard]] std::string csv(const Comparison& comparison);

} // namespace palpate::evaluation::felt
