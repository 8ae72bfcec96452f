// SPDX-License-Identifier: BSD-3-Clause
#include "Masks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace palpate::test {

namespace {

using Cell = std::array<int, 3>;

/// Number of voxels along each axis, and which are inside.
class Grid
{
  public:
    explicit Grid(const Mask& mask)
        : m_mask(mask)
    {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            m_reach[k] = static_cast<int>(std::ceil(mask.half_mm[axis] / mask.voxel_mm[axis]));
        }
    }
    int reach(std::size_t axis) const { return m_reach[axis]; }
    Vec3 centre(const Cell& c) const { return m_mask.voxel_mm.cwiseProduct(Vec3(c[0], c[1], c[2])); }
    bool isIn(const Cell& c) const { return m_mask.contains(centre(c)); }

  private:
    const Mask& m_mask;
    std::array<int, 3> m_reach{};
};

/// One vertex for each pair of neighbouring voxels with only one inside.
class Vertices
{
  public:
    Vertices(const Grid& grid, TriangleMesh& mesh)
        : m_grid(grid)
        , m_mesh(mesh)
    {
    }
    std::uint32_t between(Cell a, Cell b)
    {
        if (b < a) {
            std::swap(a, b);
        }
        const auto [found, isNew] = m_numbers.emplace(std::pair(a, b), m_mesh.vertices.size());
        if (isNew) {
            m_mesh.vertices.push_back(0.5 * (m_grid.centre(a) + m_grid.centre(b)));
        }
        return found->second;
    }

  private:
    const Grid& m_grid;
    TriangleMesh& m_mesh;
    std::map<std::pair<Cell, Cell>, std::uint32_t> m_numbers;
};

Cell plus(const Cell& a, const Cell& b)
{
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// Returns the corners of a cube's face, counter-clockwise seen from outside.
/// @param face  axis, plus 3 for the far side
std::array<Cell, 4> cornersOfFace(const Cell& low, std::size_t face)
{
    const std::size_t axis = face % 3, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const bool isFar = face >= 3;
    std::array<Cell, 4> corners{};
    constexpr std::array<std::array<int, 2>, 4> kRound{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t i = 0; i < 4; ++i) {
        Cell offset{};
        offset[axis] = isFar ? 1 : 0;
        offset[u] = kRound[isFar ? i : 3 - i][0];
        offset[v] = kRound[isFar ? i : 3 - i][1];
        corners[i] = plus(low, offset);
    }
    return corners;
}

/// Adds the polygons in one cube: on each face the surface leaves where the outline goes from outside to inside, and
/// returns at the next crossing, so that voxels that share only an edge stay separate.
void addCube(const Grid& grid, const Cell& low, Vertices& vertices, TriangleMesh& mesh)
{
    std::map<std::uint32_t, std::uint32_t> next;
    for (std::size_t face = 0; face < 6; ++face) {
        const std::array<Cell, 4> corners = cornersOfFace(low, face);
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t after = (i + 1) % 4;
            if (grid.isIn(corners[i]) || !grid.isIn(corners[after])) {
                continue; // into the mask here; out again behind the last of the consecutive inside corners
            }
            std::size_t last = after;
            while (grid.isIn(corners[(last + 1) % 4])) {
                last = (last + 1) % 4;
            }
            next[vertices.between(corners[i], corners[after])] =
                vertices.between(corners[last], corners[(last + 1) % 4]);
        }
    }
    while (!next.empty()) {
        std::vector<std::uint32_t> loop;
        for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
            loop.push_back(at->second);
            next.erase(at);
        }
        for (std::size_t i = 2; i < loop.size(); ++i) {
            mesh.triangles.push_back({loop[0], loop[i - 1], loop[i]});
        }
    }
}

template<class Visit>
void forEachCell(const Grid& grid, Visit&& visit)
{
    for (int x = -grid.reach(0); x <= grid.reach(0); ++x) {
        for (int y = -grid.reach(1); y <= grid.reach(1); ++y) {
            for (int z = -grid.reach(2); z <= grid.reach(2); ++z) {
                visit(Cell{x, y, z});
            }
        }
    }
}

} // namespace

TriangleMesh maskSurface(const Mask& mask)
{
    const Grid grid(mask);
    TriangleMesh mesh;
    Vertices vertices(grid, mesh);
    forEachCell(grid, [&](const Cell& low) { addCube(grid, low, vertices, mesh); });
    return mesh;
}

TriangleMesh voxelFaces(const Mask& mask)
{
    const Grid grid(mask);
    TriangleMesh mesh;
    // of corners, which are half a voxel below the voxel centres of the same index
    std::map<Cell, std::uint32_t> numbers;
    forEachCell(grid, [&](const Cell& cell) {
        for (std::size_t face = 0; face < 6 && grid.isIn(cell); ++face) {
            Cell other = cell;
            other[face % 3] += face < 3 ? -1 : 1;
            if (grid.isIn(other)) {
                continue;
            }
            std::array<std::uint32_t, 4> ids{};
            const std::array<Cell, 4> corners = cornersOfFace(cell, face);
            for (std::size_t i = 0; i < 4; ++i) {
                const auto [found, isNew] = numbers.emplace(corners[i], mesh.vertices.size());
                if (isNew) {
                    mesh.vertices.push_back(grid.centre(corners[i]) - 0.5 * mask.voxel_mm);
                }
                ids[i] = found->second;
            }
            mesh.triangles.push_back({ids[0], ids[1], ids[2]});
            mesh.triangles.push_back({ids[0], ids[2], ids[3]});
        }
    });
    return mesh;
}

Vec3 ballCentre_mm(const Vec3& voxel_mm)
{
    return voxel_mm.cwiseProduct(Vec3(0.137, 0.211, 0.083));
}

Mask ballMask(double radius_mm, const Vec3& voxel_mm)
{
    const Vec3 centre_mm = ballCentre_mm(voxel_mm);
    return {voxel_mm, Vec3::Constant(radius_mm) + 2.0 * voxel_mm,
            [=](const Vec3& p) { return (p - centre_mm).norm() < radius_mm; }};
}

} // namespace palpate::test
