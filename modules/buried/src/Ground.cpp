// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/buried/Ground.h"

#include <palpate/geometry/Inside.h>
#include <palpate/geometry/internal/BoxHierarchyVisit.h>

#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticPointLocator.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace palpate::buried {

namespace {

/// Minimum cosine between the normals of a patch and the contact: includes patches around an edge, but not on the other
/// side.
constexpr double kTurnedAway = -0.5;

} // namespace

/// Surface patches about a third of a contact radius wide: an evaluation needs about a hundred of them, independent of
/// the mesh resolution.
struct Ground::Patches
{
    struct Patch
    {
        Vec3 middle = Vec3::Zero();
        Vec3 area = Vec3::Zero(); ///< sum of the triangles' area vectors [mm^2]
    };
    std::vector<Patch> patches;
    vtkNew<vtkPolyData> points;
    vtkNew<vtkStaticPointLocator> locator;
};

Ground::Ground(const geometry::RepairedMesh& organ, const geometry::SurfaceIndex& index, double radius_mm)
    : m_index(index)
    , m_radius_mm(radius_mm)
{
    struct Gathered
    {
        Vec3 middle = Vec3::Zero(), area = Vec3::Zero();
        double size = 0.0;
    };
    // Group by grid cell and normal direction, so that the two sides of a thin edge form separate patches.
    std::map<std::tuple<std::int64_t, std::int64_t, std::int64_t, int>, Gathered> cells;
    const double side = radius_mm / 3.0;
    for (const geometry::Triangle& t : organ.mesh.triangles) {
        const Vec3 &a = organ.mesh.vertices[t[0]], &b = organ.mesh.vertices[t[1]], &c = organ.mesh.vertices[t[2]];
        const Vec3 area = 0.5 * (b - a).cross(c - a), middle = (a + b + c) / 3.0;
        int axis = 0;
        area.cwiseAbs().maxCoeff(&axis);
        const auto cell = [&](int k) { return static_cast<std::int64_t>(std::floor(middle[k] / side)); };
        Gathered& to = cells[{cell(0), cell(1), cell(2), 2 * axis + (area[axis] < 0.0 ? 1 : 0)}];
        const double size = area.norm();
        to.middle += size * middle;
        to.area += area;
        to.size += size;
    }
    auto made = std::make_unique<Patches>();
    const vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const auto& [key, gathered] : cells) {
        if (gathered.size > 0.0) {
            const Vec3 middle = gathered.middle / gathered.size;
            made->patches.push_back({middle, gathered.area});
            points->InsertNextPoint(middle.data());
        }
    }
    made->points->SetPoints(points);
    made->locator->SetDataSet(made->points);
    made->locator->BuildLocator();
    m_patches = std::move(made);
}

Ground::~Ground() = default;

Ground::At Ground::at(const Vec3& p_W, const Vec3& n_W) const
{
    thread_local const vtkSmartPointer<vtkIdList> nearby = vtkSmartPointer<vtkIdList>::New();
    const double reach = 2.0 * m_radius_mm;
    m_patches->locator->FindPointsWithinRadius(reach, p_W.data(), nearby);
    thread_local std::vector<vtkIdType> ids;
    ids.assign(nearby->begin(), nearby->end());
    std::sort(ids.begin(), ids.end());

    Vec3 sum = Vec3::Zero();
    const auto patchesOf = [&](const auto& use) {
        for (const vtkIdType id : ids) {
            const Patches::Patch& patch = m_patches->patches[static_cast<std::size_t>(id)];
            if (patch.area.dot(n_W) > kTurnedAway * patch.area.norm()) {
                use(patch, (patch.middle - p_W).squaredNorm() / (reach * reach));
            }
        }
    };
    // The contact pressure decreases from the centre; the weights do likewise and end continuously at zero.
    patchesOf([&](const Patches::Patch& patch, double away2) {
        const double near = 1.0 - std::min(1.0, away2);
        sum += near * near * near * near * patch.area;
    });
    At at{sum.norm() > 0.0 ? Vec3(sum.normalized()) : n_W};

    // Least-squares fit of z = A u^2 + B u v + C v^2 + D u + E v + F within two contact radii.
    const Vec3 u = at.n_W.unitOrthogonal(), v = at.n_W.cross(u);
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Identity() * 1e-12;
    Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
    patchesOf([&](const Patches::Patch& patch, double /*away2*/) {
        const Vec3 x = (patch.middle - p_W) / reach;
        const double a = u.dot(x), b = v.dot(x), weight = patch.area.norm() / (reach * reach);
        Eigen::Matrix<double, 6, 1> row;
        row << a * a, a * b, b * b, a, b, 1.0;
        normal += weight * row * row.transpose();
        right += weight * at.n_W.dot(x) * row;
    });
    const Eigen::Matrix<double, 6, 1> fit = normal.ldlt().solve(right);
    const double d2 = 1.0 + fit[3] * fit[3] + fit[4] * fit[4];
    const double mean = fit[0] + fit[2], half = std::hypot(fit[0] - fit[2], fit[1]);
    const double bend = (std::abs(mean) + half) / std::sqrt(d2) / reach; // [1/mm], the larger principal curvature
    at.isCurved = !(bend * kMinValidRadii * m_radius_mm <= 1.0);
    at.isThin = isThin(p_W, at.n_W);
    return at;
}

bool Ground::isThin(const Vec3& p_W, const Vec3& n_W) const
{
    const double reach = kMinValidRadii * m_radius_mm;
    bool isMet = false;
    m_index.hierarchy().visitSegment(p_W, p_W - reach * n_W, [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t i = first; i < first + count && !isMet; ++i) {
            const geometry::Triangle t = m_index.triangle(i);
            const Vec3 &a = m_index.vertex(t[0]), &b = m_index.vertex(t[1]), &c = m_index.vertex(t[2]);
            if ((b - a).cross(c - a).dot(n_W) <
                0.0) { // opposite side only; folds of the near side are behind the finger
                isMet = geometry::distanceAlongRay(a, b, c, p_W, -n_W) < reach;
            }
        }
        return isMet ? -1.0 : 1.0;
    });
    return isMet;
}

} // namespace palpate::buried
