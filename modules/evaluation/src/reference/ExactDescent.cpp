// SPDX-License-Identifier: BSD-3-Clause
#include "reference/ExactDescent.h"

#include "reference/ClosestPoint.h"
#include "reference/ExactSkin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palpate::evaluation {

namespace {

// Touched triangles without a common edge only intersect where surfaces cross. Above this number of touched triangles
// (the apex of a fan), only pairs with a common edge are tried.
constexpr std::size_t kFewTouched = 24;

bool isApart(const Box& box, const Vec3& low, const Vec3& high)
{
    return (box.min().array() > high.array()).any() || (box.max().array() < low.array()).any();
}

} // namespace

ExactDescent::ExactDescent(const Surface& surface, double friction)
    : m_surface(surface)
    , m_friction(friction)
    , m_skin_mm(std::ldexp(static_cast<long double>(surface.magnitude_mm()), kSkinBits))
{
}

void ExactDescent::gather(const Long3& g, const Long3& hip)
{
    // No move ends farther from the HIP than the start, apart from the lift by a few skins.
    const auto reach = static_cast<double>((hip - g).norm() + 4 * kTouched * m_skin_mm) * (1.0 + 1e-12);
    const Vec3 centre = hip.cast<double>();
    const Box wanted(centre.array() - reach, centre.array() + reach);
    if (m_gathered.contains(wanted)) {
        return;
    }
    const double spare = std::max(0.5 * reach, m_surface.facetSize_mm());
    m_gathered = Box(wanted.min().array() - spare, wanted.max().array() + spare);
    m_near.clear();
    m_surface.appendNear(m_gathered, m_near);
    m_candidates.clear();
    m_boxes.clear();
    for (const std::uint32_t i : m_near) {
        Candidate t;
        t.a = m_surface.corner(i, 0).cast<long double>();
        t.b = m_surface.corner(i, 1).cast<long double>();
        t.c = m_surface.corner(i, 2).cast<long double>();
        const Long3 ab = t.b - t.a, ac = t.c - t.a, n = ab.cross(ac);
        t.n = n.normalized();
        t.normalError = 64 * std::numeric_limits<long double>::epsilon() * ab.norm() * ac.norm() / n.norm();
        t.triangle = i;
        t.isTwoSided = m_surface.isTwoSided(i);
        m_candidates.push_back(t);
        m_boxes.push_back(m_surface.box(i));
    }
}

/// Side of the triangle's plane: +1 in front, 0 on the plane. Uses the normal where the sign is certain, otherwise
/// exact arithmetic.
int ExactDescent::side(const Candidate& t, const Long3& p)
{
    const Long3 ap = p - t.a;
    const long double distance = t.n.dot(ap);
    if (std::abs(distance) > t.normalError * ap.lpNorm<1>()) {
        return distance > 0 ? 1 : -1;
    }
    return orientation(t.a, t.b, t.c, p);
}

bool ExactDescent::blocks(const Candidate& t, const Long3& from, const Long3& to)
{
    int facing = 1;
    const int start = side(t, from);
    if (start < 0) {
        if (!t.isTwoSided) {
            return false;
        }
        facing = -1;
    }
    // A two-sided surface must not be reached exactly, because the side would then be lost.
    const int end = facing * side(t, to);
    if (end > 0 || (end == 0 && (!t.isTwoSided || start == 0))) {
        return false;
    }
    return facing * orientation(from, to, t.a, t.b) <= 0 && facing * orientation(from, to, t.b, t.c) <= 0 &&
           facing * orientation(from, to, t.c, t.a) <= 0;
}

Long3 ExactDescent::sweep(const Long3& from, const Long3& to, bool& isBlocked) const
{
    const Vec3 x = from.cast<double>(), y = to.cast<double>();
    const double spare = 4e-16 * (x.cwiseAbs().maxCoeff() + y.cwiseAbs().maxCoeff());
    const Vec3 low = x.cwiseMin(y).array() - spare, high = x.cwiseMax(y).array() + spare;
    long double first = 2, stop = 1;
    for (std::size_t i = 0; i < m_candidates.size(); ++i) {
        const Candidate& t = m_candidates[i];
        if (isApart(m_boxes[i], low, high) || !blocks(t, from, to)) {
            continue;
        }
        const long double start = std::abs(t.n.dot(from - t.a)), end = std::abs(t.n.dot(to - t.a));
        const long double length = start + end; // on opposite sides
        const long double share = length > 0 ? start / length : 0;
        const long double here = length > 0 ? std::max(0.0L, (start - m_skin_mm) / length) : 0;
        if (share < first || (share == first && here < stop)) {
            first = share;
            stop = here;
        }
    }
    isBlocked = first <= 1;
    return isBlocked ? Long3(from + stop * (to - from)) : to;
}

