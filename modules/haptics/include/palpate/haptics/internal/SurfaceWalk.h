// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/internal/Neighbourhood.h"

#include <cstdint>

namespace palpate::haptics::internal {

/// How a walk over a surface ended.
struct SurfaceWalk
{
    std::uint32_t moves = 0;
    bool hasArrived = false; ///< well inside the facet, straight above the HIP: nothing is nearer
    bool isClear = false;    ///< all of it over clear facets: nothing was asked
};

/// Moves a god-object that touches one facet along it towards the HIP and on over its edges, as long as each next
/// facet is pressed too and the surface turns by at most 60 degrees there. What stops it (a crease that holds, a rim,
/// another surface in the way) is left to the general method, which goes on from there.
/// @param most    moves, at most
/// @param side    of the facet that the god-object is on: +1 front, -1 behind
/// @param isWellInside  the god-object got there by walking: it stands a skin above the facet, well inside it
/// @param g       god-object, moved by moves that nothing blocks [mm]
/// @param facet   where it stands, replaced by where it gets to
/// @par Real-time Wait-free.
[[nodiscard]] SurfaceWalk walk(const HapticScene& scene, const HapticLayer& layer, Neighbourhood& near, const Vec3& hip,
                               std::uint32_t most, int side, bool isWellInside, Vec3& g,
                               Facet& facet) noexcept PALPATE_NONBLOCKING;

} // namespace palpate::haptics::internal
