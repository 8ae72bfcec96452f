// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/internal/Neighbourhood.h"

#include "palpate/haptics/internal/InsideShare.h"

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
constexpr double kRadiiOfMove = 3.0; // how much of a longer move is gathered for

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
        // Most offers end here: a move that ends in front of a plane with only one side, or leaves it.
        if (!surface.isTwoSided(triangle)) {
            const geometry::Triangle t = surface.triangle(triangle);
            const Vec3& a = surface.vertex(t[0]);
            const Vec3 n = (surface.vertex(t[1]) - a).cross(surface.vertex(t[2]) - a);
            const double end = n.dot(y - a);
            if (end >= 0.0 || end >= n.dot(x - a)) {
                return;
            }
        }
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

void Neighbourhood::fill(const HapticScene& scene) noexcept
{
    m_reach_mm = 0.0f;
    for (int first = 0; first < m_count; first += FacetGroup::kLanes) {
        Corners corners;
        FacetGroup& group = m_groups[static_cast<std::size_t>(first / FacetGroup::kLanes)];
        for (int i = 0; i < FacetGroup::kLanes; ++i) {
            // Lanes left over repeat the last facet; they are never looked at.
            const auto k = static_cast<std::size_t>(std::min(first + i, m_count - 1));
            const geometry::SurfaceIndex& surface = *scene.structures()[m_structure[k]].surface;
            const geometry::Triangle t = surface.triangle(m_triangle[k]);
            const Vec3 &a = surface.vertex(t[0]), &b = surface.vertex(t[1]), &c = surface.vertex(t[2]);
            for (int axis = 0; axis < 3; ++axis) {
                corners.a[axis][i] = static_cast<float>(a[axis] - m_origin[axis]);
                corners.ab[axis][i] = static_cast<float>(b[axis] - a[axis]);
                corners.ac[axis][i] = static_cast<float>(c[axis] - a[axis]);
            }
            group.isTwoSided[i] = surface.isTwoSided(m_triangle[k]) ? -1 : 0;
            CornerGroup& numbers = m_corners[static_cast<std::size_t>(first / FacetGroup::kLanes)];
            for (std::size_t corner = 0; corner < 3; ++corner) {
                numbers.corner[corner][i] = t[corner];
            }
            numbers.structure[i] = m_structure[k];
        }
        m_reach_mm = std::max(m_reach_mm, derive(corners, group));
    }
}

void Neighbourhood::offerGathered(const HapticScene& scene, First& first) const noexcept
{
    float x[3], y[3], start = 0.0f, end = 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        x[axis] = static_cast<float>(first.x[axis] - m_origin[axis]);
        y[axis] = static_cast<float>(first.y[axis] - m_origin[axis]);
        start = std::max(start, std::abs(x[axis]));
        end = std::max(end, std::abs(y[axis]));
    }
    for (std::uint64_t lanes = crossedLanes(m_groups.data(), m_count, x, y, start + end + m_reach_mm); lanes != 0;
         lanes &= lanes - 1) {
        const auto k = static_cast<std::size_t>(std::countr_zero(lanes));
        first.offer(*scene.structures()[m_structure[k]].surface, m_structure[k], m_triangle[k]);
    }
}

bool Neighbourhood::beyondEdge(const HapticScene& scene, const HapticLayer& layer, const Vec3& from, const Vec3& place,
                               const Vec3& ahead, const Facet& facet, int edge, Facet& found, int& entered) noexcept
{
    const geometry::SurfaceIndex& surface = *scene.structures()[facet.structure].surface;
    const geometry::Triangle t = surface.triangle(facet.triangle);
    const std::uint32_t p = t[static_cast<std::size_t>(edge)], q = t[static_cast<std::size_t>((edge + 1) % 3)];
    std::uint32_t other = facet.triangle;
    int others = 0;
    const auto take = [&](std::uint32_t triangle) {
        if (triangle != facet.triangle) {
            other = triangle;
            ++others;
        }
    };
    if (!holds(place)) {
        gatherAlong(scene, layer, from, ahead);
    }
    if (holds(place)) {
        for (std::uint64_t lanes = lanesAtEdge(m_corners.data(), m_count, facet.structure, p, q); lanes != 0;
             lanes &= lanes - 1) {
            take(m_triangle[static_cast<std::size_t>(std::countr_zero(lanes))]);
        }
    } else {
        const double around = 4.0 * surface.skin_mm();
        surface.hierarchy().visitBox(core::Box(place.array() - around, place.array() + around),
                                     [&](std::uint32_t i, std::uint32_t n) {
                                         for (const std::uint32_t end = i + n; i < end; ++i) {
                                             const geometry::Triangle c = surface.triangle(i);
                                             if (std::find(c.begin(), c.end(), p) != c.end() &&
                                                 std::find(c.begin(), c.end(), q) != c.end()) {
                                                 take(i);
                                             }
                                         }
                                         return true;
                                     });
    }
    if (others != 1) {
        return false;
    }
    const geometry::Triangle c = surface.triangle(other);
    for (std::size_t i = 0; i < 3; ++i) {
        // The other way round: the two are turned the same way.
        if (c[i] == q && c[(i + 1) % 3] == p) {
            entered = static_cast<int>(i);
            found = Facet::of(surface, facet.structure, other);
            return found.isTwoSided == facet.isTwoSided;
        }
    }
    return false;
}

