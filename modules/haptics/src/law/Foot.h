// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/MapValue.h"
#include "law/Touch.h"
#include "probe/BallProbe.h"

namespace palpate::haptics::law {

/// Where the god-object stands on the triangle that it touches.
/// @par Real-time Wait-free.
class Foot
{
  public:
    explicit Foot(const Touch& touch) noexcept
        : m_touch(touch)
        , m_facet(internal::Facet::of(*touch.structure.surface, 0, touch.triangle))
        , m_nearest(internal::nearestOn(m_facet, touch.p_WG))
        , m_place(touch.triangle, {m_facet.a, m_facet.b, m_facet.c}, m_nearest.q)
    {
    }

    [[nodiscard]] const MapPlace& place() const noexcept { return m_place; }
    [[nodiscard]] MapValue valueOf(const TissueMap& map) const noexcept { return m_place.valueOf(map); }

    /// The part of a vector along which the foot moves with the HIP, to first order: in the face, along the crease or
    /// the edge, nowhere in a corner.
    [[nodiscard]] Vec3 freePart(const Vec3& v) const noexcept;

  private:
    const Touch& m_touch;
    internal::Facet m_facet;
    internal::Nearest m_nearest;
    MapPlace m_place;
};

} // namespace palpate::haptics::law
