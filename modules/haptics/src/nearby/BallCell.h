// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nearby/DistanceLanes.h"
#include "nearby/TickWork.h"
#include "palpate/haptics/HapticScene.h"

#include <array>
#include <cstdint>

namespace palpate::haptics::internal {

/// All facets that a ball may touch whose centre is in or around one cell of a grid: a function of the scene and the
/// cell alone, never of the way that led there.
class BallCell
{
  public:
    /// Facets that a cell holds, at most: a hundred are tested against a move, eight at a time, in half a microsecond.
    static constexpr int kMost = 128;

    void clear() noexcept { m_size_mm = 0.0; }

    /// Finds the facets. @param size_mm  of the grid's cells, of which this is the one around p
    /// @return false when they are too many, and then holds none
    bool gather(const HapticLayer& layer, const core::Vec3& p, double size_mm) noexcept PALPATE_NONBLOCKING;

    /// @return true when p is in the cell itself, gathered or too full.
    [[nodiscard]] bool contains(const core::Vec3& p) const noexcept
    {
        return m_size_mm > 0.0 && cellOf(p, m_size_mm) == m_cell;
    }
    /// Where the ball's centre may be: the cell, and a quarter of its width around it.
    [[nodiscard]] const core::Box& region() const noexcept { return m_region; }
    [[nodiscard]] bool isFull() const noexcept { return m_isFull; } ///< too many facets: none is held
    [[nodiscard]] double size_mm() const noexcept { return m_size_mm; }
    [[nodiscard]] std::uint32_t price() const noexcept { return m_price; } ///< of gathering, in units of TickWork

    [[nodiscard]] const core::Vec3& origin() const noexcept { return m_origin; } ///< of the groups [mm]
    [[nodiscard]] int count() const noexcept { return m_count; }
    [[nodiscard]] float reach_mm() const noexcept { return m_reach_mm; } ///< largest coordinate in the groups
    [[nodiscard]] const TriangleGroup* groups() const noexcept { return m_groups.data(); }
    [[nodiscard]] std::uint32_t structure(int i) const noexcept { return m_structure[static_cast<std::size_t>(i)]; }
    [[nodiscard]] std::uint32_t triangle(int i) const noexcept { return m_triangle[static_cast<std::size_t>(i)]; }

  private:
    class Gathering;

    /// @return a cell's number by axis, as doubles: any position has one.
    [[nodiscard]] static core::Vec3 cellOf(const core::Vec3& p, double size_mm) noexcept
    {
        return (p / size_mm).array().floor();
    }

    double m_size_mm = 0.0; ///< 0: nothing is known
    core::Vec3 m_cell = core::Vec3::Zero();
    core::Box m_region;
    core::Vec3 m_origin = core::Vec3::Zero();
    float m_reach_mm = 0.0f;
    int m_count = 0;
    bool m_isFull = false;
    std::uint32_t m_price = 0;
    std::array<TriangleGroup, kMost / kLanes> m_groups{};
    std::array<std::uint32_t, kMost> m_structure{};
    std::array<std::uint32_t, kMost> m_triangle{};
};

/// The cells used last. A tick pays the price of gathering for each that it comes to, held or not, so that what is held
/// between ticks decides nothing.
class BallCells
{
  public:
    /// Forgets everything: the scene changed.
    void clear() noexcept PALPATE_NONBLOCKING;

    /// A tick begins: each cell is to be paid for again.
    void beginTick() noexcept { m_tickBegan = m_clock; }

    /// @return the cell that p is in, the largest with few enough facets; where there is none, one that `isFull`.
    [[nodiscard]] const BallCell& at(const HapticLayer& layer, const core::Vec3& p,
                                     TickWork& work) noexcept PALPATE_NONBLOCKING;

    /// @return the cell that p is in if the tick has paid for it already, else null.
    [[nodiscard]] const BallCell* paidAt(const core::Vec3& p) const noexcept PALPATE_NONBLOCKING;

    /// @return width of the largest cells [mm]
    [[nodiscard]] double size_mm(const HapticLayer& layer) noexcept PALPATE_NONBLOCKING;

  private:
    static constexpr std::size_t kHeld = 4;

    std::array<BallCell, kHeld> m_cells;
    std::array<std::uint32_t, kHeld> m_price{};   ///< with that of the larger ones that were too full
    std::array<std::uint64_t, kHeld> m_lastUse{}; ///< by m_clock
    std::uint64_t m_clock = 0;
    std::uint64_t m_tickBegan = 0;
    double m_size_mm = 0.0; ///< of the largest cells; 0: not known yet
};

} // namespace palpate::haptics::internal
