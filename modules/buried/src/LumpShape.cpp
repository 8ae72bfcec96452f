// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/buried/LumpShape.h"

#include "Decimated.h"
#include "palpate/buried/Stiffening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace palpate::buried {

namespace {

constexpr double kPi = std::numbers::pi;

struct Solid
{
    double volume_mm3 = 0.0;
    Vec3 centroid = Vec3::Zero();
};

/// @param from  reference point near the solid, for precision
Solid solidOf(const std::vector<Vec3>& vertices, const std::vector<geometry::Triangle>& triangles, const Vec3& from)
{
    double six = 0.0;
    Vec3 moment = Vec3::Zero();
    for (const geometry::Triangle& t : triangles) {
        const Vec3 a = vertices[t[0]] - from, b = vertices[t[1]] - from, c = vertices[t[2]] - from;
        const double part = a.dot(b.cross(c));
        six += part;
        moment += part * (a + b + c);
    }
    return {six / 6.0, six != 0.0 ? Vec3(from + moment / (4.0 * six)) : from};
}

/// Integrates the energy density over the enclosed volume as a surface integral over triangles.
class PressSum
{
  public:
    /// @param middle  centre of the pressure distribution [mm]
    /// @param inward  unit length
    /// @param c  `pressureScale` the contact radius
    PressSum(const Vec3& middle, const Vec3& inward, double c)
        : m_middle(middle)
        , m_inward(inward)
        , m_c(c)
    {
    }

    /// Flux through a small surface element at p: the density integrated from p outwards, weighted by the solid angle
    /// of the element.
    [[nodiscard]] double through(const Vec3& p, const Vec3& area) const
    {
        const Vec3 x = p - m_middle;
        const double R2 = x.squaredNorm(), h = m_inward.dot(x);
        if (h <= 0.0) {
            return 0.0; // above the surface, as is the rest of the ray
        }
        const double integral = h < m_c ? h * h * h / 3.0 : m_c * (h * h - m_c * h + m_c * m_c / 3.0);
        return 6.0 / kPi * integral * x.dot(area) / (R2 * R2 * R2);
    }

    /// Flux through a triangle with a rule of degree two; the triangle is split into four if wide relative to its
    /// distance.
    [[nodiscard]] double through(const Vec3& a, const Vec3& b, const Vec3& c, int splits = 0) const
    {
        const Vec3 centroid = (a + b + c) / 3.0;
        const double width2 = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
        if (width2 > kWidest * (centroid - m_middle).squaredNorm() && splits < kMostSplits) {
            const Vec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
            return through(a, ab, ca, splits + 1) + through(ab, b, bc, splits + 1) + through(ca, bc, c, splits + 1) +
                   through(ab, bc, ca, splits + 1);
        }
        const Vec3 area = 0.5 * (b - a).cross(c - a);
        return kCentroid * through(centroid, area) + kCorner * (through(a, area) + through(b, area) + through(c, area));
    }

    static constexpr double kCentroid = 0.75, kCorner = 1.0 / 12.0; ///< weights of a quadrature rule of degree two
    /// Limit of (width / distance)^2 of a triangle; the resulting error of the share is about 1e-4.
    static constexpr double kWidest = 0.06;

  private:
    static constexpr int kMostSplits = 10;

    Vec3 m_middle, m_inward;
    double m_c;
};

/// @return solid angle of a triangle, positive if its front faces away.
double solidAngle(const Vec3& a, const Vec3& b, const Vec3& c)
{
    const double A = a.norm(), B = b.norm(), C = c.norm();
    return 2.0 * std::atan2(a.dot(b.cross(c)), A * B * C + a.dot(b) * C + b.dot(c) * A + c.dot(a) * B);
}

} // namespace

