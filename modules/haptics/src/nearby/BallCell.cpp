// SPDX-License-Identifier: BSD-3-Clause
#include "nearby/BallCell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace palpate::haptics::internal {

namespace {

using core::Vec3;

constexpr double kHalfWidth = 0.75; // cells: a cell holds what is needed in it and a quarter of it around it
constexpr double kWanted = 48.0;    // facets in a cell, by the facets' mean size
constexpr int kLevels = 3;          // each half as large as the one before

// In units of TickWork.
constexpr std::uint32_t kNodePrice = 3;
constexpr std::uint32_t kFacetPrice = 2;

constexpr std::uint32_t kAhead = 8; // eights whose corners are asked for before they are looked at

// The cell that the motion leads to in so many ticks is prepared, so many eights of facets in each.
constexpr double kTicksAhead = 4.0;
constexpr std::uint32_t kGroupsATick = 4;
constexpr double kNewestShare = 0.25; // of the last tick in the mean motion

constexpr std::uint32_t kAllGroups = std::numeric_limits<std::uint32_t>::max() / kLanes;

} // namespace

void CellGathering::begin(BallCell& cell, const Vec3& p, double size_mm) noexcept
{
    m_cell = &cell;
    m_p = p;
    m_level = 0;
    cell.m_isReady = false;
    cell.m_price = 0;
    cell.m_size_mm = size_mm;
    beginLevel();
}

void CellGathering::beginLevel() noexcept
{
    BallCell& cell = *m_cell;
    const double size = cell.m_size_mm;
    cell.m_cell = BallCell::cellOf(m_p, size);
    cell.m_origin = (cell.m_cell.array() + 0.5) * size;
    cell.m_region = core::Box(cell.m_origin.array() - kHalfWidth * size, cell.m_origin.array() + kHalfWidth * size);
    cell.m_count = 0;
    cell.m_reach_mm = 0.0f;
    m_isFound = false;
    m_count = m_asked = 0;
}

/// What was begun has come to its end, or to too many facets.
void CellGathering::endLevel(bool isAll) noexcept
{
    BallCell& cell = *m_cell;
    if (!isAll && ++m_level < kLevels) {
        cell.m_size_mm *= 0.5;
        beginLevel();
        return;
    }
    cell.m_isFull = !isAll;
    if (!isAll) {
        cell.m_count = 0;
    }
    cell.m_isReady = true;
    m_cell = nullptr;
}

void CellGathering::proceed(const HapticLayer& layer, std::uint32_t groups) noexcept
{
    if (!m_isFound) {
        m_isFound = true;
        if (!find(layer)) {
            endLevel(false);
        } else if (m_count == 0) {
            endLevel(true);
        }
    } else if (!keep(layer, groups)) {
        endLevel(false);
    } else if (m_asked >= m_count) {
        endLevel(true);
    }
}

/// @return false when there are too many
bool CellGathering::find(const HapticLayer& layer) noexcept
{
    BallCell& cell = *m_cell;
    m_keep_mm = layer.fingertip_mm + layer.skin_mm + std::numbers::sqrt3 * kHalfWidth * cell.m_size_mm;
    bool isAll = true;
    std::uint32_t nodes = 0;
    const std::uint32_t above =
        layer.hierarchy.visitAround(cell.m_origin, m_keep_mm, [&](std::uint32_t s, std::uint32_t n) {
            for (const std::uint32_t end = s + n; s < end && isAll; ++s) {
                const std::uint32_t number = layer.structures[s];
                const geometry::SurfaceIndex& surface = layer.surface(number);
                const auto leaf = [&](std::uint32_t first, std::uint32_t count) {
                    isAll = m_count + count <= kMostAsked;
                    if (isAll) {
                        surface.prefetchTriangles(first);
                        for (const std::uint32_t last = first + count; first < last; ++first) {
                            m_structure[m_count] = number;
                            m_triangle[m_count++] = first;
                        }
                    }
                    return isAll;
                };
                nodes += surface.hierarchy().visitAround(cell.m_origin, m_keep_mm, leaf);
            }
            return isAll;
        });
    cell.m_price += kNodePrice * (above + nodes) + kFacetPrice * m_count;
    return isAll;
}

/// Asks for the corners of what is looked at next, without waiting for them.
void CellGathering::ask(const HapticLayer& layer, std::uint32_t end) const noexcept
{
    for (std::uint32_t i = m_asked; i < std::min(end, m_count); ++i) {
        layer.surface(m_structure[i]).prefetchCorners(m_triangle[i]);
    }
}

