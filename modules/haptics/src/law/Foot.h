// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/MapSample.h"
#include "law/Touch.h"
#include "probe/BallProbe.h"

#include <palpate/core/Realtime.h>

#include <span>

namespace palpate::haptics::law {

/// Position of the god-object's foot on the touched triangle.
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
        return m_place.numberOf(map);
    }
    [[nodiscard]] PALPATE_ALWAYS_INLINE MapSample valueOf(const TissueMap& map) const noexcept
    {
        return m_place.valueOf(map);
    }
    [[nodiscard]] const MapPlace& place() const noexcept { return m_place; }

    /// Returns the component of a map's gradient along which the foot moves with the HIP, to first order: within the
    /// face, along the crease or the edge, zero in a corner.
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
        // A point has the same barycentric coordinates as its foot.
        return touch.fingertip_mm > 0.0 ? internal::nearestOn(touch.facet, touch.p_WG)
                                        : internal::Nearest{touch.p_WG, Vec3::Zero()};
    }
    // By value, so that unused arguments stay in registers.
    [[nodiscard]] static Vec3 heldPart(Vec3 gradient, std::span<const ActiveConstraint> planes, bool isOnEdge,
                                       Vec3 along) noexcept;

    std::span<const ActiveConstraint> m_planes;
    bool m_isOnEdge; ///< ball on an edge, around which it rolls
    Vec3 m_along;    ///< unit direction of the edge; zero on the face and at a corner
    MapPlace m_place;
};

/// Input of force terms that use maps.
struct MappedTouch : Touch
{
    const Foot& foot;
};

} // namespace palpate::haptics::law
