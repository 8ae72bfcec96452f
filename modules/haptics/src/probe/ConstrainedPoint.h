// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Realtime.h>
#include <palpate/core/Types.h>

#include <array>
#include <cstdint>
#include <span>

namespace palpate::haptics::internal {

using core::Vec3;

/// The half-space `n . u >= offset_mm` of displacements u.
struct HalfSpace
{
    Vec3 n; ///< unit
    double offset_mm;
};

/// Nearest allowed displacement, and the planes that are active there.
struct ConstrainedPoint
{
    Vec3 u = Vec3::Zero();                ///< [mm]
    std::array<std::uint8_t, 3> active{}; ///< indices of the planes with a positive multiplier
    std::array<double, 3> lambda_mm;      ///< their multipliers: u - wanted = sum of lambda n
    int count = 0;                        ///< number of valid entries in `active`
};

/// Minimises 0.5 |u - wanted|^2 subject to all half-spaces: the constrained point of Zilles & Salisbury.
///
/// The paper's 4×4, 5×5 or 6×6 Lagrange system for k = 1, 2, 3 planes has the identity as its upper left block, so that
/// the multipliers are the solution of the k×k system G lambda = offset - N wanted, with the Gram matrix G = N N^T of
/// the normals. G is factored by orthonormalising the normals, which preserves the accuracy for near-parallel planes;
/// sets of planes with linearly dependent normals (up to rounding) are skipped. Sets are tried in ascending order of
/// size. The result is the first set with only positive multipliers whose point violates no other plane; by the
/// Karush-Kuhn-Tucker conditions, this solution is unique.
///
/// @param wanted      unconstrained displacement, HIP - god-object [mm]
/// @param halfSpaces  up to four
/// @param allowance_mm  tolerance on the violation of the other planes
/// @return the constrained point; if no set qualifies (contradictory or repeated planes), the set with the smallest
/// violation of the others
/// @par Real-time Wait-free: at most 14 sets.
/// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876, equations 3 to 5.
[[nodiscard]] ConstrainedPoint constrainedPoint(const Vec3& wanted, std::span<const HalfSpace> halfSpaces,
                                                double allowance_mm) noexcept PALPATE_NONBLOCKING;

/// Returns the component of `v` along which a point constrained to planes with these normals can move: in the plane,
/// along the line of two planes, zero in a corner.
/// @param v  displacement
/// @param normals  unit normals, at most three, distinct beyond rounding
/// @par Real-time Wait-free.
[[nodiscard]] Vec3 freePart(Vec3 v, std::span<const Vec3> normals) noexcept PALPATE_NONBLOCKING;

} // namespace palpate::haptics::internal
