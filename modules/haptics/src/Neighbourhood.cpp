// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/internal/Neighbourhood.h"

#include <palpate/core/Float4.h>

#include <algorithm>
#include <bit>

namespace palpate::haptics::internal {

namespace {

// Aims for this many facets in the region: fewer are gathered again too often, more cost every sweep.
constexpr int kFew = 8;
constexpr int kMany = 40;
// In free space the region grows up to this many facet sizes: on the way to a surface it must not hold all of it.
constexpr double kWidest = 16.0;
constexpr double kTicksAhead = 10.0;
constexpr double kRadiiAhead = 10.0;

bool isBefore(const Crossing& a, const Crossing& b) noexcept
{
    if (a.key != b.key) {
        return a.key < b.key;
    }
    if (a.depth != b.depth) {
        return a.depth > b.depth;
    }
    return a.facet.structure != b.facet.structure ? a.facet.structure < b.facet.structure
                                                  : a.facet.triangle < b.facet.triangle;
}

/// Share of the move x → y that stays inside the box, which x is in.
double insideShare(const core::Box& box, const Vec3& x, const Vec3& y) noexcept
{
    double share = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double d = y[axis] - x[axis];
        const double room = d > 0.0 ? box.max()[axis] - x[axis] : x[axis] - box.min()[axis];
        if (std::abs(d) > room) {
            share = std::min(share, room / std::abs(d));
        }
    }
    return share;
}

} // namespace

/// Keeps the first crossing of those offered. The order of the offers does not matter.
struct Neighbourhood::First
{
    const Vec3& x;
    const Vec3& y;
    Crossing& best;
    double limit;
    bool found = false;

    void offer(const geometry::SurfaceIndex& surface, std::uint32_t structure, std::uint32_t triangle) noexcept
    {
        const Facet facet = Facet::of(surface, structure, triangle);
        Crossing crossing;
        if (blocks(facet, x, y, limit, crossing) && (!found || isBefore(crossing, best))) {
            best = crossing;
            limit = crossing.key;
            found = true;
        }
    }
};

void Neighbourhood::clear() noexcept
{
    m_isComplete = false;
    m_hasLast = false;
    m_radius_mm = 0.0;
    m_region.setEmpty();
}

void Neighbourhood::hold(const geometry::SurfaceIndex& surface, std::uint32_t structure,
                         std::uint32_t triangle) noexcept
{
    const auto k = static_cast<std::size_t>(m_count++);
    const geometry::Triangle t = surface.triangle(triangle);
    const Vec3 &a = surface.vertex(t[0]), &b = surface.vertex(t[1]), &c = surface.vertex(t[2]);
    const Vec3 n = (b - a).cross(c - a).normalized();
    const auto box =
        geometry::FloatBox::around(core::Box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)), m_origin);
    for (int axis = 0; axis < 3; ++axis) {
        m_normal[axis][k] = static_cast<float>(n[axis]);
        m_low[axis][k] = box.low[static_cast<std::size_t>(axis)];
        m_high[axis][k] = box.high[static_cast<std::size_t>(axis)];
    }
    m_offset[k] = static_cast<float>(n.dot(a - m_origin));
    m_reach_mm = std::max(m_reach_mm, std::abs(m_offset[k]));
    m_isTwoSided[k] = surface.isTwoSided(triangle) ? -1 : 0;
    m_structure[k] = structure;
    m_triangle[k] = triangle;
}

void Neighbourhood::offerGathered(const HapticScene& scene, First& first) const noexcept
{
    using core::Float4, core::load4, core::Mask4, core::splat4;
    const Eigen::Vector3f x = (first.x - m_origin).cast<float>(), y = (first.y - m_origin).cast<float>();
    // Rounding of a plane distance below, twice over: a few ulp of the largest numbers that enter it. The skin is far
    // smaller than that, so contacts are always tested again.
    const float rounding = 2e-6f * (x.cwiseAbs().maxCoeff() + y.cwiseAbs().maxCoeff() + m_reach_mm);
    const Float4 above = splat4(rounding), below = splat4(-rounding);
    const Eigen::Vector3f d = y - x;
    for (int i = 0; i < m_count; i += 4) {
        const Float4 n0 = load4(m_normal[0] + i), n1 = load4(m_normal[1] + i), n2 = load4(m_normal[2] + i);
        const Float4 offset = load4(m_offset + i);
        const Float4 start = n0 * x[0] + n1 * x[1] + n2 * x[2] - offset;
        const Float4 end = n0 * y[0] + n1 * y[1] + n2 * y[2] - offset;
        Mask4 twoSided;
        std::memcpy(&twoSided, m_isTwoSided + i, sizeof twoSided);
        // From the front to behind; or, where there is no inside, from any side to the other.
        Mask4 crosses = ((start >= below) & (end <= above)) | (twoSided & (start <= above) & (end >= below));
        if (core::laneBits(crosses) == 0) {
            continue;
        }
        // Where the plane is met, against the triangle's box. In a plane the share is anything or not a number: not
        // told off.
        const Float4 share = start / (start - end);
        const Mask4 isCertain = core::absolute(start - end) > splat4(8.0f * rounding);
        Mask4 misses = {0, 0, 0, 0};
        for (int axis = 0; axis < 3; ++axis) {
            const Float4 met = splat4(x[axis]) + share * splat4(d[axis]);
            // The share is as uncertain as the two distances in it.
            const Float4 slack =
                splat4(rounding) + splat4(2.0f * rounding * std::abs(d[axis])) / core::absolute(start - end);
            misses |= (met < load4(m_low[axis] + i) - slack) | (met > load4(m_high[axis] + i) + slack);
        }
        crosses &= ~(misses & isCertain);
        for (std::uint32_t lanes = core::laneBits(crosses); lanes != 0; lanes &= lanes - 1) {
            const std::size_t k = static_cast<std::size_t>(i + std::countr_zero(lanes));
            first.offer(*scene.structures()[m_structure[k]].surface, m_structure[k], m_triangle[k]);
        }
    }
}

