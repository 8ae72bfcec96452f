// SPDX-License-Identifier: BSD-3-Clause
#include "ClearTriangles.h"

#include "BoxHierarchyPairs.h"
#include "palpate/geometry/internal/BoxHierarchyVisit.h"

#include <palpate/core/Float4.h>
#include <palpate/core/Parallel.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <utility>

namespace palpate::geometry {

namespace {

// Three times the maximum height of a god-object above a triangle: height, equal overshoot beyond the edges, rounding.
constexpr double kApart = SurfaceIndex::kClearSeparation;
static_assert(3.0 * SurfaceIndex::kClearHeight < kApart);

constexpr float kLeastSine = 1.0f / 32.0f; // minimum sine of a triangle's angle
constexpr float kMinNeighbourCosine = SurfaceIndex::kClearMinCosine;
constexpr std::size_t kMaxFanSize = 32; // maximum number of triangles at a vertex

// Limits for degenerate surfaces where nearly all triangles overlap: testing all pairs would take very long, and no
// triangle would be clear.
constexpr std::uint64_t kMaxPairs = 64;   // for each triangle; a sphere has 16
constexpr std::uint32_t kMaxNearby = 256; // for one triangle

using Corners = std::array<Vec3, 3>;

Corners cornersOf(const JoinedSurface& surface, const Triangle& t)
{
    return {surface.vertices[t[0]], surface.vertices[t[1]], surface.vertices[t[2]]};
}

using core::Float4;

Float4 floats(const Vec3& v)
{
    return Float4{static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]), 0.0f};
}

Float4 cross(Float4 a, Float4 b)
{
    const Float4 c = a * __builtin_shufflevector(b, b, 1, 2, 0, 3) - b * __builtin_shufflevector(a, a, 1, 2, 0, 3);
    return __builtin_shufflevector(c, c, 1, 2, 0, 3);
}

float dot(Float4 a, Float4 b)
{
    const Float4 p = a * b;
    return p[0] + p[1] + p[2];
}

/// @return unit front normal; zero if an angle of the triangle is too small.
Float4 normalOf(const Corners& corners)
{
    const Float4 ab = floats(corners[1] - corners[0]), ac = floats(corners[2] - corners[0]), bc = ac - ab;
    const Float4 n = cross(ab, ac);
    const float area2 = dot(n, n), ab2 = dot(ab, ab), ac2 = dot(ac, ac), bc2 = dot(bc, bc);
    const float longest =
        std::max({ab2 * ac2, ab2 * bc2, ac2 * bc2}); // of two sides: the angle between them has the smallest sine
    return area2 >= kLeastSine * kLeastSine * longest && area2 > 0.0f ? n / std::sqrt(area2) : Float4{};
}

typedef std::int16_t Short8 __attribute__((vector_size(16)));

/// Extents of a triangle along eight directions in integer steps, rounded outwards (a k-DOP): separates most triangle
/// pairs that do not touch.
struct Spans
{
    Short8 low, high;

    /// @return 1 if all extents overlap.
    [[nodiscard]] std::uint16_t overlaps(const Spans& other) const
    {
        const Short8 apart = (low > other.high) | (high < other.low);
        std::int64_t lanes[2];
        std::memcpy(lanes, &apart, sizeof lanes);
        return (lanes[0] | lanes[1]) == 0 ? 1 : 0;
    }
};

