// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <span>

namespace palpate::buried {

/// Stiffness of a press on an organ with lumps relative to the organ without lumps: k/k0 [1].
struct Stiffening
{
    double low = 1.0;      ///< lower bound of the model
    double estimate = 1.0; ///< estimate for compact lumps
    double high = 1.0;     ///< upper bound of the model
    friend bool operator==(const Stiffening&, const Stiffening&) = default;
};

/// Modulus ratio of lump and organ, known as a single value or as a range [1].
struct RatioRange
{
    RatioRange(double ratio) noexcept // NOLINT: a single value is a degenerate range
        : RatioRange(ratio, ratio, ratio)
    {
    }
    RatioRange(double lowest, double most, double highest) noexcept
        : low(lowest)
        , typical(most)
        , high(highest)
    {
    }
    double low, typical, high; ///< > 0, ascending
    [[nodiscard]] bool isRange() const noexcept { return low != high; }
    friend bool operator==(const RatioRange&, const RatioRange&) = default;
};

/// Contribution of a lump to a press: energy share and modulus ratio.
struct LumpShare
{
    double share = 0.0; ///< S, 0 to 1: share of the elastic energy of the press in an organ without lumps
    double ratio = 1.0; ///< rho > 0: modulus of the lump divided by the organ's; infinite: rigid
};

/// Interpolation of the estimate between the bounds: beta = kBeta (1 + S), 0: upper bound, 1: lower bound. 2/5 is exact
/// for a small, deep sphere (Eshelby). The factor 1 + S was fitted to spheres near the surface: the maximum error of
/// k/k0 - 1 is 17 %, compared to 66 % with 2/5 alone (docs/felt.md).
inline constexpr double kBeta = 0.4;

/// Computes bounds and estimate of the stiffness ratio for one lump. Bounds: theorems of minimum complementary and
/// minimum potential energy with the field of the organ without a lump. Estimate: `1 + S (rho - 1) / (1 + beta (1 - S)
/// (rho - 1))`. Model: linear, incompressible half-space with a bonded lump; proof in docs/felt.md.
/// @param share  clamped to 0 to 1
/// @param ratio  > 0; may be infinite
[[nodiscard]] PALPATE_EXPORT Stiffening stiffening(double share, double ratio) noexcept;

/// As above for several lumps that do not overlap: their shares add up.
[[nodiscard]] PALPATE_EXPORT Stiffening stiffening(std::span<const LumpShare> lumps) noexcept;

/// Length scale c of the contact pressure [mm]: the pressure `P c / (2 pi (r^2 + c^2)^(3/2))` is a bell with the
/// stiffness of a flat punch of this radius.
[[nodiscard]] PALPATE_EXPORT double pressureScale(double radius_mm) noexcept;

/// Density w of a press's elastic energy, normalised to 1 over the half-space [1/mm^3].
/// @param r_mm  distance from the press axis
/// @param z_mm  depth below the surface; the density is 0 above
/// @param radius_mm  contact radius of the finger, > 0
[[nodiscard]] PALPATE_EXPORT double pressDensity(double r_mm, double z_mm, double radius_mm) noexcept;

/// @return energy share S of the half-space below a plane [1]
/// @param depth_mm  depth of the plane, >= 0
[[nodiscard]] PALPATE_EXPORT double shareBelow(double depth_mm, double radius_mm) noexcept;

/// @return energy share S of a sphere with its centre on the press axis [1], by quadrature to about 1e-9; only the part
/// below the surface counts.
[[nodiscard]] PALPATE_EXPORT double shareOfSphere(double sphereRadius_mm, double middleDepth_mm, double radius_mm);

/// Decrease in distance between a pressing finger and a point below on the axis [mm]: the indentation minus the
/// displacement of the tissue at that point.
/// @param depth_mm  depth below the undeformed surface; clamped to 0 above
/// @param press_mm  >= 0
[[nodiscard]] PALPATE_EXPORT double approach(double depth_mm, double press_mm, double radius_mm) noexcept;

} // namespace palpate::buried