void Neighbourhood::gather(const HapticScene& scene, const HapticLayer& layer, const Vec3& x, const Vec3& y) noexcept
{
    if (m_radius_mm == 0.0) {
        m_radius_mm = layer.facetSize_mm;
    }
    // Ahead of the motion, for as many ticks as the radius covers but not endlessly for a fast one.
    const double speed = m_motion.norm();
    const Vec3 ahead = speed > 0.0 ? Vec3(x + m_motion * std::min(kTicksAhead, kRadiiAhead * m_radius_mm / speed)) : x;
    m_region = core::Box(x.cwiseMin(y).cwiseMin(ahead).array() - m_radius_mm,
                         x.cwiseMax(y).cwiseMax(ahead).array() + m_radius_mm);
    m_origin = x;
    m_reach_mm = 0.0f;
    m_count = 0;
    m_isComplete = true;
    layer.hierarchy.visitBox(m_region, [&](std::uint32_t firstStructure, std::uint32_t structureCount) {
        for (std::uint32_t s = firstStructure; s < firstStructure + structureCount; ++s) {
            const std::uint32_t number = layer.structures[s];
            const geometry::SurfaceIndex& surface = *scene.structures()[number].surface;
            // A facet may lie a few skins outside and still matter to a move inside.
            const double reach = 4.0 * surface.skin_mm();
            const core::Box query(m_region.min().array() - reach, m_region.max().array() + reach);
            surface.hierarchy().visitBox(query, [&](std::uint32_t first, std::uint32_t n) {
                if (m_count + static_cast<int>(n) > kCapacity) {
                    m_isComplete = false;
                    return false;
                }
                for (const std::uint32_t end = first + n; first < end; ++first) {
                    hold(surface, number, first);
                }
                return true;
            });
        }
        return m_isComplete;
    });
    // Lanes that hold nothing: no move can end behind them.
    for (int i = m_count; i % 4 != 0; ++i) {
        const auto k = static_cast<std::size_t>(i);
        m_normal[0][k] = m_normal[1][k] = m_normal[2][k] = 0.0f;
        m_offset[k] = -1e30f;
        m_isTwoSided[k] = 0;
    }
    if (!m_isComplete) {
        m_radius_mm *= 0.5;
    } else if (m_count > kMany) {
        m_radius_mm *= 0.8;
    } else if (m_count < kFew) {
        m_radius_mm = std::min(1.25 * m_radius_mm, kWidest * layer.facetSize_mm);
    }
}

bool Neighbourhood::sweep(const HapticScene& scene, const HapticLayer& layer, const Vec3& x, const Vec3& y,
                          Crossing& first) noexcept
{
    const std::vector<HapticStructure>& structures = scene.structures();
    for (int attempt = 0; attempt < 2; ++attempt) {
        if (m_isComplete && m_region.contains(x)) {
            const double share = insideShare(m_region, x, y);
            First nearest{x, y, first, share};
            offerGathered(scene, nearest);
            if (nearest.found || share >= 1.0) {
                return nearest.found;
            }
        }
        // A move that leaves a region as large as this one soon again is not worth gathering for.
        if (attempt == 1 || (y - x).cwiseAbs().maxCoeff() > 2.0 * m_radius_mm) {
            if (attempt == 0 && !(m_isComplete && m_region.contains(x))) {
                gather(scene, layer, x, x);
                continue;
            }
            break;
        }
        gather(scene, layer, x, y);
    }
    First nearest{x, y, first, 1.0};
    layer.hierarchy.visitSegment(x, y, [&](std::uint32_t firstStructure, std::uint32_t structureCount) {
        for (std::uint32_t s = firstStructure; s < firstStructure + structureCount; ++s) {
            const std::uint32_t number = layer.structures[s];
            const geometry::SurfaceIndex& surface = *structures[number].surface;
            surface.hierarchy().visitSegment(x, y, [&](std::uint32_t i, std::uint32_t n) {
                for (const std::uint32_t end = i + n; i < end; ++i) {
                    nearest.offer(surface, number, i);
                }
                return nearest.limit;
            });
        }
        return nearest.limit;
    });
    return nearest.found;
}

} // namespace palpate::haptics::internal
