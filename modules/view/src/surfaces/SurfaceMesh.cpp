// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/SurfaceMesh.h"

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

namespace palpate::view {

namespace {

using geometry::Triangle;
using geometry::TriangleMesh;
using geometry::Vec3;

/// Corners at each vertex; corner 3 t + c is the c-th corner of triangle t.
struct CornersOfVertices
{
    std::vector<std::uint32_t> first; ///< one entry more than vertices
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

/// Angle of a triangle at a corner: the weight in the vertex normal, which makes the normal independent of the
/// triangulation.
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

vtkSmartPointer<vtkFloatArray> arrayOf(const std::vector<float>& values, const char* name)
{
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / 3));
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    return array;
}

/// Points for shading. Triangles around a vertex that are connected across smooth edges share one point and normal; a
/// feature edge starts a new point.
class ShadedPoints
{
  public:
    explicit ShadedPoints(const TriangleMesh& mesh)
        : m_mesh(mesh)
        , m_of(cornersOfVertices(mesh))
        , m_faces(mesh.triangles.size())
        , m_connectivity(mesh.triangles.size() * 3)
    {
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            m_faces[t] = faceNormal(mesh, mesh.triangles[t]);
        }
        m_points.reserve(mesh.vertices.size() * 3);
        m_normals.reserve(mesh.vertices.size() * 3);
        for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
            m_isTaken.assign(m_of.first[v + 1] - m_of.first[v], 0);
            for (std::uint32_t seed = 0; seed < m_isTaken.size(); ++seed) {
                if (m_isTaken[seed] == 0) {
                    addPoint(v, seed);
                }
            }
        }
    }

    [[nodiscard]] vtkSmartPointer<vtkPolyData> polyData() const
    {
        auto points = vtkSmartPointer<vtkPoints>::New();
        points->SetData(arrayOf(m_points, "Points"));
        auto ids = vtkSmartPointer<vtkTypeInt32Array>::New();
        ids->SetNumberOfTuples(static_cast<vtkIdType>(m_connectivity.size()));
        std::copy(m_connectivity.begin(), m_connectivity.end(), ids->GetPointer(0));
        auto offsets = vtkSmartPointer<vtkTypeInt32Array>::New();
        offsets->SetNumberOfTuples(static_cast<vtkIdType>(m_faces.size() + 1));
        for (std::size_t t = 0; t <= m_faces.size(); ++t) {
            offsets->SetValue(static_cast<vtkIdType>(t), static_cast<std::int32_t>(3 * t));
        }
        auto cells = vtkSmartPointer<vtkCellArray>::New();
        cells->SetData(offsets, ids);
        auto data = vtkSmartPointer<vtkPolyData>::New();
        data->SetPoints(points);
        data->SetPolys(cells);
        data->GetPointData()->SetNormals(arrayOf(m_normals, "Normals"));
        return data;
    }

  private:
    /// Adds the point shared by corner `seed` of a vertex and all corners smoothly connected to `seed`.
    void addPoint(std::uint32_t v, std::uint32_t seed)
    {
        const std::uint32_t* corners = &m_of.corner[m_of.first[v]];
        const auto point = static_cast<std::int32_t>(m_points.size() / 3);
        m_isTaken[seed] = 1;
        m_queue.assign(1, seed);
        Vec3 sum = Vec3::Zero();
        for (std::size_t q = 0; q < m_queue.size(); ++q) {
            const std::uint32_t corner = corners[m_queue[q]];
            m_connectivity[corner] = point;
            sum += cornerAngle(m_mesh, corner) * m_faces[corner / 3];
            for (std::uint32_t other = 0; other < m_isTaken.size(); ++other) {
                if (m_isTaken[other] == 0 && meetSmoothly(corner, corners[other])) {
                    m_isTaken[other] = 1;
                    m_queue.push_back(other);
                }
            }
        }
        const double length = sum.norm();
        const Vec3 normal = length > 0.0 ? Vec3(sum / length) : m_faces[corners[seed] / 3];
        for (int axis = 0; axis < 3; ++axis) {
            m_points.push_back(static_cast<float>(m_mesh.vertices[v][axis]));
            m_normals.push_back(static_cast<float>(normal[axis]));
        }
    }

    [[nodiscard]] bool meetSmoothly(std::uint32_t corner, std::uint32_t other) const
    {
        static const double sharp = std::cos(kFeatureAngle_deg * std::numbers::pi / 180.0);
        return m_faces[corner / 3].dot(m_faces[other / 3]) > sharp &&
               shareEdgeAt(m_mesh.triangles[corner / 3], corner % 3, m_mesh.triangles[other / 3], other % 3);
    }

    const TriangleMesh& m_mesh;
    CornersOfVertices m_of;
    std::vector<Vec3> m_faces; ///< face normals
    std::vector<float> m_points;
    std::vector<float> m_normals;
    std::vector<std::int32_t> m_connectivity;
    std::vector<std::uint8_t> m_isTaken; ///< per corner of the current vertex
    std::vector<std::uint32_t> m_queue;
};

} // namespace

vtkSmartPointer<vtkPolyData> makeSurface(const geometry::RepairedMesh& surface)
{
    return ShadedPoints(surface.mesh).polyData();
}

} // namespace palpate::view
