// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/SmoothComparison.h"

#include "palpate/evaluation/ProductSolver.h"
#include "palpate/evaluation/Surface.h"
#include "reference/ClosestPoint.h"
#include "smooth/TrueShape.h"

#include <palpate/geometry/PnTriangles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

namespace palpate::evaluation {

namespace {

constexpr double kStiffness_N_per_mm = 0.5;
constexpr double kPressDepth_mm = 4.0, kDepthSwing_mm = 1.5;
constexpr double kSlide_mm_per_tick = 0.025; // 25 mm/s at 1 kHz
constexpr double kDegree = std::numbers::pi / 180.0;

/// Facets with interpolated normals.
class ShadedFacets
{
  public:
    explicit ShadedFacets(const geometry::RepairedMesh& mesh)
        : m_surface(mesh)
        , m_normals(mesh.mesh.vertices.size(), Vec3::Zero())
    {
        for (const geometry::Triangle& t : mesh.mesh.triangles) {
            for (std::size_t k = 0; k < 3; ++k) { // Max's weights, as for PN triangles
                const Vec3& p = mesh.mesh.vertices[t[k]];
                const Vec3 a = mesh.mesh.vertices[t[(k + 1) % 3]] - p, b = mesh.mesh.vertices[t[(k + 2) % 3]] - p;
                m_normals[t[k]] += a.cross(b) / (a.squaredNorm() * b.squaredNorm());
            }
        }
        for (Vec3& normal : m_normals) {
            normal.normalize();
        }
    }

    /// @return the normal interpolated at the point of the facets closest to `p`
    [[nodiscard]] Vec3 normalNear(const Vec3& p)
    {
        const geometry::TriangleMesh& mesh = m_surface.repaired().mesh;
        Vec3 foot = p;
        std::uint32_t nearest = 0;
        double least = std::numeric_limits<double>::infinity();
        for (double reach = m_surface.facetSize_mm(); !std::isfinite(least); reach *= 4.0) {
            m_near.clear();
            m_surface.appendNear(Box(p - Vec3::Constant(reach), p + Vec3::Constant(reach)), m_near);
            for (const std::uint32_t i : m_near) {
                const geometry::Triangle& t = mesh.triangles[i];
                const Vec3 q = closestPoint<double>(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]], p);
                const double distance = (q - p).norm();
                if (distance < least && distance <= reach) {
                    std::tie(least, foot, nearest) = std::tuple(distance, q, i);
                }
            }
        }
        const geometry::Triangle& t = mesh.triangles[nearest];
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const Vec3 n = (b - a).cross(c - a);
        const double u = n.dot((c - b).cross(foot - b)), v = n.dot((a - c).cross(foot - c));
        const double w = n.squaredNorm() - u - v;
        return (u * m_normals[t[0]] + v * m_normals[t[1]] + w * m_normals[t[2]]).normalized();
    }

  private:
    Surface m_surface;
    std::vector<Vec3> m_normals;
    std::vector<std::uint32_t> m_near;
};

/// God-object and force for a HIP.
struct Felt
{
    Vec3 p_WG = Vec3::Zero(); ///< [mm]
    Vec3 f_W = Vec3::Zero();  ///< [N]
};

enum class Way
{
    Facets,
    Pn,
    ForceShading,
    TwoPasses
};

constexpr std::array<std::pair<Way, const char*>, 4> kWays{
    {{Way::Facets, "facets"},
     {Way::Pn, "PN triangles"},
     {Way::ForceShading, "force shading (Morgenbesser and Srinivasan)"},
     {Way::TwoPasses, "two passes until at rest (Ruspini)"}}};

class SmoothSolver
{
  public:
    SmoothSolver(const geometry::RepairedMesh& mesh, Way way)
        : m_way(way)
        , m_shaded(mesh)
        , m_solver(sceneOf(mesh), "facets")
    {
    }

    void start(const Vec3& p_WH)
    {
        m_solver.start(p_WH);
        m_p_WG = p_WH;
    }

    [[nodiscard]] Felt step(const Vec3& p_WH)
    {
        if (m_way == Way::TwoPasses) {
            return twoPasses(p_WH);
        }
        m_p_WG = m_solver.step(p_WH).p_WG;
        const Vec3 spring_mm = m_p_WG - p_WH;
        const Vec3 shown_mm =
            m_way == Way::ForceShading ? Vec3(spring_mm.norm() * m_shaded.normalNear(m_p_WG)) : spring_mm;
        return {m_p_WG, kStiffness_N_per_mm * shown_mm};
    }