/// @param steps  steps per mm; coordinates are at most 32,000 steps from the origin
Spans spansOf(const Corners& corners, const Vec3& origin, double steps)
{
    const auto rows = [](Float4 v) {
        return std::array{v, 0.5f * (v + __builtin_shufflevector(v, v, 1, 2, 0, 3)),
                          0.5f * (v - __builtin_shufflevector(v, v, 1, 2, 0, 3))};
    };
    const auto a = rows(floats((corners[0] - origin) * steps)), b = rows(floats((corners[1] - origin) * steps)),
               c = rows(floats((corners[2] - origin) * steps));
    typedef std::int32_t Int8 __attribute__((vector_size(32)));
    // x, y, z, x + y, y + z, z + x, x - y, y - z
    const auto steps8 = [](const std::array<Float4, 3>& v) {
        const Float4 some = __builtin_shufflevector(v[0], v[1], 0, 1, 2, 4),
                     rest = __builtin_shufflevector(v[1], v[2], 1, 2, 4, 5);
        const core::Mask4 halves[2] = {__builtin_convertvector(some, core::Mask4),
                                       __builtin_convertvector(rest, core::Mask4)};
        Int8 all;
        std::memcpy(&all, halves, sizeof all);
        return __builtin_convertvector(all, Short8);
    };
    std::array<Float4, 3> low, high;
    for (std::size_t i = 0; i < 3; ++i) {
        low[i] = core::least(core::least(a[i], b[i]), c[i]);
        high[i] = core::greatest(core::greatest(a[i], b[i]), c[i]);
    }
    // Truncation changes a value by less than one step, the other errors are far smaller.
    return {steps8(low) - 2, steps8(high) + 2};
}

constexpr std::size_t kBlock = 16'384; // minimum number of triangles for a thread

/// Precomputed properties of each triangle and vertex.
struct Survey
{
    Survey(const JoinedSurface& joined, unsigned threads);

    const JoinedSurface& surface;
    core::LargeArray<Float4> normal;
    core::LargeArray<Spans> spans;
    std::vector<std::uint16_t>
        uses; ///< number of triangles at each vertex; may wrap around for vertices with too many triangles for a fan
    std::vector<std::uint32_t> some;    ///< one of these triangles << 2 | its corner at the vertex
    std::vector<std::uint8_t> isSmooth; ///< for each vertex: see findClear

    [[nodiscard]] bool areSmoothAround(std::uint32_t vertex) const;
};

