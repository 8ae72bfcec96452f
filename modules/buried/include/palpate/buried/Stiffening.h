// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace palpate::buried {

/// By how much a lump changes the stiffness that a press meets: k/k0, k0 that of the organ without lumps [1].
struct Stiffening
{
    double low = 1.0;      ///< never less under the model
    double estimate = 1.0; ///< for compact lumps
    double high = 1.0;     ///< never more under the model
    friend bool operator==(const Stiffening&, const Stiffening&) = default;
};

/// How many times as stiff as its organ a lump is, where only a range is known [1].
struct RatioRange
{
    RatioRange(double ratio) noexcept // NOLINT: a known ratio is a range of one number
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

/// What takes part in a press: a lump's share of the elastic energy, and how stiff it is.
struct LumpShare
{
    double share = 0.0; ///< S, 0 … 1: of the press's energy in an organ without lumps
    double ratio = 1.0; ///< rho > 0: the lump's modulus by the organ's; infinite: rigid
};

/// The estimate lies between the bounds by beta = kBeta (1 + S), 0: high, 1: low. 2/5 makes it exact for a small, deep
/// sphere (Eshelby); 1 + S was fitted to spheres near the surface: with 2/5 alone up to 66 % of k/k0 - 1 is wrong, with
/// it 17 % (resources/docs/felt.md).
inline constexpr double kBeta = 0.4;

/// Low and high: the theorems of least complementary and least potential energy with the field of the organ without a
/// lump. Estimate: `1 + S (rho - 1) / (1 + beta (1 - S) (rho - 1))`.
/// Model: linear, incompressible, a half-space, the lump bonded to it. resources/docs/felt.md has the proof.
/// @param share  0 … 1 (beyond: as these); @param ratio  > 0; may be infinite
[[nodiscard]] Stiffening stiffening(double share, double ratio) noexcept;

/// The same of several lumps that do not overlap: their shares add.
[[nodiscard]] Stiffening stiffening(std::span<const LumpShare> lumps) noexcept;

/// The finger's size in the model [mm]: its pressure is `P c / (2 pi (r^2 + c^2)^(3/2))` with this c, a bell as stiff
/// as a flat punch of the radius.
[[nodiscard]] double bellOf(double radius_mm) noexcept;

/// w: the share of a press's elastic energy that a place holds [1/mm^3]; over the half-space it integrates to 1.
/// @param r_mm  from the axis of the press; @param z_mm  below the surface; 0 above it
/// @param radius_mm  of the finger's contact, > 0
[[nodiscard]] double pressDensity(double r_mm, double z_mm, double radius_mm) noexcept;

/// @return S of all that lies deeper than a plane [1]. @param depth_mm  of the plane, >= 0
[[nodiscard]] double shareBelow(double depth_mm, double radius_mm) noexcept;

/// @return S of a sphere whose middle lies on the axis of the press [1], by quadrature to about 1e-9; of the part below
/// the surface where it sticks out.
[[nodiscard]] double shareOfSphere(double sphereRadius_mm, double middleDepth_mm, double radius_mm);

/// How much nearer a pressed finger comes to what lies below it [mm]: the press less the way on which the tissue there
/// gives way, on the axis.
/// @param depth_mm  below the surface at rest; above it: 0; @param press_mm  >= 0
[[nodiscard]] double approach(double depth_mm, double press_mm, double radius_mm) noexcept;

} // namespace palpate::buried