  private:
    /// Ruspini et al., section 6.1: the plane through the god-object with the interpolated normal gives a goal for the
    /// facets. Published programs make one such step in a tick.
    Felt twoPasses(const Vec3& p_WH)
    {
        constexpr int kMostPasses = 100;
        constexpr double kRest_mm = 1e-9;
        for (int pass = 0; pass < kMostPasses; ++pass) {
            const Vec3 n = m_shaded.normalNear(m_p_WG);
            const double below_mm = n.dot(m_p_WG - p_WH);
            const Vec3 goal = below_mm > 0.0 ? Vec3(p_WH + below_mm * n) : p_WH;
            const Vec3 before = std::exchange(m_p_WG, m_solver.step(goal).p_WG);
            if ((m_p_WG - before).norm() < kRest_mm) {
                break;
            }
        }
        return {m_p_WG, kStiffness_N_per_mm * (m_p_WG - p_WH)};
    }

    Way m_way;
    ShadedFacets m_shaded;
    ProductSolver m_solver;
    Vec3 m_p_WG = Vec3::Zero();
};

/// Closed path on a shape: a circle of 8 mm radius on the surface, with a depth that swings.
struct ClosedPath
{
    double centerU, centerV; ///< [rad]
    double swing_mm;         ///< amplitude of the depth around kPressDepth_mm
    int lobes;               ///< periods of the depth
    double phase;            ///< [rad]
};

constexpr double kCircle_mm = 8.0;
constexpr int kRoundTicks = static_cast<int>(2.0 * std::numbers::pi * kCircle_mm / kSlide_mm_per_tick);

Vec3 hipAt(const TrueShape& shape, const ClosedPath& path, int tick)
{
    const double a = 2.0 * std::numbers::pi * tick / kRoundTicks, around = kCircle_mm / shape.radius_mm;
    const SurfacePoint at = shape.at(path.centerU + around * std::cos(a), path.centerV + around * std::sin(a));
    return at.p_W - (kPressDepth_mm + path.swing_mm * std::sin(path.lobes * a + path.phase)) * at.n_W;
}

/// Follows a path twice and measures the second round, which starts and ends in the same state.
void follow(const TrueShape& shape, SmoothSolver& solver, const ClosedPath& path, SmoothRow& row)
{
    const SurfacePoint above = shape.closest(hipAt(shape, path, 0));
    solver.start(above.p_W + above.n_W);
    double work = 0.0;
    Vec3 before_WH = Vec3::Zero();
    Felt before;
    for (int tick = 0; tick <= 2 * kRoundTicks; ++tick) {
        const Vec3 p_WH = hipAt(shape, path, tick);
        const Felt felt = solver.step(p_WH);
        if (tick > kRoundTicks) {
            const SurfacePoint truth = shape.closest(p_WH);
            row.position_mm = std::max(row.position_mm, (felt.p_WG - shape.closest(felt.p_WG).p_W).norm());
            const double turn = std::atan2(felt.f_W.cross(truth.n_W).norm(), felt.f_W.dot(truth.n_W));
            row.direction_deg = std::max(row.direction_deg, turn / kDegree);
            work += 0.5 * (felt.f_W + before.f_W).dot(p_WH - before_WH); // N mm = mJ
            if (path.swing_mm == 0.0) {
                row.step_N = std::max(row.step_N, (felt.f_W - before.f_W).norm());
            }
        }
        before = felt;
        before_WH = p_WH;
    }
    row.work_mJ = std::max(row.work_mJ, std::abs(work));
}

SmoothRow measure(const TrueShape& shape, Way way, const char* name)
{
    geometry::RepairedMesh mesh = geometry::repair(shape.facets);
    if (way == Way::Pn) {
        geometry::PnSurface curved = geometry::pnTriangles(mesh);
        mesh = curved.surface ? std::move(*curved.surface) : std::move(mesh);
    }
    SmoothRow row{shape.name, name, mesh.mesh.triangles.size(), shape.radius_mm};
    row.press_mJ = 0.5 * kStiffness_N_per_mm * kPressDepth_mm * kPressDepth_mm;
    SmoothSolver solver(mesh, way);
    for (const ClosedPath& path : {ClosedPath{0.11, 0.07, 0.0, 1, 0.0}, ClosedPath{-0.2, 0.3, kDepthSwing_mm, 1, 0.4},
                                   ClosedPath{0.4, -0.1, kDepthSwing_mm, 3, 1.7}}) {
        follow(shape, solver, path, row);
    }
    return row;
}

} // namespace

std::vector<SmoothRow> compareSmoothSurfaces()
{
    std::vector<SmoothRow> rows;
    for (const TrueShape& shape : trueShapes()) {
        for (const auto& [way, name] : kWays) {
            rows.push_back(measure(shape, way, name));
        }
    }
    return rows;
}

} // namespace palpate::evaluation