Survey::Survey(const JoinedSurface& joined, unsigned threads)
    : surface(joined)
    , normal(joined.triangleCount())
    , spans(joined.triangleCount())
    , uses(joined.vertexCount(), 0)
    , some(joined.vertexCount())
    , isSmooth(joined.vertexCount())
{
    for (std::uint32_t i = 0; i < surface.triangleCount(); ++i) {
        const Triangle& t = surface.triangles[i];
        for (std::uint32_t k = 0; k < 3; ++k) {
            ++uses[t[k]];
            some[t[k]] = i << 2 | k;
        }
    }
    const Vec3& origin = surface.hierarchy.origin();
    const double most =
        std::max((surface.bounds.max() - origin).maxCoeff(), (origin - surface.bounds.min()).maxCoeff());
    core::parallelForBlocks(
        surface.triangleCount(), kBlock,
        [&](std::size_t i) {
            const Corners corners = cornersOf(surface, surface.triangles[i]);
            normal[i] = normalOf(corners);
            spans[i] = spansOf(corners, origin, 32'000.0 / most);
        },
        threads);
    core::parallelForBlocks(
        surface.vertexCount(), kBlock / 2,
        [&](std::size_t v) { isSmooth[v] = areSmoothAround(static_cast<std::uint32_t>(v)) ? 1 : 0; }, threads);
}

/// @return true if the triangles at a vertex form a single fan, disjoint in projection; see findClear.
bool Survey::areSmoothAround(std::uint32_t vertex) const
{
    const std::size_t count = uses[vertex];
    if (count < 3 || count > kMaxFanSize) {
        return false;
    }
    std::array<std::uint32_t, kMaxFanSize> around;
    std::array<Float4, kMaxFanSize + 1> spoke; // spoke[i] to spoke[i + 1]: one triangle
    Float4 mean{};
    const std::uint32_t start = some[vertex] >> 2;
    std::uint32_t at = start, k = some[vertex] & 3u;
    const Vec3& centre = surface.vertices[vertex];
    for (std::size_t i = 0; i < count; ++i) {
        around[i] = at;
        mean += normal[at];
        spoke[i] = floats(surface.vertices[surface.triangles[at][k == 2 ? 0 : k + 1]] - centre);
        // Continue across the edge that ends at the vertex.
        const SurfaceIndex::Neighbour next = surface.neighbour(at, k == 0 ? 2 : k - 1);
        at = next.triangle;
        k = next.edge;
        if (at == SurfaceIndex::kNoNeighbour || (at == start) != (i + 1 == count)) {
            return false; // a boundary edge, or a second fan
        }
    }
    spoke[count] = spoke[0];
    // For a single turn, the spokes cross a plane through the mean normal from one side to the other exactly once.
    const Float4 size = core::absolute(mean);
    Float4 axis{};
    axis[size[0] <= size[1] && size[0] <= size[2] ? 0 : size[1] <= size[2] ? 1 : 2] = 1.0f;
    const Float4 aside = cross(mean, axis);
    const float limit = kMinNeighbourCosine * std::sqrt(dot(mean, mean));
    int turns = 0;
    Float4 before = normal[around[count - 1]];
    for (std::size_t i = 0; i < count; ++i) {
        const Float4 n = normal[around[i]];
        if (!(dot(n, mean) > limit && dot(n, before) > kMinNeighbourCosine)) {
            return false;
        }
        before = n;
        turns += dot(spoke[i], aside) >= 0.0f && dot(spoke[i + 1], aside) < 0.0f ? 1 : 0;
    }
    return turns == 1;
}

bool shareCorner(const Triangle& a, const Triangle& b)
{
    return std::any_of(a.begin(), a.end(), [&b](std::uint32_t v) { return v == b[0] || v == b[1] || v == b[2]; });
}

/// @return true if a separating axis shows a gap above `gap_mm` between two triangles.
bool areApart(const Corners& f, const Corners& g, double gap_mm)
{
    const auto separates = [&](const Vec3& axis) {
        const double f1 = axis.dot(f[1] - f[0]), f2 = axis.dot(f[2] - f[0]);
        const double g0 = axis.dot(g[0] - f[0]), g1 = axis.dot(g[1] - f[0]), g2 = axis.dot(g[2] - f[0]);
        const double above = std::min({g0, g1, g2}) - std::max({0.0, f1, f2});
        const double below = std::min({0.0, f1, f2}) - std::max({g0, g1, g2});
        const double gap = std::max(above, below);
        return gap > 0.0 && gap * gap > gap_mm * gap_mm * axis.squaredNorm();
    };
    if (separates(g[0] + g[1] + g[2] - (f[0] + f[1] + f[2]))) {
        return true;
    }
    for (const Corners* t : {&f, &g}) {
        const Vec3 ab = (*t)[1] - (*t)[0], bc = (*t)[2] - (*t)[1], ca = (*t)[0] - (*t)[2];
        const Vec3 n = ab.cross(bc);
        if (separates(n) || separates(ab.cross(n)) || separates(bc.cross(n)) || separates(ca.cross(n))) {
            return true;
        }
    }
    return false;
}

/// @return true if all triangles without a shared corner with triangle `i` are far enough away and not too many.
bool isAlone(const JoinedSurface& surface, std::uint32_t i, double gap_mm)
{
    const Triangle& t = surface.triangles[i];
    const Corners corners = cornersOf(surface, t);
    const Box box(corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]).array() - gap_mm,
                  corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]).array() + gap_mm);
    bool result = true;
    std::uint32_t nearby = 0;
    surface.hierarchy.visitBox(box, [&](std::uint32_t first, std::uint32_t n) {
        nearby += n;
        result = nearby <= kMaxNearby;
        for (std::uint32_t j = first; j < first + n && result; ++j) {
            const Triangle& other = surface.triangles[j];
            result = shareCorner(t, other) || areApart(corners, cornersOf(surface, other), gap_mm);
        }
        return result;
    });
    return result;
}

