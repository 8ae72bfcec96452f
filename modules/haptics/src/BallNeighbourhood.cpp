// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/internal/BallNeighbourhood.h"

#include "palpate/haptics/internal/InsideShare.h"

#include <algorithm>
#include <cmath>

namespace palpate::haptics::internal {

namespace {

// Aims for this many facets beyond those that the ball touches anyway: fewer are gathered again too often.
constexpr int kMany = 110;
constexpr double kTicksAhead = 10.0;
constexpr double kMarginsAhead = 10.0;
constexpr double kMarginsOfMove = 3.0; // how much of a longer move is gathered for at once
constexpr int kMostPieces = 8;         // before the whole hierarchy is searched
// Beyond these margins, in facet sizes and in radii, free space is not worth its facets.
constexpr double kWidestFacets = 16.0;
constexpr double kWidestRadii = 2.0;

bool isBefore(const BallCrossing& a, const BallCrossing& b) noexcept
{
    if (a.key != b.key) {
        return a.key < b.key;
    }
    if (a.stop != b.stop) {
        return a.stop < b.stop;
    }
    return a.facet.structure != b.facet.structure ? a.facet.structure < b.facet.structure
                                                  : a.facet.triangle < b.facet.triangle;
}

} // namespace

/// Keeps the first crossing of those offered. The order of the offers does not matter.
struct BallNeighbourhood::First
{
    const Vec3& x;
    const Vec3& y;
    double radius_mm;
    BallCrossing& best;
    double limit;
    bool found = false;

