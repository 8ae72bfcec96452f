// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/SurfaceSection.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace palpate::geometry {

namespace {

constexpr std::size_t kNoSegment = std::numeric_limits<std::size_t>::max();

/// Key of an edge, the same for both directions.
std::uint64_t edgeKey(std::uint32_t a, std::uint32_t b) noexcept
{
    return (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b);
}

/// Part of a contour within one triangle, from the edge that leads below the plane to the edge that leads above.
struct SectionSegment
{
    std::uint64_t from = 0, to = 0; ///< edges
    bool isTwoSided = false;
};

/// Point of an edge in the plane. The order of the key makes it the same for both triangles at the edge.
Eigen::Vector2d crossingOf(std::uint64_t edge, std::span<const Vec3> vertices, const SectionPlane& plane)
{
    const Vec3 &a = vertices[edge >> 32U], &b = vertices[edge & 0xffffffffU];
    const double da = plane.distance_mm(a), db = plane.distance_mm(b);
    return plane.inPlane(a + da / (da - db) * (b - a)); // exactly one of them is below 0
}

std::vector<SectionSegment> segmentsOf(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                                       std::span<const std::uint8_t> twoSided, const SectionPlane& plane)
{
    std::vector<std::uint8_t> above(vertices.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        above[i] = plane.distance_mm(vertices[i]) >= 0.0 ? 1 : 0;
        count += above[i];
    }
    std::vector<SectionSegment> segments;
    if (count == 0 || count == vertices.size()) {
        return segments;
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        const int sum = above[t[0]] + above[t[1]] + above[t[2]];
        if (sum == 0 || sum == 3) {
            continue;
        }
        SectionSegment segment;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t a = t[c], b = t[(c + 1) % 3];
            if (above[a] != above[b]) {
                (above[a] != 0 ? segment.from : segment.to) = edgeKey(a, b);
            }
        }
        segment.isTwoSided = i < twoSided.size() && twoSided[i] != 0;
        segments.push_back(segment);
    }
    return segments;
}

/// For each segment the one that starts where it ends, each at most once; kNoSegment at the end of an open contour.
std::vector<std::size_t> successors(const std::vector<SectionSegment>& segments)
{
    std::vector<std::pair<std::uint64_t, std::size_t>> starts, ends;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        starts.emplace_back(segments[i].from, i);
        ends.emplace_back(segments[i].to, i);
    }
    std::sort(starts.begin(), starts.end());
    std::sort(ends.begin(), ends.end());
    std::vector<std::size_t> next(segments.size(), kNoSegment);
    auto start = starts.begin();
    for (const auto& [edge, segment] : ends) {
        while (start != starts.end() && start->first < edge) {
            ++start;
        }
        if (start != starts.end() && start->first == edge) {
            next[segment] = start->second;
            ++start;
        }
    }
    return next;
}

} // namespace

SectionPlane SectionPlane::through(const Vec3& p_W, const Vec3& n_W)
{
    SectionPlane plane;
    plane.p_W = p_W;
    plane.n_W = n_W.normalized();
    plane.u_W = plane.n_W.unitOrthogonal();
    plane.v_W = plane.n_W.cross(plane.u_W);
    return plane;
}

bool SectionPlane::crosses(const Box& box_W) const
{
    if (box_W.isEmpty()) {
        return false;
    }
    const double centre = distance_mm(box_W.center());
    return std::abs(centre) <= 0.5 * n_W.cwiseAbs().dot(box_W.diagonal());
}

std::vector<SectionContour> sectionOf(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                                      std::span<const std::uint8_t> twoSided, const SectionPlane& plane)
{
    const std::vector<SectionSegment> segments = segmentsOf(vertices, triangles, twoSided, plane);
    const std::vector<std::size_t> next = successors(segments);
    std::vector<bool> isFirst(segments.size(), true), isDone(segments.size(), false);
    for (const std::size_t one : next) {
        if (one != kNoSegment) {
            isFirst[one] = false;
        }
    }
    std::vector<SectionContour> contours;
    const auto follow = [&](std::size_t first) {
        SectionContour contour;
        bool isTwoSided = false;
        std::size_t at = first, last = first;
        for (; at != kNoSegment && !isDone[at]; at = next[at]) {
            isDone[at] = true;
            isTwoSided = isTwoSided || segments[at].isTwoSided;
            contour.points.push_back(crossingOf(segments[at].from, vertices, plane));
            last = at;
        }
        if (at == kNoSegment) {
            contour.points.push_back(crossingOf(segments[last].to, vertices, plane));
        }
        contour.isClosed = at != kNoSegment && !isTwoSided;
        if (at != kNoSegment && isTwoSided) {
            contour.points.push_back(contour.points.front()); // an outline that is not filled
        }
        contours.push_back(std::move(contour));
    };
    for (std::size_t i = 0; i < segments.size(); ++i) { // open contours first, from their starts
        if (isFirst[i]) {
            follow(i);
        }
    }
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (!isDone[i]) {
            follow(i);
        }
    }
    return contours;
}

} // namespace palpate::geometry
