// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/ForceTable.h"

#include "law/LawKnots.h"

#include <bit>
#include <cstring>
#include <string>

namespace palpate::haptics {

namespace {

using core::Status;
using core::StatusCode;
using Knot = ForceTable::Knot;
using KnotNumbers = std::array<double, 4>; // of one serialized knot

static_assert(std::endian::native == std::endian::little, "bytes() writes numbers as they lie in memory");

constexpr double kDeepest_mm = 1e9; // maximum depth of a knot; keeps forces finite

/// Returns the error of the cell between two knots; empty if valid.
core::Message problem(const Knot& from, const Knot& to)
{
    const double length = to.depth_mm - from.depth_mm;
    if (!(length >= ForceTable::kLeastCell_mm)) {
        return core::Message(PALPATE_TEXT("is not deeper than the previous knot"));
    }
    const double most = ForceTable::kMaxSlope;
    if (std::abs(from.slopeAfter) > most || std::abs(to.slopeBefore) > most ||
        std::abs(to.force_N - from.force_N) > most * length) {
        return core::Message(PALPATE_TEXT("has a steeper slope than any law"));
    }
    // A cubic lies within the convex hull of its four control points; these are the inner two.
    const double allowed = -1e-9 * (from.force_N + to.force_N);
    if (from.force_N + from.slopeAfter * length / 3.0 < allowed ||
        to.force_N - to.slopeBefore * length / 3.0 < allowed) {
        return core::Message(PALPATE_TEXT("follows a cell with a force below 0"));
    }
    return {};
}

/// Returns the error of a single knot; empty if valid.
core::Message problem(const Knot& knot, bool isFirst, bool isLast)
{
    if (!std::isfinite(knot.depth_mm) || !std::isfinite(knot.force_N) || !std::isfinite(knot.slopeBefore) ||
        !std::isfinite(knot.slopeAfter)) {
        return core::Message(PALPATE_TEXT("has a number that is not finite"));
    }
    if (isFirst && (knot.depth_mm != 0.0 || knot.force_N != 0.0)) {
        return core::Message(PALPATE_TEXT("is not at 0 mm and 0 N"));
    }
    if (knot.force_N < 0.0) {
        return core::Message(PALPATE_TEXT("has a force below 0"));
    }
    if (isLast && (knot.slopeAfter < 0.0 || knot.slopeAfter > ForceTable::kMaxSlope || knot.depth_mm > kDeepest_mm)) {
        return core::Message(PALPATE_TEXT("ends with a slope below 0 or steeper than any law"));
    }
    return {};
}

} // namespace

core::Result<std::shared_ptr<const ForceTable>> ForceTable::fromKnots(std::vector<Knot> knots)
{
    if (knots.empty() || knots.size() > kMostKnots) {
        return Status(StatusCode::OutOfRange, PALPATE_TEXT("force table: found %1 knots, expected 1 to %2"),
                      knots.size(), kMostKnots);
    }
    for (std::size_t i = 0; i < knots.size(); ++i) {
        core::Message what = problem(knots[i], i == 0, i + 1 == knots.size());
        if (what.isEmpty() && i > 0) {
            what = problem(knots[i - 1], knots[i]);
        }
        if (!what.isEmpty()) {
            return Status(StatusCode::OutOfRange, PALPATE_TEXT("force table: knot %1 of %2 %3"), i + 1, knots.size(),
                          what);
        }
    }
    return std::shared_ptr<const ForceTable>(new ForceTable(std::move(knots)));
}

std::shared_ptr<const ForceTable> ForceTable::build(const Tissue& tissue)
{
    if (tissue.law.kind == core::LawKind::Linear || !core::check(tissue.law).isOk()) {
        return {};
    }
    core::Result<std::shared_ptr<const ForceTable>> table = fromKnots(law::knotsOf(tissue.law));
    return table.isOk() ? std::move(table).value() : nullptr;
}

core::Result<std::shared_ptr<const ForceTable>> ForceTable::fromBytes(std::span<const std::byte> bytes)
{
    if (bytes.size() % sizeof(KnotNumbers) != 0 || bytes.size() > kMostKnots * sizeof(KnotNumbers)) {
        return Status(StatusCode::BadFormat, PALPATE_TEXT("force table: found %1 bytes, expected %2 for each knot"),
                      bytes.size(), sizeof(KnotNumbers));
    }
    std::vector<Knot> knots;
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(KnotNumbers)) {
        KnotNumbers numbers;
        std::memcpy(numbers.data(), bytes.data() + at, sizeof(KnotNumbers));
        knots.push_back({numbers[0], numbers[1], numbers[2], numbers[3]});
    }
    return fromKnots(std::move(knots));
}

