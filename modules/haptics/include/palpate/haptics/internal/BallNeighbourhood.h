// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"
#include "palpate/haptics/internal/Ball.h"
#include "palpate/haptics/internal/TriangleDistances.h"

#include <array>
#include <cstdint>

namespace palpate::haptics::internal {

/// The facets around a ball, gathered once and used for as long as the ball stays among them. Complete inside its
/// region, so it never changes an answer, only what the answer costs.
class BallNeighbourhood
{
  public:
    /// Forgets everything: the scene changed.
    void clear() noexcept PALPATE_NONBLOCKING;

    /// Tells where the ball's centre starts this tick: which way it is going decides where facets are gathered.
    /// @par Real-time Wait-free.
    void beginTick(const Vec3& g) noexcept PALPATE_NONBLOCKING
    {
        m_motion = m_hasLast ? Vec3(g - m_last) : Vec3::Zero();
        m_last = g;
        m_hasLast = true;
    }

    /// Finds the first facet of the layer that blocks a ball with the scene's radius, its centre going x → y.
    /// @return false when nothing blocks it.
    /// @par Real-time Wait-free.
    [[nodiscard]] bool sweep(const HapticScene& scene, const HapticLayer& layer, const Vec3& x, const Vec3& y,
                             BallCrossing& first) noexcept PALPATE_NONBLOCKING;

  private:
    static constexpr int kCapacity = 256;

    struct First;
    void offerGathered(const HapticScene& scene, First& first) noexcept;
    void gather(const HapticScene& scene, const HapticLayer& layer, const Vec3& x, const Vec3& y) noexcept;
    void fill(const HapticScene& scene) noexcept;

    core::Box m_region; ///< of the ball's centre
    double m_margin_mm = 0.0;
    Vec3 m_last = Vec3::Zero();   ///< centre at the start of the tick [mm]
    Vec3 m_motion = Vec3::Zero(); ///< of the previous tick [mm]
    bool m_hasLast = false;
    bool m_isComplete = false; ///< every facet that a ball in the region can touch is held
    int m_count = 0;
    Vec3 m_origin = Vec3::Zero();
    float m_reach_mm = 0.0f;                                               ///< largest coordinate in m_groups
    std::array<TriangleGroup, kCapacity / TriangleGroup::kLanes> m_groups; ///< relative to m_origin
    std::uint32_t m_structure[kCapacity];
    std::uint32_t m_triangle[kCapacity]; ///< position in the structure's SurfaceIndex
};

} // namespace palpate::haptics::internal
