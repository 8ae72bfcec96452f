// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/internal/BallTick.h"

#include "palpate/haptics/internal/ConstrainedPoint.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace palpate::haptics::internal {

namespace {

constexpr std::uint32_t kPatience = 32;

// How far a step round edges and corners goes by the curvature's word, in radii: round one, where the step is exact, up
// to 60 degrees; between two, as far as the quadratic model holds.
constexpr double kRoundOne = 1.73;
constexpr double kBetweenTwo = 0.25;

// A long step that led away from the HIP is taken back and tried shorter, down to steps as on planes.
constexpr double kShorter = 0.25;
constexpr double kLeastTrust = 1e-3;

constexpr double kAside = 1e-6; // radii that a ball is moved to see whether it rolls

// A ball deeper than this many skins was not pressed there but put there, and is let out rather than pushed.
constexpr double kPressed = 4.0;

/// A direction and its opposite as one: an edge's two triangles go along it in opposite ways, and which of them is met
/// is a matter of rounding.
Vec3 eitherWay(const Vec3& d) noexcept
{
    const double first = d.x() != 0.0 ? d.x() : d.y() != 0.0 ? d.y() : d.z();
    return first < 0.0 ? Vec3(-d) : d;
}

/// The line along which two contacts let the ball go.
struct Crease
{
    Vec3 t = Vec3::Zero();  ///< unit; zero where the contacts are nearly one
    double curvature = 0.0; ///< of 0.5 |HIP - centre|^2 along it, with the contacts kept

    /// @param push  sum of the multipliers times the normals [mm]
    Crease(const BallContact& p, const BallContact& q, const Vec3& push) noexcept
    {
        const Vec3 across = p.n.cross(q.n);
        const double sine2 = across.squaredNorm();
        if (sine2 < 1e-12) {
            return;
        }
        // The Lagrangian's second derivative is 1 less the bends.
        t = across / std::sqrt(sine2);
        const double cosine = p.n.dot(q.n), onP = p.n.dot(push), onQ = q.n.dot(push);
        const auto bend = [this](const BallContact& c, double multiplier) {
            const double edge = c.along.dot(t);
            return c.isCurved ? multiplier / c.distance_mm * (1.0 - edge * edge) : 0.0;
        };
        curvature = 1.0 - bend(p, (onP - cosine * onQ) / sine2) - bend(q, (onQ - cosine * onP) / sine2);
    }
};

} // namespace

void BallContact::lookFrom(const Vec3& g) noexcept
{
    const Nearest nearest = nearestOn(facet, g);
    isCurved = nearest.isCurved;
    along = nearest.along;
    contact = nearest.q;
    if (isCurved) {
        const Vec3 away = g - nearest.q;
        distance_mm = away.norm();
        n = distance_mm > 0.0 ? Vec3(away / distance_mm) : Vec3(side * facet.n);
    } else {
        n = side * facet.n;
        distance_mm = n.dot(g - facet.a);
    }
}

void BallTick::touch(const Facet& facet, int side) noexcept
{
    BallContact& contact = m_contacts[static_cast<std::size_t>(m_count++)];
    contact.facet = facet;
    contact.side = side;
    contact.lookFrom(m_god);
    m_skin_mm = std::max(m_skin_mm, facet.skin_mm);
}

void BallTick::dropParted() noexcept
{
    const double radius = m_scene.fingertip_mm();
    const auto end = std::remove_if(m_contacts.begin(), m_contacts.begin() + m_count, [&](BallContact& c) {
        c.lookFrom(m_god);
        return c.distance_mm > radius + 3.0 * c.facet.skin_mm;
    });
    m_count = static_cast<int>(end - m_contacts.begin());
}