/// Keeps what the ball may touch. @return false when there are too many
bool CellGathering::keep(const HapticLayer& layer, std::uint32_t groups) noexcept
{
    BallCell& cell = *m_cell;
    double origin4[4]{};
    std::copy_n(cell.m_origin.data(), 3, origin4);
    const float nowhere[3]{};
    for (; groups > 0 && m_asked < m_count; --groups) {
        if (m_asked % (kAhead * kLanes) == 0) {
            ask(layer, m_asked + kAhead * kLanes);
        }
        const auto n = static_cast<int>(std::min<std::uint32_t>(m_count - m_asked, kLanes));
        TriangleBatch batch;
        for (int i = 0; i < n; ++i, ++m_asked) {
            batch.add(layer.surface(m_structure[m_asked]), m_structure[m_asked], m_triangle[m_asked]);
        }
        TriangleGroup group;
        const float reach = batch.derive(origin4, group);
        alignas(32) float distance_mm[kLanes];
        distances(&group, n, nowhere, nowhere, distance_mm);
        bool isRoom = true;
        forEachBetween(distance_mm, n, kAnyDistance, m_keep_mm + kDistanceRounding * reach, [&](int i) {
            if (cell.m_count == BallCell::kMost) {
                isRoom = false;
                return;
            }
            const auto k = static_cast<std::size_t>(cell.m_count++);
            cell.m_structure[k] = batch.structure(i);
            cell.m_triangle[k] = batch.triangle(i);
            cell.m_reach_mm = std::max(cell.m_reach_mm, reach);
            copyTriangle(&group, i, cell.m_groups.data(), static_cast<int>(k));
        });
        if (!isRoom) {
            return false;
        }
    }
    return true;
}

void BallCells::clear() noexcept
{
    m_next.stop();
    for (BallCell& cell : m_cells) {
        cell.clear();
    }
    m_size_mm = 0.0;
    m_hasLast = false;
    m_motion = Vec3::Zero();
}

double BallCells::size_mm(const HapticLayer& layer) noexcept
{
    if (m_size_mm == 0.0) {
        // Facets of mean size within a shell around a ball that stands on them.
        const double area = 0.433 * layer.facetSize_mm * layer.facetSize_mm;
        const double r = layer.fingertip_mm, patch = kWanted * area / std::numbers::pi;
        m_size_mm = patch / (std::sqrt(r * r + patch) + r) / (std::numbers::sqrt3 * kHalfWidth);
    }
    return m_size_mm;
}

/// @return number of the cell that p is in; kHeld: none
std::size_t BallCells::held(const Vec3& p) const noexcept
{
    std::size_t i = 0;
    while (i < kHeld && !m_cells[i].contains(p)) {
        ++i;
    }
    return i;
}

/// @return number of the cell that was used the longest ago, but for the one that is being filled
std::size_t BallCells::oldest() const noexcept
{
    std::size_t best = kHeld;
    for (std::size_t i = 0; i < kHeld; ++i) {
        if (&m_cells[i] != m_next.cell() && (best == kHeld || m_lastUse[i] < m_lastUse[best])) {
            best = i;
        }
    }
    return best;
}

void BallCells::endTick(const HapticLayer& layer, const Vec3& g) noexcept
{
    if (m_hasLast) {
        m_motion += kNewestShare * (g - m_last - m_motion);
    }
    m_last = g;
    m_hasLast = true;
    if (m_next.cell() != nullptr) {
        m_next.proceed(layer, kGroupsATick);
        return;
    }
    const Vec3 soon = g + kTicksAhead * m_motion;
    if (held(g) < kHeld && held(soon) == kHeld && (soon - g).cwiseAbs().maxCoeff() <= size_mm(layer)) {
        const std::size_t i = oldest();
        m_lastUse[i] = m_tickBegan; // not to make room again before it is used
        m_next.begin(m_cells[i], soon, size_mm(layer));
    }
}

const BallCell* BallCells::paidAt(const Vec3& p) const noexcept
{
    for (std::size_t i = 0; i < kHeld; ++i) {
        if (m_lastUse[i] > m_tickBegan && m_cells[i].contains(p)) {
            return &m_cells[i];
        }
    }
    return nullptr;
}

const BallCell& BallCells::at(const HapticLayer& layer, const Vec3& p, TickWork& work) noexcept
{
    ++m_clock;
    if (m_next.isFor(p, size_mm(layer)) && held(p) == kHeld) {
        while (m_next.cell() != nullptr) {
            m_next.proceed(layer, kAllGroups);
        }
    }
    std::size_t i = held(p);
    if (i == kHeld) {
        i = oldest();
        CellGathering gathering;
        gathering.begin(m_cells[i], p, size_mm(layer));
        while (gathering.cell() != nullptr) {
            gathering.proceed(layer, kAllGroups);
        }
        m_lastUse[i] = 0;
    }
    if (m_lastUse[i] <= m_tickBegan) {
        work.spend(m_cells[i].price());
    }
    m_lastUse[i] = m_clock;
    return m_cells[i];
}

} // namespace palpate::haptics::internal
