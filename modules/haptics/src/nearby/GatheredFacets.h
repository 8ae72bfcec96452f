// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nearby/PlaneLanes.h"
#include "palpate/haptics/HapticScene.h"

#include <array>
#include <cstdint>

namespace palpate::haptics::internal {

/// All facets of a layer near a region, in single precision and structure-of-arrays layout. Gathering proceeds in
/// steps, so that the work can be spread over ticks and memory latency is hidden.
class GatheredFacets
{
  public:
    static constexpr int kMost = 64; ///< capacity; a multiple of eight

    void clear() noexcept
    {
        m_stage = Stage::Empty;
        m_count = 0;
    }

    /// First step: finds the facets.
    /// @param region    positions from which the facets are queried [mm]
    /// @param origin    origin of the single-precision coordinates, in the region [mm]
    /// @param around_mm  distance outside the region at which a facet still matters
    /// @return false, with no facets, if there are too many
    bool begin(const HapticLayer& layer, const core::Box& region, const core::Vec3& origin,
               double around_mm) noexcept PALPATE_NONBLOCKING;

    /// Next steps: prefetches the corners, then fills up to `groups` groups per call until all are filled.
    void proceed(const HapticLayer& layer, int groups) noexcept PALPATE_NONBLOCKING;
    void finish(const HapticLayer& layer) noexcept PALPATE_NONBLOCKING
    {
        while (isBegun() && !isReady()) {
            proceed(layer, kMost);
        }
    }

    [[nodiscard]] bool isBegun() const noexcept { return m_stage != Stage::Empty; }
    [[nodiscard]] bool isReady() const noexcept { return m_stage == Stage::Ready; }
    /// Returns true if `p` is in the region of the set, ready or not.
    [[nodiscard]] bool covers(const core::Vec3& p) const noexcept { return isBegun() && m_region.contains(p); }
    /// Returns true if all facets near `p` are ready.
    [[nodiscard]] bool holds(const core::Vec3& p) const noexcept { return isReady() && m_region.contains(p); }

    [[nodiscard]] const core::Box& region() const noexcept { return m_region; }
    [[nodiscard]] const core::Vec3& origin() const noexcept { return m_origin; }
    [[nodiscard]] int count() const noexcept { return m_count; }
    [[nodiscard]] float reach_mm() const noexcept { return m_reach_mm; } ///< largest coordinate in the groups
    [[nodiscard]] const FacetGroup* groups() const noexcept { return m_groups.data(); }
    [[nodiscard]] std::uint32_t structure(int i) const noexcept { return m_structure[i]; }
    /// Returns the index in the structure's SurfaceIndex.
    [[nodiscard]] std::uint32_t triangle(int i) const noexcept { return m_triangle[i]; }

  private:
    enum class Stage : std::uint8_t
    {
        Empty,
        Found,    ///< triangle indices are known
        Numbered, ///< addresses of the corners are known
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
    // Arrays by facet, padded to a multiple of eight with the last facet.
    const double* m_at[3][kMost]; ///< addresses of the corners
    std::uint32_t m_structure[kMost];
    alignas(32) std::int32_t m_isTwoSided[kMost]; ///< all ones or zero
    std::uint32_t m_triangle[kMost];
};

} // namespace palpate::haptics::internal
