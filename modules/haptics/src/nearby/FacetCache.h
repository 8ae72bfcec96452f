// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nearby/GatheredFacets.h"

namespace palpate::haptics::internal {

/// Parameters of gathering.
struct GatheringPlan
{
    int few;  ///< with fewer facets, the next region is larger, because a small region is left too soon
    int many; ///< with more facets, the next region is smaller, because each facet adds to the cost of every sweep
    double narrowest_mm; ///< minimum margin of a region (a smaller region is left in the next tick), unless not all
                         ///< facets can be cached
    double widest_mm; ///< maximum margin of a region in free space: a region on the way to a surface must not contain
                      ///< all of it
    double around_mm; ///< distance outside the region at which a facet still matters
};

/// Cache of the facets around a god-object: consecutive ticks touch the same few triangles. Complete inside its region,
/// so that the cache changes the cost of a query but never the result. While one set is in use, the next is gathered in
/// the direction of motion, a part in each tick.
class FacetCache
{
  public:
    /// Clears the cache; called when the scene has changed.
    void clear() noexcept PALPATE_NONBLOCKING;

    /// Updates the mean motion with the god-object's position after a tick.
    void follow(const core::Vec3& g) noexcept PALPATE_NONBLOCKING;

    /// Gathers a part of the facets that the next ticks will need.
    /// @param isNew  no facets were needed in this place before
    void prepare(const HapticLayer& layer, const GatheringPlan& plan, bool isNew) noexcept PALPATE_NONBLOCKING;

    /// Returns the expected position of the god-object when a set begun now is ready.
    [[nodiscard]] core::Vec3 soon() const noexcept;

    /// Returns the mean motion of the last ticks [mm per tick].
    [[nodiscard]] const core::Vec3& motion() const noexcept { return m_motion; }

    [[nodiscard]] const GatheredFacets& held() const noexcept { return m_sets[m_used]; }
    [[nodiscard]] bool holds(const core::Vec3& p) const noexcept { return held().holds(p); }

    /// Switches to the prepared set if `p` and `q` are in its region.
    /// @return false if they are not
    bool takePrepared(const HapticLayer& layer, const core::Vec3& p, const core::Vec3& q) noexcept PALPATE_NONBLOCKING;

    /// Gathers around the first part of the path x → y, up to a few margins.
    /// @return false if there are too many facets; the next attempt uses half the margin
    bool gather(const HapticLayer& layer, const GatheringPlan& plan, const core::Vec3& x,
                const core::Vec3& y) noexcept PALPATE_NONBLOCKING;

    /// Gathers only the facets that matter at `p`.
    /// @return false if there are too many: then no region that contains `p` can be cached
    bool gatherAt(const HapticLayer& layer, const GatheringPlan& plan,
                  const core::Vec3& p) noexcept PALPATE_NONBLOCKING;

  private:
    void adapt(const GatheringPlan& plan, int count) noexcept;
    [[nodiscard]] core::Vec3 ahead(const core::Vec3& from) const noexcept;

    std::array<GatheredFacets, 2> m_sets;
    std::size_t m_used = 0;
    double m_margin_mm = 0.0;                 ///< around the god-object's path; 0: not yet known
    core::Vec3 m_last = core::Vec3::Zero();   ///< god-object position after the last tick [mm]
    core::Vec3 m_motion = core::Vec3::Zero(); ///< mean of the last ticks [mm]
    bool m_hasLast = false;
};

} // namespace palpate::haptics::internal
