// SPDX-License-Identifier: BSD-3-Clause
#include "TissueJudge.h"

#include <algorithm>
#include <limits>

namespace palpate::adversary {

namespace {

constexpr double kUlp = std::numeric_limits<double>::epsilon();

/// Returns the barycentric coordinates of the point of a triangle nearest to p.
/// @par Source
/// Ericson, Real-Time Collision Detection, 2005, section 5.1.5.
Vec3 nearestShares(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
    const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
    if (d1 <= 0.0 && d2 <= 0.0) {
        return Vec3(1, 0, 0);
    }
    if (d3 >= 0.0 && d4 <= d3) {
        return Vec3(0, 1, 0);
    }
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        return Vec3(1.0 - d1 / (d1 - d3), d1 / (d1 - d3), 0);
    }
    if (d6 >= 0.0 && d5 <= d6) {
        return Vec3(0, 0, 1);
    }
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        return Vec3(1.0 - d2 / (d2 - d6), 0, d2 / (d2 - d6));
    }
    if (va <= 0.0 && d4 >= d3 && d5 >= d6) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return Vec3(0, 1.0 - w, w);
    }
    return Vec3(va, vb, vc) / (va + vb + vc);
}

double at(const haptics::TissueMap& map, std::uint32_t triangle, const Vec3& shares)
{
    const std::array<float, 3>& corner = (*map.corners)[triangle];
    return map.factor * (shares[0] * double{corner[0]} + shares[1] * double{corner[1]} + shares[2] * double{corner[2]});
}

/// Returns the cubic correction of a map at barycentric coordinates: control values next to the corners, and a central
/// one chosen for a linear cross-edge slope along each edge, weighted by the distance to the edges.
double bentBy(const haptics::TissueMap& map, std::uint32_t triangle, const Vec3& b, const Vec3& ab, const Vec3& ac)
{
    if (!map.bendsOn(triangle)) {
        return 0.0;
    }
    const std::array<float, 6>& bend = (*map.bends)[triangle];
    const std::array<Vec3, 3> corner{Vec3::Zero(), ab, ac};
    double value = 0.0, middle = 0.0, weights = 0.0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const auto from = [&](int at) { return double{bend[static_cast<std::size_t>(at)]}; };
        const double start = from(2 * i), end = from(2 * i + 1);
        value += 3.0 * b[i] * b[j] * (start * b[i] + end * b[j]);
        const auto c = [&](int at) -> const Vec3& { return corner[static_cast<std::size_t>(at)]; };
        const Vec3 along = c(j) - c(i);
        const double foot = std::clamp((c(j) - c(k)).dot(along) / along.squaredNorm(), -1.0, 2.0);
        // Besides the edge's own two control values, half of the adjacent ones on the other edges.
        const double own =
            (1.5 * foot - 0.5) * start + (1.0 - 1.5 * foot) * end + 0.5 * (from(2 * k + 1) + from(2 * j));
        middle += b[i] * b[j] * own;
        weights += b[i] * b[j];
    }
    return map.factor * (value + (weights > 0.0 ? 6.0 * b[0] * b[1] * b[2] * middle / weights : 0.0));
}

/// Returns the gradient magnitude of a map on a triangle [1/mm in units of the map]: the length of the difference of
/// two edge vectors, each times the rise along the other, over twice the area. Computed in long double, since the area
/// of a sliver is a small difference.
/// @param shares  barycentric coordinates
double slope(const haptics::TissueMap& map, std::uint32_t triangle, const Vec3& shares, const Vec3& ab, const Vec3& ac)
{
    using Long3 = Eigen::Matrix<long double, 3, 1>;
    const std::array<float, 3>& corner = (*map.corners)[triangle];
    const Long3 b = ab.cast<long double>(), c = ac.cast<long double>();
    const auto rise = [&](int i) {
        constexpr double kShare = 1e-6;
        const Vec3 step = 0.5 * kShare * (Vec3::Unit(i) - Vec3::Unit(0));
        const double bent = bentBy(map, triangle, shares + step, ab, ac) - bentBy(map, triangle, shares - step, ab, ac);
        return map.factor * (static_cast<long double>(corner[i]) - corner[0]) + static_cast<long double>(bent) / kShare;
    };
    return static_cast<double>((rise(1) * c - rise(2) * b).norm() / b.cross(c).norm());
}

/// @return relative rounding error of an area in double precision: large for a sliver
double roundingOfArea(const Vec3& ab, const Vec3& ac)
{
    return 16.0 * kUlp * std::max(ab.squaredNorm(), ac.squaredNorm()) / ab.cross(ac).norm();
}

} // namespace