/// Counts the potentially touching triangles of each triangle: those in nearby leaves with overlapping extents.
class TouchCount
{
  public:
    /// Tests all triangle pairs in leaves within `gap_mm` of each other, up to the pair limit.
    TouchCount(const Survey& survey, double gap_mm, unsigned threads);

    /// True if the pair limit was reached, so that the counts are incomplete.
    [[nodiscard]] bool isPairLimitExceeded() const noexcept { return m_pairs > m_mostPairs; }
    /// @return count modulo 2^16
    [[nodiscard]] std::uint16_t of(std::uint32_t triangle) const noexcept
    {
        std::uint16_t sum = 0;
        for (const Part& part : m_parts) {
            sum += part.touching[triangle];
        }
        return sum;
    }

  private:
    struct alignas(64) Part // counts of one thread
    {
        core::LargeArray<std::uint16_t> touching; ///< for each triangle
        std::uint64_t pairs = 0;                  ///< pairs not yet added to m_pairs
    };

    std::vector<Part> m_parts;
    std::uint64_t m_mostPairs;
    std::atomic<std::uint64_t> m_pairs = 0;
};

TouchCount::TouchCount(const Survey& survey, double gap_mm, unsigned threads)
    : m_mostPairs(std::max<std::uint64_t>(kMaxPairs * survey.surface.triangleCount(), 1'000'000))
{
    const std::uint32_t count = survey.surface.triangleCount();
    // Each thread uses two bytes per triangle; the limit keeps the total below the memory of the survey.
    constexpr std::uint32_t kMostThreads = 16;
    threads = std::clamp(count / static_cast<std::uint32_t>(kBlock), 1U, std::clamp(threads, 1U, kMostThreads));
    m_parts.resize(threads);
    core::parallelFor(
        threads, [&](std::size_t i, unsigned /*thread*/) { m_parts[i].touching.assign(count, 0); }, threads);
    survey.surface.hierarchy.visitPairs(
        gap_mm, threads,
        [&](unsigned thread, std::uint32_t first, std::uint32_t n, std::uint32_t otherFirst, std::uint32_t m) {
            Part& part = m_parts[thread];
            std::uint16_t* touching = part.touching.data();
            for (std::uint32_t i = first; i < first + n; ++i) {
                const Spans spans = survey.spans[i];
                std::uint16_t found = 0;
                for (std::uint32_t j = first == otherFirst ? i + 1 : otherFirst; j < otherFirst + m; ++j) {
                    const std::uint16_t overlap = spans.overlaps(survey.spans[j]);
                    found += overlap;
                    touching[j] += overlap;
                }
                touching[i] += found;
            }
            part.pairs += n * m;
            if (part.pairs < 1'000'000) {
                return true;
            }
            m_pairs += std::exchange(part.pairs, 0);
            return m_pairs <= m_mostPairs;
        });
    for (const Part& part : m_parts) {
        m_pairs += part.pairs;
    }
}

} // namespace

std::vector<std::uint8_t> findClear(const JoinedSurface& surface, unsigned threads)
{
    const Survey survey(surface, threads);
    const double gap_mm = kApart * surface.skin_mm;
    const TouchCount touching(survey, gap_mm, threads);
    std::vector<std::uint8_t> isClear(surface.triangleCount());
    if (touching.isPairLimitExceeded()) {
        return isClear;
    }
    core::parallelForBlocks(
        surface.triangleCount(), kBlock,
        [&](std::size_t at) {
            const auto i = static_cast<std::uint32_t>(at);
            const Triangle& t = surface.triangles[i];
            if ((survey.isSmooth[t[0]] & survey.isSmooth[t[1]] & survey.isSmooth[t[2]]) == 0) {
                return;
            }
            // Triangles with a shared corner touch; three of them share two corners. Without other contacts the
            // triangle is alone.
            const int sharing = survey.uses[t[0]] + survey.uses[t[1]] + survey.uses[t[2]] - 6;
            isClear[i] = touching.of(i) == sharing || isAlone(surface, i, gap_mm) ? 1 : 0;
        },
        threads);
    return isClear;
}

} // namespace palpate::geometry
