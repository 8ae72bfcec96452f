// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/geometry/Repair.h>
#include <palpate/geometry/SurfaceIndex.h>

#include <memory>

namespace palpate::buried {

using core::Vec3;

/// Organ surface at the scale of a finger contact: details smaller than the finger are averaged.
class PALPATE_EXPORT Ground
{
  public:
    /// Validity limit of the half-space model in contact radii: minimum radius of curvature and organ thickness.
    static constexpr double kMinValidRadii = 4.0;

    struct At
    {
        Vec3 n_W;              ///< mean outward normal of the contact area, unit length
        bool isCurved = false; ///< the radius of curvature is below kMinValidRadii contact radii
        bool isThin = false;   ///< the opposite surface is nearer than kMinValidRadii contact radii
    };

    /// @param organ  repaired, world frame [mm], edges no longer than the contact radius; stored by reference
    /// @param index  built from `organ`; stored by reference
    /// @param radius_mm  contact radius of the finger, > 0
    Ground(const geometry::RepairedMesh& organ, const geometry::SurfaceIndex& index, double radius_mm);
    ~Ground();
    Ground(const Ground&) = delete;
    Ground& operator=(const Ground&) = delete;

    /// @param p_W  point on the surface [mm]
    /// @param n_W  outward normal at this point
    /// @par Cost Microseconds. Any thread, with bit-identical results.
    [[nodiscard]] At at(const Vec3& p_W, const Vec3& n_W) const;

  private:
    [[nodiscard]] bool isThin(const Vec3& p_W, const Vec3& n_W) const;

    struct Patches;
    std::unique_ptr<const Patches> m_patches;
    const geometry::SurfaceIndex& m_index;
    double m_radius_mm;
};

} // namespace palpate::buried
