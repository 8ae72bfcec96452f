// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/CornerForce.h"

#include "palpate/evaluation/ProductSolver.h"
#include "palpate/evaluation/Shapes.h"
#include "palpate/evaluation/VectorFieldSolver.h"

#include <cmath>
#include <numbers>

namespace palpate::evaluation {

namespace {

// The second box is wider: otherwise both would form a single surface when their tops are coplanar.
constexpr double kHalfWidth_mm = 60.0, kSecondHalfWidth_mm = 70.0, kThickness_mm = 40.0;
constexpr double kPress_mm = 2.0; // depth below the corner, along the bisector
constexpr double kAside_mm = 0.3; // offset from the middle of the boxes, where the face diagonals cross

/// Returns a box below z = 0, rotated about y by `lean_rad`.
geometry::TriangleMesh leaningBox(double lean_rad, double halfWidth_mm)
{
    geometry::TriangleMesh mesh =
        shapes::box(Vec3(-halfWidth_mm, -halfWidth_mm, -kThickness_mm), Vec3(halfWidth_mm, halfWidth_mm, 0.0), 3);
    const Eigen::AngleAxisd turn(lean_rad, Vec3::UnitY());
    for (Vec3& v : mesh.vertices) {
        v = turn * v;
    }
    return mesh;
}

} // namespace

std::vector<CornerForce> forceInCorners()
{
    std::vector<CornerForce> corners;
    for (int degrees = 20; degrees <= 180; degrees += 10) {
        const double lean = 0.5 * (180.0 - degrees) * std::numbers::pi / 180.0;
        geometry::TriangleMesh mesh = leaningBox(lean, kHalfWidth_mm);
        shapes::append(mesh, leaningBox(-lean, kSecondHalfWidth_mm));
        const Surface surface(geometry::repair(mesh, geometry::Facing::AsGiven));
        VectorFieldSolver field(surface, VectorFieldSolver::Overlap::Sum);
        ProductSolver product(sceneOf(surface.repaired()), "Palpate");
        const auto at = [](double height_mm) { return Vec3(0.0, kAside_mm, height_mm); };
        product.start(at(kPress_mm));
        for (double height = kPress_mm; height > -kPress_mm; height -= 0.1) {
            (void)product.step(at(height));
        }
        const Vec3 pressed = at(-kPress_mm);
        corners.push_back({static_cast<double>(degrees), field.step(pressed).spring_mm.norm() / kPress_mm,
                           product.step(pressed).spring_mm.norm() / kPress_mm});
    }
    return corners;
}

} // namespace palpate::evaluation
