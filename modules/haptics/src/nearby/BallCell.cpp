// SPDX-License-Identifier: BSD-3-Clause
#include "nearby/BallCell.h"

#include <palpate/geometry/internal/BoxHierarchySwept.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace palpate::haptics::internal {

namespace {

using core::Vec3;

constexpr double kHalfWidth = 0.75; // cells: a cell includes the facets for a margin of a quarter of its width
constexpr double kWanted = 48.0;    // target number of facets of mean size in a cell
constexpr int kLevels = 3;          // each level has half the cell size of the previous one
constexpr std::uint32_t kMaxTested = 8 * BallCell::kMost; // bounding boxes tested before a cell counts as too full

// In units of TickWork.
constexpr std::uint32_t kGather = 90;
constexpr std::uint32_t kNode = 2;
constexpr std::uint32_t kFacet = 1;

} // namespace

/// Gathering of one cell. First collects all candidate facets, then prefetches their corners, then computes distances,
/// so that the memory latency of many facets overlaps.
class BallCell::Gathering
{
  public:
    /// Collects candidates.
    /// @return false if there are too many
    bool find(const geometry::SurfaceIndex& surface, std::uint32_t structure, std::uint32_t first,
              std::uint32_t n) noexcept
    {
        if (m_count + n > kMaxTested) {
            return false;
        }
        surface.prefetchTriangles(first);
        for (const std::uint32_t end = first + n; first < end; ++first) {
            m_structure[m_count] = structure;
            m_triangle[m_count++] = first;
        }
        return true;
    }

    /// Keeps the facets that the ball may touch.
    /// @return false if there are too many
    bool keep(const HapticLayer& layer, double reach_mm, BallCell& cell) noexcept
    {
        locate(layer);
        double origin4[4]{};
        std::copy_n(cell.m_origin.data(), 3, origin4);
        const float nowhere[3]{};
        bool isRoom = true;
        for (std::uint32_t first = 0; first < m_count && isRoom; first += kLanes) {
            Corners corners;
            TriangleGroup group;
            setCorners(m_at[0] + first, m_at[1] + first, m_at[2] + first, origin4, corners);
            std::copy_n(m_isTwoSided.data() + first, kLanes, corners.isTwoSided);
            const float reach = derive(corners, group);
            const int n = static_cast<int>(std::min<std::uint32_t>(m_count - first, kLanes));
            alignas(32) float distance_mm[kLanes];
            distances(&group, n, nowhere, nowhere, distance_mm);
            forEachBetween(distance_mm, n, kAnyDistance, reach_mm + kDistanceRounding * reach, [&](int i) {
                if (cell.m_count == kMost) {
                    isRoom = false;
                    return;
                }
                const auto k = static_cast<std::size_t>(cell.m_count++);
                cell.m_structure[k] = m_structure[first + static_cast<std::uint32_t>(i)];
                cell.m_triangle[k] = m_triangle[first + static_cast<std::uint32_t>(i)];
                cell.m_reach_mm = std::max(cell.m_reach_mm, reach);
                copyTriangle(&group, i, cell.m_groups.data(), static_cast<int>(k));
            });
        }
        return isRoom;
    }

    [[nodiscard]] std::uint32_t found() const noexcept { return m_count; }

  private:
    void locate(const HapticLayer& layer) noexcept
    {
        for (std::uint32_t i = 0; i < m_count; ++i) {
            const geometry::SurfaceIndex& surface = layer.surface(m_structure[i]);
            const geometry::Triangle t = surface.triangle(m_triangle[i]);
            for (std::size_t c = 0; c < 3; ++c) {
                m_at[c][i] = surface.vertex(t[c]).data();
                core::prefetch(m_at[c][i]);
            }
            m_isTwoSided[i] = surface.isTwoSided(m_triangle[i]) ? -1 : 0;
        }
        for (std::uint32_t i = m_count; i % kLanes != 0; ++i) {
            m_isTwoSided[i] = 0;
            for (auto& corner : m_at) {
                corner[i] = corner[m_count - 1]; // pad the last eight with the last facet
            }
        }
    }

    std::uint32_t m_count = 0;
    std::array<std::uint32_t, kMaxTested> m_structure;
    std::array<std::uint32_t, kMaxTested> m_triangle;
    std::array<std::int32_t, kMaxTested> m_isTwoSided; ///< all ones or zero
    const double* m_at[3][kMaxTested];
};

bool BallCell::gather(const HapticLayer& layer, const Vec3& p, double size_mm) noexcept
{
    m_size_mm = size_mm;
    m_cell = cellOf(p, size_mm);
    m_origin = (m_cell.array() + 0.5) * size_mm;
    m_region = core::Box(m_origin.array() - kHalfWidth * size_mm, m_origin.array() + kHalfWidth * size_mm);
    m_count = 0;
    m_reach_mm = 0.0f;
    const double reach = layer.fingertip_mm + layer.skin_mm + std::numbers::sqrt3 * kHalfWidth * size_mm;
    Gathering gathering;
    bool isAll = true;
    std::uint32_t nodes = 0;
    const std::uint32_t above = layer.hierarchy.visitAround(m_origin, reach, [&](std::uint32_t s, std::uint32_t n) {
        for (const std::uint32_t end = s + n; s < end && isAll; ++s) {
            const std::uint32_t number = layer.structures[s];
            const geometry::SurfaceIndex& surface = layer.surface(number);
            nodes += surface.hierarchy().visitAround(m_origin, reach, [&](std::uint32_t first, std::uint32_t count) {
                return isAll = gathering.find(surface, number, first, count);
            });
        }
        return isAll;
    });
    isAll = isAll && gathering.keep(layer, reach, *this);
    m_price = kGather + kNode * (above + nodes) + kFacet * gathering.found();
    m_isFull = !isAll;
    if (m_isFull) {
        m_count = 0;
    }
    return isAll;
}

void BallCells::clear() noexcept
{
    for (BallCell& cell : m_cells) {
        cell.clear();
    }
    m_size_mm = 0.0;
}

double BallCells::size_mm(const HapticLayer& layer) noexcept
{
    if (m_size_mm == 0.0) {
        // Facets of mean size within a shell around a ball in contact with them.
        const double area = 0.433 * layer.facetSize_mm * layer.facetSize_mm; // sqrt(3) / 4
        const double r = layer.fingertip_mm, patch = kWanted * area / std::numbers::pi;
        m_size_mm = patch / (std::sqrt(r * r + patch) + r) / (std::numbers::sqrt3 * kHalfWidth);
    }
    return m_size_mm;
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
    for (std::size_t i = 0; i < kHeld; ++i) {
        if (m_cells[i].contains(p)) {
            if (m_lastUse[i] <= m_tickBegan) {
                work.spend(m_price[i]);
            }
            m_lastUse[i] = m_clock;
            return m_cells[i];
        }
    }
    const auto oldest =
        static_cast<std::size_t>(std::min_element(m_lastUse.begin(), m_lastUse.end()) - m_lastUse.begin());
    BallCell& cell = m_cells[oldest];
    m_lastUse[oldest] = m_clock;
    m_price[oldest] = 0;
    double size = size_mm(layer);
    for (int level = 0; level < kLevels; ++level, size *= 0.5) {
        const bool isHeld = cell.gather(layer, p, size);
        m_price[oldest] += cell.price();
        if (isHeld) {
            break;
        }
    }
    work.spend(m_price[oldest]);
    return cell;
}

} // namespace palpate::haptics::internal
