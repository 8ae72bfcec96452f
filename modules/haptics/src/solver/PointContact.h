// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "probe/PointProbe.h"
#include "solver/ActiveSet.h"

namespace palpate::haptics::internal {

/// A facet that a point touches, and from which side.
struct PointContact
{
    Facet facet;
    int side = 1;                    ///< +1: from its front, -1: from behind
    Footing footing = Footing::Away; ///< where the god-object stands on it, when it was last asked
    bool isInTheWay = false;         ///< was met by a move from the very place where the god-object is

    [[nodiscard]] Vec3 normal() const noexcept { return side > 0 ? facet.n : Vec3(-facet.n); }
    /// Distance of `g` in front of the plane [mm].
    [[nodiscard]] double gap(const Vec3& g) const noexcept { return side * facet.n.dot(g - facet.a); }
    [[nodiscard]] bool isSame(const PointContact& other) const noexcept
    {
        return facet.structure == other.facet.structure && facet.triangle == other.facet.triangle && side == other.side;
    }
    /// True when `g` stands on the triangle. A plane can be in the way where its triangle lies beside, met at a shallow
    /// angle: friction has nothing to hold there.
    [[nodiscard]] bool supports(const Vec3& g) const noexcept
    {
        const double skin = facet.skin_mm;
        return footingOn(facet, side, g, {kSupporting * skin, kTouched * skin, 0.0}) != Footing::Away;
    }
    /// The displacements from `g` that keep a skin's gap.
    [[nodiscard]] HalfSpace planeFrom(const Vec3& g) const noexcept { return {normal(), facet.skin_mm - gap(g)}; }
};

using PointContacts = ActiveSet<PointContact>;

} // namespace palpate::haptics::internal
