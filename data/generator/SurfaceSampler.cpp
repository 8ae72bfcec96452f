// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceSampler.h"

#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataConnectivityFilter.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace palpate::phantom {

namespace {

using geometry::Triangle;
using geometry::TriangleMesh;

TriangleMesh contour(const Distance& distance, const core::Box& box, double cell_mm)
{
    const Vec3 size = box.sizes();
    int n[3];
    for (int axis = 0; axis < 3; ++axis) {
        n[axis] = static_cast<int>(std::ceil(size[axis] / cell_mm)) + 1;
    }
    vtkNew<vtkImageData> image;
    image->SetDimensions(n);
    image->SetOrigin(box.min().data());
    image->SetSpacing(cell_mm, cell_mm, cell_mm);
    image->AllocateScalars(VTK_DOUBLE, 1);
    auto* value = static_cast<double*>(image->GetScalarPointer());
    for (int k = 0; k < n[2]; ++k) {
        for (int j = 0; j < n[1]; ++j) {
            for (int i = 0; i < n[0]; ++i) {
                *value++ = distance(box.min() + cell_mm * Vec3(i, j, k));
            }
        }
    }
    vtkNew<vtkFlyingEdges3D> edges;
    edges->SetInputData(image);
    edges->SetValue(0, 0.0);
    edges->ComputeNormalsOff();
    edges->ComputeGradientsOff();
    edges->ComputeScalarsOff();
    vtkNew<vtkPolyDataConnectivityFilter> largest; // drops cavities enclosed by vessels
    largest->SetInputConnection(edges->GetOutputPort());
    largest->SetExtractionModeToLargestRegion();
    largest->Update();
    vtkPolyData* surface = largest->GetOutput();

    TriangleMesh mesh;
    mesh.vertices.resize(static_cast<std::size_t>(surface->GetNumberOfPoints()));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        surface->GetPoint(static_cast<vtkIdType>(i), mesh.vertices[i].data());
    }
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell) {
        surface->GetCellPoints(cell, count, ids);
        // Orientation reversed: the filter treats values above the contour as inside.
        mesh.triangles.push_back({static_cast<std::uint32_t>(ids[0]), static_cast<std::uint32_t>(ids[2]),
                                  static_cast<std::uint32_t>(ids[1])});
    }
    return mesh;
}

std::uint64_t edgeKey(std::uint32_t a, std::uint32_t b)
{
    return (std::uint64_t(std::min(a, b)) << 32) | std::max(a, b);
}

/// Collapses mesh edges to their midpoints.
class EdgeCollapse
{
  public:
    explicit EdgeCollapse(TriangleMesh& mesh)
        : m_mesh(mesh)
        , m_around(mesh.vertices.size())
        , m_gone(mesh.triangles.size(), false)
    {
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            for (const std::uint32_t v : mesh.triangles[t]) {
                m_around[v].push_back(t);
            }
        }
    }

    [[nodiscard]] bool isGone(std::uint32_t triangle) const { return m_gone[triangle]; }

    /// Collapses edge a b unless the surface would fold or a vertex would get too many neighbours.
    void collapse(std::uint32_t a, std::uint32_t b)
    {
        const std::vector<std::uint32_t> left = neighbours(a), right = neighbours(b);
        std::vector<std::uint32_t> both;
        std::set_intersection(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(both));
        const Vec3 middle = 0.5 * (m_mesh.vertices[a] + m_mesh.vertices[b]);
        if (both.size() != 2 || left.size() + right.size() > 14 || folds(a, b, middle)) {
            return;
        }
        m_mesh.vertices[a] = middle;
        for (const std::uint32_t t : m_around[b]) {
            Triangle& triangle = m_mesh.triangles[t];
            if (has(triangle, a)) {
                m_gone[t] = true;
            } else {
                std::replace(triangle.begin(), triangle.end(), b, a);
                m_around[a].push_back(t);
            }
        }
        m_around[b].clear();
        for (const std::uint32_t v : {a, both[0], both[1]}) {
            std::erase_if(m_around[v], [&](std::uint32_t t) { return m_gone[t]; });
        }
    }

    /// Returns the mesh without collapsed triangles.
    [[nodiscard]] TriangleMesh kept() const
    {
        TriangleMesh kept;
        std::vector<std::uint32_t> number(m_mesh.vertices.size(), ~0u);
        for (std::uint32_t t = 0; t < m_mesh.triangles.size(); ++t) {
            if (m_gone[t]) {
                continue;
            }
            Triangle triangle = m_mesh.triangles[t];
            for (std::uint32_t& v : triangle) {
                if (number[v] == ~0u) {
                    number[v] = static_cast<std::uint32_t>(kept.vertices.size());
                    kept.vertices.push_back(m_mesh.vertices[v]);
                }
                v = number[v];
            }
            kept.triangles.push_back(triangle);
        }
        return kept;
    }

  private:
    static bool has(const Triangle& t, std::uint32_t v) { return std::count(t.begin(), t.end(), v) > 0; }

    [[nodiscard]] std::vector<std::uint32_t> neighbours(std::uint32_t v) const
    {
        std::vector<std::uint32_t> found;
        for (const std::uint32_t t : m_around[v]) {
            for (const std::uint32_t w : m_mesh.triangles[t]) {
                if (w != v) {
                    found.push_back(w);
                }
            }
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

    [[nodiscard]] Vec3 normal(const Triangle& t, std::uint32_t moved, const Vec3& p) const
    {
        const auto at = [&](std::uint32_t v) { return v == moved ? p : m_mesh.vertices[v]; };
        return Vec3((at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])));
    }

    [[nodiscard]] bool folds(std::uint32_t a, std::uint32_t b, const Vec3& middle) const
    {
        for (const std::uint32_t v : {a, b}) {
            for (const std::uint32_t t : m_around[v]) {
                const Triangle& triangle = m_mesh.triangles[t];
                const Vec3 before = normal(triangle, v, m_mesh.vertices[v]).normalized();
                const Vec3 after = normal(triangle, v, middle).normalized();
                if (!(has(triangle, a) && has(triangle, b)) && before.dot(after) < 0.7) {
                    return true;
                }
            }
        }
        return false;
    }

    TriangleMesh& m_mesh;
    std::vector<std::vector<std::uint32_t>> m_around; ///< triangles at each vertex
    std::vector<bool> m_gone;
};

