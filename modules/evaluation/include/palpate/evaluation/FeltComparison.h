// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/buried/Stiffening.h>
#include <palpate/core/Status.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// What buried::stiffening says of lumps below a press, held against solutions that share nothing with it: the exact
/// punch on a layer and finite elements. Lengths are in radii of the contact, stiffness by that without a lump (k/k0).
namespace palpate::evaluation::felt {

/// A half-space of another modulus below a layer.
struct LayerCase
{
    double thickness = 0.0, ratio = 0.0; ///< an infinite ratio: rigid
    double exact = 0.0;                  ///< k/k0 of the punch, layeredPunch
    double punch = 0.0, bell = 0.0;      ///< k/k0 by the elements
    buried::Stiffening model;            ///< with the bell's share
};

/// A sphere under a cover.
struct SphereCase
{
    double sphereRadius = 0.0, cover = 0.0, ratio = 0.0;
    double share = 0.0;                       ///< S by the model's density, of the bell
    double shareOfBell = 0.0;                 ///< the same by the elements
    double shareOfPunch = 0.0;                ///< what it is under the punch's own pressure
    double bell = 0.0, punch = 0.0;           ///< k/k0 by the elements
    buried::Stiffening model, modelWithPunch; ///< with `share`, with `shareOfPunch`
};

struct Comparison
{
    std::vector<LayerCase> layers;
    std::vector<SphereCase> spheres;
    std::size_t elements = 0; ///< of the largest case
    double farError = 0.0;    ///< largest error of the elements' stiffness without a lump [1]
    double duration_s = 0.0;
    bool isQuick = false, isWhole = true; ///< not whole when it was cancelled: what is there is right
};

struct Options
{
    bool isQuick = false; ///< 30 spheres instead of 100
    /// Told the share done, 0 … 1, and what is being done; false cancels. May be empty. On the calling thread.
    std::function<bool(double, const std::string&)> progress;
};

/// Solves all cases on all cores; the same result whatever their number.
[[nodiscard]] Comparison compare(const Options& options);

/// @return whether a stiffness is not outside of the bounds
[[nodiscard]] bool isWithin(const buried::Stiffening& bounds, double stiffness) noexcept;
/// @return |(estimate - 1) / (truth - 1) - 1|: the error of what is felt of a lump
[[nodiscard]] double excessError(double estimate, double truth) noexcept;

/// Largest and median; 0 of nothing.
struct Spread
{
    double largest = 0.0, median = 0.0;
};
[[nodiscard]] Spread spreadOf(std::vector<double> values);

/// What must hold: how often it does.
struct Verdict
{
    std::size_t bellWithin = 0;       ///< spheres whose k/k0 under the bell is within the bounds
    std::size_t punchWithinOwn = 0;   ///< under the punch, within those of the punch's own share
    std::size_t punchWithinBell = 0;  ///< under the punch, within those of the bell's share: need not hold
    double layerError = 0.0;          ///< largest error of the elements on layers [1]
    double shareError = 0.0;          ///< largest difference of the bell's shares [1]
    Spread bell, punchOwn, punchBell; ///< excessError of the estimates
    [[nodiscard]] bool isProved(std::size_t spheres) const;
};
[[nodiscard]] Verdict verdictOf(const Comparison& comparison);

/// `felt.html` (self-contained), `felt.csv`, a row a case, and the figures `felt-cover.svg` and `felt-estimate.svg` in
/// a folder that is there; each file appears only when it is whole.
[[nodiscard]] core::Status writeReport(const std::filesystem::path& folder, const Comparison& comparison);
[[nodiscard]] std::string html(const Comparison& comparison);
[[nodiscard]] std::string csv(const Comparison& comparison);

} // namespace palpate::evaluation::felt
