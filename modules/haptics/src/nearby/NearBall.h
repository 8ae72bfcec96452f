// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nearby/BallCell.h"
#include "nearby/TickWork.h"
#include "probe/BallProbe.h"

namespace palpate::haptics::internal {

/// Tells which facets a ball's moves meet: asks the cells that a short move leads through, and the whole hierarchy for
/// the rest of a long one.
class NearBall
{
  public:
    /// Forgets everything: the scene changed.
    void clear() noexcept PALPATE_NONBLOCKING { m_cells.clear(); }

    void beginTick() noexcept PALPATE_NONBLOCKING { m_cells.beginTick(); }

    /// Finds the first facet of the layer that blocks a ball with the scene's radius, its centre going x → y.
    /// @param first  where Blocked: by what; where Unknown: `stop` is the share of the move that may be made, and its
    ///               facet one of those in the way, if its `key` is not beyond 1
    /// @par Real-time Wait-free; bounded by `work`.
    [[nodiscard]] Sweep sweep(const HapticLayer& layer, const Vec3& x, const Vec3& y, TickWork& work,
                              BallCrossing& first) noexcept PALPATE_NONBLOCKING;

    /// Gathers at the end of a tick what the next is expected to ask for, to spread the time over both. Decides
    /// nothing, and is charged like all that is gathered.
    /// @param x,y  where the centre is now, and where the next tick will lead it if it goes on like this
    void prepare(const HapticLayer& layer, const Vec3& x, const Vec3& y, TickWork& work) noexcept PALPATE_NONBLOCKING;

  private:
    struct First;
    class Traversal;

    static void offer(const HapticLayer& layer, const BallCell& cell, double begin, double end, TickWork& work,
                      First& first) noexcept;

    BallCells m_cells;
};

} // namespace palpate::haptics::internal