std::vector<std::byte> ForceTable::bytes() const
{
    std::vector<std::byte> bytes(m_knots.size() * sizeof(KnotNumbers));
    for (std::size_t i = 0; i < m_knots.size(); ++i) {
        const Knot& knot = m_knots[i];
        const KnotNumbers numbers{knot.depth_mm, knot.force_N, knot.slopeBefore, knot.slopeAfter};
        std::memcpy(bytes.data() + i * sizeof(KnotNumbers), numbers.data(), sizeof(KnotNumbers));
    }
    return bytes;
}

ForceTable::Cell ForceTable::cellBetween(const Knot& from, const Knot& to, double energy_mJ)
{
    const double length = to.depth_mm - from.depth_mm;
    const double line = (to.force_N - from.force_N) / length;
    const double square = (3.0 * line - 2.0 * from.slopeAfter - to.slopeBefore) / length;
    const double cube = (from.slopeAfter + to.slopeBefore - 2.0 * line) / (length * length);
    return {from.depth_mm, to.depth_mm, from.force_N, from.slopeAfter, square, cube, energy_mJ, square / 3.0};
}

double ForceTable::greatestSlope(const Cell& cell)
{
    const auto slopeAt = [&](double t) { return cell.rise + t * (2.0 * cell.square + t * (3.0 * cell.cube)); };
    const double length = cell.end_mm - cell.start_mm, top = -cell.square / (3.0 * cell.cube);
    const double within = cell.cube < 0.0 && top > 0.0 && top < length ? slopeAt(top) : cell.rise;
    return std::max({cell.rise, slopeAt(length), within});
}

bool ForceTable::falls(const Cell& cell)
{
    const Cell turned{cell.start_mm, cell.end_mm, -cell.force_N, -cell.rise, -cell.square, -cell.cube, 0.0, 0.0};
    return greatestSlope(turned) > 0.0;
}

ForceTable::ForceTable(std::vector<Knot> knots)
    : m_knots(std::move(knots))
{
    m_cells.reserve(m_knots.size());
    double energy_mJ = 0.0, above = 0.0; // energy and moment accumulated before a cell
    for (std::size_t i = 0; i + 1 < m_knots.size(); ++i) {
        const Cell& cell = m_cells.emplace_back(cellBetween(m_knots[i], m_knots[i + 1], energy_mJ));
        m_greatestSlope = std::max(m_greatestSlope, greatestSlope(cell));
        m_neverFalls = m_neverFalls && !falls(cell);
        const double t = cell.end_mm - cell.start_mm;
        m_moments.push_back(above);
        above += moment(cell, t);
        energy_mJ += t * (cell.force_N + t * (0.5 * cell.rise + t * (cell.third + t * (0.25 * cell.cube))));
    }
    const Knot& last = m_knots.back();
    m_cells.push_back({last.depth_mm, std::numeric_limits<double>::infinity(), last.force_N, last.slopeAfter, 0.0, 0.0,
                       energy_mJ, 0.0});
    m_moments.push_back(above);
    m_greatestSlope = std::max(m_greatestSlope, last.slopeAfter);

    m_firstPlace = placeOf(last.depth_mm) + 2 - kIndexSize; // the last index entry is in the last cell
    std::uint16_t cell = 0;
    for (std::int64_t i = 0; i < kIndexSize; ++i) {
        const std::int64_t place = m_firstPlace + i; // the first entry also covers all smaller depths
        const double shallowest_mm = i > 0 && place > 0 ? std::bit_cast<double>(place << kPlaceShift) : 0.0;
        while (shallowest_mm > m_cells[cell].end_mm) {
            ++cell;
        }
        m_index[static_cast<std::size_t>(i)] = cell;
    }
}

double maxStiffness(const Tissue& tissue)
{
    const std::shared_ptr<const ForceTable> table = ForceTable::build(tissue);
    return table == nullptr ? tissue.stiffness_N_per_mm : table->greatestSlope_N_per_mm();
}

double stiffnessAt(const Tissue& tissue, double depth_mm)
{
    const std::shared_ptr<const ForceTable> table = ForceTable::build(tissue);
    return table == nullptr ? tissue.stiffness_N_per_mm : table->slope(depth_mm);
}

std::size_t ForceTable::byteSize() const noexcept
{
    return sizeof(ForceTable) + m_cells.capacity() * sizeof(Cell) + m_moments.capacity() * sizeof(double) +
           m_knots.capacity() * sizeof(Knot);
}

} // namespace palpate::haptics
