// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nearby/TickWork.h"
#include "palpate/haptics/HapticScene.h"

#include <palpate/core/Realtime.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate::haptics::internal {

/// Distances that a ball keeps for one tick where it was placed too near to surfaces: from each connected part the
/// distance of its centre, instead of the radius.
///
/// Without this table such a ball could not move along a surface. All facets within the radius touch the ball, those at
/// the side as well as the one below, and a ball must not come nearer to a facet that it touches. As the surface is one
/// part with one distance, the ball moves along the surface like a smaller ball, which touches only the facet below.
///
/// The distances are functions of the position: they grow while the ball moves away, and no tick needs a memory of the
/// start.
class TightRoom
{
  public:
    /// Finds the distances of a ball whose centre is at `p`. Facets that face away from `p` do not count, as for moves:
    /// a ball inside a closed surface may leave.
    ///
    /// The search goes from near to far, because the nearest facets decide and are few. Whether `p` is inside is
    /// decided by the first facet on one ray per surface. A ray that grazes an edge can be wrong; then a ball counts as
    /// placed too near for longer than necessary, or only after it is placed again.
    /// @param work  budget; parts that are not found before its end, or beyond kMostParts, keep the whole ball off, and
    ///              from each of their facets that is nearer at least the present distance
    /// @par Real-time Wait-free; bounded by `work`.
    void search(const HapticLayer& layer, const core::Vec3& p, TickWork& work) noexcept PALPATE_NONBLOCKING;

    /// Returns true if the whole ball fits and its centre is outside all closed surfaces: then no move of the solver
    /// brings the ball nearer to a surface than its radius, until the scene changes.
    [[nodiscard]] bool isWhole() const noexcept { return m_isWhole; }

    /// Returns the distance to be kept from a facet [mm], a skin less than the present one: at least a skin, at most
    /// the fingertip's radius.
    [[nodiscard]] double radiusOff(const HapticLayer& layer, std::uint32_t structure,
                                   std::uint32_t triangle) const noexcept PALPATE_NONBLOCKING;

  private:
    static constexpr std::size_t kMostParts = 32;

    /// A part that is too near.
    struct Near
    {
        std::uint32_t structure;
        std::uint32_t part;
        double radius_mm;
    };

    [[nodiscard]] Near* find(std::uint32_t structure, std::uint32_t part) noexcept;
    [[nodiscard]] bool searchWithin(const HapticLayer& layer, const core::Vec3& p, double reach_mm,
                                    TickWork& work) noexcept;
    void note(std::uint32_t structure, std::uint32_t part, double radius_mm) noexcept;

    std::array<Near, kMostParts> m_near;
    std::size_t m_count = 0;
    std::size_t m_known = 0; ///< entries of the searches before this one, which are final
    bool m_isFull = false;   ///< further parts are too near
    bool m_isWhole = false;
};

/// As TightRoom::radiusOff.
/// @param room  null for a ball with its whole room
[[nodiscard]] inline double radiusOff(const TightRoom* room, const HapticLayer& layer, std::uint32_t structure,
                                      std::uint32_t triangle) noexcept
{
    return room == nullptr ? layer.fingertip_mm : room->radiusOff(layer, structure, triangle);
}

} // namespace palpate::haptics::internal
