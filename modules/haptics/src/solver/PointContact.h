// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "probe/PointProbe.h"
#include "solver/ActiveSet.h"

namespace palpate::haptics::internal {

/// A facet touched by a point, and the side of contact.
struct PointContact
{
    Facet facet;
    int side = 1;                    ///< +1: front, -1: back
    Footing footing = Footing::Away; ///< position of the god-object on the facet at the last query
    bool isInTheWay = false;         ///< blocked a move that started at the current position

    [[nodiscard]] Vec3 normal() const noexcept { return side > 0 ? facet.n : Vec3(-facet.n); }
    /// Returns the distance of `g` in front of the plane [mm].
    [[nodiscard]] double gap(const Vec3& g) const noexcept { return side * facet.n.dot(g - facet.a); }
    [[nodiscard]] bool isSame(const PointContact& other) const noexcept
    {
        return facet.structure == other.facet.structure && facet.triangle == other.facet.triangle && side == other.side;
    }
    /// Returns true if `g` stands on the triangle. A plane met at a shallow angle can block a move although its
    /// triangle is to the side of the god-object; friction cannot act there.
    [[nodiscard]] bool supports(const Vec3& g) const noexcept
    {
        const double skin = facet.skin_mm;
        return footingOn(facet, side, g, {kSupporting * skin, kTouchRadius * skin, 0.0}) != Footing::Away;
    }
    /// Returns the half-space of displacements from `g` that keep a gap of one skin.
    [[nodiscard]] HalfSpace planeFrom(const Vec3& g) const noexcept { return {normal(), facet.skin_mm - gap(g)}; }
};

using PointContacts = ActiveSet<PointContact>;

} // namespace palpate::haptics::internal
