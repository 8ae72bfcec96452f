// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/internal/Neighbourhood.h"

#include <cstdint>

namespace palpate::haptics::internal {

/// How far a god-object came that followed the pull over one sheet of surface, from facet to facet.
struct SurfaceWalk
{
    Vec3 g;      ///< [mm]; reached by moves that nothing blocks
    Facet facet; ///< where it stands
    std::uint32_t moves = 0;
    bool hasArrived = false; ///< well inside `facet`, straight above the HIP: nothing is nearer
};

/// Moves a god-object that touches one facet along it towards the HIP and on over its edges, as long as each next
/// facet is pressed too and the surface is no sharper than 60 degrees there. What stops it (a crease that holds, a
/// rim, another surface in the way) is left to the general method, which goes on from there.
/// @param side  of the facet that the god-object is on: +1 front, -1 behind
/// @par Real-time Wait-free.
void walk(const HapticScene& scene, const HapticLayer& layer, Neighbourhood& near, const Vec3& hip, int side,
          double margin_mm, SurfaceWalk& at) noexcept PALPATE_NONBLOCKING;

} // namespace palpate::haptics::internal
