// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nearby/NearPoint.h"
#include "solver/PointContact.h"

#include <array>
#include <span>

namespace palpate::haptics::internal {

/// A way out of a corner whose planes leave no room: at a vertex the surface may fall away on one side although the
/// planes around it hold the god-object, because the free space is not the intersection of their half-spaces there.
///
/// Tried are the straight way to the HIP and those along each plane and each pair of planes that are touched.
/// @par Real-time Wait-free; bounded by the work of the tick that `near` has begun.
class Escape
{
  public:
    /// @param god,skin_mm  the god-object and the gap that it keeps [mm]
    Escape(const Vec3& hip, const HapticLayer& layer, NearPoint& near, const Vec3& god, double skin_mm) noexcept
        : m_hip(hip)
        , m_layer(layer)
        , m_near(near)
        , m_god(god)
        , m_skin_mm(skin_mm)
    {
    }

    /// Where a way leads.
    struct End
    {
        Vec3 p;                 ///< [mm]
        PointContacts along;    ///< the facets that it follows
        bool isBlocked = false; ///< by `next`
        PointContact next;
    };

    /// Finds a way that leads closer to the HIP.
    /// @param held  the present contacts
    /// @return false where there is none
    [[nodiscard]] bool find(const PointContacts& held, End& end) noexcept PALPATE_NONBLOCKING;

  private:
    static constexpr std::size_t kMostTouched = 16; // facets around a vertex, and planes

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
    double m_largest_mm = 0.0; ///< skin of those touched
    double m_most_mm = 0.0;    ///< from the HIP, at the end of a way that is worth a move
    std::array<Facet, kMostTouched> m_touched;
    std::size_t m_count = 0;
    bool m_isRoom = true;                            ///< for all that are touched
    std::array<PointContact, kMostTouched> m_planes; ///< of those and of the rest, each once
    std::size_t m_planeCount = 0;
};

} // namespace palpate::haptics::internal