Vec3 BallTick::nextMove() noexcept
{
    const Vec3 wanted = m_hip - m_god;
    if (m_count == 0) {
        return wanted;
    }
    const double radius = m_scene.fingertip_mm();
    std::array<HalfSpace, kMost> planes;
    for (std::size_t i = 0; i < static_cast<std::size_t>(m_count); ++i) {
        const BallContact& c = m_contacts[i];
        const double missing = radius + c.facet.skin_mm - c.distance_mm;
        planes[i] = {c.n, missing <= kPressed * c.facet.skin_mm ? missing : 0.0};
    }
    const double allowance = std::max(1e-3 * m_skin_mm, 8.0 * std::numeric_limits<double>::epsilon() * wanted.norm());
    const ConstrainedPoint point =
        constrainedPoint(wanted, std::span(planes).first(static_cast<std::size_t>(m_count)), allowance);
    for (int i = 0; i < point.count; ++i) {
        const std::size_t kept = point.active[static_cast<std::size_t>(i)];
        if (kept != static_cast<std::size_t>(i)) {
            m_contacts[static_cast<std::size_t>(i)] = m_contacts[kept];
        }
    }
    m_count = point.count;
    return rolled(point.u, wanted);
}

/// Lengthens a step that goes round edges and corners: their planes turn with the ball, by the multiplier over the
/// radius.
Vec3 BallTick::rolled(const Vec3& u, const Vec3& wanted) noexcept
{
    // Only round what it has gone round before: on a fine mesh the ball has left an edge after the first plain step.
    Vec3 around = Vec3::Zero();
    for (std::size_t i = 0; i < static_cast<std::size_t>(m_count); ++i) {
        const BallContact& c = m_contacts[i];
        around += !c.isCurved ? c.n : c.along.isZero(0.0) ? c.contact : eitherWay(c.along);
    }
    Vec3& last = m_rolledAround[m_count == 2 ? 1 : 0];
    const bool isAgain = around == last && m_trust >= kLeastTrust;
    last = around;
    if (!isAgain) {
        return u;
    }
    const Vec3 push = u - wanted; // sum of the multipliers times the normals
    Vec3 bent = Vec3::Zero();     // the part of u that goes round
    double whole = 0.0;           // its length when it goes all the way
    if (m_count == 1 && m_contacts[0].isCurved) {
        const BallContact& c = m_contacts[0];
        bent = u - c.n.dot(u) * c.n;
        bent -= c.along.dot(bent) * c.along;
        // To where the pull goes straight through the edge or the corner: from there the ball comes down in place.
        const double above = c.distance_mm + c.n.dot(wanted);
        const double step = bent.norm(), most = kRoundOne * c.distance_mm;
        whole = std::min(c.distance_mm * step < most * above ? c.distance_mm * step / above : most,
                         std::max(step, m_trust * most));
    } else if (m_count == 2 && (m_contacts[0].isCurved || m_contacts[1].isCurved)) {
        const BallContact &p = m_contacts[0], &q = m_contacts[1];
        const Crease crease(p, q, push);
        if (crease.t.isZero(0.0)) {
            return u;
        }
        const double h = crease.curvature; // Newton's step
        bent = crease.t.dot(u) * crease.t;
        const double step = bent.norm(), most = kBetweenTwo * std::min(p.distance_mm, q.distance_mm);
        whole = std::min(step < most * h ? step / h : most, std::max(step, m_trust * most));
    }
    const double step = bent.norm();
    if (step == 0.0 || whole <= step) {
        return u;
    }
    m_before = {m_god, m_contacts, m_count, wanted.norm()};
    m_isTrying = true;
    return u + (whole / step - 1.0) * bent;
}

/// Which way the ball would roll off what it stands on, where the pull goes straight through an edge or a corner and
/// out beyond it; zero where it can't.
Vec3 BallTick::slope() const noexcept
{
    const BallContact &p = m_contacts[0], &q = m_contacts[1];
    if (m_count == 1 && p.isCurved && p.distance_mm + p.n.dot(m_hip - m_god) < 0.0) {
        return p.along.isZero(0.0) ? p.n.unitOrthogonal() : Vec3(p.along.cross(p.n));
    }
    if (m_count == 2 && (p.isCurved || q.isCurved)) {
        const Crease crease(p, q, m_god - m_hip);
        return crease.curvature > 0.0 ? Vec3::Zero() : crease.t; // a valley holds it
    }
    return Vec3::Zero();
}

