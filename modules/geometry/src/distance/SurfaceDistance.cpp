// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/SurfaceDistance.h"

#include "distance/TrianglePair.h"
#include "palpate/geometry/Inside.h"
#include "palpate/geometry/internal/BoxHierarchySwept.h"
#include "palpate/geometry/internal/BoxHierarchyVisit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace palpate::geometry {

namespace {

/// A little more than a distance, so that rounding in the traversal leaves nothing out.
double justBeyond(double distance_mm)
{
    return distance_mm * (1.0 + 1e-9) + 1e-12;
}

/// A run of consecutive triangles of an index, which are near each other, with a sphere around them.
struct Run
{
    std::uint32_t first, count;
    Vec3 centre;
    double radius_mm;
    core::Box box;
};

/// Runs of triangles in levels: those of level 0 have kRun triangles, those of each next level kRun runs of the one
/// before.
class Runs
{
  public:
    static constexpr std::uint32_t kRun = 4;

    explicit Runs(const SurfaceIndex& surface)
    {
        std::vector<Run> level;
        for (std::uint32_t first = 0; first < surface.triangleCount(); first += kRun) {
            level.push_back(runAt(surface, first));
        }
        m_levels.push_back(std::move(level));
        while (m_levels.back().size() > 1) {
            m_levels.push_back(joined(m_levels.back()));
        }
    }
    [[nodiscard]] std::size_t top() const { return m_levels.size() - 1; }
    [[nodiscard]] const std::vector<Run>& level(std::size_t i) const { return m_levels[i]; }

  private:
    static Run around(const core::Box& box, std::uint32_t first, std::uint32_t count)
    {
        return {first, count, box.center(), 0.5 * box.diagonal().norm(), box};
    }
    static Run runAt(const SurfaceIndex& surface, std::uint32_t first)
    {
        const std::uint32_t count = std::min(kRun, surface.triangleCount() - first);
        core::Box box;
        for (std::uint32_t i = first; i < first + count; ++i) {
            for (const Vec3& corner : cornersAt(surface, i)) {
                box.extend(corner);
            }
        }
        return around(box, first, count);
    }
    static std::vector<Run> joined(const std::vector<Run>& below)
    {
        std::vector<Run> level;
        for (std::size_t i = 0; i < below.size(); i += kRun) {
            core::Box box;
            std::uint32_t count = 0;
            for (std::size_t k = i; k < std::min(below.size(), i + kRun); ++k) {
                box.extend(below[k].box);
                count += below[k].count;
            }
            level.push_back(around(box, below[i].first, count));
        }
        return level;
    }

    std::vector<std::vector<Run>> m_levels; ///< the last has one run
};

/// Search for the closest points of two surfaces.
class PairSearch
{
  public:
    PairSearch(const SurfaceIndex& few, const SurfaceIndex& many)
        : m_few(few)
        , m_many(many)
        , m_runs(few)
    {
    }
    NearPair nearest()
    {
        startWithSamples();
        open(m_runs.top(), 0);
        return m_best;
    }

  private:
    void take(const NearPair& pair)
    {
        if (pair.distance2 < m_best.distance2) {
            m_best = pair;
            m_best_mm = std::sqrt(pair.distance2);
        }
    }

    /// Finds a good bound: the closest of a few vertices, then to and fro between the surfaces while it gets closer.
    void startWithSamples()
    {
        constexpr std::uint32_t kSamples = 64;
        constexpr int kProjections = 32;
        const std::uint32_t step = std::max(1U, m_few.vertexCount() / kSamples);
        for (std::uint32_t i = 0; i < m_few.vertexCount(); i += step) {
            const Vec3& p = m_few.vertex(i);
            const auto within = std::isfinite(m_best_mm) ? std::optional(m_best_mm) : std::nullopt;
            if (const auto q = nearestPoint(m_many, p, within)) {
                take({p, q->at, (p - q->at).squaredNorm()});
            }
        }
        for (int i = 0; i < kProjections; ++i) {
            const double before_mm = m_best_mm;
            if (const auto p = nearestPoint(m_few, m_best.q, m_best_mm)) {
                take({p->at, m_best.q, (p->at - m_best.q).squaredNorm()});
            }
            if (const auto q = nearestPoint(m_many, m_best.p, m_best_mm)) {
                take({m_best.p, q->at, (m_best.p - q->at).squaredNorm()});
            }
            if (!(m_best_mm < 0.999 * before_mm)) {
                break;
            }
        }
    }

    void open(std::size_t level, std::size_t number)
    {
        const Run& run = m_runs.level(level)[number];
        if (m_best_mm == 0.0 || !isNear(run, m_many.bounds())) {
            return;
        }
        if (level == 0) {
            measure(run);
            return;
        }
        if (!hasNear(run)) {
            return;
        }
        const std::size_t size = m_runs.level(level - 1).size();
        for (std::size_t i = Runs::kRun * number; i < std::min(size, Runs::kRun * (number + 1)); ++i) {
            open(level - 1, i);
        }
    }
    [[nodiscard]] bool isNear(const Run& run, const core::Box& box) const
    {
        return run.box.squaredExteriorDistance(box) <= justBeyond(m_best.distance2);
    }
    /// True if a leaf of the other surface may be close enough.
    [[nodiscard]] bool hasNear(const Run& run) const
    {
        bool isFound = false;
        m_many.hierarchy().visitAround(run.centre, justBeyond(m_best_mm + run.radius_mm),
                                       [&isFound](std::uint32_t, std::uint32_t) {
                                           isFound = true;
                                           return false;
                                       });
        return isFound;
    }
    void measure(const Run& run)
    {
        m_many.hierarchy().visitAround(run.centre, justBeyond(m_best_mm + run.radius_mm),
                                       [&](std::uint32_t first, std::uint32_t count) {
                                           for (std::uint32_t j = first; j < first + count; ++j) {
                                               measure(run, cornersAt(m_many, j));
                                           }
                                           return m_best_mm > 0.0;
                                       });
    }
    void measure(const Run& run, const Corners& other)
    {
        core::Box box(other[0]);
        box.extend(other[1]);
        box.extend(other[2]);
        if (!isNear(run, box)) {
            return;
        }
        for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
            const Corners one = cornersAt(m_few, i);
            core::Box around(one[0]);
            around.extend(one[1]);
            around.extend(one[2]);
            if (around.squaredExteriorDistance(box) <= m_best.distance2) {
                take(nearestOf(one, other));
            }
        }
    }

