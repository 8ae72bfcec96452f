// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/Tissue.h"

#include <palpate/core/Export.h>
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

/// Tabulated force law: force and energy as functions of penetration depth, read by the servo thread. Immutable, so a
/// table can be shared between threads.
///
/// Between two knots the force is the cubic Hermite polynomial that matches force and slope at both ends, and the
/// energy is its exact integral, a quartic. Beyond the last knot the force continues linearly with the last slope. Each
/// knot stores a slope on either side, so that a corner of the law stays a corner. Knots are placed where the law needs
/// them (kLawKnots in total) rather than evenly: on even knots Hertz's d^1.5 would have an error of 1e-5 near its
/// start, and the corners of a click would be rounded. A table takes about 29 kB; a bounded table has at most
/// kMostKnots knots and takes up to 108 kB. Building and evaluation use only + - * / and the square root, so that the
/// knots are bit-identical on all machines. See docs/laws.md for the laws.
class PALPATE_EXPORT ForceTable
{
  public:
    /// Force [N] at a depth [mm], with the one-sided slopes [N/mm] before and after the knot.
    struct Knot
    {
        double depth_mm = 0.0, force_N = 0.0, slopeBefore = 0.0, slopeAfter = 0.0;
        friend bool operator==(const Knot&, const Knot&) = default;
    };
    struct Value
    {
        double force_N = 0.0;
        double energy_mJ = 0.0; ///< stored energy, the work done by the hand from the surface to this depth [mJ = N·mm]
    };

    /// Depth range over which analytic laws are tabulated; they continue linearly beyond.
    static constexpr double kReach_mm = 25.0;
    static constexpr std::size_t kLawKnots = 257;
    static constexpr std::size_t kMostKnots = 1024; ///< maximum number of knots of any table, including bounded ones
    /// Minimum distance between knots.
    static constexpr double kLeastCell_mm = 1e-9;

    /// Builds the table of a tissue's force law.
    /// @return null if the law is linear or if `core::check` rejects its parameters
    [[nodiscard]] static std::shared_ptr<const ForceTable> build(const Tissue& tissue);
    /// Builds a table from knots.
    /// @return the table, or an error if the list is empty, exceeds kMostKnots or contains non-finite numbers, if
    /// depths do not ascend, the first knot is not (0, 0), a force falls below 0, a slope exceeds kMaxSlope, or the
    /// last slope is negative
    [[nodiscard]] static core::Result<std::shared_ptr<const ForceTable>> fromKnots(std::vector<Knot> knots);
    /// Reads a table written by `bytes`. Performs the checks of `fromKnots`, so that the force is finite and not
    /// negative for any input.
    [[nodiscard]] static core::Result<std::shared_ptr<const ForceTable>> fromBytes(std::span<const std::byte> bytes);
    /// Serializes the knots.
    /// @return 4 little-endian doubles per knot: depth [mm], force [N], slopes before and after [N/mm]
    [[nodiscard]] std::vector<std::byte> bytes() const;

    /// Returns the largest force law that nowhere exceeds the table's and rises by at most `most_N_per_mm`: the part of
    /// a law that a device with this stiffness limit can display. While the law is monotonic, this is the integral of
    /// min(F', most) until it meets F again.
    /// @param table  null returns null; a table within the limit is returned unchanged
    /// @param most_N_per_mm  stiffness limit of the device [N/mm]
    /// @pre most_N_per_mm > 0
    [[nodiscard]] static std::shared_ptr<const ForceTable> bounded(const std::shared_ptr<const ForceTable>& table,
                                                                   double most_N_per_mm);
    /// Maximum slope [N/mm] of a table, also when read from a recording; steeper tables are rejected. Three times the
    /// limit of core::ForceLaw, because the cubic between two measured points may be three times as steep as the line
    /// between them.
    static constexpr double kMaxSlope = 3001.0;

    /// Returns force [N] and energy [mJ] at a depth [mm]; 0 at and above the surface, and for NaN.
    /// @par Real-time Bounded; touches two cache lines.
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
    /// Returns the first moment of the force, the integral of depth times force from the surface to `depth_mm`
    /// [N·mm^2]; 0 above the surface.
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
    /// Returns the slope of the force [N/mm]; at a knot, the slope before the knot. 0 above the surface.
    [[nodiscard]] double slope(double depth_mm) const noexcept PALPATE_NONBLOCKING
    {
        if (!(depth_mm >= 0.0)) {
            return 0.0;
        }
        const Cell& cell = cellAt(depth_mm);
        const double t = depth_mm - cell.start_mm;
        return cell.rise + t * (2.0 * cell.square + t * (3.0 * cell.cube));
    }

