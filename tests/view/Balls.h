// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/MeshReport.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace palpate::test {

/// Returns a sphere of 20 * 4^levels triangles about `centre`, normals outwards.
inline geometry::TriangleMesh ball(double radius_mm, int levels, const core::Vec3& centre = core::Vec3::Zero())
{
    const double g = std::numbers::phi;
    geometry::TriangleMesh mesh;
    mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                     {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [place, isNew] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.vertices.size()));
            if (isNew) {
                mesh.vertices.emplace_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
            }
            return place->second;
        };
        std::vector<geometry::Triangle> finer;
        for (const geometry::Triangle& t : mesh.triangles) {
            const std::uint32_t a = middle(t[0], t[1]);
            const std::uint32_t b = middle(t[1], t[2]);
            const std::uint32_t c = middle(t[2], t[0]);
            finer.insert(finer.end(), {{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}});
        }
        mesh.triangles = std::move(finer);
    }
    for (core::Vec3& p : mesh.vertices) {
        p = centre + radius_mm * p.normalized();
    }
    return mesh;
}

/// Returns a cube from -half to +half, normals outwards.
inline geometry::TriangleMesh block(double half_mm)
{
    geometry::TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.emplace_back((i & 1) != 0 ? half_mm : -half_mm, (i & 2) != 0 ? half_mm : -half_mm,
                                   (i & 4) != 0 ? half_mm : -half_mm);
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

} // namespace palpate::test