LumpShape::LumpShape(const geometry::RepairedMesh& surface, std::size_t most)
    : m_vertices(surface.mesh.vertices)
    , m_triangles(surface.mesh.triangles)
    , m_middle(surface.mesh.bounds().center())
{
    const Solid whole = solidOf(m_vertices, m_triangles, m_middle);
    m_volume_mm3 = whole.volume_mm3;
    if (most > 0 && m_triangles.size() > most) {
        geometry::TriangleMesh coarse = decimated(surface.mesh, most);
        const Solid left = solidOf(coarse.vertices, coarse.triangles, m_middle);
        if (left.volume_mm3 > 0.5 * whole.volume_mm3) { // otherwise too thin for decimation
            const double by = std::cbrt(whole.volume_mm3 / left.volume_mm3);
            for (Vec3& v : coarse.vertices) {
                v = whole.centroid + by * (v - left.centroid);
            }
            m_vertices = std::move(coarse.vertices);
            m_triangles = std::move(coarse.triangles);
        }
    }
    for (const Vec3& v : m_vertices) {
        m_reach_mm = std::max(m_reach_mm, (v - m_middle).norm());
    }
    m_vertexAreas.assign(m_vertices.size(), Vec3::Zero());
    for (const geometry::Triangle& t : m_triangles) {
        const Vec3 &a = m_vertices[t[0]], &b = m_vertices[t[1]], &c = m_vertices[t[2]];
        m_faces.push_back({(a + b + c) / 3.0, 0.5 * (b - a).cross(c - a)});
        for (const std::uint32_t corner : t) {
            m_vertexAreas[corner] += m_faces.back().area;
        }
        m_widest2_mm2 = std::max({m_widest2_mm2, (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    }
    if (most > kCoarseTriangles && m_triangles.size() > 2 * kCoarseTriangles) {
        m_fromAfar = std::make_shared<const LumpShape>(surface, kCoarseTriangles);
    }
}

bool LumpShape::isFar(const ContactPlace& place, double deepest_mm) const
{
    const double c = pressureScale(place.radius_mm);
    // w <= (6 c / pi) / R^4, and a press reduces the distance to the lump by at most its depth.
    const double nearest = (m_middle - place.p_W).norm() - m_reach_mm - c - deepest_mm;
    return nearest > 0.0 && m_volume_mm3 * 6.0 * c / kPi < kLeastShare * nearest * nearest * nearest * nearest;
}

bool LumpShape::isAround(const Vec3& p_W) const
{
    if (distanceLowerBound(p_W) >= 0.0) {
        return false;
    }
    double angle = 0.0;
    for (const geometry::Triangle& t : m_triangles) {
        angle += solidAngle(m_vertices[t[0]] - p_W, m_vertices[t[1]] - p_W, m_vertices[t[2]] - p_W);
    }
    return angle > 2.0 * kPi;
}

void LumpShape::shares(const ContactPlace& place, std::span<const double> presses_mm, std::span<double> shares) const
{
    std::fill(shares.begin(), shares.end(), 0.0);
    if (m_triangles.empty() || presses_mm.empty() || isFar(place, presses_mm.back())) {
        return;
    }
    if (m_fromAfar != nullptr && distanceLowerBound(place.p_W) - presses_mm.back() > kCoarseDistance * m_reach_mm) {
        m_fromAfar->shares(place, presses_mm, shares);
        return;
    }
    const double c = pressureScale(place.radius_mm);
    const Vec3 inward = -place.n_W, middle = place.p_W + c * place.n_W;
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& v : m_vertices) {
        least = std::min(least, inward.dot(v - place.p_W));
    }
    for (std::size_t press = 0; press < presses_mm.size(); ++press) {
        const Vec3 from = middle + approach(least, presses_mm[press], place.radius_mm) * inward;
        const PressSum sum(from, inward, c);
        const double away = distanceLowerBound(from);
        double out = 0.0;
        if (away > 0.0 && m_widest2_mm2 <= PressSum::kWidest * away * away) {
            for (std::size_t i = 0; i < m_vertices.size(); ++i) {
                out += PressSum::kCorner * sum.through(m_vertices[i], m_vertexAreas[i]);
            }
            for (const Face& face : m_faces) {
                out += PressSum::kCentroid * sum.through(face.centroid, face.area);
            }
        } else {
            for (const geometry::Triangle& t : m_triangles) {
                out += sum.through(m_vertices[t[0]], m_vertices[t[1]], m_vertices[t[2]]);
            }
        }
        // Rays that start inside the lump enter at their origin, with the complete integral of the density ahead.
        shares[press] = (isAround(from) ? 1.0 : 0.0) - out;
    }
}

} // namespace palpate::buried
