// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/MapValue.h"
#include "law/Touch.h"
#include "probe/BallProbe.h"

#include <palpate/core/Realtime.h>

#include <span>

namespace palpate::haptics::law {

/// Where the god-object stands on the triangle that it touches.
/// @par Real-time Wait-free.
class Foot
{
  public:
    PALPATE_ALWAYS_INLINE explicit Foot(const Touch& touch) noexcept
        : Foot(touch.facet, touch.planes, nearestOn(touch))
    {
    }

    [[nodiscard]] PALPATE_ALWAYS_INLINE double numberOf(const TissueMap& map) const noexcept
    {
        return m_place.risesOf(map).value;
    }
    [[nodiscard]] PALPATE_ALWAYS_INLINE MapValue valueOf(const TissueMap& map) const noexcept
    {
        return m_place.valueOf(map);
    }
    [[nodiscard]] const MapPlace& place() const noexcept { return m_place; }

    /// The part of a map's gradient along which the foot moves with the HIP, to first order: in the face, along the
    /// crease or the edge, nowhere in a corner.
    [[nodiscard]] PALPATE_ALWAYS_INLINE Vec3 freePart(const Vec3& gradient) const noexcept
    {
        return m_planes.size() == 1 && !m_isOnEdge ? gradient : heldPart(gradient, m_planes, m_isOnEdge, m_along);
    }

  private:
    PALPATE_ALWAYS_INLINE Foot(const internal::Facet& facet, std::span<const ActiveConstraint> planes,
                               const internal::Nearest& nearest) noexcept
        : m_planes(planes)
        , m_isOnEdge(nearest.isCurved)
        , m_along(nearest.along)
        , m_place(facet, nearest.q)
    {
    }
    [[nodiscard]] PALPATE_ALWAYS_INLINE static internal::Nearest nearestOn(const Touch& touch) noexcept
    {
        // A point is above its foot, where it has the same barycentric coordinates.
        return touch.fingertip_mm > 0.0 ? internal::nearestOn(touch.facet, touch.p_WG)
                                        : internal::Nearest{touch.p_WG, Vec3::Zero()};
    }
    // By value, so that what is not passed in most ticks stays in registers.
    [[nodiscard]] static Vec3 heldPart(Vec3 gradient, std::span<const ActiveConstraint> planes, bool isOnEdge,
                                       Vec3 along) noexcept;

    std::span<const ActiveConstraint> m_planes;
    bool m_isOnEdge; ///< of a ball: it rolls around it
    Vec3 m_along;    ///< of the edge, unit; zero on the face and at a corner
    MapPlace m_place;
};

/// A touch where a map of the force is.
struct MappedTouch : Touch
{
    const Foot& foot;
};

} // namespace palpate::haptics::law
