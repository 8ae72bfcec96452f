// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nearby/TickWork.h"
#include "nearby/TriangleBatch.h"
#include "palpate/haptics/HapticScene.h"

#include <array>
#include <cstdint>

namespace palpate::haptics::internal {

/// All facets that a ball may touch whose centre is in or around one cell of a grid: a function of the scene and the
/// cell alone, never of the way that led there.
class BallCell
{
  public:
    /// Facets that a cell holds, at most: a hundred tell eight a time whether a move may touch them in half a
    /// microsecond.
    static constexpr int kMost = 128;

    void clear() noexcept { m_isReady = false; }

    /// @return true when p is in the cell itself, gathered or too full.
    [[nodiscard]] bool contains(const core::Vec3& p) const noexcept
    {
        return m_isReady && cellOf(p, m_size_mm) == m_cell;
    }
    /// Where the ball's centre may be: the cell, and a quarter of its width around it.
    [[nodiscard]] const core::Box& region() const noexcept { return m_region; }
    [[nodiscard]] bool isFull() const noexcept { return m_isFull; } ///< too many facets: none is held
    [[nodiscard]] double size_mm() const noexcept { return m_size_mm; }
    /// @return what gathering costs, in units of TickWork, with that of the larger cells that were too full.
    [[nodiscard]] std::uint32_t price() const noexcept { return m_price; }

    [[nodiscard]] const core::Vec3& origin() const noexcept { return m_origin; } ///< of the groups [mm]
    [[nodiscard]] int count() const noexcept { return m_count; }
    [[nodiscard]] float reach_mm() const noexcept { return m_reach_mm; } ///< largest coordinate in the groups
    [[nodiscard]] const TriangleGroup* groups() const noexcept { return m_groups.data(); }
    [[nodiscard]] std::uint32_t structure(int i) const noexcept { return m_structure[static_cast<std::size_t>(i)]; }
    [[nodiscard]] std::uint32_t triangle(int i) const noexcept { return m_triangle[static_cast<std::size_t>(i)]; }

    /// @return a cell's number by axis, as doubles: any position has one.
    [[nodiscard]] static core::Vec3 cellOf(const core::Vec3& p, double size_mm) noexcept
    {
        return (p / size_mm).array().floor();
    }

  private:
    friend class CellGathering;

    bool m_isReady = false; ///< else nothing is known
    double m_size_mm = 0.0;
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

/// Fills a cell by steps, so that the work can be spread over ticks: first the facets whose boxes come near are found,
/// then those that the ball may touch are kept, eight at a time. Where there are too many, the cell half as wide around
/// the same place is filled instead, twice at most.
class CellGathering
{
  public:
    /// @param p        in the cell [mm]
    /// @param size_mm  of the largest cells
    void begin(BallCell& cell, const core::Vec3& p, double size_mm) noexcept PALPATE_NONBLOCKING;
    void stop() noexcept { m_cell = nullptr; }

    /// One step: finds, or keeps of at most so many eights. The cell is ready with the last.
    void proceed(const HapticLayer& layer, std::uint32_t groups) noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] const BallCell* cell() const noexcept { return m_cell; } ///< that is being filled; null: none
    /// @return true when it began for a place in the same one of the largest cells.
    [[nodiscard]] bool isFor(const core::Vec3& p, double size_mm) const noexcept
    {
        return m_cell != nullptr && BallCell::cellOf(p, size_mm) == BallCell::cellOf(m_p, size_mm);
    }

  private:
    static constexpr std::uint32_t kMostAsked = 8 * BallCell::kMost; // facets by their boxes: more count as too many

    void beginLevel() noexcept;
    [[nodiscard]] bool find(const HapticLayer& layer) noexcept;
    [[nodiscard]] bool keep(const HapticLayer& layer, std::uint32_t groups) noexcept;
    void ask(const HapticLayer& layer, std::uint32_t end) const noexcept;
    void endLevel(bool isAll) noexcept;

    BallCell* m_cell = nullptr;
    core::Vec3 m_p = core::Vec3::Zero();
    double m_keep_mm = 0.0; ///< what comes so near to the cell's middle is kept
    int m_level = 0;
    bool m_isFound = false;
    std::uint32_t m_count = 0; ///< found
    std::uint32_t m_asked = 0; ///< of those, that it is known of whether they are kept
    std::array<std::uint32_t, kMostAsked> m_structure;
    std::array<std::uint32_t, kMostAsked> m_triangle;
};

/// The cells used last, and the one that the motion leads to. A tick pays the price of gathering for each that it comes
/// to, held or not, so that what is held between ticks decides nothing.
class BallCells
{
  public:
    /// Forgets everything: the scene changed.
    void clear() noexcept PALPATE_NONBLOCKING;

    /// A tick begins: each cell is to be paid for again.
    void beginTick() noexcept { m_tickBegan = m_clock; }

    /// A tick has ended with the ball's centre at `g`: does a part of what the next will need. [mm]
    void endTick(const HapticLayer& layer, const core::Vec3& g) noexcept PALPATE_NONBLOCKING;

    /// @return the cell that p is in, the largest with few enough facets; where there is none, one that `isFull`.
    [[nodiscard]] const BallCell& at(const HapticLayer& layer, const core::Vec3& p,
                                     TickWork& work) noexcept PALPATE_NONBLOCKING;

    /// @return the cell that p is in if the tick has paid for it already, else null.
    [[nodiscard]] const BallCell* paidAt(const core::Vec3& p) const noexcept PALPATE_NONBLOCKING;

    /// @return width of the largest cells [mm]
    [[nodiscard]] double size_mm(const HapticLayer& layer) noexcept PALPATE_NONBLOCKING;

  private:
    static constexpr std::size_t kHeld = 4;

    [[nodiscard]] std::size_t held(const core::Vec3& p) const noexcept;
    [[nodiscard]] std::size_t oldest() const noexcept;

    std::array<BallCell, kHeld> m_cells;
    std::array<std::uint64_t, kHeld> m_lastUse{}; ///< by m_clock
    CellGathering m_next;                         ///< of one of the cells
    std::uint64_t m_clock = 0;
    std::uint64_t m_tickBegan = 0;
    double m_size_mm = 0.0;                   ///< of the largest cells; 0: not known yet
    core::Vec3 m_last = core::Vec3::Zero();   ///< the ball's centre after the last tick [mm]
    core::Vec3 m_motion = core::Vec3::Zero(); ///< mean of the last ticks [mm]
    bool m_hasLast = false;
};

} // namespace palpate::haptics::internal
