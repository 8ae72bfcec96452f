// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nearby/BallCell.h"
#include "nearby/TickWork.h"
#include "nearby/TightRoom.h"
#include "probe/BallProbe.h"

namespace palpate::haptics::internal {

/// Finds the facets that block moves of a ball: tests the grid cells that a short move passes through, and traverses
/// the whole hierarchy for the rest of a long one.
class NearBall
{
  public:
    /// Clears the cache; called when the scene has changed.
    void clear() noexcept PALPATE_NONBLOCKING { m_cells.clear(); }

    void beginTick() noexcept PALPATE_NONBLOCKING { m_cells.beginTick(); }

    /// Finds the first facet of the layer that blocks a ball of the scene's radius whose centre moves x → y.
    /// @param room  smaller distances to be kept from some parts of surfaces; may be null
    /// @param work  remaining budget
    /// @param first  if Blocked: the first crossing; if Unknown: `stop` is the fraction of the move that may be made,
    /// and if `key` is at most 1, `facet` is one of the blocking facets
    /// @par Real-time Wait-free; bounded by `work`.
    [[nodiscard]] Sweep sweep(const HapticLayer& layer, const TightRoom* room, const Vec3& x, const Vec3& y,
                              TickWork& work, BallCrossing& first) noexcept PALPATE_NONBLOCKING;

    /// Gathers at the end of a tick the cells that the next tick is expected to need, to spread the time over both.
    /// Does not influence results, and is charged like all gathering.
    /// @param x,y  current position of the centre, and the position expected after the next tick
    void prepare(const HapticLayer& layer, const Vec3& x, const Vec3& y, TickWork& work) noexcept PALPATE_NONBLOCKING;

  private:
    struct First;
    class Traversal;

    static void offer(const HapticLayer& layer, const BallCell& cell, double begin, double end, TickWork& work,
                      First& first) noexcept;

    BallCells m_cells;
};

} // namespace palpate::haptics::internal