    const SurfaceIndex &m_few, &m_many;
    Runs m_runs;
    NearPair m_best{Vec3::Zero(), Vec3::Zero(), std::numeric_limits<double>::infinity()};
    double m_best_mm = std::numeric_limits<double>::infinity();
};

bool isClosed(const SurfaceIndex& surface)
{
    for (std::uint32_t i = 0; i < surface.triangleCount(); ++i) {
        if (surface.isTwoSided(i)) {
            return false;
        }
    }
    return true;
}

/// True if a connected part of `inner` lies in `outer`. The surfaces do not meet, so one vertex decides for all
/// triangles that are connected within the box of `outer`.
bool hasPartInside(const SurfaceIndex& inner, const SurfaceIndex& outer)
{
    if (!inner.bounds().intersects(outer.bounds())) {
        return false;
    }
    std::vector<std::uint32_t> inBox, connected;
    std::vector<bool> isOpen(inner.triangleCount(), false);
    inner.hierarchy().visitBox(outer.bounds(), [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t i = first; i < first + count; ++i) {
            inBox.push_back(i);
            isOpen[i] = true;
        }
        return true;
    });
    if (inBox.empty() || !isClosed(outer)) {
        return false;
    }
    for (const std::uint32_t seed : inBox) {
        if (!isOpen[seed]) {
            continue;
        }
        if (isInside(outer, inner.vertex(inner.triangle(seed)[0]))) {
            return true;
        }
        isOpen[seed] = false;
        for (connected.assign(1, seed); !connected.empty();) {
            const std::uint32_t i = connected.back();
            connected.pop_back();
            for (std::uint32_t edge = 0; edge < 3; ++edge) {
                const std::uint32_t next = inner.neighbour(i, edge).triangle;
                if (next != SurfaceIndex::kNoNeighbour && isOpen[next]) {
                    isOpen[next] = false;
                    connected.push_back(next);
                }
            }
        }
    }
    return false;
}

} // namespace

std::optional<NearestPoint> nearestPoint(const SurfaceIndex& surface, const Vec3& p, std::optional<double> within_mm)
{
    if (surface.triangleCount() == 0) {
        return std::nullopt;
    }
    // Start again with a smaller reach as soon as a much closer triangle is found.
    constexpr double kMuchCloser = 0.6;
    double reach_mm = within_mm.value_or((p - surface.vertex(surface.triangle(0)[0])).norm());
    std::optional<NearPair> nearest;
    for (bool isComplete = false; !isComplete;) {
        isComplete = true;
        surface.hierarchy().visitAround(p, justBeyond(reach_mm), [&](std::uint32_t first, std::uint32_t count) {
            for (std::uint32_t i = first; i < first + count; ++i) {
                const NearPair found = nearestOf(p, cornersAt(surface, i));
                if (!nearest || found.distance2 < nearest->distance2) {
                    nearest = found;
                }
            }
            if (const double found_mm = std::sqrt(nearest->distance2); found_mm < kMuchCloser * reach_mm) {
                reach_mm = found_mm;
                isComplete = false;
            }
            return isComplete;
        });
    }
    if (!nearest || (within_mm && nearest->distance2 > justBeyond(*within_mm) * justBeyond(*within_mm))) {
        return std::nullopt;
    }
    return NearestPoint{std::sqrt(nearest->distance2), nearest->q};
}

std::optional<SurfaceDistance> surfaceDistance(const SurfaceIndex& first, const SurfaceIndex& second)
{
    if (first.triangleCount() == 0 || second.triangleCount() == 0) {
        return std::nullopt;
    }
    const bool isSwapped = first.triangleCount() > second.triangleCount();
    NearPair nearest = isSwapped ? PairSearch(second, first).nearest() : PairSearch(first, second).nearest();
    if (isSwapped) {
        std::swap(nearest.p, nearest.q);
    }
    // Rounding error of a touching corner.
    const double size_mm = first.bounds().merged(second.bounds()).diagonal().norm();
    const double apart_mm = std::sqrt(nearest.distance2);
    if (apart_mm <= 1e-14 * size_mm) {
        return SurfaceDistance{Relation::Crossing, 0.0, 0.0, nearest.p, nearest.p};
    }
    const Relation relation = hasPartInside(first, second)   ? Relation::Inside
                              : hasPartInside(second, first) ? Relation::Around
                                                             : Relation::Apart;
    return SurfaceDistance{relation, relation == Relation::Apart ? apart_mm : 0.0, apart_mm, nearest.p, nearest.q};
}

} // namespace palpate::geometry
