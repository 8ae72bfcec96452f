// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scene/SurfaceMesh.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace palpate::scene {

namespace {

using geometry::Triangle;
using geometry::TriangleMesh;
using geometry::Vec3;

/// Corners of each vertex: corner 3 t + c is the c-th corner of triangle t.
struct CornersOfVertices
{
    std::vector<std::uint32_t> first; ///< one more than vertices
    std::vector<std::uint32_t> corner;
};

CornersOfVertices cornersOfVertices(const TriangleMesh& mesh)
{
    CornersOfVertices of;
    of.first.assign(mesh.vertices.size() + 1, 0);
    for (const Triangle& t : mesh.triangles) {
        for (const std::uint32_t v : t) {
            ++of.first[v + 1];
        }
    }
    for (std::size_t v = 0; v + 1 < of.first.size(); ++v) {
        of.first[v + 1] += of.first[v];
    }
    of.corner.resize(mesh.triangles.size() * 3);
    std::vector<std::uint32_t> next(of.first.begin(), of.first.end() - 1);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::uint32_t c = 0; c < 3; ++c) {
            of.corner[next[mesh.triangles[t][c]]++] = 3 * t + c;
        }
    }
    return of;
}

Vec3 faceNormal(const TriangleMesh& mesh, const Triangle& t)
{
    return (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).normalized();
}

/// The angle of a triangle at a corner: its weight in the vertex normal, so that the triangulation does not show.
double cornerAngle(const TriangleMesh& mesh, std::uint32_t corner)
{
    const Triangle& t = mesh.triangles[corner / 3];
    const Vec3& p = mesh.vertices[t[corner % 3]];
    const Vec3 u = (mesh.vertices[t[(corner + 1) % 3]] - p).normalized();
    const Vec3 v = (mesh.vertices[t[(corner + 2) % 3]] - p).normalized();
    return std::atan2(u.cross(v).norm(), u.dot(v));
}

bool shareEdgeAt(const Triangle& a, std::uint32_t cornerA, const Triangle& b, std::uint32_t cornerB)
{
    const std::uint32_t a1 = a[(cornerA + 1) % 3];
    const std::uint32_t a2 = a[(cornerA + 2) % 3];
    const std::uint32_t b1 = b[(cornerB + 1) % 3];
    const std::uint32_t b2 = b[(cornerB + 2) % 3];
    return a1 == b1 || a1 == b2 || a2 == b1 || a2 == b2;
}

} // namespace

vtkSmartPointer<vtkPolyData> makeSurface(const geometry::RepairedMesh& surface)
{
    const TriangleMesh& mesh = surface.mesh;
    const std::size_t triangles = mesh.triangles.size();
    const double sharp = std::cos(kFeatureAngle_deg * std::numbers::pi / 180.0);

    std::vector<Vec3> faces(triangles);
    for (std::size_t t = 0; t < triangles; ++t) {
        faces[t] = faceNormal(mesh, mesh.triangles[t]);
    }
    const CornersOfVertices of = cornersOfVertices(mesh);

    std::vector<float> points;
    std::vector<float> normals;
    points.reserve(mesh.vertices.size() * 3);
    normals.reserve(mesh.vertices.size() * 3);
    std::vector<std::int32_t> connectivity(triangles * 3);
    std::vector<std::uint32_t> group; // of each corner of the vertex at hand
    std::vector<std::uint32_t> queue;
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        const std::uint32_t begin = of.first[v];
        const std::uint32_t count = of.first[v + 1] - begin;
        group.assign(count, 0);
        // Triangles round a vertex that meet smoothly, one over an edge to the next, share a point and a normal; a
        // feature edge starts another.
        for (std::uint32_t seed = 0, groups = 0; seed < count; ++seed) {
            if (group[seed] != 0) {
                continue;
            }
            const auto point = static_cast<std::int32_t>(points.size() / 3);
            group[seed] = ++groups;
            queue.assign(1, seed);
            Vec3 sum = Vec3::Zero();
            for (std::size_t q = 0; q < queue.size(); ++q) {
                const std::uint32_t corner = of.corner[begin + queue[q]];
                connectivity[corner] = point;
                sum += cornerAngle(mesh, corner) * faces[corner / 3];
                for (std::uint32_t other = 0; other < count; ++other) {
                    const std::uint32_t otherCorner = of.corner[begin + other];
                    if (group[other] == 0 && faces[corner / 3].dot(faces[otherCorner / 3]) > sharp &&
                        shareEdgeAt(mesh.triangles[corner / 3], corner % 3, mesh.triangles[otherCorner / 3],
                                    otherCorner % 3)) {
                        group[other] = groups;
                        queue.push_back(other);
                    }
                }
            }
            const double length = sum.norm();
            const Vec3 normal = length > 0.0 ? Vec3(sum / length) : faces[of.corner[begin + seed] / 3];
            for (int axis = 0; axis < 3; ++axis) {
                points.push_back(static_cast<float>(mesh.vertices[v][axis]));
                normals.push_back(static_cast<float>(normal[axis]));
            }
        }
    }

    const auto arrayOf = [](const std::vector<float>& values, const char* name) {
        auto array = vtkSmartPointer<vtkFloatArray>::New();
        array->SetName(name);
        array->SetNumberOfComponents(3);
        array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / 3));
        std::copy(values.begin(), values.end(), array->GetPointer(0));
        return array;
    };
    auto vtkPts = vtkSmartPointer<vtkPoints>::New();
    vtkPts->SetData(arrayOf(points, "Points"));

    auto ids = vtkSmartPointer<vtkTypeInt32Array>::New();
    ids->SetNumberOfTuples(static_cast<vtkIdType>(connectivity.size()));
    std::copy(connectivity.begin(), connectivity.end(), ids->GetPointer(0));
    auto offsets = vtkSmartPointer<vtkTypeInt32Array>::New();
    offsets->SetNumberOfTuples(static_cast<vtkIdType>(triangles + 1));
    for (std::size_t t = 0; t <= triangles; ++t) {
        offsets->SetValue(static_cast<vtkIdType>(t), static_cast<std::int32_t>(3 * t));
    }
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(offsets, ids);

    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(vtkPts);
    data->SetPolys(cells);
    data->GetPointData()->SetNormals(arrayOf(normals, "Normals"));
    return data;
}

} // namespace palpate::scene
