// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"
#include "palpate/haptics/internal/Facet.h"

#include <array>
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

    /// Calls `f(facet)` for every gathered facet near `g`, gathering them first when needed. Where more lie there than
    /// can be held, those that were gathered last are missing.
    template<class F>
    void forEachNear(const HapticScene& scene, const HapticLayer& layer, const Vec3& g, F&& f) noexcept
    {
        if (!m_isComplete || !m_region.contains(g)) {
            gather(scene, layer, g, g);
        }
        for (int i = 0; i < m_count; ++i) {
            const auto k = static_cast<std::size_t>(i);
            f(Facet::of(*scene.structures()[m_structure[k]].surface, m_structure[k], m_triangle[k]));
        }
    }

  private:
    static constexpr int kCapacity = 64;

    struct First;
    void hold(const geometry::SurfaceIndex& surface, std::uint32_t structure, std::uint32_t triangle) noexcept;
    void offerGathered(const HapticScene& scene, First& first) const noexcept;
    void gather(const HapticScene& scene, const HapticLayer& layer, const Vec3& x, const Vec3& y) noexcept;

    core::Box m_region;
    double m_radius_mm = 0.0;
    Vec3 m_last = Vec3::Zero();   ///< god-object at the start of the tick [mm]
    Vec3 m_motion = Vec3::Zero(); ///< of the previous tick [mm]
    bool m_hasLast = false;
    bool m_isComplete = false; ///< every facet in the region is held
    int m_count = 0;

    // The gathered facets as floats relative to m_origin, side by side, so that four are told off a move at once. What
    // floats cannot tell is tested again in double precision.
    Vec3 m_origin = Vec3::Zero();
    float m_reach_mm = 0.0f;                  ///< largest number in m_offset: decides what its rounding is
    alignas(16) float m_normal[3][kCapacity]; ///< unit, of the front
    alignas(16) float m_offset[kCapacity];    ///< of the plane from m_origin, along the normal [mm]
    alignas(16) float m_low[3][kCapacity];    ///< box of the triangle, rounded outwards [mm]
    alignas(16) float m_high[3][kCapacity];
    alignas(16) std::int32_t m_isTwoSided[kCapacity]; ///< all ones or zero
    std::uint32_t m_structure[kCapacity];
    std::uint32_t m_triangle[kCapacity]; ///< position in the structure's SurfaceIndex
};

} // namespace palpate::haptics::internal