void ExactDescent::findTouched(const Long3& g)
{
    m_touched.clear();
    const long double reach = kTouched * m_skin_mm;
    const Vec3 p = g.cast<double>();
    const double wide = 2.0 * static_cast<double>(reach) + 4e-16 * p.cwiseAbs().maxCoeff();
    const Vec3 low = p.array() - wide, high = p.array() + wide;
    for (std::size_t i = 0; i < m_candidates.size(); ++i) {
        if (isApart(m_boxes[i], low, high)) {
            continue;
        }
        const Candidate& t = m_candidates[i];
        const int facing = side(t, g);
        if (facing < 0 && !t.isTwoSided) {
            continue;
        }
        if ((closestPoint<long double>(t.a, t.b, t.c, g) - g).norm() <= reach) {
            m_touched.push_back({&t, facing < 0 ? Long3(-t.n) : t.n});
        }
    }
}

/// Collects all pairs of touched triangles, or only pairs with a common edge if many are touched.
void ExactDescent::findPairs()
{
    m_pairs.clear();
    const auto count = static_cast<std::uint32_t>(m_touched.size());
    if (count <= kFewTouched) {
        for (std::uint32_t i = 0; i < count; ++i) {
            for (std::uint32_t j = i + 1; j < count; ++j) {
                m_pairs.emplace_back(i, j);
            }
        }
        return;
    }
    std::vector<std::array<std::uint32_t, 3>> uses; // edge vertices (ascending), touched triangle
    for (std::uint32_t i = 0; i < count; ++i) {
        const geometry::Triangle& t = m_surface.repaired().mesh.triangles[m_touched[i].triangle->triangle];
        for (std::size_t k = 0; k < 3; ++k) {
            uses.push_back({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]), i});
        }
    }
    std::sort(uses.begin(), uses.end());
    for (std::size_t a = 0; a < uses.size(); ++a) {
        for (std::size_t b = a + 1; b < uses.size() && uses[b][0] == uses[a][0] && uses[b][1] == uses[a][1]; ++b) {
            m_pairs.emplace_back(uses[a][2], uses[b][2]);
        }
    }
}

void ExactDescent::collectWays(const Long3& from, const Long3& hip)
{
    m_ways.clear();
    const Long3 wanted = hip - from;
    const auto offer = [&](const Long3& u, int planes, std::array<const Candidate*, 2> on,
                           long double multiplierSum_mm) {
        const long double promise = (2 * wanted - u).dot(u);
        if (promise > 0) {
            m_ways.push_back({from + u, promise, planes, on, multiplierSum_mm});
        }
    };
    const auto room = [&](const Touched& t) { return m_skin_mm - t.n.dot(from - t.triangle->a); };
    offer(wanted, 0, {}, 0);
    for (std::size_t i = 0; i < m_touched.size(); ++i) {
        const Long3& n = m_touched[i].n;
        const long double push_mm = room(m_touched[i]) - n.dot(wanted);
        offer(wanted + n * push_mm, 1, {m_touched[i].triangle, nullptr}, std::max(0.0L, push_mm));
    }
    for (const auto& [i, j] : m_pairs) {
        const Touched &p = m_touched[i], &q = m_touched[j];
        const Long3 line = p.n.cross(q.n);
        if (line.norm() < 1e-13L) {
            continue; // the same plane within long double precision
        }
        // u: `wanted` projected onto both planes, first onto p, then within p onto q.
        const Long3 across = line.cross(p.n).normalized();
        Long3 u = wanted + p.n * (room(p) - p.n.dot(wanted));
        u += across * ((room(q) - q.n.dot(u)) / q.n.dot(across));
        // u - wanted = a p.n + b q.n
        const Long3 push = u - wanted;
        const long double c = p.n.dot(q.n), det = 1 - c * c;
        const long double a = (p.n.dot(push) - c * q.n.dot(push)) / det, b = (q.n.dot(push) - c * p.n.dot(push)) / det;
        offer(u, 2, {p.triangle, q.triangle}, std::max(0.0L, a) + std::max(0.0L, b));
    }
    std::sort(m_ways.begin(), m_ways.end(), [](const Way& a, const Way& b) { return a.promise > b.promise; });
}

