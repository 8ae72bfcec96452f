// SPDX-License-Identifier: BSD-3-Clause
#include "reference/ExactBall.h"

#include "reference/ClosestPoint.h"
#include "reference/ExactSkin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palpate::evaluation {

namespace {

constexpr long double kSpare = 1.0L / 64; // skins: margin for rounding errors of the distance
constexpr long double kTangent = 1e-17L;  // relative to a move: a contact violated by less is satisfied
constexpr long double kLongest = 0.1L;    // radii: longest extrapolated move
constexpr long double kSlow = 0.3L;       // ratio of successive moves above which to extrapolate
constexpr long double kAlike = 0.9L;      // cosine between successive moves
constexpr long double kProbe = 1e-3L;     // radii: lateral probe for unstable equilibria
constexpr long double kLevel = 1e-9L;     // sine of the slope that counts as level
constexpr long double kNever = 2;
constexpr int kMostSteps = 200; // Newton steps; at a grazing contact each only halves the error
constexpr std::size_t kFewNormals = 24;

} // namespace

ExactBall::ExactBall(const Surface& surface, double radius_mm)
    : m_surface(surface)
    , m_radius_mm(radius_mm)
    , m_skin_mm(std::ldexp(static_cast<long double>(surface.magnitude_mm()), kSkinBits))
{
}

void ExactBall::gather(const Vec3& centre, double reach_mm)
{
    const Box wanted(centre.array() - reach_mm, centre.array() + reach_mm);
    if (m_gathered.contains(wanted)) {
        return;
    }
    const double spare = std::max(0.25 * reach_mm, m_surface.facetSize_mm());
    m_gathered = Box(wanted.min().array() - spare, wanted.max().array() + spare);
    m_near.clear();
    m_surface.appendNear(m_gathered, m_near);
    m_candidates.clear();
    for (const std::uint32_t i : m_near) {
        Candidate t;
        t.a = m_surface.corner(i, 0).cast<long double>();
        t.b = m_surface.corner(i, 1).cast<long double>();
        t.c = m_surface.corner(i, 2).cast<long double>();
        const Long3 ab = t.b - t.a, ac = t.c - t.a, n = ab.cross(ac);
        t.n = n.normalized();
        t.normalError = 64 * std::numeric_limits<long double>::epsilon() * ab.norm() * ac.norm() / n.norm();
        t.middle = m_surface.box(i).center();
        t.reach_mm = 0.5 * m_surface.box(i).sizes().norm();
        t.isTwoSided = m_surface.isTwoSided(i);
        m_candidates.push_back(t);
    }
}

/// Returns true if a sphere with centre `p` is in front of the triangle, so that the triangle can block it.
bool ExactBall::faces(const Candidate& t, const Long3& p)
{
    const Long3 ap = p - t.a;
    const long double distance = t.n.dot(ap);
    if (t.isTwoSided || std::abs(distance) > t.normalError * ap.lpNorm<1>()) {
        return t.isTwoSided || distance > 0;
    }
    return orientation(t.a, t.b, t.c, p) >= 0;
}

long double ExactBall::firstTouch(const Candidate& t, const Long3& from, const Long3& way, long double kept_mm,
                                  long double limit) const
{
    long double at = 0;
    for (int i = 0; i < kMostSteps && at <= limit; ++i) {
        const Long3 p = from + at * way, away = p - closestPoint<long double>(t.a, t.b, t.c, p);
        const long double distance = away.norm(), growth = away.dot(way);
        if (distance - kept_mm <= 0.5L * kSpare * m_skin_mm) {
            return at;
        }
        if (growth >= 0) {
            return kNever; // the distance only grows from here
        }
        at += (distance - kept_mm) * distance / -growth;
    }
    return at <= limit ? at : kNever;
}

