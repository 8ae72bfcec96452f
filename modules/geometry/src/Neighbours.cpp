// SPDX-License-Identifier: BSD-3-Clause
#include "Neighbours.h"

#include "palpate/geometry/SurfaceIndex.h"

#include <palpate/core/Parallel.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

namespace palpate::geometry {

namespace {

constexpr std::uint32_t kNoSide = SurfaceIndex::kNoNeighbour << 2;

/// Edge of a triangle, stored at its smaller vertex.
struct Side
{
    std::uint32_t larger; ///< larger vertex
    std::uint32_t where;  ///< triangle << 2 | edge
};

/// Matching sides of a vertex that lead to the same other vertex.
struct Found
{
    std::uint32_t count = 0;
    std::uint32_t where = kNoSide; ///< one of the matches
};

/// Vertices with more sides than this use a sorted search.
constexpr std::size_t kFewAway = 64;

bool isSmaller(const Side& a, const Side& b)
{
    return a.larger < b.larger;
}

Found find(std::span<const Side> sides, std::uint32_t larger, bool isSorted)
{
    Found found;
    if (isSorted) {
        const auto [first, last] = std::equal_range(sides.begin(), sides.end(), Side{larger, 0}, isSmaller);
        found.count = static_cast<std::uint32_t>(last - first);
        found.where = first != last ? first->where : kNoSide;
        return found;
    }
    for (const Side& side : sides) {
        const bool isOne = side.larger == larger;
        found.count += isOne ? 1 : 0;
        found.where = isOne ? side.where : found.where;
    }
    return found;
}

/// Connects the triangles at edges with the smaller vertex in the range first to last - 1.
void join(std::span<const Triangle> triangles, std::uint32_t first, std::uint32_t last,
          core::LargeArray<Triangle>& joined)
{
    // For each vertex, the outgoing sides followed by the incoming sides.
    std::vector<std::uint32_t> ends(2 * std::size_t{last - first} + 2, 0);
    const auto forEachSide = [&](auto&& f) {
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            const Triangle& t = triangles[i];
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t a = t[k], b = t[k == 2 ? 0 : k + 1];
                const std::uint32_t smaller = std::min(a, b);
                if (smaller >= first && smaller < last) {
                    f(2 * std::size_t{smaller - first} + (a > b ? 1 : 0), Side{std::max(a, b), i << 2 | k});
                }
            }
        }
    };
    forEachSide([&ends](std::size_t which, const Side& /*side*/) { ++ends[which + 2]; });
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    core::LargeArray<Side> sides(ends.back());
    forEachSide([&](std::size_t which, const Side& side) {
        joined[side.where >> 2][side.where & 3u] = kNoSide;
        sides[ends[which + 1]++] = side;
    });
    for (std::size_t v = 0; v < last - first; ++v) {
        const std::span<Side> away(sides.data() + ends[2 * v], sides.data() + ends[2 * v + 1]);
        const std::span<Side> back(away.data() + away.size(), sides.data() + ends[2 * v + 2]);
        const bool isSorted = away.size() + back.size() > kFewAway;
        if (isSorted) {
            std::sort(away.begin(), away.end(), isSmaller);
            std::sort(back.begin(), back.end(), isSmaller);
        }
        for (const Side& side : away) {
            const Found other = find(back, side.larger, isSorted);
            // With several sides in one direction the pairing is ambiguous.
            if (other.count == 1 && find(away, side.larger, isSorted).count == 1) {
                joined[side.where >> 2][side.where & 3u] = other.where;
                joined[other.where >> 2][other.where & 3u] = side.where;
            }
        }
    }
}

} // namespace

core::LargeArray<Triangle> findNeighbours(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                                          unsigned threads)
{
    core::LargeArray<Triangle> found(triangles.size());
    // Each part processes a range of vertices but scans all triangles.
    constexpr std::size_t kTrianglesEach = 10'000;
    const auto parts = std::clamp<std::size_t>(triangles.size() / kTrianglesEach, 1, std::max(1U, threads));
    const auto end = [&](std::size_t part) { return static_cast<std::uint32_t>(part * vertexCount / parts); };
    core::parallelFor(
        parts, [&](std::size_t i, unsigned /*thread*/) { join(triangles, end(i), end(i + 1), found); }, threads);
    return found;
}

} // namespace palpate::geometry
