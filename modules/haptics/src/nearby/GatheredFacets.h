// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nearby/PlaneLanes.h"
#include "palpate/haptics/HapticScene.h"

#include <array>
#include <cstdint>

namespace palpate::haptics::internal {

/// All facets of a layer that come near a region, as floats side by side. They are gathered in steps, so that the work
/// can be spread over ticks and none waits for memory longer than it must.
class GatheredFacets
{
  public:
    static constexpr int kMost = 64; ///< facets that can be held, a multiple of eight

    void clear() noexcept
    {
        m_stage = Stage::Empty;
        m_count = 0;
    }

    /// First step: finds the facets.
    /// @param region    of what asks for them [mm]
    /// @param origin    that floats are relative to, in the region [mm]
    /// @param around_mm  how far outside of the region a facet may lie and still matter
    /// @return false, empty, when there are too many.
    bool begin(const HapticLayer& layer, const core::Box& region, const core::Vec3& origin,
               double around_mm) noexcept PALPATE_NONBLOCKING;

    /// The next steps: asks for the corners; then fills up to `groups` groups, until all are.
    void proceed(const HapticLayer& layer, int groups) noexcept PALPATE_NONBLOCKING;
    void finish(const HapticLayer& layer) noexcept PALPATE_NONBLOCKING
    {
        while (isBegun() && !isReady()) {
            proceed(layer, kMost);
        }
    }

    [[nodiscard]] bool isBegun() const noexcept { return m_stage != Stage::Empty; }
    [[nodiscard]] bool isReady() const noexcept { return m_stage == Stage::Ready; }
    /// @return true when `p` is in the region that was begun.
    [[nodiscard]] bool covers(const core::Vec3& p) const noexcept { return isBegun() && m_region.contains(p); }
    /// @return true when all facets near `p` are ready.
    [[nodiscard]] bool holds(const core::Vec3& p) const noexcept { return isReady() && m_region.contains(p); }

    [[nodiscard]] const core::Box& region() const noexcept { return m_region; }
    [[nodiscard]] const core::Vec3& origin() const noexcept { return m_origin; }
    [[nodiscard]] int count() const noexcept { return m_count; }
    [[nodiscard]] float reach_mm() const noexcept { return m_reach_mm; } ///< largest coordinate in the groups
    [[nodiscard]] const FacetGroup* groups() const noexcept { return m_groups.data(); }
    [[nodiscard]] std::uint32_t structure(int i) const noexcept { return m_structure[i]; }
    /// @return position in the structure's SurfaceIndex.
    [[nodiscard]] std::uint32_t triangle(int i) const noexcept { return m_triangle[i]; }

  private:
    enum class Stage : std::uint8_t
    {
        Empty,
        Found,    ///< numbers of the triangles are known
        Numbered, ///< and where their corners are
        Ready,
    };

    void number(const HapticLayer& layer) noexcept;

    core::Box m_region;
    double m_origin4[4]{};
    core::Vec3 m_origin = core::Vec3::Zero();
    int m_count = 0;
    int m_filled = 0; ///< groups
    float m_reach_mm = 0.0f;
    Stage m_stage = Stage::Empty;
    std::array<FacetGroup, kMost / kLanes> m_groups;
    // Of each facet, by eights; the last eight are filled up with the last facet.
    const double* m_at[3][kMost]; ///< where its corners lie
    std::uint32_t m_structure[kMost];
    alignas(32) std::int32_t m_isTwoSided[kMost]; ///< all ones or zero
    std::uint32_t m_triangle[kMost];
};

} // namespace palpate::haptics::internal
