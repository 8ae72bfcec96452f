// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "probe/Skin.h"

#include <palpate/core/Realtime.h>
#include <palpate/geometry/SurfaceIndex.h>

#include <cstdint>

namespace palpate::haptics::internal {

using core::Vec3;

/// A triangle prepared for collision tests.
struct Facet
{
    Vec3 a, b, c;         ///< corners [mm]
    Vec3 n;               ///< unit normal of the front
    double skin_mm = 0.0; ///< gap that the god-object keeps to the facet
    std::uint32_t structure = 0;
    std::uint32_t triangle = 0; ///< index in the structure's SurfaceIndex
    bool isTwoSided = false;

    [[nodiscard]] static Facet of(const geometry::SurfaceIndex& surface, std::uint32_t structure,
                                  std::uint32_t triangle) noexcept PALPATE_NONBLOCKING;
};

/// Where a move meets a facet that blocks the move.
struct Crossing
{
    double key;   ///< sort key of crossings along the move: 0 if already touching, otherwise the fraction at which the
                  ///< plate is entered
    double depth; ///< depth of the end of the move behind the plane [mm]; with equal keys the larger depth comes first
    double stop;  ///< fraction of the move that may be made, 0 to 1, up to a gap of one skin
    Facet facet;
    int side; ///< +1: met from the front, -1: from the back
};

/// Tests whether `facet` blocks the straight move x → y. A move is blocked if its direction is against the normal, it
/// starts on the front or on the plane, ends behind the plane and passes through the closed triangle; or if it enters
/// the plate around the triangle. The plate of a two-sided facet extends half a skin to both sides, the plate of a
/// one-sided facet a sixteenth of a skin to the front.
///
/// A move that ends at the stop of the first crossing passes no facet and enters no plate. A touched facet stops the
/// move at its start. Otherwise the stop precedes the key, where the plate of the first facet is entered, and no other
/// plate is entered before.
///
/// The three edge tests use the signs of the triple products of the move and each edge. Two triangles that share an
/// edge compute bitwise opposite values, and values within the rounding bound count as inside, so that no move passes
/// between neighbours. In a facet's plane these values and the fraction of the crossing are only rounding; the crossing
/// must then be where the move is within a skin of the facet's bounding box.
/// @param limit  crossings beyond this key are ignored
/// @par Real-time Wait-free.
[[nodiscard]] bool blocks(const Facet& facet, const Vec3& x, const Vec3& y, double limit,
                          Crossing& crossing) noexcept PALPATE_NONBLOCKING;

/// Position of a god-object's foot relative to a facet.
enum class Footing : std::uint8_t
{
    Away,   ///< outside the facet
    AtEdge, ///< nearer to an edge than `edge_mm`, inside or outside
    Inside, ///< on the facet
};

/// Tolerances of the test whether a god-object stands on a facet.
struct Standing
{
    double gap_mm;   ///< maximum distance from the facet's plane
    double slack_mm; ///< maximum distance of the foot outside the closed triangle
    double edge_mm;  ///< width of the band along the edges that counts as AtEdge
};

/// Classifies the position of a god-object at `g` relative to `facet`.
/// @param side  side of the facet that `g` is on: +1 front, -1 back
/// @par Real-time Wait-free.
[[nodiscard]] Footing footingOn(const Facet& facet, int side, const Vec3& g,
                                const Standing& standing) noexcept PALPATE_NONBLOCKING;

} // namespace palpate::haptics::internal
