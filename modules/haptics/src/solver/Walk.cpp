// SPDX-License-Identifier: BSD-3-Clause
#include "solver/Walk.h"

#include "probe/ConstrainedPoint.h"

#include <algorithm>

namespace palpate::haptics::internal {

namespace {

constexpr std::uint32_t kMostSteps = 64;
constexpr std::uint32_t kMovePrice = 64; // price of a sweep, in units of TickWork
constexpr double kFarTarget = 16.0;      // facet sizes
constexpr double kSharpest = 0.5;        // cosine of the largest angle between the normals of two facets
static_assert(kSharpest <= geometry::SurfaceIndex::kClearMinCosine, "a walk crosses every edge of a clear facet");

/// Classifies the god-object's position on a facet; Away if the position is lower than a previous walk would have left
/// it.
/// @param edge  width of the band along the edges that counts as AtEdge, in skins
Footing standsOn(const Facet& facet, int side, const Vec3& g, double edge) noexcept
{
    const double skin = facet.skin_mm;
    if (side * facet.n.dot(g - facet.a) <= kMinWalkHeight * skin) {
        return Footing::Away;
    }
    return footingOn(facet, side, g, {geometry::SurfaceIndex::kClearHeight * skin, skin, edge * skin});
}

/// Returns true if `p` is at least `least_mm` away from each corner.
bool isOffCorners(const Facet& facet, const Vec3& p, double least_mm) noexcept
{
    const double least2 = least_mm * least_mm;
    return (p - facet.a).squaredNorm() > least2 && (p - facet.b).squaredNorm() > least2 &&
           (p - facet.c).squaredNorm() > least2;
}

} // namespace

/// Where the straight path to a target in a facet's plane leaves the facet.
struct Walk::Exit
{
    int edge = -1;            ///< 0 to 2: from corner a, b, c to the next; -1: the path stays inside
    double share = 1.0;       ///< fraction of the path
    bool isWellInside = true; ///< the target is inside by at least the margin
};

/// Constrained point of two facets with a common edge.
struct Walk::Crease
{
    Vec3 target;          ///< constrained point of the active planes [mm]
    int held = 0;         ///< number of active planes
    int first = 0;        ///< index of the first active plane
    bool isWithin = true; ///< the target is at the edge, between the ends by at least the margin
};

Walk::Ended Walk::run(Start start, std::uint32_t most) noexcept
{
    begin(start);
    Next next = start == Start::InCrease ? startFromCrease() : Next::Step;
    // The budget is charged at the end, by moves made: how far the walk looks ahead before testing depends on the
    // facets held, which must not influence the price.
    const std::uint32_t affordable = m_near.work().left() / kMovePrice + 1;
    for (std::uint32_t i = 0; i < std::min({most, kMostSteps, affordable}) && next == Next::Step; ++i) {
        next = step();
    }
    if (next != Next::Over) {
        if (m_isClear) {
            stand();
        } else {
            (void)commitPath();
        }
    }
    m_near.spend(kMovePrice * (m_moves + 1));
    return m_ended;
}

PALPATE_ALWAYS_INLINE void Walk::begin(Start start) noexcept
{
    m_path[0] = m_god;
    m_over[0] = m_over[1] = {m_facet.structure, m_facet.triangle};
    // Where a walk ended early at an edge, the facet that it left may block the path back.
    const bool isInside =
        start == Start::WellInside ||
        (start == Start::OnFacet && standsOn(m_facet, m_side, m_god, kTouchRadius) == Footing::Inside);
    const bool isInCrease = start == Start::InCrease && standsOn(m_facet, m_side, m_god, 0.0) != Footing::Away &&
                            standsOn(m_beyond, m_side, m_god, 0.0) != Footing::Away;
    m_isClear = (isInside || (isInCrease && isClearAt(m_beyond, m_god))) && isClearAt(m_facet, m_god);
}

PALPATE_ALWAYS_INLINE bool Walk::isClearAt(const Facet& facet, const Vec3& p) noexcept
{
    return m_surface.isClear(facet.triangle) &&
           isOffCorners(facet, p, geometry::SurfaceIndex::kClearOfCorners * m_facet.skin_mm) &&
           m_near.isAlone(m_layer, facet.structure, p);
}

/// Starts from a crease: along the crease, or off onto one of its two facets.
Walk::Next Walk::startFromCrease() noexcept
{
    m_ended = Ended::AtCreaseEnd;
    int edge = 0;
    while (edge < 3 &&
           m_surface.neighbour(m_facet.triangle, static_cast<std::uint32_t>(edge)).triangle != m_beyond.triangle) {
        ++edge;
    }
    if (edge == 3) {
        return Next::Over;
    }
    const Crease crease = creaseAt(m_facet, edge, m_god);
    if (crease.held == 0 || (crease.held == 2 && !crease.isWithin)) {
        return Next::Over;
    }
    if (crease.held == 2) {
        m_isClear = m_isClear && isClearAt(m_facet, crease.target) && isClearAt(m_beyond, crease.target);
        m_ended = makeLastMove(crease.target) ? Ended::InCrease : Ended::AtCreaseEnd;
        return Next::Over;
    }
    if (crease.first == 1) {
        m_facet = m_beyond;
        m_over[0] = m_over[1] = {m_facet.structure, m_facet.triangle};
    }
    m_ended = Ended::Unfinished;
    return Next::Step;
}

/// Moves over the current facet: to the foot of the HIP on its plane, or to the edge on the way there.
PALPATE_ALWAYS_INLINE Walk::Next Walk::step() noexcept
{
    const Vec3 outwards = m_side * m_here->n;
    const double rise = m_here->skin_mm - outwards.dot(m_hip - m_here->a);
    if (rise <= 0.0) {
        return Next::Stop; // the HIP is no longer behind the facet
    }
    Vec3 target = m_hip + rise * outwards;
    if (m_friction != nullptr) {
        target = slowed(target, rise);
    }
    if (isFar(target)) {
        return Next::Stop; // the straight path through free space is shorter
    }
    const Exit exit = exitFrom(last(), target);
    if (exit.edge < 0) {
        return exit.isWellInside ? arrive(target) : Next::Stop; // too near an edge to decide
    }
    return exit.edge == m_entered ? enterCrease(last()) : cross(exit, target);
}

/// Returns the position that friction allows on the way to `target` on the current facet; the current position if
/// static friction holds.
PALPATE_ALWAYS_INLINE Vec3 Walk::slowed(const Vec3& target, double rise) noexcept
{
    const Vec3 back = last() - m_hip;
    const Vec3 behind = back - m_here->n.dot(back) * m_here->n;
    m_friction->lift();
    m_friction->press(*m_here, last(), rise);
    const double left = m_friction->remainingFraction(behind.norm(), kMinMove * m_here->skin_mm);
    return left < 1.0 ? Vec3(target + left * behind) : last();
}

PALPATE_ALWAYS_INLINE bool Walk::isFar(const Vec3& target) const noexcept
{
    return (target - last()).squaredNorm() > kFarTarget * kFarTarget * m_layer.facetSize_mm * m_layer.facetSize_mm;
}

PALPATE_ALWAYS_INLINE Walk::Exit Walk::exitFrom(const Vec3& from, const Vec3& to) const noexcept
{
    // Project along the axis in which the facet appears largest; the margin shrinks accordingly.
    const Facet& facet = *m_here;
    int axis = 0;
    double shown = std::abs(facet.n[0]);
    for (int i = 1; i < 3; ++i) {
        if (std::abs(facet.n[i]) > shown) {
            axis = i;
            shown = std::abs(facet.n[i]);
        }
    }
    const double turned = facet.n[axis] > 0.0 ? 1.0 : -1.0;
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    Exit exit;
    const std::array<const Vec3*, 4> corner{&facet.a, &facet.b, &facet.c, &facet.a};
    for (std::size_t e = 0; e < 3; ++e) {
        const Vec3 &p = *corner[e], &q = *corner[e + 1];
        const double u = turned * (q[j] - p[j]), v = turned * (q[k] - p[k]);
        // Distance to the left of the edge, times the edge length.
        const double end = u * (to[k] - p[k]) - v * (to[j] - p[j]);
        if (end > m_margin_mm * (std::abs(u) + std::abs(v))) {
            continue;
        }
        exit.isWellInside = false;
        if (end > 0.0) {
            continue;
        }
        const double begin = std::max(0.0, u * (from[k] - p[k]) - v * (from[j] - p[j]));
        const double share = begin > 0.0 ? begin / (begin - end) : 0.0;
        if (exit.edge < 0 || share < exit.share) {
            exit.edge = static_cast<int>(e);
            exit.share = share;
        }
    }
    return exit;
}

PALPATE_ALWAYS_INLINE Walk::Next Walk::arrive(const Vec3& target) noexcept
{
    m_isClear = m_isClear && isClearAt(*m_here, target);
    // The next gathering may not cover the path so far, so the path is tested first.
    if ((m_isClear || m_near.holds(target) || commitPath()) && makeLastMove(target)) {
        m_ended = Ended::OnFacet;
    }
    return Next::Over;
}

/// Ends the walk in the crease of two facets neither of which lets the god-object pass to the other.
/// @param from  position at which the walk returned to their edge
Walk::Next Walk::enterCrease(const Vec3& from) noexcept
{
    const auto edge = static_cast<std::uint32_t>(m_entered);
    m_beyond = Facet::of(m_surface, m_facet.structure, m_surface.neighbour(m_here->triangle, edge).triangle);
    const Crease crease = creaseAt(*m_here, m_entered, from);
    if (crease.held != 2) {
        return Next::Stop;
    }
    if (!crease.isWithin) {
        if (m_isClear) {
            stand();
        }
        m_ended = m_isClear || commitPath() ? Ended::AtCreaseEnd : Ended::Unfinished;
        return Next::Over;
    }
    m_isClear = m_isClear && isClearAt(*m_here, crease.target) && isClearAt(m_beyond, crease.target);
    if ((m_isClear || m_near.holds(crease.target) || commitPath()) && makeLastMove(crease.target)) {
        m_ended = Ended::InCrease;
    }
    return Next::Over;
}

/// @param facet  one of the two facets; the other is m_beyond
/// @param edge  index of the common edge in `facet`
Walk::Crease Walk::creaseAt(const Facet& facet, int edge, const Vec3& g) noexcept
{
    const Vec3 n = m_side * facet.n, m = m_side * m_beyond.n;
    const std::array planes{HalfSpace{n, facet.skin_mm - n.dot(g - facet.a)},
                            HalfSpace{m, m_beyond.skin_mm - m.dot(g - m_beyond.a)}};
    const Vec3 wanted = m_hip - g;
    const ConstrainedPoint point = constrainedPoint(wanted, planes, allowance(facet.skin_mm, wanted));
    const std::array<const Vec3*, 5> corner{&facet.a, &facet.b, &facet.c, &facet.a, &facet.b};
    const auto e = static_cast<std::size_t>(edge);
    const Vec3 &begin = *corner[e], &end = *corner[e + 1], &opposite = *corner[e + 2];
    Crease crease;
    crease.target = g + point.u;
    crease.held = m.dot(opposite - m_beyond.a) > 0.0 ? point.count : 0; // only if the facets form a concave edge
    crease.first = point.active[0];
    const Vec3 along = (end - begin).normalized();
    if (m_friction != nullptr && crease.held == 2) {
        const double ahead = along.dot(point.u);
        m_friction->lift();
        m_friction->press(facet, g, point.lambda_mm[0]);
        m_friction->press(m_beyond, g, point.lambda_mm[1]);
        const double left = m_friction->remainingFraction(std::abs(ahead), kMinMove * facet.skin_mm);
        crease.target = left < 1.0 ? Vec3(crease.target - left * ahead * along) : g;
    }
    // The intersection line of two nearly parallel planes is determined by rounding and may lie anywhere beside the
    // edge.
    const Vec3 from = crease.target - begin;
    const bool isAtEdge = from.cross(along).norm() <= kEdgeTolerance * facet.skin_mm;
    crease.isWithin = isAtEdge && along.dot(from) > m_margin_mm && along.dot(end - crease.target) > m_margin_mm;
    return crease;
}

/// Crosses an edge to the adjacent facet.
Walk::Next Walk::cross(const Exit& exit, const Vec3& target) noexcept
{
    Vec3 to = last() + exit.share * (target - last());
    m_isClear = m_isClear && isClearAt(*m_here, to);
    if (!m_isClear && !m_near.holds(to) && !commitPath()) {
        return Next::Over;
    }
    const geometry::SurfaceIndex::Neighbour neighbour =
        m_surface.neighbour(m_here->triangle, static_cast<std::uint32_t>(exit.edge));
    if (!m_isClear) {
        m_near.reach(m_layer, last(), to, target);
    }
    if (neighbour.triangle == geometry::SurfaceIndex::kNoNeighbour) {
        return Next::Stop;
    }
    Facet& next = m_met[m_crossings++ % 2];
    next = Facet::of(m_surface, m_facet.structure, neighbour.triangle);
    m_entered = static_cast<int>(neighbour.edge);
    if (m_here->n.dot(next.n) < kSharpest) {
        return Next::Stop;
    }
    // At a concave edge the next facet is met before the edge.
    const double end = m_side * next.n.dot(target - next.a) - next.skin_mm;
    if (end < 0.0) {
        const double begin = m_side * next.n.dot(last() - next.a) - next.skin_mm;
        const double share = begin > 0.0 ? begin / (begin - end) : 0.0;
        if (share < exit.share) {
            to = last() + share * (target - last());
        }
    }
    if (!liftOver(next, target, exit.share, to)) {
        return Next::Stop;
    }
    m_here = &next;
    if (m_isClear) {
        m_path[0] = m_god = to;
        m_over[0] = m_over[1];
        m_over[1] = {next.structure, next.triangle};
        ++m_moves;
        return Next::Step;
    }
    addToPath(to);
    m_over[m_points] = {next.structure, next.triangle};
    ++m_crossed;
    return m_points < m_path.size() || commitPath() ? Next::Step : Next::Over;
}

/// Extends a move over a convex edge. The foot on the facet before the edge may leave that facet too early by its
/// height above the facet, so the move continues until the god-object is half a skin above the next facet's plane. The
/// path along the next facet then passes the plane of the previous one half a skin or more beyond their edge, for turns
/// of up to 60 degrees.
/// @param next  facet beyond the edge
/// @param target  end of the straight path on the previous facet [mm]
/// @param share  fraction of the path at which it leaves the previous facet
/// @param to  end of the move; updated [mm]
/// @return false if that position is not at the edge
bool Walk::liftOver(const Facet& next, const Vec3& target, double share, Vec3& to) const noexcept
{
    const double least = kLiftHeight * next.skin_mm;
    if (m_side * next.n.dot(to - next.a) >= least) {
        return true;
    }
    const Vec3& from = last();
    const double begin = m_side * next.n.dot(from - next.a), end = m_side * next.n.dot(target - next.a);
    const double lifted = (least - begin) / (end - begin);
    if (!(end > begin) || lifted > 1.0 || (lifted - share) * (target - from).norm() > kEdgeTolerance * next.skin_mm) {
        return false;
    }
    to = from + lifted * (target - from);
    return m_side * next.n.dot(to - next.a) > 0.0;
}

PALPATE_ALWAYS_INLINE void Walk::stand() noexcept
{
    if (m_here != &m_facet) {
        m_facet = *m_here;
    }
}

void Walk::addToPath(const Vec3& p) noexcept
{
    if (m_friction != nullptr) {
        m_frictionAt[m_points] = m_friction->state();
    }
    m_path[m_points++] = p;
}

/// Makes the moves of the path up to the first blocked one, and begins a new path there.
///
/// The facet of a move and the facet across the edge cannot block the move: a move begins and ends a skin above the
/// facet that it follows, and where the two facets turn by at most 60 degrees it passes the plane of the other half a
/// skin or more beyond their edge.
/// @return true if no move is blocked
bool Walk::commitPath() noexcept
{
    const std::size_t moves = m_near.freeMoves(m_layer, std::span<const Vec3>(m_path).first(m_points),
                                               std::span<const FacetNumber>(m_over).first(m_crossed + 2));
    const bool isFree = moves + 1 == m_points;
    m_god = m_path[moves];
    m_moves += static_cast<std::uint32_t>(moves);
    if (!isFree) {
        m_facet = Facet::of(m_surface, m_facet.structure, m_over[moves + 1].triangle);
        if (m_friction != nullptr) {
            // Undo the look-ahead, whose length depends on the facets held.
            m_friction->restore(m_frictionAt[moves + 1]);
        }
    } else {
        stand();
    }
    m_here = &m_facet;
    m_path[0] = m_god;
    m_over[0] = m_over[std::min(moves, m_crossed)];
    m_over[1] = {m_facet.structure, m_facet.triangle};
    m_points = 1;
    m_crossed = 0;
    return isFree;
}

/// Makes the last move.
/// @return false if the move is blocked
PALPATE_ALWAYS_INLINE bool Walk::makeLastMove(const Vec3& target) noexcept
{
    if (m_isClear) {
        m_god = target;
        ++m_moves;
        stand();
        return true;
    }
    addToPath(target);
    return commitPath();
}

} // namespace palpate::haptics::internal