PlaceOnTriangle::PlaceOnTriangle(const geometry::SurfaceIndex& surface, std::uint32_t triangle, const Vec3& p)
    : m_triangle(triangle)
{
    const geometry::Triangle t = surface.triangle(triangle);
    const Vec3 &a = surface.vertex(t[0]), &b = surface.vertex(t[1]), &c = surface.vertex(t[2]);
    m_ab = b - a;
    m_ac = c - a;
    m_shares = nearestShares(p, a, b, c);
}

double PlaceOnTriangle::valueOf(const haptics::TissueMap& map) const
{
    return at(map, m_triangle, m_shares);
}

double PlaceOnTriangle::slopeOf(const haptics::TissueMap& map) const
{
    return slope(map, m_triangle, m_shares, m_ab, m_ac);
}

ForceOfTissue::ForceOfTissue(const haptics::HapticStructure& structure, const haptics::ActiveConstraint& plane,
                             const Vec3& god, const Vec3& hip)
    : m_on(structure)
    , m_spring(god - hip)
    , m_damping(structure.tissue.damping_Ns_per_mm)
{
    const geometry::SurfaceIndex& surface = *structure.surface;
    const geometry::Triangle t = surface.triangle(plane.triangle);
    const Vec3 &a = surface.vertex(t[0]), &b = surface.vertex(t[1]), &c = surface.vertex(t[2]);
    const Vec3 shares = nearestShares(god, a, b, c);
    const haptics::TissueMaps& maps = structure.maps;
    if (!maps.damping.isEmpty()) {
        m_damping = at(maps.damping, plane.triangle, shares);
        m_dampingSlope = slope(maps.damping, plane.triangle, shares, b - a, c - a);
    }
    if (!maps.friction.isEmpty()) {
        m_friction = maps.friction.factor * double{std::ranges::max((*maps.friction.corners)[plane.triangle])};
    }
    if (!maps.stiffness.isEmpty()) {
        m_stiffness =
            at(maps.stiffness, plane.triangle, shares) + bentBy(maps.stiffness, plane.triangle, shares, b - a, c - a);
        m_least = maps.stiffness.factor * double{std::ranges::min((*maps.stiffness.corners)[plane.triangle])};
        m_slope_per_mm = slope(maps.stiffness, plane.triangle, shares, b - a, c - a);
        m_rounding = roundingOfArea(b - a, c - a);
    }
}

bool ForceOfTissue::is(const Vec3& f_W, const Vec3& v_WH) const
{
    const double depth = m_spring.norm();
    const haptics::ForceTable::Value law = m_on.lawAt(depth);
    const Vec3 elastic = depth > 0.0 ? Vec3(m_stiffness * law.force_N / depth * m_spring) : Vec3::Zero();
    const Vec3 viscous = m_damping * v_WH;
    const double beside = m_on.tissue.hasFriction() ? 0.0 : law.energy_mJ * m_slope_per_mm;
    // Without maps the force is a product of a number and a difference; with a map, the value depends on the foot point
    // of a god-object some skins above a triangle, which may be a sliver.
    const double rounding = m_on.maps.isEmpty() ? 16.0 * kUlp : 1e-6;
    const double place =
        128.0 * m_on.surface->skin_mm() * (m_slope_per_mm * law.force_N + m_dampingSlope * v_WH.norm());
    return (f_W - elastic + viscous).norm() <=
           (1.0 + 1e-6 + m_rounding) * beside + place + rounding * (elastic.norm() + viscous.norm());
}

double ForceOfTissue::coefficient(double mu, double lambda_mm) const
{
    const haptics::ForceTable::Value law = m_on.lawAt(lambda_mm);
    const double takesUp = law.force_N > 0.0 ? law.energy_mJ / law.force_N * m_slope_per_mm / m_least : 0.0;
    return std::max(m_friction * mu, takesUp);
}

double outsideCone_mm(const haptics::HapticStructure& structure, const haptics::TickResult& tick, const Vec3& hip)
{
    if (structure.maps.stiffness.bendsOn(tick.active[0].triangle)) {
        return 0.0; // friction depends on the slope at the start of the move
    }
    const haptics::Tissue& tissue = structure.tissue;
    const Vec3 spring = tick.p_WG - hip, n = tick.active[0].n_W;
    const double lambda = std::max(0.0, n.dot(spring));
    const bool isHeld = tick.friction() == haptics::Friction::Holds;
    const ForceOfTissue force(structure, tick.active[0], tick.p_WG, hip);
    const double mu = isHeld ? tissue.friction_static : tissue.friction_dynamic;
    return (spring - n.dot(spring) * n).norm() - (1.0 + 1e-6) * force.coefficient(mu, lambda) * lambda;
}

} // namespace palpate::adversary
