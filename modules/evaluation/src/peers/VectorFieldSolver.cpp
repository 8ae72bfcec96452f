// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/VectorFieldSolver.h"

#include "palpate/evaluation/Shapes.h"
#include "reference/ClosestPoint.h"

#include <limits>

namespace palpate::evaluation {

VectorFieldSolver::VectorFieldSolver(const Surface& surface, Overlap overlap)
    : m_surface(surface)
    , m_overlap(overlap)
{
}

std::string VectorFieldSolver::name() const
{
    return m_overlap == Overlap::Nearest ? "vector field, nearest" : "vector field, sum";
}

/// Nearest point of the surface, or of one component if `component` is not negative; brute force in growing boxes.
Vec3 VectorFieldSolver::nearest(const Vec3& p, int component) const
{
    Vec3 best = p;
    double least = std::numeric_limits<double>::infinity();
    std::vector<std::uint32_t> near;
    const double all = m_surface.bounds().sizes().sum() + (p - m_surface.bounds().center()).norm();
    for (double reach = 2.0 * m_surface.facetSize_mm();; reach *= 2.0) {
        near.clear();
        m_surface.appendNear(Box(p.array() - reach, p.array() + reach), near);
        for (const std::uint32_t i : near) {
            if (m_surface.isTwoSided(i) ||
                (component >= 0 && m_surface.components()[i] != static_cast<std::uint32_t>(component))) {
                continue;
            }
            const Vec3 q =
                closestPoint<double>(m_surface.corner(i, 0), m_surface.corner(i, 1), m_surface.corner(i, 2), p);
            if ((q - p).norm() < least) {
                least = (q - p).norm();
                best = q;
            }
        }
        if (least <= reach || reach > all) {
            return best;
        }
    }
}

SolverStep VectorFieldSolver::step(const Vec3& p_WH)
{
    SolverStep result;
    result.p_WG = p_WH;
    if (!p_WH.allFinite() || m_surface.triangleCount() == 0) {
        result.isConverged = p_WH.allFinite();
        return result;
    }
    if (m_overlap == Overlap::Nearest) {
        if (m_surface.winding(p_WH) > 0) {
            result.p_WG = nearest(p_WH, -1);
            result.constraints = 1;
        }
        result.spring_mm = result.p_WG - p_WH;
        return result;
    }
    for (std::uint32_t c = 0; c < m_surface.componentCount(); ++c) {
        const int component = static_cast<int>(c);
        if (m_surface.winding(p_WH, component) > 0) {
            result.spring_mm += nearest(p_WH, component) - p_WH;
            ++result.constraints;
        }
    }
    result.p_WG = p_WH + result.spring_mm;
    return result;
}

VectorFieldFigures measureVectorField()
{
    VectorFieldFigures figures;
    {
        figures.plate_mm = 2.0;
        const Surface plate(geometry::repair(shapes::box(Vec3(-20, -20, -figures.plate_mm), Vec3(20, 20, 0), 4),
                                             geometry::Facing::AsGiven));
        VectorFieldSolver solver(plate);
        for (double depth = 0.01; depth < figures.plate_mm; depth += 0.01) {
            if (solver.step(Vec3(0.3, 0.2, -depth)).spring_mm.z() < 0.0) {
                break;
            }
            figures.popThroughDepth_mm = depth;
        }
    }
    {
        const Surface cube(
            geometry::repair(shapes::box(Vec3(-10, -10, -10), Vec3(10, 10, 10), 2), geometry::Facing::AsGiven));
        VectorFieldSolver solver(cube);
        const Vec3 before = solver.step(Vec3(0, 0, 1e-6)).spring_mm, after = solver.step(Vec3(0, 0, -1e-6)).spring_mm;
        figures.jumpAtTheMiddle_N = (before - after).norm();
    }
    {
        geometry::TriangleMesh mesh = shapes::box(Vec3(-30, -10, -20), Vec3(5, 10, 0), 2);
        shapes::append(mesh, shapes::box(Vec3(-5, -10, -20), Vec3(30, 10, 0), 3));
        const Surface boxes(geometry::repair(mesh, geometry::Facing::AsGiven));
        VectorFieldSolver solver(boxes, VectorFieldSolver::Overlap::Sum);
        const auto felt = [&](double x) {
            const auto at = [&](double z) { return solver.step(Vec3(x, 0.1, z)).spring_mm.z(); };
            return at(-2.0) - at(-1.0);
        };
        figures.stiffnessAlone = felt(-15.0);
        figures.stiffnessOverlapped = felt(0.0);
    }
    return figures;
}

} // namespace palpate::evaluation
