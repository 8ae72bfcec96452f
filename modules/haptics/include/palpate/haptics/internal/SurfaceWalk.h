// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/internal/Neighbourhood.h"

#include <cstdint>

namespace palpate::haptics::internal {

/// How a walk over a surface ended.
struct SurfaceWalk
{
    std::uint32_t moves = 0;
    bool hasArrived = false; ///< at the nearest place: well inside the facet, or in a crease
    bool isClear = false;    ///< all of it over clear facets: nothing was asked
    bool isInCrease = false; ///< held by the facet beyond an edge, too
    Facet beyond;            ///< that one
};

/// Moves a god-object that touches one facet, or two at their common edge, along them towards the HIP and on over
/// edges, as long as each next facet is pressed too and the surface turns by at most 60 degrees there. It ends well
/// inside a facet or in a crease, between the ends of the edge. What else stops it (a corner, a rim, another surface in
/// the way) is left to the general method, which goes on from there.
/// @param most    moves, at most
/// @param side    of the facets that the god-object is on: +1 front, -1 behind
/// @param isWellInside  the god-object got there by walking: it stands a skin above the facet, well inside it
/// @param second  the other facet that it touches; null: none
/// @param g       god-object, moved by moves that nothing blocks [mm]
/// @param facet   where it stands, replaced by where it gets to
/// @par Real-time Wait-free.
[[nodiscard]] SurfaceWalk walk(const HapticScene& scene, const HapticLayer& layer, Neighbourhood& near, const Vec3& hip,
                               std::uint32_t most, int side, bool isWellInside, const Facet* second, Vec3& g,
                               Facet& facet) noexcept PALPATE_NONBLOCKING;

} // namespace palpate::haptics::internal
