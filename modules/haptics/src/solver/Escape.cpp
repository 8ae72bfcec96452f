// SPDX-License-Identifier: BSD-3-Clause
#include "solver/Escape.h"

#include "solver/VertexRing.h"

#include <algorithm>

namespace palpate::haptics::internal {

namespace {

constexpr double kSameNormal = 1e-12; // rounding of the difference of unit normals

bool isSamePlane(const PointContact& p, const PointContact& q) noexcept
{
    return (p.normal() - q.normal()).squaredNorm() <= kSameNormal * kSameNormal &&
           std::abs(p.gap(q.facet.a)) <= kPlaneTolerance * std::min(p.facet.skin_mm, q.facet.skin_mm);
}

/// Two parallel planes constrain a point no more than one of them.
bool areParallel(const PointContact& p, const PointContact& q) noexcept
{
    return p.facet.n.cross(q.facet.n).squaredNorm() <= kSameNormal * kSameNormal;
}

} // namespace

/// Adds a touched facet and its plane, unless an equal plane was added already: adjacent facets of a voxel wall or of a
/// box face lead in the same direction.
void Escape::add(const PointContact& contact) noexcept
{
    m_largest_mm = std::max(m_largest_mm, contact.facet.skin_mm);
    if (m_count == m_touched.size()) {
        m_isRoom = false;
    } else {
        m_touched[m_count++] = contact.facet;
    }
    const auto isSame = [&contact](const PointContact& plane) { return isSamePlane(plane, contact); };
    if (m_planeCount < m_planes.size() && std::none_of(planes().begin(), planes().end(), isSame)) {
        m_planes[m_planeCount++] = contact;
    }
}

/// Collects the touched facets. Held contacts come first, because paths along them succeed more often.
/// @return true if all touched facets were collected
bool Escape::gather(const PointContacts& held) noexcept
{
    for (const PointContact& contact : held) {
        add(contact);
    }
    return m_near.forEachNear(m_layer, m_god, kMaxQueryRadius * m_layer.skin_mm, [&](const Facet& facet) {
        const PointContact contact{facet, facet.n.dot(m_god - facet.a) < 0.0 && facet.isTwoSided ? -1 : 1};
        const double reach = kTouchRadius * facet.skin_mm; // maximum distance of a foot outside its facet
        if (footingOn(facet, contact.side, m_god, {reach, reach, 0.0}) != Footing::Away &&
            std::none_of(held.begin(), held.end(), [&](const PointContact& c) { return c.isSame(contact); })) {
            add(contact);
        }
    });
}

bool Escape::find(const PointContacts& held, End& end) noexcept
{
    const bool isKnown = gather(held);
    const double skin = std::max(m_skin_mm, m_largest_mm);
    // Within the thickness of the skin, the edge of a facet may block a path that is open beyond. The paths therefore
    // start slightly above the planes, away from the HIP.
    const Vec3 wanted = m_hip - m_god;
    const double spring = wanted.norm();
    m_most_mm = spring - kLeastGain * skin;
    Vec3 from = m_god - wanted * (kTouchRadius * skin / spring);
    if (isKnown && m_isRoom && m_most_mm > 0.0 && isHeldByVertexRing(touched(), from, m_hip - from, m_most_mm)) {
        return false;
    }
    Crossing above;
    const Sweep swept = m_near.sweep(m_layer, m_god, from, above);
    if (swept == Sweep::Unknown) {
        return false;
    }
    if (swept == Sweep::Blocked) {
        from = m_god + above.stop * (from - m_god);
    }
    if (follow(from, {}, end)) {
        return true;
    }
    for (const PointContact& plane : planes()) {
        if (follow(from, std::array{plane}, end)) {
            return true;
        }
    }
    for (std::size_t i = 0; i < m_planeCount; ++i) {
        for (std::size_t j = i + 1; j < m_planeCount; ++j) {
            if (!areParallel(m_planes[i], m_planes[j]) && follow(from, std::array{m_planes[i], m_planes[j]}, end)) {
                return true;
            }
        }
    }
    return false;
}

/// Follows the given subset of the touched planes.
/// @return false if the gain towards the HIP is too small
bool Escape::follow(Vec3 from, std::span<const PointContact> along, End& end) noexcept
{
    std::array<HalfSpace, 2> planes;
    const auto setPlanes = [&] {
        for (std::size_t i = 0; i < along.size(); ++i) {
            planes[i] = along[i].planeFrom(from);
        }
        return std::span<const HalfSpace>(planes).first(along.size());
    };
    const Vec3 pull = m_hip - from;
    if ((pull - constrainedPoint(pull, setPlanes(), allowance(m_skin_mm, pull)).u).norm() > m_most_mm) {
        return false; // most candidates are rejected here, without a sweep
    }
    // First move to a skin above the planes, if that move is free: from there their edges do not block.
    Crossing crossing;
    const Vec3 up = constrainedPoint(Vec3::Zero(), setPlanes(), 0.0).u;
    if (!along.empty() && m_near.sweep(m_layer, from, from + up, crossing) == Sweep::Free) {
        from += up;
    }
    const Vec3 wanted = m_hip - from;
    const ConstrainedPoint point = constrainedPoint(wanted, setPlanes(), allowance(m_skin_mm, wanted));
    if ((wanted - point.u).norm() > m_most_mm) {
        return false;
    }
    Vec3 u = point.u;
    // Most paths are blocked by a touched facet, which is detected without a sweep.
    const auto stands = [&](const Facet& facet) { return blocks(facet, from, from + u, 0.0, crossing); };
    if (std::any_of(touched().begin(), touched().end(), stands)) {
        return false;
    }
    const Sweep swept = m_near.sweep(m_layer, from, from + u, crossing);
    if (swept == Sweep::Unknown) {
        return false;
    }
    end.isBlocked = swept == Sweep::Blocked;
    if (end.isBlocked) {
        u *= crossing.stop;
        if ((wanted - u).norm() > m_most_mm) {
            return false;
        }
        end.next = {crossing.facet, crossing.side};
    }
    end.p = from + u;
    end.along.clear();
    for (int i = 0; i < point.count; ++i) {
        end.along.add() = along[point.active[static_cast<std::size_t>(i)]];
    }
    return true;
}

} // namespace palpate::haptics::internal
