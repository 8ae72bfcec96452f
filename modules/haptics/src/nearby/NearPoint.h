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

/// Which facet: a structure's number and a position in its SurfaceIndex.
struct FacetNumber
{
    std::uint32_t structure;
    std::uint32_t triangle;
};

/// Tells which facets a point's moves meet: asks those gathered around it, and beyond them the whole hierarchy.
class NearPoint
{
  public:
    static constexpr std::size_t kMostPoints = 9; ///< of a path

    /// What a sweep costs, as a rule, when the facets held answer it: to gather up to 64 facets, rule them out and test
    /// those that stay. A traversal that asks no more than twice as many is charged the same, so that the price does
    /// not tell whether it was needed. In units of TickWork.
    static constexpr std::uint32_t kSweepPrice = 64;

    /// Forgets everything: the scene changed.
    void clear() noexcept PALPATE_NONBLOCKING
    {
        m_cache.clear();
        m_around = {};
        m_empty.setEmpty();
    }

    /// Begins a tick, or a part of one, that may do so much work.
    void beginTick(const TickWork& work) noexcept PALPATE_NONBLOCKING { m_work = work; }
    [[nodiscard]] const TickWork& work() const noexcept { return m_work; }
    void spend(std::uint32_t units) noexcept { m_work.spend(units); }

    /// Tells where the god-object stands after a tick.
    /// @par Real-time Wait-free.
    void endTick(const HapticLayer& layer, const Vec3& g) noexcept PALPATE_NONBLOCKING;

    /// The same after a tick that tested no facets.
    /// @param isClearAround  the neighbours of the facet that it ended on are clear, too
    void endClearTick(const HapticLayer& layer, const Vec3& g, bool isClearAround) noexcept PALPATE_NONBLOCKING;

    /// The same after a tick in free space.
    void endFreeTick(const HapticLayer& layer, const Vec3& g) noexcept PALPATE_NONBLOCKING;

    /// @return true when it is known that nothing is anywhere near the move x → y.
    [[nodiscard]] bool isFree(const Vec3& x, const Vec3& y) const noexcept
    {
        return m_empty.contains(x) && m_empty.contains(y);
    }

    /// Finds the first facet of the layer that blocks the move x → y.
    /// @param first   filled when it is blocked; when that is unknown, with a facet that was being asked
    /// @param walked  facets that are known not to block it
    /// @par Real-time Wait-free; bounded by the tick's work.
    [[nodiscard]] Sweep sweep(const HapticLayer& layer, const Vec3& x, const Vec3& y, Crossing& first,
                              std::span<const FacetNumber> walked = {}) noexcept PALPATE_NONBLOCKING;

    /// @return true when the facets around `g` are held: what is asked there costs no gathering.
    [[nodiscard]] bool holds(const Vec3& g) const noexcept { return m_cache.holds(g); }

    /// Gathers along the way from `from` over `place` on to `ahead`, unless the facets around `place` are held. [mm]
    /// @par Real-time Wait-free.
    void reach(const HapticLayer& layer, const Vec3& from, const Vec3& place,
               const Vec3& ahead) noexcept PALPATE_NONBLOCKING;

    /// @return true when no other structure of the layer comes near `p`; false when one may.
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

    /// Follows a chain of straight moves up to the first that is blocked.
    /// @param path    at most kMostPoints points [mm]
    /// @param walked  facets that the path goes over: that before the first move's, then that of each move, and maybe
    ///                that of the path's end. A move is known not to be blocked by its own, nor by those before and
    ///                after
    /// @return how many of the moves are free.
    /// @par Real-time Wait-free.
    [[nodiscard]] std::size_t freeMoves(const HapticLayer& layer, std::span<const Vec3> path,
                                        std::span<const FacetNumber> walked) noexcept PALPATE_NONBLOCKING;

    /// Calls `f(facet)` for every facet that comes within `reach_mm`, at most kNearby skins, of `g`, and maybe for some
    /// that nearly do, in an order that does not depend on what is held.
    /// @return false, without a call, where more lie there than can be held, or the tick's work is spent.
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
    /// What `sweep` does, charged for no more than what a traversal costs beyond a sweep.
    [[nodiscard]] Sweep ask(const HapticLayer& layer, const Vec3& x, const Vec3& y, Crossing& first,
                            std::span<const FacetNumber> walked) noexcept;
    /// The same by a traversal of all hierarchies.
    [[nodiscard]] Sweep sweepAll(const HapticLayer& layer, First nearest) noexcept;
    [[nodiscard]] int near(const HapticLayer& layer, const Vec3& g, double reach_mm,
                           std::array<int, kHeld>& found) noexcept;
    void offerHeld(const HapticLayer& layer, First& first) const noexcept;
    [[nodiscard]] Facet facet(const HapticLayer& layer, int i) const noexcept
    {
        const std::uint32_t structure = m_cache.held().structure(i);
        return Facet::of(layer.surface(structure), structure, m_cache.held().triangle(i));
    }

    /// A box in which it is known whether other structures of the layer are near.
    struct Around
    {
        core::Box box; ///< [mm]
        double half_mm = 0.0;
        std::uint32_t structure = 0;
        bool isAlone = false;
    };
    void lookAround(const HapticLayer& layer, std::uint32_t structure, const Vec3& p) noexcept;

    FacetCache m_cache;
    Around m_around;
    core::Box m_empty;                                          ///< no facet of the layer reaches into it [mm]
    TickWork m_work{std::numeric_limits<std::uint32_t>::max()}; ///< of the tick
};

} // namespace palpate::haptics::internal
