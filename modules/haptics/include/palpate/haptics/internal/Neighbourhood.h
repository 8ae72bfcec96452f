// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"
#include "palpate/haptics/internal/Facet.h"
#include "palpate/haptics/internal/FacetGroup.h"

#include <array>
#include <bit>
#include <cstdint>
#include <span>

namespace palpate::haptics::internal {

/// The facets around a god-object, gathered once and used for as long as it stays among them: consecutive ticks touch
/// the same few triangles. Complete inside its region, so it never changes an answer, only what the answer costs.
class Neighbourhood
{
  public:
    static constexpr std::size_t kMostPoints = 9; ///< of a path

    /// Forgets everything: the scene changed.
    void clear() noexcept PALPATE_NONBLOCKING;

    /// Tells where the god-object starts this tick: which way it is going decides where facets are gathered.
    /// @par Real-time Wait-free.
    void beginTick(const Vec3& g) noexcept PALPATE_NONBLOCKING
    {
        m_motion = m_hasLast ? Vec3(g - m_last) : Vec3::Zero();
        m_last = g;
        m_hasLast = true;
    }

    /// Finds the first facet of the layer that blocks the move x → y.
    /// @return false when nothing blocks it.
    /// @par Real-time Wait-free.
    [[nodiscard]] bool sweep(const HapticScene& scene, const HapticLayer& layer, const Vec3& x, const Vec3& y,
                             Crossing& first) noexcept PALPATE_NONBLOCKING;

    /// @return true when the facets around `g` are held: what is asked there costs no gathering.
    [[nodiscard]] bool holds(const Vec3& g) const noexcept { return m_isComplete && m_region.contains(g); }

    /// Finds the facet on the other side of an edge of `facet`.
    /// @param place  on that edge, to within a few skins [mm]
    /// @param from,ahead  the way that leads there and on: facets are gathered along it, if they must be [mm]
    /// @param edge  0 … 2: from corner a, b, c to the next
    /// @param entered  set to the same edge's number in the facet that is found
    /// @return false when there is none, more than one, or one that is turned over.
    /// @par Real-time Wait-free.
    [[nodiscard]] bool beyondEdge(const HapticScene& scene, const HapticLayer& layer, const Vec3& from,
                                  const Vec3& place, const Vec3& ahead, const Facet& facet, int edge, Facet& found,
                                  int& entered) noexcept PALPATE_NONBLOCKING;

    /// Follows a chain of straight moves up to the first that is blocked.
    /// @param path  at most kMostPoints points [mm]
    /// @return how many of the moves are free.
    /// @par Real-time Wait-free.
    [[nodiscard]] std::size_t freeMoves(const HapticScene& scene, const HapticLayer& layer,
                                        std::span<const Vec3> path) noexcept PALPATE_NONBLOCKING;

    /// Calls `f(facet)` for every facet that comes within `reach_mm` of `g`, and maybe for some that nearly do. Where
    /// more lie there than can be held, those that were gathered last are missing.
    template<class F>
    void forEachNear(const HapticScene& scene, const HapticLayer& layer, const Vec3& g, double reach_mm, F&& f) noexcept
    {
        for (std::uint64_t lanes = near(scene, layer, g, reach_mm); lanes != 0; lanes &= lanes - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(lanes));
            f(Facet::of(*scene.structures()[m_structure[k]].surface, m_structure[k], m_triangle[k]));
        }
    }

  private:
    static constexpr int kCapacity = 64;

    struct First;
    void gatherAlong(const HapticScene& scene, const HapticLayer& layer, const Vec3& x, const Vec3& y) noexcept;
    [[nodiscard]] std::uint64_t near(const HapticScene& scene, const HapticLayer& layer, const Vec3& g,
                                     double reach_mm) noexcept;
    void offerGathered(const HapticScene& scene, First& first) const noexcept;
    void gather(const HapticScene& scene, const HapticLayer& layer, const Vec3& x, const Vec3& y) noexcept;
    void fill(const HapticScene& scene) noexcept;

    core::Box m_region;
    double m_radius_mm = 0.0;
    Vec3 m_last = Vec3::Zero();   ///< god-object at the start of the tick [mm]
    Vec3 m_motion = Vec3::Zero(); ///< of the previous tick [mm]
    bool m_hasLast = false;
    bool m_isComplete = false; ///< every facet in the region is held
    int m_count = 0;
    Vec3 m_origin = Vec3::Zero();
    float m_reach_mm = 0.0f;                                         ///< largest coordinate in m_groups
    std::array<FacetGroup, kCapacity / FacetGroup::kLanes> m_groups; ///< relative to m_origin
    std::array<CornerGroup, kCapacity / FacetGroup::kLanes> m_corners;
    std::uint32_t m_structure[kCapacity];
    std::uint32_t m_triangle[kCapacity]; ///< position in the structure's SurfaceIndex
};

} // namespace palpate::haptics::internal
