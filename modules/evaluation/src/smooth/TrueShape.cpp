// SPDX-License-Identifier: BSD-3-Clause
#include "smooth/TrueShape.h"

#include "palpate/evaluation/Shapes.h"

#include <cmath>
#include <numbers>

namespace palpate::evaluation {

namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;

/// Grid of `columns` x `rows` squares, closed where its first and last points are to be the same.
template<class Point>
geometry::TriangleMesh grid(int columns, int rows, bool closesRows, Point&& point)
{
    geometry::TriangleMesh mesh;
    const int lines = closesRows ? rows : rows + 1;
    for (int j = 0; j < lines; ++j) {
        for (int i = 0; i < columns; ++i) {
            mesh.vertices.push_back(point(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
        }
    }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>((j % lines) * columns + i % columns); };
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return mesh;
}

} // namespace

SurfacePoint TrueShape::at(double u, double v) const
{
    switch (kind) {
    case Kind::Sphere: {
        const Vec3 n(std::sin(u) * std::cos(v), std::sin(v), std::cos(u) * std::cos(v));
        return {radius_mm * n, n};
    }
    case Kind::Cylinder: {
        const Vec3 n(std::sin(u), 0.0, std::cos(u));
        return {radius_mm * n + radius_mm * v * Vec3::UnitY(), n};
    }
    case Kind::Torus:
        break;
    }
    const double around = v * radius_mm / ring_mm; // the ring lies in the plane of x and y
    const Vec3 out(std::cos(around), std::sin(around), 0.0);
    const Vec3 n = std::sin(u) * out + std::cos(u) * Vec3::UnitZ();
    return {ring_mm * out + radius_mm * n, n};
}

SurfacePoint TrueShape::closest(const Vec3& p_WH) const
{
    Vec3 axis = Vec3::Zero(); // nearest point of the tube's middle
    if (kind == Kind::Cylinder) {
        axis.y() = p_WH.y();
    } else if (kind == Kind::Torus) {
        axis = ring_mm * Vec3(p_WH.x(), p_WH.y(), 0.0).normalized();
    }
    const Vec3 n = (p_WH - axis).normalized();
    return {axis + radius_mm * n, n};
}

std::vector<TrueShape> trueShapes()
{
    TrueShape sphere{TrueShape::Kind::Sphere, "sphere"}, cylinder{TrueShape::Kind::Cylinder, "cylinder"},
        torus{TrueShape::Kind::Torus, "torus"};
    sphere.facets = shapes::bumpySphere(8, sphere.radius_mm, 0.0);
    // The ends are open and out of reach: the paths stay within 10 mm of the middle.
    cylinder.facets = grid(32, 28, false, [&](double i, double j) {
        const double a = kFullTurn * i;
        return Vec3(20.0 * std::sin(a), 100.0 * (j - 0.5), 20.0 * std::cos(a));
    });
    torus.radius_mm = 12.0;
    torus.facets = grid(24, 32, true, [&](double i, double j) {
        const double a = kFullTurn * i, b = kFullTurn * j;
        const Vec3 out(std::cos(b), std::sin(b), 0.0);
        return Vec3(torus.ring_mm * out + torus.radius_mm * (std::sin(a) * out + std::cos(a) * Vec3::UnitZ()));
    });
    return {sphere, cylinder, torus};
}

} // namespace palpate::evaluation
