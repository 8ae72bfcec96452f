// SPDX-License-Identifier: BSD-3-Clause
#include "nearby/GatheredFacets.h"

#include <palpate/geometry/internal/BoxHierarchyVisit.h>

#include <algorithm>
#include <cstring>

namespace palpate::haptics::internal {

bool GatheredFacets::begin(const HapticLayer& layer, const core::Box& region, const core::Vec3& origin,
                           double around_mm) noexcept
{
    clear();
    m_region = region;
    m_origin = origin;
    std::copy_n(origin.data(), 3, m_origin4);
    const core::Box query(region.min().array() - around_mm, region.max().array() + around_mm);
    bool isAll = true;
    layer.hierarchy.visitBox(query, [&](std::uint32_t firstStructure, std::uint32_t structureCount) {
        for (std::uint32_t s = firstStructure; s < firstStructure + structureCount && isAll; ++s) {
            const std::uint32_t number = layer.structures[s];
            const geometry::SurfaceIndex& surface = layer.surface(number);
            const int before = m_count;
            surface.hierarchy().visitBox(query, [&](std::uint32_t first, std::uint32_t n) {
                if (m_count + static_cast<int>(n) > kMost) {
                    isAll = false;
                    return false;
                }
                surface.prefetchTriangles(first);
                for (const std::uint32_t end = first + n; first < end; ++first) {
                    m_triangle[m_count++] = first;
                }
                return true;
            });
            std::fill(m_structure + before, m_structure + m_count, number);
        }
        return isAll;
    });
    if (!isAll) {
        m_count = 0;
        return false;
    }
    m_stage = m_count == 0 ? Stage::Ready : Stage::Found;
    m_filled = 0;
    m_reach_mm = 0.0f;
    return true;
}

void GatheredFacets::number(const HapticLayer& layer) noexcept
{
    const geometry::SurfaceIndex* surface = nullptr;
    std::uint32_t structure = m_structure[0] + 1;
    for (int i = 0; i < m_count; ++i) {
        if (m_structure[i] != structure) {
            structure = m_structure[i];
            surface = &layer.surface(structure);
        }
        const geometry::Triangle t = surface->triangle(m_triangle[i]);
        for (std::size_t c = 0; c < 3; ++c) {
            m_at[c][i] = surface->vertex(t[c]).data();
            core::prefetch(m_at[c][i]); // overlap the memory latency of all facets
        }
        m_isTwoSided[i] = surface->isTwoSided(m_triangle[i]) ? -1 : 0;
    }
    for (int i = m_count; i % kLanes != 0; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            m_at[c][i] = m_at[c][m_count - 1];
        }
        m_isTwoSided[i] = 0;
    }
}

void GatheredFacets::proceed(const HapticLayer& layer, int groups) noexcept
{
    if (m_stage == Stage::Found) {
        number(layer);
        m_stage = Stage::Numbered;
        return;
    }
    for (; groups > 0 && m_stage == Stage::Numbered; --groups) {
        const int first = m_filled * kLanes;
        Corners corners;
        setCorners(m_at[0] + first, m_at[1] + first, m_at[2] + first, m_origin4, corners);
        std::memcpy(corners.isTwoSided, m_isTwoSided + first, sizeof corners.isTwoSided);
        m_reach_mm = std::max(m_reach_mm, derive(corners, m_groups[static_cast<std::size_t>(m_filled)]));
        ++m_filled;
        if (m_filled * kLanes >= m_count) {
            m_stage = Stage::Ready;
        }
    }
}

} // namespace palpate::haptics::internal
