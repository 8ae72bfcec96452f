// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/TissueMap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace palpate::haptics {

namespace {

using core::Vec3;
using geometry::SurfaceIndex;
using Corners = std::vector<std::array<float, 3>>;

constexpr double kSharp = 0.766; // cosine of 40 degrees: sharper edges are not smoothed
constexpr int kMostAround = 64;  // maximum number of triangles visited around a vertex
constexpr double kSlight = 1e-6; // relative to the value: single-precision rounding, not a bend
// Tolerance on the range of a control value, relative to the range of the surrounding values.
constexpr double kBeyond = 1e-6;

/// Plane and gradient of a triangle.
struct Flat
{
    Vec3 normal;   ///< with twice the area as length [mm^2]
    Vec3 gradient; ///< of the values at its corners

    Flat(const SurfaceIndex& surface, const Corners& corners, std::uint32_t triangle)
    {
        const geometry::Triangle t = surface.triangle(triangle);
        const Vec3 e1 = surface.vertex(t[1]) - surface.vertex(t[0]), e2 = surface.vertex(t[2]) - surface.vertex(t[0]);
        const std::array<float, 3>& at = corners[triangle];
        normal = e1.cross(e2);
        gradient =
            ((double{at[1]} - double{at[0]}) * e2.cross(normal) + (double{at[2]} - double{at[0]}) * normal.cross(e1)) /
            normal.squaredNorm();
    }
};

using Flats = std::vector<Flat>;

/// The triangles around a corner over which the map is smooth, and the gradient at the corner.
class AroundCorner
{
  public:
    AroundCorner(const SurfaceIndex& surface, const Flats& flats, const Corners& corners, std::uint32_t triangle,
                 std::size_t corner)
        : m_surface(surface)
        , m_flats(flats)
        , m_corners(corners)
        , m_vertex(surface.triangle(triangle)[corner])
        , m_value(corners[triangle][corner])
    {
        m_normal = flats[triangle].normal;
        take(triangle);
        if (!goAround(triangle, corner)) {
            (void)goAround(triangle, (corner + 2) % 3);
        }
    }

    [[nodiscard]] Vec3 gradient() const
    {
        const Vec3 mean = m_sum / m_area;
        const Vec3 along = mean - mean.dot(m_normal) / m_normal.squaredNorm() * m_normal;
        double most = 1.0;
        const double beyond = kBeyond * (m_highest - m_lowest);
        for (int i = 0; i < m_count; ++i) {
            for (const std::uint32_t v : m_surface.triangle(m_triangles[static_cast<std::size_t>(i)])) {
                const double rise = along.dot(m_surface.vertex(v) - m_surface.vertex(m_vertex)) / 3.0;
                const double room = (rise > 0.0 ? m_highest - m_value : m_value - m_lowest) + beyond;
                most = std::abs(rise) > room ? std::min(most, room / std::abs(rise)) : most;
            }
        }
        return most * along;
    }

  private:
    void take(std::uint32_t triangle)
    {
        const double area = m_flats[triangle].normal.norm();
        m_sum += area * m_flats[triangle].gradient;
        m_area += area;
        for (const float value : m_corners[triangle]) {
            m_lowest = std::min(m_lowest, double{value});
            m_highest = std::max(m_highest, double{value});
        }
        m_triangles[static_cast<std::size_t>(m_count++)] = triangle;
    }

    /// Visits the triangles around the corner.
    /// @param edge  edge of the corner over which to leave the first triangle
    /// @return true if the traversal closed the ring
    bool goAround(std::uint32_t from, std::size_t edge)
    {
        std::uint32_t triangle = from;
        while (m_count < kMostAround) {
            const SurfaceIndex::Neighbour next = m_surface.neighbour(triangle, static_cast<std::uint32_t>(edge));
            if (next.triangle == SurfaceIndex::kNoNeighbour || next.triangle == from) {
                return next.triangle == from;
            }
            const geometry::Triangle& t = m_surface.triangle(next.triangle);
            const auto corner = static_cast<std::size_t>(std::find(t.begin(), t.end(), m_vertex) - t.begin());
            const Vec3 &before = m_flats[triangle].normal, &normal = m_flats[next.triangle].normal;
            if (corner == t.size() || m_corners[next.triangle][corner] != m_value ||
                std::abs(normal.dot(before)) < kSharp * normal.norm() * before.norm()) {
                return false;
            }
            take(next.triangle);
            m_normal += normal.dot(m_normal) < 0.0 ? Vec3(-normal) : normal;
            triangle = next.triangle;
            edge = next.edge == corner ? (corner + 2) % 3 : corner;
        }
        return false;
    }

    const SurfaceIndex& m_surface;
    const Flats& m_flats;
    const Corners& m_corners;
    std::uint32_t m_vertex;
    float m_value;
    Vec3 m_normal; ///< sum of the triangle normals, weighted by twice the area [mm^2]
    Vec3 m_sum = Vec3::Zero();
    double m_area = 0.0, m_lowest = m_value, m_highest = m_value;
    std::array<std::uint32_t, kMostAround> m_triangles{};
    int m_count = 0;
};

} // namespace

TissueMap TissueMap::withBends(const geometry::SurfaceIndex& surface) const
{
    auto edges = std::make_shared<std::vector<std::array<float, 6>>>(surface.triangleCount());
    Flats flats;
    flats.reserve(surface.triangleCount());
    for (std::uint32_t t = 0; t < surface.triangleCount(); ++t) {
        flats.emplace_back(surface, *corners, t);
    }
    bool isBent = false;
    for (std::uint32_t t = 0; t < surface.triangleCount(); ++t) {
        const geometry::Triangle triangle = surface.triangle(t);
        for (std::size_t i = 0; i < triangle.size(); ++i) {
            const Vec3 gradient = AroundCorner(surface, flats, *corners, t, i).gradient();
            const double value = (*corners)[t][i];
            const auto bend = [&](std::size_t to) {
                const Vec3 along = surface.vertex(triangle[to]) - surface.vertex(triangle[i]);
                const double above = (gradient.dot(along) - (double{(*corners)[t][to]} - value)) / 3.0;
                const bool isSlight = std::abs(above) <= kSlight * std::abs(value);
                isBent = isBent || !isSlight;
                return isSlight ? 0.0F : static_cast<float>(above);
            };
            (*edges)[t][2 * i] = bend((i + 1) % 3);
            (*edges)[t][2 * ((i + 2) % 3) + 1] = bend((i + 2) % 3);
        }
    }
    if (!isBent) {
        edges->clear();
    }
    TissueMap bent = *this;
    bent.bends = std::move(edges);
    return bent;
}

} // namespace palpate::haptics