    void offer(const geometry::SurfaceIndex& surface, std::uint32_t structure, std::uint32_t triangle) noexcept
    {
        BallCrossing crossing;
        if (blocksBall(Facet::of(surface, structure, triangle), x, y, radius_mm, limit, crossing) &&
            (!found || isBefore(crossing, best))) {
            best = crossing;
            limit = crossing.key;
            found = true;
        }
    }
};

void BallNeighbourhood::clear() noexcept
{
    m_isComplete = false;
    m_hasLast = false;
    m_margin_mm = 0.0;
    m_region.setEmpty();
}

void BallNeighbourhood::fill(const HapticScene& scene) noexcept
{
    m_reach_mm = 0.0f;
    for (int first = 0; first < m_count; first += TriangleGroup::kLanes) {
        TriangleGroup& group = m_groups[static_cast<std::size_t>(first / TriangleGroup::kLanes)];
        for (int i = 0; i < TriangleGroup::kLanes; ++i) {
            // Lanes left over repeat the last facet; they are never looked at.
            const auto k = static_cast<std::size_t>(std::min(first + i, m_count - 1));
            const geometry::SurfaceIndex& surface = *scene.structures()[m_structure[k]].surface;
            const geometry::Triangle t = surface.triangle(m_triangle[k]);
            const Vec3 &a = surface.vertex(t[0]), &b = surface.vertex(t[1]), &c = surface.vertex(t[2]);
            for (int axis = 0; axis < 3; ++axis) {
                group.corners.a[axis][i] = static_cast<float>(a[axis] - m_origin[axis]);
                group.corners.ab[axis][i] = static_cast<float>(b[axis] - a[axis]);
                group.corners.ac[axis][i] = static_cast<float>(c[axis] - a[axis]);
            }
        }
        m_reach_mm = std::max(m_reach_mm, derive(group));
    }
}

void BallNeighbourhood::offerGathered(const HapticScene& scene, First& first) noexcept
{
    if (m_count == 0) {
        return;
    }
    // A short move is told off from its middle, a long one from its start: it is expected to end early.
    const double length = (first.y - first.x).norm();
    const bool isShort = length < 0.5 * first.radius_mm;
    const Vec3 from = isShort ? Vec3(0.5 * (first.x + first.y)) : first.x;
    float at[3], coordinate = m_reach_mm;
    for (int axis = 0; axis < 3; ++axis) {
        at[axis] = static_cast<float>(from[axis] - m_origin[axis]);
        coordinate = std::max(coordinate, std::abs(at[axis]));
    }
    alignas(32) float distance[kCapacity];
    distances(m_groups.data(), m_count, at, distance);
    // Rounding of a distance: a few ulp of the coordinates, times the flattest triangle that is told off.
    const double rounding = 1e-5 * coordinate;
    const double touching = first.radius_mm + rounding;
    const auto offerBetween = [&](double beyond, double upTo) {
        for (int i = 0; i < m_count; ++i) {
            const auto k = static_cast<std::size_t>(i);
            if (static_cast<double>(distance[i]) > beyond && static_cast<double>(distance[i]) <= upTo) {
                first.offer(*scene.structures()[m_structure[k]].surface, m_structure[k], m_triangle[k]);
            }
        }
    };
    if (isShort) {
        offerBetween(-1.0, touching + 0.5 * length);
        return;
    }
    // The nearer first: what is met early spares the rest.
    double offered = -1.0;
    for (const double share : {0.01, 0.05, 0.25, 1.0}) {
        const double upTo = touching + length * std::min(share, first.limit);
        offerBetween(offered, upTo);
        offered = upTo;
        if (first.limit <= share) {
            return;
        }
    }
}

void BallNeighbourhood::gather(const HapticScene& scene, const HapticLayer& layer, const Vec3& x,
                               const Vec3& y) noexcept
{
    if (m_margin_mm == 0.0) {
        m_margin_mm = layer.facetSize_mm;
    }
    const double speed = m_motion.norm();
    const Vec3 ahead =
        speed > 0.0 ? Vec3(x + m_motion * std::min(kTicksAhead, kMarginsAhead * m_margin_mm / speed)) : x;
    m_region = core::Box(x.cwiseMin(y).cwiseMin(ahead).array() - m_margin_mm,
                         x.cwiseMax(y).cwiseMax(ahead).array() + m_margin_mm);
    m_origin = x;
    m_count = 0;
    m_isComplete = true;
    const double around = scene.fingertip_mm() + 4.0 * layer.skin_mm;
    const core::Box query(m_region.min().array() - around, m_region.max().array() + around);
    layer.hierarchy.visitBox(query, [&](std::uint32_t firstStructure, std::uint32_t structureCount) {
        for (std::uint32_t s = firstStructure; s < firstStructure + structureCount; ++s) {
            const std::uint32_t number = layer.structures[s];
            const geometry::SurfaceIndex& surface = *scene.structures()[number].surface;
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
    if (!m_isComplete) {
        m_count = 0;
        m_margin_mm *= 0.5;
        return;
    }
    // One round of waiting for memory rather than one for each facet.
    for (int i = 0; i < m_count; ++i) {
        scene.structures()[m_structure[i]].surface->prefetchCorners(m_triangle[i]);
    }
    fill(scene);
    if (m_count > kMany) {
        m_margin_mm *= 0.8;
    } else if (m_count < kMany / 2) {
        m_margin_mm = std::min(1.25 * m_margin_mm,
                               std::max(kWidestFacets * layer.facetSize_mm, kWidestRadii * scene.fingertip_mm()));
    }
}

bool BallNeighbourhood::sweep(const HapticScene& scene, const HapticLayer& layer, const Vec3& x, const Vec3& y,
                              BallCrossing& first) noexcept
{
    const double radius = scene.fingertip_mm();
    double done = 0.0; // share of the move that is known to be free
    if (m_isComplete && m_region.contains(x)) {
        done = insideShare(m_region, x, y);
        First nearest{x, y, radius, first, done};
        offerGathered(scene, nearest);
        if (nearest.found || done >= 1.0) {
            return nearest.found;
        }
    }
    // Piece by piece: what is gathered for the last of them serves the moves that follow.
    const double length = (y - x).cwiseAbs().maxCoeff();
    for (int piece = 0; piece < kMostPieces; ++piece) {
        const Vec3 p = x + done * (y - x);
        const double most = kMarginsOfMove * std::max(m_margin_mm, layer.facetSize_mm);
        gather(scene, layer, p, p + (y - x) * std::min(1.0 - done, most / length));
        for (int again = 0; again < 4 && !m_isComplete; ++again) {
            gather(scene, layer, p, p); // with half the margin each time
        }
        if (!m_isComplete) {
            break;
        }
        const double upTo = done + (1.0 - done) * insideShare(m_region, p, y);
        First nearest{x, y, radius, first, upTo};
        offerGathered(scene, nearest);
        if (nearest.found || upTo >= 1.0) {
            return nearest.found;
        }
        done = upTo;
    }
    First nearest{x, y, radius, first, 1.0};
    const double around = radius + 4.0 * layer.skin_mm;
    layer.hierarchy.visitSegment(
        x, y,
        [&](std::uint32_t firstStructure, std::uint32_t structureCount) {
            for (std::uint32_t s = firstStructure; s < firstStructure + structureCount; ++s) {
                const std::uint32_t number = layer.structures[s];
                const geometry::SurfaceIndex& surface = *scene.structures()[number].surface;
                surface.hierarchy().visitSegment(
                    x, y,
                    [&](std::uint32_t i, std::uint32_t n) {
                        for (const std::uint32_t end = i + n; i < end; ++i) {
                            nearest.offer(surface, number, i);
                        }
                        return nearest.limit;
                    },
                    around);
            }
            return nearest.limit;
        },
        around);
    return nearest.found;
}

} // namespace palpate::haptics::internal
