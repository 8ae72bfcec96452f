// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nearby/GatheredFacets.h"

namespace palpate::haptics::internal {

/// How much is gathered at once.
struct GatheringPlan
{
    int few;             ///< facets: with fewer, the next region is larger, or it would be left too soon
    int many;            ///< facets: with more, the next region is smaller, as each facet costs every sweep time
    double narrowest_mm; ///< margin of a region: with less it is left with the next tick, unless not all can be held
    double widest_mm;    ///< margin of a region in free space: on the way to a surface it must not hold all of it
    double around_mm;    ///< how far outside of the region a facet still matters
};

/// The facets around a god-object, gathered once and used for as long as it stays among them: consecutive ticks touch
/// the same few triangles. Complete inside its region, so it never changes an answer, only what the answer costs. While
/// one set is used, the next is gathered where the motion leads, a little in each tick.
class FacetCache
{
  public:
    /// Forgets everything: the scene changed.
    void clear() noexcept PALPATE_NONBLOCKING;

    /// Tells where the god-object stands after a tick.
    void follow(const core::Vec3& g) noexcept PALPATE_NONBLOCKING;

    /// Gathers a part of the facets that the next ticks will need.
    /// @param isNew  nothing was needed here up to now
    void prepare(const HapticLayer& layer, const GatheringPlan& plan, bool isNew) noexcept PALPATE_NONBLOCKING;

    /// @return where the god-object will be by the time that something begun now is ready.
    [[nodiscard]] core::Vec3 soon() const noexcept;

    /// @return mean motion of the last ticks [mm a tick]
    [[nodiscard]] const core::Vec3& motion() const noexcept { return m_motion; }

    [[nodiscard]] const GatheredFacets& held() const noexcept { return m_sets[m_used]; }
    [[nodiscard]] bool holds(const core::Vec3& p) const noexcept { return held().holds(p); }

    /// Goes over to the set that is prepared, if `p` and `q` are in its region. @return false when they are not.
    bool takePrepared(const HapticLayer& layer, const core::Vec3& p, const core::Vec3& q) noexcept PALPATE_NONBLOCKING;

    /// Gathers around the first part of the way x → y, as much as a few margins.
    /// @return false when there are too many; the next attempt is for half the margin.
    bool gather(const HapticLayer& layer, const GatheringPlan& plan, const core::Vec3& x,
                const core::Vec3& y) noexcept PALPATE_NONBLOCKING;

    /// Gathers what matters at `p` alone. @return false when there is too much: then no region with `p` can be held.
    bool gatherAt(const HapticLayer& layer, const GatheringPlan& plan,
                  const core::Vec3& p) noexcept PALPATE_NONBLOCKING;

  private:
    void adapt(const GatheringPlan& plan, int count) noexcept;
    [[nodiscard]] core::Vec3 ahead(const core::Vec3& from) const noexcept;

    std::array<GatheredFacets, 2> m_sets;
    std::size_t m_used = 0;
    double m_margin_mm = 0.0;                 ///< around the god-object's way; 0: not known yet
    core::Vec3 m_last = core::Vec3::Zero();   ///< god-object after the last tick [mm]
    core::Vec3 m_motion = core::Vec3::Zero(); ///< mean of the last ticks [mm]
    bool m_hasLast = false;
};

} // namespace palpate::haptics::internal
