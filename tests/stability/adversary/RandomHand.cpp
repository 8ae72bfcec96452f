// SPDX-License-Identifier: BSD-3-Clause
#include "RandomHand.h"

namespace palpate::adversary {

RandomHand::RandomHand(const RandomScene& scene, bool isExact, std::uint64_t seed)
    : m_scene(scene)
    , m_chance(seed)
    , m_isExact(isExact)
    , m_size_mm(scene.size_mm())
    , m_middle(scene.bounds.center())
    , m_hip(m_middle + 0.7 * m_size_mm * m_chance.direction())
{
}

Vec3 RandomHand::next()
{
    if (m_left-- <= 0) {
        begin();
    }
    Vec3 hip = moved();
    m_hip = hip;
    const bool isStill = m_motion == Motion::Rest || m_motion == Motion::Creep;
    if (!m_isExact && !isStill) {
        hip += 1e-6 * m_size_mm * m_chance.noise();
    }
    return hip;
}

/// Draws a motion, a facet, and the distance, depth and speed.
void RandomHand::begin()
{
    m_motion = static_cast<Motion>(m_chance.below(kMotions));
    m_left = m_chance.whole(20, 300);
    m_tick = 0;
    const TriangleMesh& mesh = m_scene.structures[m_chance.below(m_scene.structures.size())].mesh.mesh;
    const Triangle& t = mesh.triangles[m_chance.below(mesh.triangles.size())];
    const std::size_t first = m_chance.below(3);
    for (std::size_t k = 0; k < 3; ++k) {
        m_facet[k] = mesh.vertices[t[(first + k) % 3]];
    }
    m_normal = (m_facet[1] - m_facet[0]).cross(m_facet[2] - m_facet[0]).normalized();
    m_amount_mm = m_chance.magnitude(1e-4, 0.3) * m_size_mm;
    m_depth_mm = m_chance.is(0.3) ? 0.0 : m_chance.magnitude(1e-9, 0.2) * m_size_mm;
    switch (m_motion) {
    case Motion::WhiteNoise:
        m_place = m_chance.is(0.5) ? m_hip : m_facet[0];
        break;
    case Motion::Strike:
        m_step = m_chance.magnitude(1e-2, 0.5) * m_size_mm *
                 (m_middle + 0.3 * m_size_mm * m_chance.inCube() - m_hip).normalized();
        break;
    case Motion::Slide:
        m_hip = m_facet[0] - m_depth_mm * m_normal;
        m_step = m_chance.magnitude(1e-4, 1e-2) * m_size_mm * m_chance.direction().cross(m_normal);
        break;
    case Motion::Creep:
        m_step = m_chance.magnitude(1e-12, 1e-6) * m_size_mm * m_chance.direction();
        break;
    case Motion::Far:
        m_left = m_chance.whole(1, 3);
        break;
    default:
        break;
    }
}

Vec3 RandomHand::moved()
{
    const double tick = m_tick++;
    const Vec3 edge = m_facet[1] - m_facet[0];
    switch (m_motion) {
    case Motion::WhiteNoise:
        return m_place + m_amount_mm * m_chance.noise();
    case Motion::Walk: {
        const Vec3 hip = m_hip + 0.3 * m_amount_mm * m_chance.noise();
        return (hip - m_middle).norm() > m_size_mm ? Vec3(0.5 * (hip + m_middle)) : hip;
    }
    case Motion::Teleport:
        return m_middle + m_chance.share() * m_size_mm * m_chance.direction();
    case Motion::Strike:
        if ((m_hip - m_middle).norm() > 0.8 * m_size_mm && m_step.dot(m_hip - m_middle) > 0.0) {
            m_step = -m_step;
        }
        return m_hip + m_step;
    case Motion::Slide:
        if ((m_hip - m_middle).norm() > 0.7 * m_size_mm) {
            m_step = -m_step;
        }
        return m_hip + m_step;
    case Motion::OnFeatures:
        return onFeature();
    case Motion::AlongEdge:
        return m_facet[0] + (0.5 - 0.7 * std::cos(0.02 * tick)) * edge - m_depth_mm * m_normal;
    case Motion::ThroughVertex:
        return m_facet[0] + std::sin(0.05 * tick) * m_amount_mm * m_normal;
    case Motion::AroundVertex: {
        const Vec3 u = edge.normalized(), v = m_normal.cross(u);
        return m_facet[0] + m_amount_mm * (std::cos(0.1 * tick) * u + std::sin(0.1 * tick) * v) - m_depth_mm * m_normal;
    }
    case Motion::InPlane:
        return m_facet[0] + 0.1 * m_chance.whole(-20, 30) * edge +
               0.1 * m_chance.whole(-20, 30) * (m_facet[2] - m_facet[0]);
    case Motion::Creep:
        return m_hip + m_step;
    case Motion::Far:
        return m_middle + m_chance.magnitude(10.0, 500.0) * m_size_mm * m_chance.direction();
    case Motion::Rest:
        break;
    }
    return m_hip;
}

/// Returns a vertex, the middle of an edge or facet, or a point on the line of an edge, from a random facet of the
/// scene.
Vec3 RandomHand::onFeature()
{
    const TriangleMesh& mesh = m_scene.structures[m_chance.below(m_scene.structures.size())].mesh.mesh;
    const Triangle& t = mesh.triangles[m_chance.below(mesh.triangles.size())];
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    switch (m_chance.below(4)) {
    case 0:
        return a;
    case 1:
        return 0.5 * (a + b);
    case 2:
        return (a + b + c) / 3.0;
    default:
        return a + m_chance.between(-1.0, 2.0) * (b - a);
    }
}

} // namespace palpate::adversary