Long3 ExactBall::sweep(const Long3& from, const Long3& to) const
{
    const Long3 way = to - from;
    const Vec3 x = from.cast<double>(), d = way.cast<double>();
    const double d2 = d.squaredNorm(), radius = static_cast<double>(m_radius_mm);
    if (d2 == 0.0) {
        return from;
    }
    const double spare = static_cast<double>(kTouched * m_skin_mm) + 1e-15 * x.cwiseAbs().maxCoeff();
    long double first = 1, stop = 1;
    bool isBlocked = false;
    for (const Candidate& t : m_candidates) {
        const Vec3 w = t.middle - x;
        const double most = radius + t.reach_mm + spare;
        // Beyond the first contact found so far, a triangle no longer matters.
        const double share = std::clamp(w.dot(d) / d2, 0.0, static_cast<double>(first));
        if ((w - share * d).squaredNorm() > most * most || !faces(t, from)) {
            continue;
        }
        const Long3 away = from - closestPoint<long double>(t.a, t.b, t.c, from);
        const long double distance = away.norm();
        if (away.dot(way) >= 0) {
            continue; // the distance from a convex set only grows along this move
        }
        if (distance <= m_radius_mm + m_skin_mm) {
            const long double spareHere = kSpare * m_skin_mm + t.normalError * m_radius_mm;
            if (firstTouch(t, from, way, std::min(m_radius_mm, distance) - spareHere, 1) <= 1) {
                return from;
            }
            continue;
        }
        const long double touch = firstTouch(t, from, way, m_radius_mm, first);
        if (touch <= first) {
            first = touch;
            stop = std::min(stop, firstTouch(t, from, way, m_radius_mm + m_skin_mm, touch));
            isBlocked = true;
        }
    }
    return isBlocked ? Long3(from + stop * way) : to;
}

void ExactBall::findNormals(const Long3& g)
{
    m_normals.clear();
    const Vec3 p = g.cast<double>();
    const long double touching = m_radius_mm + kTouched * m_skin_mm;
    const double spare = static_cast<double>(touching) + 1e-15 * p.cwiseAbs().maxCoeff();
    for (const Candidate& t : m_candidates) {
        const double most = t.reach_mm + spare;
        if ((t.middle - p).squaredNorm() > most * most || !faces(t, g)) {
            continue;
        }
        const Long3 away = g - closestPoint<long double>(t.a, t.b, t.c, g);
        const long double distance = away.norm();
        if (distance <= touching && distance > 0) {
            m_normals.emplace_back(away / distance);
        }
    }
}

/// Repeatedly adds the contact that the current move violates most, and keeps the contacts among the known ones that
/// constrain `wanted` together. Each iteration shortens the move, so no set recurs.
Long3 ExactBall::free(const Long3& wanted)
{
    Long3 way = wanted;
    std::array<Long3, 3> held;
    std::size_t count = 0;
    const long double tolerance = kTangent * wanted.norm();
    for (m_constraints = 0; count < held.size();) {
        const auto worst = std::min_element(m_normals.begin(), m_normals.end(),
                                            [&](const Long3& a, const Long3& b) { return a.dot(way) < b.dot(way); });
        if (worst == m_normals.end() || worst->dot(way) >= -tolerance) {
            return way;
        }
        held[count++] = *worst;
        // Choose the longest move: along the new contact alone, or along the new contact and one of the others.
        const Long3 n = *worst, onPlane = wanted - n.dot(wanted) * n;
        Long3 best = Long3::Zero();
        std::array<std::size_t, 2> kept{count - 1, count - 1};
        std::size_t bestCount = 0;
        const auto offer = [&](const Long3& u, std::size_t other, std::size_t planes) {
            const bool isFree = std::all_of(held.begin(), held.begin() + static_cast<std::ptrdiff_t>(count),
                                            [&](const Long3& m) { return m.dot(u) >= -tolerance; });
            if (isFree && (bestCount == 0 || u.squaredNorm() > best.squaredNorm())) {
                best = u;
                kept[1] = other;
                bestCount = planes;
            }
        };
        offer(onPlane - n.dot(onPlane) * n, count - 1, 1);
        for (std::size_t i = 0; i + 1 < count; ++i) {
            Long3 e = held[i] - n.dot(held[i]) * n;
            e = (e - n.dot(e) * n).normalized();
            Long3 u = onPlane - e.dot(onPlane) * e;
            u -= n.dot(u) * n;
            offer(u - e.dot(u) * e, i, 2);
        }
        m_constraints = static_cast<int>(std::max<std::size_t>(bestCount, 1));
        if (bestCount == 0) {
            m_constraints = 3;
            return Long3::Zero();
        }
        way = best;
        const Long3 other = held[kept[1]];
        held[0] = n;
        held[1] = other;
        count = bestCount;
    }
    m_constraints = 3;
    return Long3::Zero();
}

