// SPDX-License-Identifier: BSD-3-Clause
#include "solver/Walk.h"

#include "solver/ConstrainedPoint.h"

#include <algorithm>

namespace palpate::haptics::internal {

namespace {

constexpr std::uint32_t kMostFacets = 64;
constexpr std::uint32_t kMovePrice = 64; // as of a sweep, in units of TickWork
constexpr double kFarTarget = 16.0;      // facet sizes
constexpr double kSharpest = 0.5;        // cosine of the angle between two facets' normals
static_assert(kSharpest <= geometry::SurfaceIndex::kClearTurned, "a walk crosses every edge of a clear facet");

/// @return where a god-object stands on a facet, if it does so as one that has walked there.
/// @param edge  width of the band along the edges that counts as AtEdge, in skins
Footing standsOn(const Facet& facet, int side, const Vec3& g, double edge) noexcept
{
    const double skin = facet.skin_mm;
    if (side * facet.n.dot(g - facet.a) <= kStanding * skin) {
        return Footing::Away;
    }
    return footingOn(facet, side, g, {geometry::SurfaceIndex::kClearHeight * skin, skin, edge * skin});
}

/// @return true when `p` is at least `least_mm` away from each corner.
bool isOffCorners(const Facet& facet, const Vec3& p, double least_mm) noexcept
{
    const double least2 = least_mm * least_mm;
    return (p - facet.a).squaredNorm() > least2 && (p - facet.b).squaredNorm() > least2 &&
           (p - facet.c).squaredNorm() > least2;
}

} // namespace

/// Where the way to a place in a facet's plane leaves the facet.
struct Walk::Exit
{
    int edge = -1;            ///< 0 … 2: from corner a, b, c to the next; -1: it does not leave
    double share = 1.0;       ///< of the way
    bool isWellInside = true; ///< the place itself, by at least the margin
};

/// Where two facets with a common edge hold a god-object.
struct Walk::Crease
{
    Vec3 target;          ///< constrained point of the planes that hold [mm]
    int held = 0;         ///< how many of the two hold
    int first = 0;        ///< number of the first that does
    bool isWithin = true; ///< the target is at the edge, between its ends by at least the margin
};

Walk::Ended Walk::run(Start start, std::uint32_t most) noexcept
{
    begin(start);
    Next next = start == Start::InCrease ? leaveCrease() : Next::Step;
    // Charged below, by the moves made: how far the walk looks ahead before it asks for them depends on what is held.
    const std::uint32_t affordable = m_near.work().left() / kMovePrice + 1;
    for (std::uint32_t i = 0; i < std::min({most, kMostFacets, affordable}) && next == Next::Step; ++i) {
        next = step();
    }
    if (next != Next::Over) {
        if (m_isClear) {
            stand();
        } else {
            (void)makePathMoves();
        }
    }
    m_near.spend(kMovePrice * (m_moves + 1));
    return m_ended;
}

PALPATE_ALWAYS_INLINE void Walk::begin(Start start) noexcept
{
    m_path[0] = m_god;
    m_over[0] = m_over[1] = {m_facet.structure, m_facet.triangle};
    // At an edge, where a walk may have ended early, the facet that it left may be in the way back.
    const bool isInside = start == Start::WellInside ||
                          (start == Start::OnFacet && standsOn(m_facet, m_side, m_god, kTouched) == Footing::Inside);
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

/// From the crease where the walk begins: along it, or off one of its two facets.
Walk::Next Walk::leaveCrease() noexcept
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

/// Over the facet here: to the foot of the HIP on it, or to the edge on the way there.
PALPATE_ALWAYS_INLINE Walk::Next Walk::step() noexcept
{
    const Vec3 outwards = m_side * m_here->n;
    const double rise = m_here->skin_mm - outwards.dot(m_hip - m_here->a);
    if (rise <= 0.0) {
        return Next::Stop; // the facet lets go
    }
    Vec3 target = m_hip + rise * outwards;
    if (m_friction != nullptr) {
        target = slowed(target, rise);
    }
    if (isFar(target)) {
        return Next::Stop; // straight through the air is shorter
    }
    const Exit exit = exitFrom(last(), target);
    if (exit.edge < 0) {
        return exit.isWellInside ? arrive(target) : Next::Stop; // too near an edge to tell
    }
    return exit.edge == m_entered ? enterCrease(last()) : cross(exit, target);
}

/// Where friction lets the god-object go on the way to `target` on the facet here: the same place where it holds.
PALPATE_ALWAYS_INLINE Vec3 Walk::slowed(const Vec3& target, double rise) noexcept
{
    const Vec3 back = last() - m_hip;
    const Vec3 behind = back - m_here->n.dot(back) * m_here->n;
    m_friction->lift();
    m_friction->press(*m_here, last(), rise);
    const double left = m_friction->remainingShare(behind.norm(), kRoundingOfMoves * m_here->skin_mm);
    return left < 1.0 ? Vec3(target + left * behind) : last();
}

PALPATE_ALWAYS_INLINE bool Walk::isFar(const Vec3& target) const noexcept
{
    return (target - last()).squaredNorm() > kFarTarget * kFarTarget * m_layer.facetSize_mm * m_layer.facetSize_mm;
}

PALPATE_ALWAYS_INLINE Walk::Exit Walk::exitFrom(const Vec3& from, const Vec3& to) const noexcept
{
    // Seen along the axis that shows most of the facet; the margin shrinks there with it.
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
        const double end = u * (to[k] - p[k]) - v * (to[j] - p[j]); // to the left of the edge, times its length
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
    // The facets gathered next need not be those around the path so far: it is asked for first.
    if ((m_isClear || m_near.holds(target) || makePathMoves()) && makeLastMove(target)) {
        m_ended = Ended::OnFacet;
    }
    return Next::Over;
}

/// Neither of two facets lets the god-object go over to the other. @param from  where it came back to their edge
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
        m_ended = m_isClear || makePathMoves() ? Ended::AtCreaseEnd : Ended::Unfinished;
        return Next::Over;
    }
    m_isClear = m_isClear && isClearAt(*m_here, crease.target) && isClearAt(m_beyond, crease.target);
    if ((m_isClear || m_near.holds(crease.target) || makePathMoves()) && makeLastMove(crease.target)) {
        m_ended = Ended::InCrease;
    }
    return Next::Over;
}