/// Quick rejection for many touched triangles: returns true if one of them blocks the move within the minimum length.
/// The triangle that blocked the previous move is tested first.
bool ExactDescent::isBlockedQuickly(const Long3& from, const Long3& to, long double leastMove_mm)
{
    if (m_touched.size() <= kFewTouched) {
        return false;
    }
    const long double length = (to - from).norm();
    const auto shuts = [&](const Candidate& t) {
        if (!blocks(t, from, to)) {
            return false;
        }
        const long double start = std::abs(t.n.dot(from - t.a)), end = std::abs(t.n.dot(to - t.a));
        return start * length <= 0.5L * leastMove_mm * (start + end);
    };
    for (std::size_t i = 0; i < m_touched.size(); ++i) {
        const std::size_t k = (m_lastShut + i) % m_touched.size();
        if (shuts(*m_touched[k].triangle)) {
            m_lastShut = k;
            return true;
        }
    }
    return false;
}

/// Makes the move from `from` that ends closest to the HIP. @return false if no move is possible
bool ExactDescent::advance(Long3& g, const Long3& from, const Long3& hip, long double leastMove_mm)
{
    const Long3 wanted = hip - g;
    const long double least = 2 * wanted.norm() * kLeastGain * m_skin_mm;
    long double best = least;
    Long3 reached = g;
    int planes = 0;
    const Way* taken = nullptr;
    const long double lost = (2 * wanted - (from - g)).dot(from - g);
    for (const Way& way : m_ways) {
        if (way.promise + lost <= best) {
            break; // the remaining moves promise less than the best one found
        }
        if (isBlockedQuickly(from, way.target, leastMove_mm) ||
            (m_friction > 0 && supportedLength_mm(way, from) <= leastMove_mm)) {
            continue;
        }
        bool isBlocked = false;
        const Long3 p = sweep(from, way.target, isBlocked);
        const Long3 move = p - g;
        const long double gain = (2 * wanted - move).dot(move);
        if (gain > best && move.norm() > leastMove_mm) {
            best = gain;
            reached = p;
            planes = way.planes + (isBlocked ? 1 : 0);
            taken = &way;
        }
    }
    if (best <= least) {
        return false;
    }
    if (m_friction > 0 && taken->planes > 0) {
        return moveWithFriction(g, from, *taken, leastMove_mm);
    }
    g = reached;
    m_constraints = std::min(planes, 3);
    return true;
}

/// Length of a move until it leaves one of the supporting triangles; a triangle supports the point only above its
/// area.
long double ExactDescent::supportedLength_mm(const Way& way, const Long3& from)
{
    const Long3 along = (way.target - from).normalized();
    long double stays = std::numeric_limits<long double>::infinity();
    for (const Candidate* on : way.on) {
        if (on == nullptr) {
            continue;
        }
        const std::array<const Long3*, 3> corners{&on->a, &on->b, &on->c};
        for (std::size_t i = 0; i < 3; ++i) {
            const Long3& corner = *corners[i];
            const Long3 out = (*corners[(i + 1) % 3] - corner).cross(on->n).normalized();
            if (const long double speed = out.dot(along); speed > 0) {
                stays = std::min(stays, std::max(0.0L, out.dot(corner - from)) / speed);
            }
        }
    }
    return stays;
}

/// Move with friction along the contact: the point stays R = friction times push behind its frictionless end point.
/// The move ends slightly beyond the supporting triangles, where others take over.
/// @return false if the point sticks or hardly moves
bool ExactDescent::moveWithFriction(Long3& g, const Long3& from, const Way& way, long double leastMove_mm)
{
    const Long3 left = way.target - from;
    const long double r = left.norm(), behind = m_friction * way.multiplierSum_mm;
    if (r <= behind) {
        return false;
    }
    bool isBlocked = false;
    const long double move_mm = std::min(r - behind, supportedLength_mm(way, from) + leastMove_mm);
    const Long3 p = sweep(from, from + left * (move_mm / r), isBlocked);
    if ((p - g).norm() <= leastMove_mm) {
        return false;
    }
    g = p;
    m_constraints = std::min(way.planes + (isBlocked ? 1 : 0), 3);
    return true;
}

std::uint32_t ExactDescent::converge(Long3& g, const Long3& hip)
{
    gather(g, hip);
    for (std::uint32_t moves = 0; moves < kMostMoves; ++moves) {
        if (g == hip) {
            m_constraints = 0;
            return moves;
        }
        findTouched(g);
        findPairs();
        collectWays(g, hip);
        if (advance(g, g, hip, 4 * m_skin_mm)) {
            continue;
        }
        // Within the thickness of a skin, the edge of a triangle can block a direction that is free beyond the edge:
        // also try all moves from slightly above.
        bool isBlocked = false;
        const Long3 above = sweep(g, g - (hip - g).normalized() * kTouched * m_skin_mm, isBlocked);
        collectWays(above, hip);
        if (!advance(g, above, hip, 2 * kTouched * m_skin_mm)) {
            return moves;
        }
    }
    return kMostMoves;
}

} // namespace palpate::evaluation
