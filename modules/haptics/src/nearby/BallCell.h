// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nearby/DistanceLanes.h"
#include "nearby/TickWork.h"
#include "palpate/haptics/HapticScene.h"

#include <array>
#include <cstdint>

namespace palpate::haptics::internal {

/// All facets that a ball may touch whose centre is in or around one cell of a grid. Depends only on the scene and the
/// cell, never on the path that led there.
class BallCell
{
  public:
    /// Maximum number of facets in a cell. Testing a hundred facets against a move, eight at a time, takes half a
    /// microsecond.
    static constexpr int kMost = 128;

    void clear() noexcept { m_size_mm = 0.0; }

    /// Gathers the facets of the cell that contains `p`.
    /// @param size_mm  cell size of the grid
    /// @return false, with no facets, if there are too many
    bool gather(const HapticLayer& layer, const core::Vec3& p, double size_mm) noexcept PALPATE_NONBLOCKING;

    /// Returns true if `p` is in the cell itself, whether gathered or too full.
    [[nodiscard]] bool contains(const core::Vec3& p) const noexcept
    {
        return m_size_mm > 0.0 && cellOf(p, m_size_mm) == m_cell;
    }
    /// Returns the region of the ball's centre for which the cell is complete: the cell and a margin of a quarter of
    /// its width.
    [[nodiscard]] const core::Box& region() const noexcept { return m_region; }
    [[nodiscard]] bool isFull() const noexcept { return m_isFull; } ///< too many facets: the cell is empty
    [[nodiscard]] double size_mm() const noexcept { return m_size_mm; }
    [[nodiscard]] std::uint32_t price() const noexcept { return m_price; } ///< price of gathering, in units of TickWork

    [[nodiscard]] const core::Vec3& origin() const noexcept { return m_origin; } ///< of the groups [mm]
    [[nodiscard]] int count() const noexcept { return m_count; }
    [[nodiscard]] float reach_mm() const noexcept { return m_reach_mm; } ///< largest coordinate in the groups
    [[nodiscard]] const TriangleGroup* groups() const noexcept { return m_groups.data(); }
    [[nodiscard]] std::uint32_t structure(int i) const noexcept { return m_structure[static_cast<std::size_t>(i)]; }
    [[nodiscard]] std::uint32_t triangle(int i) const noexcept { return m_triangle[static_cast<std::size_t>(i)]; }

  private:
    class Gathering;

    /// Returns the integer coordinates of a cell, as doubles to cover any position.
    [[nodiscard]] static core::Vec3 cellOf(const core::Vec3& p, double size_mm) noexcept
    {
        return (p / size_mm).array().floor();
    }

    double m_size_mm = 0.0; ///< 0: empty
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

/// Cache of the most recently used cells. A tick pays the price of gathering for each cell that it visits, cached or
/// not, so that the cache does not influence results.
class BallCells
{
  public:
    /// Clears the cache; called when the scene has changed.
    void clear() noexcept PALPATE_NONBLOCKING;

    /// Begins a tick: each cell must be paid for again.
    void beginTick() noexcept { m_tickBegan = m_clock; }

    /// Returns the cell that contains `p`, at the largest size with few enough facets; if there is none, a cell with
    /// `isFull`.
    [[nodiscard]] const BallCell& at(const HapticLayer& layer, const core::Vec3& p,
                                     TickWork& work) noexcept PALPATE_NONBLOCKING;

    /// Returns the cell that contains `p` if it was paid for in this tick, otherwise null.
    [[nodiscard]] const BallCell* paidAt(const core::Vec3& p) const noexcept PALPATE_NONBLOCKING;

    /// Returns the width of the largest cells [mm].
    [[nodiscard]] double size_mm(const HapticLayer& layer) noexcept PALPATE_NONBLOCKING;

  private:
    static constexpr std::size_t kHeld = 4;

    std::array<BallCell, kHeld> m_cells;
    std::array<std::uint32_t, kHeld> m_price{};   ///< includes the price of the larger cells that were too full
    std::array<std::uint64_t, kHeld> m_lastUse{}; ///< in units of m_clock
    std::uint64_t m_clock = 0;
    std::uint64_t m_tickBegan = 0;
    double m_size_mm = 0.0; ///< of the largest cells; 0: not yet computed
};

} // namespace palpate::haptics::internal
