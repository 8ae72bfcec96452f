// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <array>
#include <span>

namespace palpate::evaluation {

using core::Vec3;

/// A plane n . x = d.
struct Plane
{
    Vec3 n = Vec3::UnitZ(); ///< unit
    double d = 0.0;         ///< [mm]
};

/// Constrained point of Zilles & Salisbury and the cost of computing it.
struct Elimination
{
    Vec3 p = Vec3::Zero();            ///< [mm]
    std::array<double, 3> lambda{};   ///< Lagrange multipliers
    int multiplicativeOperations = 0; ///< multiplications and divisions actually performed
    bool isSolved = false;            ///< false: zero pivot, the planes have no common point
};

/// Multiplications and divisions stated in the paper for 1, 2 and 3 planes.
inline constexpr std::array<int, 3> kPaperOperations{12, 33, 65};

/// Minimises 0.5 |x - hip|^2 subject to up to three planes by symmetric elimination of the paper's 4×4, 5×5 or 6×6
/// system
///
///     | I  N^T | | x      |   | hip |
///     | N   0  | | lambda | = | d   |
///
/// The pivots of the identity block need no division; a symmetric k×k system remains.
/// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876, equation 5.
[[nodiscard]] Elimination eliminate(const Vec3& hip, std::span<const Plane> planes);

} // namespace palpate::evaluation
