// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/Tissue.h"

#include <palpate/core/Realtime.h>
#include <palpate/core/Status.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace palpate::haptics {

/// Force and energy of a law by depth: what the servo thread reads. Immutable; shared between threads.
///
/// Between knots the force is the cubic that meets both ends' forces and slopes (Hermite), and the energy its integral,
/// a quartic; after the last knot the force is straight on with the last slope. A knot has a slope to either side, so
/// that a law's corner is a corner. Knots lie where a law needs them (kLawKnots), not evenly: Hertz's d^1.5 would be
/// 1e-5 wrong near its start on even ones, and a click's corners would be rounded. Some 29 kB; a bounded table, at most
/// kMostKnots, 108 kB. Made and read with + - * / and the square root alone, so that the knots give the same bits on
/// each machine. resources/docs/laws.md has the laws.
class ForceTable
{
  public:
    /// A law's force [N] at a depth, and the slope [N/mm] with which it comes and goes on.
    struct Knot
    {
        double depth_mm = 0.0, force_N = 0.0, slopeBefore = 0.0, slopeAfter = 0.0;
        friend bool operator==(const Knot&, const Knot&) = default;
    };
    struct Value
    {
        double force_N = 0.0;
        double energy_mJ = 0.0; ///< done by a hand that pressed in so far; 1 N·mm
    };

    /// Laws that are formulas are tabulated over this depth, and go on straight beyond.
    static constexpr double kReach_mm = 25.0;
    static constexpr std::size_t kLawKnots = 257;
    static constexpr std::size_t kMostKnots = 1024; ///< of a table that was bounded, too
    /// Knots stand at least so far apart.
    static constexpr double kLeastCell_mm = 1e-9;

    /// @return the table of the tissue's law; null where it is linear, and where `core::check` refuses its numbers.
    [[nodiscard]] static std::shared_ptr<const ForceTable> build(const Tissue& tissue);
    /// @return the table of these knots, or what is wrong with them: fewer than one, more than kMostKnots, not
    /// finite, not ascending, a first that is not (0, 0), a force that gets below 0, a slope beyond kMostSlope, an
    /// end that falls.
    [[nodiscard]] static core::Result<std::shared_ptr<const ForceTable>> fromKnots(std::vector<Knot> knots);
    /// The inverse of `bytes`; checks as `fromKnots` does, so whatever the bytes are the force is finite and at least
    /// 0.
    [[nodiscard]] static core::Result<std::shared_ptr<const ForceTable>> fromBytes(std::span<const std::byte> bytes);
    /// @return 4 little-endian doubles a knot: depth [mm], force [N], slope before and after [N/mm].
    [[nodiscard]] std::vector<std::byte> bytes() const;

    /// The largest force nowhere above the table's that rises by at most `most_N_per_mm`: what a device that holds that
    /// much can show of a law. Where the law never falls back, the integral of min(F', most) until it meets F again.
    /// @param table  null gives null; one that is flat enough is returned itself
    /// @pre most_N_per_mm > 0
    [[nodiscard]] static std::shared_ptr<const ForceTable> bounded(const std::shared_ptr<const ForceTable>& table,
                                                                   double most_N_per_mm);
    /// [N/mm] A table or a recording's with a steeper slope is refused: three times core::ForceLaw's most, since the
    /// cubic between two measured points may be that much steeper than the line between them.
    static constexpr double kMostSlope = 3001.0;

    /// The force [N] and energy [mJ] at a depth [mm]; 0 at and above the surface, and for NaN.
    /// @par Real-time Bounded; two cache lines.
    [[nodiscard]] Value at(double depth_mm) const noexcept PALPATE_NONBLOCKING
    {
        if (!(depth_mm > 0.0)) {
            return {};
        }
        const Cell& cell = cellAt(depth_mm);
        const double t = depth_mm - cell.start_mm;
        return {force(cell, t), cell.energy_mJ + t * (cell.force_N + t * (0.5 * cell.rise +
                                                                          t * (cell.third + t * (0.25 * cell.cube))))};
    }
    /// The first moment of the force, the integral of depth times force from the surface down [N·mm^2]; 0 above it.
    [[nodiscard]] double moment(double depth_mm) const noexcept PALPATE_NONBLOCKING
    {
        if (!(depth_mm > 0.0)) {
            return 0.0;
        }
        const Cell& cell = cellAt(depth_mm);
        return m_moments[static_cast<std::size_t>(&cell - m_cells.data())] + moment(cell, depth_mm - cell.start_mm);
    }
    [[nodiscard]] double force(double depth_mm) const noexcept PALPATE_NONBLOCKING
    {
        if (!(depth_mm > 0.0)) {
            return 0.0;
        }
        const Cell& cell = cellAt(depth_mm);
        return force(cell, depth_mm - cell.start_mm);
    }
    [[nodiscard]] double energy(double depth_mm) const noexcept PALPATE_NONBLOCKING { return at(depth_mm).energy_mJ; }
    /// The slope of the force [N/mm]; at a knot that before it. 0 above the surface.
    [[nodiscard]] double slope(double depth_mm) const noexcept PALPATE_NONBLOCKING
    {
        if (!(depth_mm >= 0.0)) {
            return 0.0;
        }
        const Cell& cell = cellAt(depth_mm);
        const double t = depth_mm - cell.start_mm;
        return cell.rise + t * (2.0 * cell.square + t * (3.0 * cell.cube));
    }