    /// Returns the maximum slope over all depths, including between knots. This is the stiffness that a device must be
    /// able to render.
    [[nodiscard]] double greatestSlope_N_per_mm() const noexcept PALPATE_NONBLOCKING { return m_greatestSlope; }
    /// Returns true if the slope is at least 0 at every depth.
    [[nodiscard]] bool isMonotonic() const noexcept PALPATE_NONBLOCKING { return m_neverFalls; }
    [[nodiscard]] std::span<const Knot> knots() const noexcept { return m_knots; }
    /// Memory of the table in bytes.
    [[nodiscard]] std::size_t byteSize() const noexcept;

    friend bool operator==(const ForceTable& a, const ForceTable& b) { return a.m_knots == b.m_knots; }

  private:
    /// One interval between knots, in a single cache line. F = force + rise t + square t^2 + cube t^3, with t the depth
    /// below the start of the interval.
    struct alignas(64) Cell
    {
        double start_mm, end_mm;
        double force_N, rise, square, cube;
        double energy_mJ;
        double third; ///< square / 3
    };
    static constexpr std::int64_t kIndexSize = 1024; ///< 16 binary exponents with 64 entries each

    explicit ForceTable(std::vector<Knot> knots);
    [[nodiscard]] static Cell cellBetween(const Knot& from, const Knot& to, double energy_mJ);
    [[nodiscard]] static double greatestSlope(const Cell& cell);
    [[nodiscard]] static bool falls(const Cell& cell);
    [[nodiscard]] std::vector<Knot> boundedKnots(double most_N_per_mm) const;

    [[nodiscard]] static double force(const Cell& cell, double t) noexcept
    {
        return cell.force_N + t * (cell.rise + t * (cell.square + t * cell.cube));
    }
    /// Moment of the force from the start of the cell to t below the start.
    [[nodiscard]] static double moment(const Cell& cell, double t) noexcept
    {
        const double energy = t * (cell.force_N + t * (0.5 * cell.rise + t * (cell.third + t * (0.25 * cell.cube))));
        return cell.start_mm * energy +
               t * t * (0.5 * cell.force_N + t * (cell.rise / 3.0 + t * (0.25 * cell.square + t * (0.2 * cell.cube))));
    }
    /// Index entry of a depth > 0: the exponent and the first six bits of the mantissa, so that resolution is highest
    /// at small depths, where laws are curved and knots are dense.
    [[nodiscard]] static std::int64_t placeOf(double depth_mm) noexcept
    {
        return std::bit_cast<std::int64_t>(depth_mm) >> kPlaceShift;
    }
    [[nodiscard]] const Cell& cellAt(double depth_mm) const noexcept
    {
        const std::int64_t place = std::clamp<std::int64_t>(placeOf(depth_mm) - m_firstPlace, 0, kIndexSize - 1);
        const Cell* cell = m_cells.data() + m_index[static_cast<std::size_t>(place)];
        while (depth_mm > cell->end_mm) {
            ++cell; // terminates: the last cell ends at infinity
        }
        return *cell;
    }

    static constexpr int kPlaceShift = 46;
    std::int64_t m_firstPlace = 0; ///< place of the first index entry
    double m_greatestSlope = 0.0;
    bool m_neverFalls = true;
    std::array<std::uint16_t, static_cast<std::size_t>(kIndexSize)>
        m_index{}; ///< first cell that overlaps the index entry
    std::vector<Cell> m_cells;
    std::vector<double> m_moments; ///< moment of the force accumulated before each cell [N·mm^2]
    std::vector<Knot> m_knots;
};

/// Returns the maximum slope of force over depth of a tissue [N/mm].
[[nodiscard]] PALPATE_EXPORT double maxStiffness(const Tissue& tissue);
/// Returns the slope of a tissue's law at a depth [N/mm]. Builds a table on each call: for plots, not for the servo
/// thread.
[[nodiscard]] PALPATE_EXPORT double stiffnessAt(const Tissue& tissue, double depth_mm);

} // namespace palpate::haptics
