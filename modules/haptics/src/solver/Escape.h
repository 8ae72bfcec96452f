// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nearby/NearPoint.h"
#include "solver/PointContact.h"

#include <array>
#include <span>

namespace palpate::haptics::internal {

/// Finds a way out of a corner whose planes leave no room. At a saddle vertex the surface may fall away on one side
/// although the planes around the vertex hold the god-object, because free space is not the intersection of their
/// half-spaces there.
///
/// Candidates are the straight path to the HIP and the paths along each touched plane and each pair of touched planes.
/// @par Real-time Wait-free; bounded by the work of the tick that `near` has begun.
class Escape
{
  public:
    /// @param god,skin_mm  the god-object and its gap [mm]
    Escape(const Vec3& hip, const HapticLayer& layer, NearPoint& near, const Vec3& god, double skin_mm) noexcept
        : m_hip(hip)
        , m_layer(layer)
        , m_near(near)
        , m_god(god)
        , m_skin_mm(skin_mm)
    {
    }

    /// End of an escape path.
    struct End
    {
        Vec3 p;                 ///< position [mm]
        PointContacts along;    ///< facets whose planes the path follows
        bool isBlocked = false; ///< the path ends at `next`
        PointContact next;
    };

    /// Finds a path that leads closer to the HIP.
    /// @param held  current contacts
    /// @param end  set if a path was found
    /// @return false if there is none
    [[nodiscard]] bool find(const PointContacts& held, End& end) noexcept PALPATE_NONBLOCKING;

  private:
    static constexpr std::size_t kMaxTouched = 16; // maximum number of touched facets, and of planes

    [[nodiscard]] bool gather(const PointContacts& held) noexcept;
    void add(const PointContact& contact) noexcept;
    [[nodiscard]] bool follow(Vec3 from, std::span<const PointContact> along, End& end) noexcept;

    [[nodiscard]] std::span<const Facet> touched() const noexcept
    {
        return std::span<const Facet>(m_touched).first(m_count);
    }
    [[nodiscard]] std::span<const PointContact> planes() const noexcept
    {
        return std::span<const PointContact>(m_planes).first(m_planeCount);
    }

    const Vec3& m_hip;
    const HapticLayer& m_layer;
    NearPoint& m_near;
    const Vec3& m_god;
    double m_skin_mm;
    double m_largest_mm = 0.0; ///< maximum skin of the touched facets
    double m_most_mm = 0.0;    ///< maximum distance from the HIP at the end of a useful path
    std::array<Facet, kMaxTouched> m_touched;
    std::size_t m_count = 0;
    bool m_isRoom = true;                           ///< all touched facets fit
    std::array<PointContact, kMaxTouched> m_planes; ///< distinct planes of the touched facets
    std::size_t m_planeCount = 0;
};

} // namespace palpate::haptics::internal
