// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"

#include <algorithm>
#include <cmath>

namespace palpate::test {

namespace {

using geometry::Triangle;

/// Adds a parallelogram from corner `o` along `u` and `v`, normal u × v, split n × n.
void addPatch(TriangleMesh& mesh, const Vec3& o, const Vec3& u, const Vec3& v, int n)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto row = static_cast<std::uint32_t>(n + 1);
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            mesh.vertices.push_back(o + u * (double(i) / n) + v * (double(j) / n));
        }
    }
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = first + j * row + i;
            mesh.triangles.push_back({a, a + 1, a + row + 1});
            mesh.triangles.push_back({a, a + row + 1, a + row});
        }
    }
}

void addPolygon(TriangleMesh& mesh, const std::vector<Vec3>& corners)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
    for (std::uint32_t i = 2; i < corners.size(); ++i) {
        mesh.triangles.push_back({first, first + i - 1, first + i});
    }
}

} // namespace

TriangleMesh bumpySphere(int n, double radius_mm, double bump)
{
    const double t = (1.0 + std::sqrt(5.0)) / 2.0;
    std::vector<Vec3> corner{{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                             {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
    const std::vector<Triangle> faces{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    TriangleMesh mesh;
    for (const Triangle& face : faces) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        const auto at = [first](int i, int j) { return first + static_cast<std::uint32_t>(i * (i + 1) / 2 + j); };
        for (int i = 0; i <= n; ++i) {
            for (int j = 0; j <= i; ++j) {
                Vec3 p = (corner[face[0]] * (n - i) + corner[face[1]] * (i - j) + corner[face[2]] * j).normalized();
                // Faces compute their shared corners in different orders: rounding makes the results identical.
                p = (p * 1e11).array().round() / 1e11;
                const double scale = 1.0 + bump * std::sin(20 * p.x()) * std::sin(20 * p.y()) * std::sin(20 * p.z());
                mesh.vertices.push_back(radius_mm * scale * p);
            }
        }
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j <= i; ++j) {
                mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
                if (j < i) {
                    mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
                }
            }
        }
    }
    return mesh;
}

TriangleMesh sphere(int n, double radius_mm)
{
    return bumpySphere(n, radius_mm, 0.0);
}

TriangleMesh box(const Vec3& low, const Vec3& high, int n)
{
    const Vec3 d = high - low;
    const Vec3 x = d.x() * Vec3::UnitX(), y = d.y() * Vec3::UnitY(), z = d.z() * Vec3::UnitZ();
    TriangleMesh mesh;
    addPatch(mesh, low, y, x, n);
    addPatch(mesh, low, x, z, n);
    addPatch(mesh, low, z, y, n);
    addPatch(mesh, low + z, x, y, n);
    addPatch(mesh, low + y, z, x, n);
    addPatch(mesh, low + x, y, z, n);
    return mesh;
}

TriangleMesh groove(double openingAngle_rad, double height_mm, double halfLength_mm)
{
    const double w = height_mm * std::tan(openingAngle_rad / 2.0), W = w + height_mm, L = halfLength_mm, B = height_mm;
    TriangleMesh mesh;
    // Walls, tops, sides and the bottom, split along the groove so that no corner is on another's edge.
    const std::vector<std::pair<double, double>> profile{{-W, height_mm}, {-w, height_mm}, {0, 0},  {w, height_mm},
                                                         {W, height_mm},  {W, -B},         {0, -B}, {-W, -B}};
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const auto [x0, z0] = profile[i];
        const auto [x1, z1] = profile[(i + 1) % profile.size()];
        addPatch(mesh, Vec3(x0, -L, z0), Vec3(x1 - x0, 0, z1 - z0), Vec3(0, 2 * L, 0), 1);
    }
    for (const double side : {-1.0, 1.0}) {
        std::vector<Vec3> front{
            {W * side, -L, -B}, {W * side, -L, height_mm}, {w * side, -L, height_mm}, {0, -L, 0}, {0, -L, -B}};
        std::vector<Vec3> back = front;
        for (Vec3& p : back) {
            p.y() = L;
        }
        std::vector<Vec3>& reversed = side > 0 ? front : back;
        std::reverse(reversed.begin() + 1, reversed.end());
        addPolygon(mesh, front);
        addPolygon(mesh, back);
    }
    return mesh;
}

TriangleMesh sheet(double halfSize_mm, int n)
{
    TriangleMesh mesh;
    addPatch(mesh, Vec3(-halfSize_mm, -halfSize_mm, 0), Vec3(2 * halfSize_mm, 0, 0), Vec3(0, 2 * halfSize_mm, 0), n);
    return mesh;
}

void append(TriangleMesh& mesh, const TriangleMesh& other)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const Triangle& t : other.triangles) {
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
}

TriangleMesh soup(const TriangleMesh& mesh)
{
    TriangleMesh result;
    for (const Triangle& t : mesh.triangles) {
        addPolygon(result, {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
    }
    return result;
}

TriangleMesh transformed(const TriangleMesh& mesh, const std::function<Vec3(const Vec3&)>& map)
{
    TriangleMesh result = mesh;
    for (Vec3& v : result.vertices) {
        v = map(v);
    }
    return result;
}

TriangleMesh moved(const TriangleMesh& mesh, const Vec3& by)
{
    return transformed(mesh, [&by](const Vec3& v) { return Vec3(v + by); });
}

std::shared_ptr<const geometry::SurfaceIndex> indexed(const TriangleMesh& mesh)
{
    return std::make_shared<geometry::SurfaceIndex>(
        geometry::SurfaceIndex::build(geometry::repair(mesh, geometry::Facing::AsGiven)));
}

} // namespace palpate::test