/// @param facet  one of the two, the other being that beyond; @param edge  the common one's number in it
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
    crease.held = m.dot(opposite - m_beyond.a) > 0.0 ? point.count : 0; // only where they rise towards each other
    crease.first = point.active[0];
    const Vec3 along = (end - begin).normalized();
    if (m_friction != nullptr && crease.held == 2) {
        const double ahead = along.dot(point.u);
        m_friction->lift();
        m_friction->press(facet, g, point.lambda_mm[0]);
        m_friction->press(m_beyond, g, point.lambda_mm[1]);
        const double left = m_friction->remainingShare(std::abs(ahead), kRoundingOfMoves * facet.skin_mm);
        crease.target = left < 1.0 ? Vec3(crease.target - left * ahead * along) : g;
    }
    // Where two planes are one to rounding, so is where they cross: that may lie anywhere beside the edge.
    const Vec3 from = crease.target - begin;
    const bool isAtEdge = from.cross(along).norm() <= kBesideEdge * facet.skin_mm;
    crease.isWithin = isAtEdge && along.dot(from) > m_margin_mm && along.dot(end - crease.target) > m_margin_mm;
    return crease;
}

/// Over an edge to the facet beyond it.
Walk::Next Walk::cross(const Exit& exit, const Vec3& target) noexcept
{
    Vec3 to = last() + exit.share * (target - last());
    m_isClear = m_isClear && isClearAt(*m_here, to);
    if (!m_isClear && !m_near.holds(to) && !makePathMoves()) {
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
    // Where the surface rises, the next facet is met before the edge.
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
    return m_points < m_path.size() || makePathMoves() ? Next::Step : Next::Over;
}

/// Where the surface falls away beyond an edge, the foot on the facet before it can leave that facet too early by its
/// height above it: goes on until the god-object is half a skin above the next facet's plane. From there the way along
/// that one passes the plane of the one before half a skin or more beyond their edge, as far as they turn by 60
/// degrees.
/// @param share  of the way to the target at which it leaves the facet before
/// @return false when that place is not at the edge
bool Walk::liftOver(const Facet& next, const Vec3& target, double share, Vec3& to) const noexcept
{
    const double least = kLifted * next.skin_mm;
    if (m_side * next.n.dot(to - next.a) >= least) {
        return true;
    }
    const Vec3& from = last();
    const double begin = m_side * next.n.dot(from - next.a), end = m_side * next.n.dot(target - next.a);
    const double lifted = (least - begin) / (end - begin);
    if (!(end > begin) || lifted > 1.0 || (lifted - share) * (target - from).norm() > kBesideEdge * next.skin_mm) {
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

/// Makes the moves of the path up to the first that is blocked, and begins a new one there.
///
/// On one facet and over the edge to the next, neither can be in the way: a move begins and ends a skin above the one
/// it follows, and where their angle is at most 60 degrees it passes the other's plane half a skin or more beyond their
/// edge.
/// @return true when none is blocked
bool Walk::makePathMoves() noexcept
{
    const std::size_t moves = m_near.freeMoves(m_layer, std::span<const Vec3>(m_path).first(m_points),
                                               std::span<const FacetNumber>(m_over).first(m_crossed + 2));
    const bool isFree = moves + 1 == m_points;
    m_god = m_path[moves];
    m_moves += static_cast<std::uint32_t>(moves);
    if (!isFree) {
        m_facet = Facet::of(m_surface, m_facet.structure, m_over[moves + 1].triangle);
        if (m_friction != nullptr) {
            m_friction->restore(m_frictionAt[moves + 1]); // how far was looked ahead depends on what is held
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

/// Makes the last move. @return false when it is blocked
PALPATE_ALWAYS_INLINE bool Walk::makeLastMove(const Vec3& target) noexcept
{
    if (m_isClear) {
        m_god = target;
        ++m_moves;
        stand();
        return true;
    }
    addToPath(target);
    return makePathMoves();
}

} // namespace palpate::haptics::internal