/// Moves a ball at rest aside, to one side and then to the other, by so little that it only tells whether it would
/// roll.
/// @return true when there is a side to try; where none led closer it stands where it stood
bool BallTick::topples() noexcept
{
    const double spring = (m_hip - m_god).norm();
    if (m_nudges == 0 || spring < m_stood.spring_mm - m_skin_mm) {
        m_nudges = 0;
        m_aside = slope();
        m_stood = {m_god, m_contacts, m_count, spring};
    } else {
        m_god = m_stood.god;
        m_contacts = m_stood.contacts;
        m_count = m_stood.count;
    }
    while (m_nudges < 2 && !m_aside.isZero(0.0)) {
        const Vec3 target = m_god + (m_nudges++ == 0 ? kAside : -kAside) * m_scene.fingertip_mm() * m_aside;
        BallCrossing crossing;
        if (!m_near.sweep(m_scene, m_layer, m_god, target, crossing)) {
            m_god = target;
            dropParted();
            return true;
        }
    }
    return false;
}

std::uint32_t BallTick::converge(std::uint32_t limit) noexcept
{
    double spring = std::numeric_limits<double>::infinity();
    dropParted();
    for (std::uint32_t i = 0; i < limit; ++i) {
        if (i % kPatience == kPatience - 1) {
            const double last = std::exchange(spring, (m_hip - m_god).norm());
            if (spring > last - m_skin_mm) {
                if (m_trust < kLeastTrust && m_count > 0) {
                    return i + 1;
                }
                m_trust = 0.0; // where long steps take turns, short ones arrive
            }
        }
        if (m_isTrying && m_count > 0) {
            m_isTrying = false;
            if ((m_hip - m_god).norm() > m_before.spring_mm + m_skin_mm) {
                m_god = m_before.god;
                m_contacts = m_before.contacts;
                m_count = m_before.count;
                m_trust *= kShorter;
            }
        }
        const Vec3 u = nextMove();
        const double step = u.cwiseAbs().maxCoeff();
        if (m_count > 0 && step <= 1e-3 * m_skin_mm) {
            if (topples()) {
                continue;
            }
            return i + 1;
        }
        BallCrossing crossing;
        if (!m_near.sweep(m_scene, m_layer, m_god, m_god + u, crossing)) {
            const int before = m_count;
            const bool isFlat = std::none_of(m_contacts.begin(), m_contacts.begin() + m_count,
                                             [](const BallContact& c) { return c.isCurved; });
            m_god += u;
            dropParted();
            const bool isStillFlat = std::none_of(m_contacts.begin(), m_contacts.begin() + m_count,
                                                  [](const BallContact& c) { return c.isCurved; });
            if (m_count == before && isFlat && isStillFlat && !topples()) {
                return i + 1;
            }
            continue;
        }
        m_skin_mm = std::max(m_skin_mm, crossing.facet.skin_mm);
        const bool hasMoved = crossing.stop * step > 1e-3 * m_skin_mm;
        if (hasMoved) {
            m_god += crossing.stop * u;
            dropParted();
        }
        const bool isHeld = std::any_of(m_contacts.begin(), m_contacts.begin() + m_count, [&](const BallContact& c) {
            return c.facet.structure == crossing.facet.structure && c.facet.triangle == crossing.facet.triangle;
        });
        if (isHeld) {
            if (!hasMoved) {
                return i + 1;
            }
            continue;
        }
        if (m_count == static_cast<int>(kMost)) {
            std::move(m_contacts.begin() + 1, m_contacts.end(), m_contacts.begin());
            --m_count;
        }
        touch(crossing.facet, crossing.side);
    }
    return limit;
}

} // namespace palpate::haptics::internal
