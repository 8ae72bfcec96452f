// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nearby/FacetCache.h"
#include "nearby/TickWork.h"
#include "probe/PointProbe.h"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>

namespace palpate::haptics::internal {

/// Identifies a facet: index of the structure and index in its SurfaceIndex.
struct FacetNumber
{
    std::uint32_t structure;
    std::uint32_t triangle;
};

/// Finds the facets that block moves of a point: tests the facets cached around the point, and beyond these traverses
/// the whole hierarchy.
class NearPoint
{
  public:
    static constexpr std::size_t kMaxPoints = 9; ///< of a path

    /// Fixed price of a sweep answered from the cache, in units of TickWork: gathering up to 64 facets, ruling them out
    /// and testing the remaining ones. A traversal that visits at most twice as many facets has the same price, so that
    /// the price does not depend on whether a traversal was needed.
    static constexpr std::uint32_t kSweepPrice = 64;

    /// Clears the cache; called when the scene has changed.
    void clear() noexcept PALPATE_NONBLOCKING
    {
        m_cache.clear();
        m_around = {};
        m_empty.setEmpty();
    }

    /// Begins a tick, or a part of a tick, with this work budget.
    void beginTick(const TickWork& work) noexcept PALPATE_NONBLOCKING { m_work = work; }
    [[nodiscard]] const TickWork& work() const noexcept { return m_work; }
    void spend(std::uint32_t units) noexcept { m_work.spend(units); }

    /// Updates the cache with the god-object's position after a tick.
    /// @par Real-time Wait-free.
    void endTick(const HapticLayer& layer, const Vec3& g) noexcept PALPATE_NONBLOCKING;

    /// Same as `endTick`, after a tick that tested no facets.
    /// @param isClearAround  the neighbours of the final facet are clear, too
    void endClearTick(const HapticLayer& layer, const Vec3& g, bool isClearAround) noexcept PALPATE_NONBLOCKING;

    /// Same as `endTick`, after a tick in free space.
    void endFreeTick(const HapticLayer& layer, const Vec3& g) noexcept PALPATE_NONBLOCKING;

    /// Returns true if no facet is known to be near the move x → y.
    [[nodiscard]] bool isFree(const Vec3& x, const Vec3& y) const noexcept
    {
        return m_empty.contains(x) && m_empty.contains(y);
    }

    /// Finds the first facet of the layer that blocks the move x → y.
    /// @param first   set if the move is blocked; if the result is Unknown, contains one of the facets tested
    /// @param walked  facets known not to block the move
    /// @par Real-time Wait-free; bounded by the tick's work.
    [[nodiscard]] Sweep sweep(const HapticLayer& layer, const Vec3& x, const Vec3& y, Crossing& first,
                              std::span<const FacetNumber> walked = {}) noexcept PALPATE_NONBLOCKING;

    /// Returns true if the facets around `g` are cached, so that queries there require no gathering.
    [[nodiscard]] bool holds(const Vec3& g) const noexcept { return m_cache.holds(g); }

    /// Gathers the facets along the path from `from` through `place` to `ahead` [mm], unless the facets around `place`
    /// are cached.
    /// @par Real-time Wait-free.
    void reach(const HapticLayer& layer, const Vec3& from, const Vec3& place,
               const Vec3& ahead) noexcept PALPATE_NONBLOCKING;

    /// Returns true if no other structure of the layer is near `p`; conservative.
    /// @par Real-time Wait-free.
    [[nodiscard]] bool isAlone(const HapticLayer& layer, std::uint32_t structure,
                               const Vec3& p) noexcept PALPATE_NONBLOCKING
    {
        if (layer.structures.size() == 1) {
            return true;
        }
        if (m_around.structure != structure || !m_around.box.contains(p)) {
            lookAround(layer, structure, p);
        }
        return m_around.isAlone;
    }

    /// Tests a chain of straight moves up to the first blocked one.
    /// @param path    at most kMaxPoints points [mm]
    /// @param walked  facets below the path: first the facet before the first move, then one per move, and optionally
    /// the facet at the end. A move is known not to be blocked by its own facet nor by the previous and the next one
    /// @return the number of free moves at the start of the path
    /// @par Real-time Wait-free.
    [[nodiscard]] std::size_t freeMoves(const HapticLayer& layer, std::span<const Vec3> path,
                                        std::span<const FacetNumber> walked) noexcept PALPATE_NONBLOCKING;

    /// Calls `f(facet)` for each facet within `reach_mm` of `g` (at most kMaxQueryRadius skins), and possibly for
    /// facets slightly farther away. The order does not depend on the cache.
    /// @return false, without calling `f`, if there are more facets than can be cached or the tick's work is spent
    template<class F>
    bool forEachNear(const HapticLayer& layer, const Vec3& g, double reach_mm, F&& f) noexcept
    {
        std::array<int, kHeld> found;
        const int count = near(layer, g, reach_mm, found);
        for (int i = 0; i < count; ++i) {
            f(facet(layer, found[static_cast<std::size_t>(i)]));
        }
        return holds(g) && !m_work.isSpent();
    }

  private:
    static constexpr int kHeld = GatheredFacets::kMost;

    struct First;
    /// Implements `sweep`. Charges only for the work of a traversal beyond the fixed price.
    [[nodiscard]] Sweep ask(const HapticLayer& layer, const Vec3& x, const Vec3& y, Crossing& first,
                            std::span<const FacetNumber> walked) noexcept;
    /// Implements `sweep` by a traversal of all hierarchies.
    [[nodiscard]] Sweep sweepAll(const HapticLayer& layer, First nearest) noexcept;
    [[nodiscard]] int near(const HapticLayer& layer, const Vec3& g, double reach_mm,
                           std::array<int, kHeld>& found) noexcept;
    void offerHeld(const HapticLayer& layer, First& first) const noexcept;
    [[nodiscard]] Facet facet(const HapticLayer& layer, int i) const noexcept
    {
        const std::uint32_t structure = m_cache.held().structure(i);
        return Facet::of(layer.surface(structure), structure, m_cache.held().triangle(i));
    }

    /// A box in which the proximity of other structures of the layer is known.
    struct Around
    {
        core::Box box; ///< world frame [mm]
        double half_mm = 0.0;
        std::uint32_t structure = 0;
        bool isAlone = false;
    };
    void lookAround(const HapticLayer& layer, std::uint32_t structure, const Vec3& p) noexcept;

    FacetCache m_cache;
    Around m_around;
    core::Box m_empty;                                          ///< no facet of the layer reaches into this box [mm]
    TickWork m_work{std::numeric_limits<std::uint32_t>::max()}; ///< remaining work of the tick
};

} // namespace palpate::haptics::internal
