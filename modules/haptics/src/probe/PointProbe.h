// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "probe/Skin.h"

#include <palpate/core/Realtime.h>
#include <palpate/geometry/SurfaceIndex.h>

#include <cstdint>

namespace palpate::haptics::internal {

using core::Vec3;

/// A triangle ready to be tested against moves.
struct Facet
{
    Vec3 a, b, c;         ///< corners [mm]
    Vec3 n;               ///< unit normal of the front
    double skin_mm = 0.0; ///< gap that the god-object keeps to it
    std::uint32_t structure = 0;
    std::uint32_t triangle = 0; ///< position in the structure's SurfaceIndex
    bool isTwoSided = false;

    [[nodiscard]] static Facet of(const geometry::SurfaceIndex& surface, std::uint32_t structure,
                                  std::uint32_t triangle) noexcept PALPATE_NONBLOCKING;
};

/// Where a move meets a facet that blocks it.
struct Crossing
{
    double key; ///< order of crossings along the move: 0 when touched already, else the share where it enters the plate
    double depth; ///< how far behind the plane the move would end [mm]; the larger first when keys are equal
    double stop;  ///< share of the move that may be made, 0 … 1: there the gap is the skin
    Facet facet;
    int side; ///< +1: met from the front, -1: from behind
};

/// Tests whether `facet` blocks the straight move x → y: it goes against the normal, starts on the front or on the
/// plane, ends behind it and passes through the closed triangle, or it enters the plate around the triangle: half a
/// skin thick on both sides of a facet without an inside, a sixteenth of a skin in front of any other.
///
/// No facet is passed by a move that ends at the stop of the first crossing, and no plate is entered. A facet that is
/// touched stops the move where it starts. Else the stop lies before the key, where the first facet's plate is entered,
/// and no other plate is entered before.
///
/// The three edge tests are signs of the volumes spanned by the move and an edge. Two triangles that share an edge
/// compute the same volume with the opposite sign, to the last bit, and volumes within their rounding bound count as
/// inside: so no move passes between neighbours. In a facet's plane those volumes are rounding alone, as is the share
/// at which it is met: that must be where the move is within a skin of the facet's box.
/// @param limit  crossings beyond this key are of no interest
/// @par Real-time Wait-free.
[[nodiscard]] bool blocks(const Facet& facet, const Vec3& x, const Vec3& y, double limit,
                          Crossing& crossing) noexcept PALPATE_NONBLOCKING;

/// Where the foot of a god-object lies on a facet's plane.
enum class Footing : std::uint8_t
{
    Away,   ///< not on the facet
    AtEdge, ///< nearer to an edge than `edge_mm`, on either side of it
    Inside, ///< on the facet
};

/// How near to a facet a god-object must be to stand on it.
struct Standing
{
    double gap_mm;   ///< from its plane, at most
    double slack_mm; ///< how far outside the closed triangle the foot may lie
    double edge_mm;  ///< width of the band along the edges that counts as AtEdge
};

/// Finds where a god-object at `g` stands on `facet`; Away where it does not.
/// @param side  that `g` is on: +1 front, -1 behind
/// @par Real-time Wait-free.
[[nodiscard]] Footing footingOn(const Facet& facet, int side, const Vec3& g,
                                const Standing& standing) noexcept PALPATE_NONBLOCKING;

} // namespace palpate::haptics::internal