std::size_t Neighbourhood::freeMoves(const HapticScene& scene, const HapticLayer& layer,
                                     std::span<const Vec3> path) noexcept
{
    std::size_t moves = path.size() - 1;
    Crossing crossing;
    if (!std::all_of(path.begin(), path.end(), [this](const Vec3& p) { return holds(p); })) {
        for (std::size_t i = 0; i < moves; ++i) {
            if (sweep(scene, layer, path[i], path[i + 1], crossing)) {
                return i;
            }
        }
        return moves;
    }
    float points[kMostPoints][3];
    float coordinate = 0.0f;
    for (std::size_t i = 0; i < path.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            points[i][axis] = static_cast<float>(path[i][axis] - m_origin[axis]);
            coordinate = std::max(coordinate, std::abs(points[i][axis]));
        }
    }
    for (std::uint64_t lanes = crossedLanes(m_groups.data(), m_count, points, static_cast<int>(path.size()),
                                            2.0f * coordinate + m_reach_mm);
         lanes != 0; lanes &= lanes - 1) {
        const auto k = static_cast<std::size_t>(std::countr_zero(lanes));
        for (std::size_t i = 0; i < moves; ++i) {
            First any{path[i], path[i + 1], crossing, 1.0};
            any.offer(*scene.structures()[m_structure[k]].surface, m_structure[k], m_triangle[k]);
            if (any.found) {
                moves = i;
            }
        }
    }
    return moves;
}

void Neighbourhood::gatherAlong(const HapticScene& scene, const HapticLayer& layer, const Vec3& x,
                                const Vec3& y) noexcept
{
    const double length = (y - x).cwiseAbs().maxCoeff();
    const double most = kRadiiOfMove * std::max(m_radius_mm, layer.facetSize_mm);
    gather(scene, layer, x, length > most ? Vec3(x + (y - x) * (most / length)) : y);
}

std::uint64_t Neighbourhood::near(const HapticScene& scene, const HapticLayer& layer, const Vec3& g,
                                  double reach_mm) noexcept
{
    // A region that holds too many is halved with each attempt; more than can be held at one point stay unknown.
    for (int attempt = 0; attempt < 8 && !(m_isComplete && m_region.contains(g)); ++attempt) {
        gather(scene, layer, g, g);
    }
    float at[3], coordinate = m_reach_mm;
    for (int axis = 0; axis < 3; ++axis) {
        at[axis] = static_cast<float>(g[axis] - m_origin[axis]);
        coordinate = std::max(coordinate, std::abs(at[axis]));
    }
    return nearLanes(m_groups.data(), m_count, at, static_cast<float>(reach_mm), 2.0f * coordinate);
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
                surface.prefetchTriangles(first);
                for (const std::uint32_t end = first + n; first < end; ++first, ++m_count) {
                    m_structure[m_count] = number;
                    m_triangle[m_count] = first;
                }
                return true;
            });
        }
        return m_isComplete;
    });
    // One round of waiting for memory rather than one for each facet.
    for (int i = 0; i < m_count; ++i) {
        scene.structures()[m_structure[i]].surface->prefetchCorners(m_triangle[i]);
    }
    fill(scene);
    // A region stretched along a long move tells nothing about the facets' size.
    const bool isStretched = (y - x).cwiseAbs().maxCoeff() > m_radius_mm;
    if (!m_isComplete) {
        m_radius_mm *= 0.5;
    } else if (m_count > kMany && !isStretched) {
        m_radius_mm *= 0.8;
    } else if (m_count < kFew) {
        m_radius_mm = std::min(1.25 * m_radius_mm, kWidest * layer.facetSize_mm);
    }
}

bool Neighbourhood::sweep(const HapticScene& scene, const HapticLayer& layer, const Vec3& x, const Vec3& y,
                          Crossing& first) noexcept
{
    const std::vector<HapticStructure>& structures = scene.structures();
    // In the region that is held; if the move leaves it, once more in one gathered along the first part of the move.
    for (int attempt = 0; attempt < 2; ++attempt) {
        if (m_isComplete && m_region.contains(x)) {
            const double share = insideShare(m_region, x, y);
            First nearest{x, y, first, share};
            offerGathered(scene, nearest);
            if (nearest.found || share >= 1.0) {
                return nearest.found;
            }
        }
        if (attempt == 0) {
            gatherAlong(scene, layer, x, y);
        }
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