/// Removes slivers: collapses each edge shorter than `shortest` unless the surface would fold.
void collapseShortEdges(TriangleMesh& mesh, double shortest)
{
    EdgeCollapse edges(mesh);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int side = 0; side < 3 && !edges.isGone(t); ++side) {
            const std::uint32_t a = mesh.triangles[t][side];
            const std::uint32_t b = mesh.triangles[t][(side + 1) % 3];
            if ((mesh.vertices[a] - mesh.vertices[b]).norm() < shortest) {
                edges.collapse(a, b);
            }
        }
    }
    mesh = edges.kept();
}

/// Flips edges to bring the valence of vertices close to six, which makes triangles more equilateral.
void balanceValence(TriangleMesh& mesh)
{
    std::vector<int> valence(mesh.vertices.size(), 0);
    std::unordered_map<std::uint64_t, std::array<std::uint32_t, 2>> sides;
    sides.reserve(mesh.triangles.size() * 2);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = mesh.triangles[t][i];
            const std::uint32_t b = mesh.triangles[t][(i + 1) % 3];
            const auto [found, isNew] = sides.try_emplace(edgeKey(a, b), std::array<std::uint32_t, 2>{t, t});
            if (!isNew) {
                found->second[1] = t;
            }
            ++valence[a];
        }
    }
    const auto replaceSide = [&](std::uint32_t a, std::uint32_t b, std::uint32_t from, std::uint32_t to) {
        std::array<std::uint32_t, 2>& pair = sides.at(edgeKey(a, b));
        (pair[0] == from ? pair[0] : pair[1]) = to;
    };
    const auto normal = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        return Vec3((mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).normalized());
    };
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = mesh.triangles[t][i];
            const std::uint32_t b = mesh.triangles[t][(i + 1) % 3];
            const std::uint32_t c = mesh.triangles[t][(i + 2) % 3];
            const std::array<std::uint32_t, 2> pair = sides.at(edgeKey(a, b));
            const std::uint32_t other = pair[0] == t ? pair[1] : pair[0];
            std::uint32_t d = a;
            for (const std::uint32_t v : mesh.triangles[other]) {
                d = v != a && v != b ? v : d;
            }
            if (sides.contains(edgeKey(c, d))) {
                continue;
            }
            const auto cost = [](int v) { return (v - 6) * (v - 6); };
            const int before = cost(valence[a]) + cost(valence[b]) + cost(valence[c]) + cost(valence[d]);
            const int after = cost(valence[a] - 1) + cost(valence[b] - 1) + cost(valence[c] + 1) + cost(valence[d] + 1);
            const Vec3 facing = normal(a, b, c) + normal(b, a, d);
            if (after >= before || normal(c, d, b).dot(facing) < 1.6 || normal(d, c, a).dot(facing) < 1.6) {
                continue;
            }
            mesh.triangles[t] = {c, d, b};
            mesh.triangles[other] = {d, c, a};
            sides.erase(edgeKey(a, b));
            sides[edgeKey(c, d)] = {t, other};
            replaceSide(a, c, t, other);
            replaceSide(d, b, other, t);
            --valence[a];
            --valence[b];
            ++valence[c];
            ++valence[d];
            break;
        }
    }
}

/// Moves each vertex along the surface towards the centroid of its neighbours.
void relax(TriangleMesh& mesh, const Distance& distance)
{
    std::vector<Vec3> sum(mesh.vertices.size(), Vec3::Zero());
    std::vector<double> weight(mesh.vertices.size(), 0.0);
    for (const Triangle& t : mesh.triangles) {
        const Vec3 middle = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
        const double area =
            (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).norm();
        for (const std::uint32_t v : t) {
            sum[v] += area * middle;
            weight[v] += area;
        }
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const Vec3 n = outward(distance, mesh.vertices[v]);
        Vec3 step = sum[v] / weight[v] - mesh.vertices[v];
        step -= n.dot(step) * n;
        mesh.vertices[v] = onSurface(distance, mesh.vertices[v] + step);
    }
}

} // namespace

TriangleMesh sampleSurface(const Distance& distance, const core::Box& box, double cell_mm)
{
    TriangleMesh mesh = contour(distance, box, cell_mm);
    for (int round = 0; round < 3; ++round) {
        collapseShortEdges(mesh, 0.55 * cell_mm);
        for (int i = 0; i < 4; ++i) {
            balanceValence(mesh);
            relax(mesh, distance);
        }
    }
    collapseShortEdges(mesh, 0.35 * cell_mm);
    for (Vec3& v : mesh.vertices) {
        v = onSurface(distance, v);
    }
    return mesh;
}

void roundCoordinates(TriangleMesh& mesh)
{
    for (Vec3& v : mesh.vertices) {
        v = (v * 1024.0).array().round() / 1024.0;
    }
}

} // namespace palpate::phantom