    /// The largest slope at any depth, between knots too: what a device must hold.
    [[nodiscard]] double greatestSlope_N_per_mm() const noexcept PALPATE_NONBLOCKING { return m_greatestSlope; }
    /// True when the slope is at least 0 at each depth.
    [[nodiscard]] bool neverFalls() const noexcept PALPATE_NONBLOCKING { return m_neverFalls; }
    [[nodiscard]] std::span<const Knot> knots() const noexcept { return m_knots; }
    /// Bytes of the table.
    [[nodiscard]] std::size_t byteSize() const noexcept;

    friend bool operator==(const ForceTable& a, const ForceTable& b) { return a.m_knots == b.m_knots; }

  private:
    /// F = force + rise t + square t^2 + cube t^3, t the depth below the start: one cache line.
    struct alignas(64) Cell
    {
        double start_mm, end_mm;
        double force_N, rise, square, cube;
        double energy_mJ;
        double third; ///< square / 3
    };
    static constexpr std::int64_t kIndexSize = 1024; ///< 16 halvings of the depth, each in 64 places

    explicit ForceTable(std::vector<Knot> knots);
    [[nodiscard]] static Cell cellBetween(const Knot& from, const Knot& to, double energy_mJ);
    [[nodiscard]] static double greatestSlope(const Cell& cell);
    [[nodiscard]] static bool falls(const Cell& cell);
    [[nodiscard]] std::vector<Knot> boundedKnots(double most_N_per_mm) const;

    [[nodiscard]] static double force(const Cell& cell, double t) noexcept
    {
        return cell.force_N + t * (cell.rise + t * (cell.square + t * cell.cube));
    }
    /// From the cell's start to t below it.
    [[nodiscard]] static double moment(const Cell& cell, double t) noexcept
    {
        const double energy = t * (cell.force_N + t * (0.5 * cell.rise + t * (cell.third + t * (0.25 * cell.cube))));
        return cell.start_mm * energy +
               t * t * (0.5 * cell.force_N + t * (cell.rise / 3.0 + t * (0.25 * cell.square + t * (0.2 * cell.cube))));
    }
    /// Of a depth > 0: its exponent and the first six bits of its mantissa, so that places stand close where it is
    /// small. Laws are curved at their start, and there the knots stand close, too.
    [[nodiscard]] static std::int64_t placeOf(double depth_mm) noexcept
    {
        return std::bit_cast<std::int64_t>(depth_mm) >> kPlaceShift;
    }
    [[nodiscard]] const Cell& cellAt(double depth_mm) const noexcept
    {
        const std::int64_t place = std::clamp<std::int64_t>(placeOf(depth_mm) - m_firstPlace, 0, kIndexSize - 1);
        const Cell* cell = m_cells.data() + m_index[static_cast<std::size_t>(place)];
        while (depth_mm > cell->end_mm) {
            ++cell; // the last cell ends at infinity
        }
        return *cell;
    }

    static constexpr int kPlaceShift = 46;
    std::int64_t m_firstPlace = 0; ///< of the index
    double m_greatestSlope = 0.0;
    bool m_neverFalls = true;
    std::array<std::uint16_t, static_cast<std::size_t>(kIndexSize)> m_index{}; ///< the first cell that a place may mean
    std::vector<Cell> m_cells;
    std::vector<double> m_moments; ///< of what lies above each cell
    std::vector<Knot> m_knots;
};

/// @return the largest slope of force by depth that a hand meets on such a tissue [N/mm].
[[nodiscard]] double greatestStiffness(const Tissue& tissue);
/// @return the slope at a depth [N/mm]. Builds a table: for a picture, not for the servo thread.
[[nodiscard]] double stiffnessAt(const Tissue& tissue, double depth_mm);

} // namespace palpate::haptics
