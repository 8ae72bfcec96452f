// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/internal/BallCell.h"

#include "palpate/haptics/internal/TriangleBatch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace palpate::haptics::internal {

namespace {

using core::Vec3;

constexpr double kHalfWidth = 0.75; // cells: a cell holds what is needed in it and a quarter of it around it
constexpr double kWanted = 48.0;    // facets in a cell, by the facets' mean size
constexpr int kLevels = 3;          // each half as large as the one before
constexpr std::uint32_t kMostAsked = 4 * BallCell::kMost; // facets by their boxes, before a cell counts as too full

// In units of TickWork.
constexpr std::uint32_t kNode = 3;
constexpr std::uint32_t kFacet = 2;

} // namespace

/// One cell being filled.
class BallCell::Gathering
{
  public:
    Gathering(BallCell& cell, double reach_mm) noexcept
        : m_cell(cell)
        , m_reach_mm(reach_mm)
    {
        std::copy_n(cell.m_origin.data(), 3, m_origin4);
    }

    /// @return false when there is too much
    bool add(const geometry::SurfaceIndex& surface, std::uint32_t structure, std::uint32_t first,
             std::uint32_t n) noexcept
    {
        m_asked += n;
        for (const std::uint32_t end = first + n; first < end; ++first) {
            m_batch.add(surface, structure, first);
            if (m_batch.isFull() && !flush()) {
                return false;
            }
        }
        return m_asked <= kMostAsked;
    }

    /// Keeps those of the batch that the ball may touch.
    bool flush() noexcept
    {
        if (m_batch.isEmpty()) {
            return true;
        }
        TriangleGroup group;
        const float reach = m_batch.derive(m_origin4, group);
        const float nowhere[3]{};
        alignas(32) float distance_mm[kLanes];
        distances(&group, m_batch.count(), nowhere, nowhere, distance_mm);
        const double upTo = m_reach_mm + kDistanceRounding * reach;
        bool isRoom = true;
        forEachBetween(distance_mm, m_batch.count(), kAnyDistance, upTo, [&](int i) {
            if (m_cell.m_count == kMost) {
                isRoom = false;
                return;
            }
            const auto k = static_cast<std::size_t>(m_cell.m_count++);
            m_cell.m_structure[k] = m_batch.structure(i);
            m_cell.m_triangle[k] = m_batch.triangle(i);
            m_cell.m_reach_mm = std::max(m_cell.m_reach_mm, reach);
            copyTriangle(&group, i, m_cell.m_groups.data(), static_cast<int>(k));
        });
        m_batch.clear();
        return isRoom;
    }

    [[nodiscard]] std::uint32_t asked() const noexcept { return m_asked; }

  private:
    BallCell& m_cell;
    double m_reach_mm;
    TriangleBatch m_batch;
    std::uint32_t m_asked = 0;
    double m_origin4[4]{};
};

bool BallCell::gather(const HapticScene& scene, const HapticLayer& layer, const Vec3& p, double size_mm) noexcept
{
    m_size_mm = size_mm;
    m_cell = cellOf(p, size_mm);
    m_origin = (m_cell.array() + 0.5) * size_mm;
    m_region = core::Box(m_origin.array() - kHalfWidth * size_mm, m_origin.array() + kHalfWidth * size_mm);
    m_count = 0;
    m_reach_mm = 0.0f;
    const double reach = scene.fingertip_mm() + layer.skin_mm + std::numbers::sqrt3 * kHalfWidth * size_mm;
    Gathering gathering(*this, reach);
    bool isAll = true;
    std::uint32_t nodes = 0;
    const std::uint32_t above = layer.hierarchy.visitAround(m_origin, reach, [&](std::uint32_t s, std::uint32_t n) {
        for (const std::uint32_t end = s + n; s < end && isAll; ++s) {
            const std::uint32_t number = layer.structures[s];
            const geometry::SurfaceIndex& surface = *scene.structures()[number].surface;
            nodes += surface.hierarchy().visitAround(m_origin, reach, [&](std::uint32_t first, std::uint32_t count) {
                return isAll = gathering.add(surface, number, first, count);
            });
        }
        return isAll;
    });
    isAll = isAll && gathering.flush();
    m_price = kNode * (above + nodes) + kFacet * gathering.asked();
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

double BallCells::size_mm(const HapticScene& scene, const HapticLayer& layer) noexcept
{
    if (m_size_mm == 0.0) {
        // Facets of mean size within a shell around a ball that stands on them.
        const double area = 0.433 * layer.facetSize_mm * layer.facetSize_mm;
        const double r = scene.fingertip_mm(), patch = kWanted * area / std::numbers::pi;
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

const BallCell& BallCells::at(const HapticScene& scene, const HapticLayer& layer, const Vec3& p,
                              TickWork& work) noexcept
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
    const auto oldest = static_cast<std::size_t>(std::min_element(m_lastUse.begin(), m_lastUse.end()) -
                                                 m_lastUse.begin());
    BallCell& cell = m_cells[oldest];
    m_lastUse[oldest] = m_clock;
    m_price[oldest] = 0;
    double size = size_mm(scene, layer);
    for (int level = 0; level < kLevels; ++level, size *= 0.5) {
        const bool isHeld = cell.gather(scene, layer, p, size);
        m_price[oldest] += cell.price();
        if (isHeld) {
            break;
        }
    }
    work.spend(m_price[oldest]);
    return cell;
}

} // namespace palpate::haptics::internal
