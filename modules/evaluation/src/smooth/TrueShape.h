// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/TriangleMesh.h>

#include <string>
#include <vector>

namespace palpate::evaluation {

using core::Vec3;

/// Point of a surface with its unit normal.
struct SurfacePoint
{
    Vec3 p_W = Vec3::Zero(); ///< [mm]
    Vec3 n_W = Vec3::UnitZ();
};

/// Smooth surface with a formula, and its facets. The surface is that of a tube around a circle: a torus, and with an
/// infinite or no circle a cylinder along y or a sphere.
struct TrueShape
{
    enum class Kind
    {
        Sphere,
        Cylinder,
        Torus
    };
    Kind kind = Kind::Sphere;
    std::string name;
    double radius_mm = 20.0; ///< of the sphere, the cylinder or the tube
    double ring_mm = 30.0;   ///< radius of the torus' circle
    geometry::TriangleMesh facets{};

    /// Point at the angles u and v [rad], a patch of about radius_mm times the angles around the top at u = v = 0.
    [[nodiscard]] SurfacePoint at(double u, double v) const;
    /// Point closest to a HIP that is less deep than radius_mm.
    [[nodiscard]] SurfacePoint closest(const Vec3& p_WH) const;
};

/// Sphere, cylinder and torus of the comparison.
[[nodiscard]] std::vector<TrueShape> trueShapes();

} // namespace palpate::evaluation