/// Extrapolates successive moves around an edge or a corner, which shrink geometrically, to the limit of the series.
/// @return factor for the length of `way`, at least 1
long double ExactBall::extrapolatedLength(const Long3& way, const Long3& before) const
{
    const long double length = way.norm(), last = before.norm();
    if (last == 0 || way.dot(before) < kAlike * length * last || length < kSlow * last) {
        return 1;
    }
    const long double most = kLongest * m_radius_mm / length;
    return std::clamp(length < last ? last / (last - length) : most, 1.0L, std::max(1.0L, most));
}

long double ExactBall::advance(Long3& g, const Long3& way, long double share, const Long3& hip) const
{
    const Long3 wanted = hip - g, from = g;
    long double best = 0;
    for (const long double s : {share, 1.0L}) {
        const Long3 reached = sweep(sweep(from, from + s * way), hip);
        const Long3 move = reached - from;
        const long double gain = (2 * wanted - move).dot(move);
        if (gain > best) {
            best = gain;
            g = reached;
        }
        if (share == 1) {
            break;
        }
    }
    return best;
}

/// Detects an unstable equilibrium: when the pull goes straight through an edge or a corner, the sphere may rest on
/// the top although it could roll down on any side, with an initial gain too small to measure. @return true if the
/// sphere was moved
bool ExactBall::leaveUnstableEquilibrium(Long3& g, const Long3& hip) const
{
    const Long3 n = (g - hip).normalized(), across = n.unitOrthogonal(), along = n.cross(across);
    std::vector<Long3> ways{across, -across, along, -along};
    for (std::size_t i = 0; i < std::min(kFewNormals, m_normals.size()); ++i) {
        if (const Long3 crease = n.cross(m_normals[i]); crease.norm() > kLevel) {
            ways.insert(ways.end(), {crease.normalized(), -crease.normalized()});
        }
    }
    const long double least = leastGain(hip - g);
    for (const Long3& way : ways) {
        // Require descent along the whole probe, not beyond a hump: the foot may be within the last tenth of a
        // micrometre of a facet.
        Long3 reached = g;
        const std::array<long double, 3> shares{1.0L / 64, 0.25L, 1.0L};
        const bool isDownhill = std::all_of(shares.begin(), shares.end(), [&](long double share) {
            reached = sweep(sweep(g, g + share * kProbe * m_radius_mm * way), hip);
            const Long3 move = reached - g;
            return (2 * (hip - g) - move).dot(move) > least;
        });
        if (isDownhill) {
            g = reached;
            return true;
        }
    }
    return false;
}

long double ExactBall::leastGain(const Long3& wanted) const
{
    return 2 * wanted.norm() * kLeastGain * m_skin_mm;
}

std::uint32_t ExactBall::converge(Long3& g, const Long3& hip)
{
    // No move ends farther from the HIP than the start, except extrapolated ones, by at most a radius.
    gather(hip.cast<double>(), static_cast<double>((hip - g).norm() + (2 + kLongest) * m_radius_mm) * (1 + 1e-12));
    g = sweep(g, hip);
    Long3 before = Long3::Zero();
    for (std::uint32_t moves = 1; moves < kMostMoves; ++moves) {
        m_constraints = 0;
        if (g == hip) {
            return moves;
        }
        findNormals(g);
        const Long3 way = free(hip - g);
        const long double least = leastGain(hip - g);
        if (advance(g, way, extrapolatedLength(way, before), hip) <= least && !leaveUnstableEquilibrium(g, hip)) {
            return moves;
        }
        before = way;
    }
    return kMostMoves;
}

double ExactBall::clearance_mm(const Vec3& p, double most_mm)
{
    gather(p, most_mm);
    const Long3 centre = p.cast<long double>();
    long double least = most_mm;
    for (const Candidate& t : m_candidates) {
        if ((t.middle - p).norm() <= most_mm + t.reach_mm && faces(t, centre)) {
            least = std::min(least, (centre - closestPoint<long double>(t.a, t.b, t.c, centre)).norm());
        }
    }
    return static_cast<double>(least);
}

} // namespace palpate::evaluation
