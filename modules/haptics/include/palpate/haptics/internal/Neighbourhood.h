// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"
#include "palpate/haptics/internal/Facet.h"
#include "palpate/haptics/internal/FacetGroup.h"

#include <array>
#include <bit>
#include <cstdint>

namespace palpate::haptics::internal {

/// The facets around a god-object, gathered once and used for as long as it stays among them: consecutive ticks touch
/// the same few triangles. Complete inside its region, so it never changes an answer, only what the answer costs.
class Neighbourhood
{
  public:
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
    std::uint32_t m_structure[kCapacity];
    std::uint32_t m_triangle[kCapacity]; ///< position in the structure's SurfaceIndex
};

} // namespace palpate::haptics::internal
