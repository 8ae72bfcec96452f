// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/MeshReport.h>
#include <palpate/geometry/SurfaceIndex.h>

#include <memory>

namespace palpate::buried {

using core::Vec3;

/// An organ's surface as a finger of a size meets it: what is smaller than the finger is evened out.
class Ground
{
  public:
    /// In contact radii: a surface that is curved more, or an organ that is thinner, is no half-space.
    static constexpr double kLeastRadii = 4.0;

    struct At
    {
        Vec3 n_W;              ///< mean outward normal of what the finger covers, unit length
        bool isCurved = false; ///< the surface bends with a radius below kLeastRadii contact radii
        bool isThin = false;   ///< the organ's other side is nearer than kLeastRadii contact radii
    };

    /// @param organ  repaired, world frame [mm], no edge longer than the finger's radius; kept by reference
    /// @param index  made of `organ`; kept by reference
    /// @param radius_mm  of the finger's contact, > 0
    Ground(const geometry::RepairedMesh& organ, const geometry::SurfaceIndex& index, double radius_mm);
    ~Ground();
    Ground(const Ground&) = delete;
    Ground& operator=(const Ground&) = delete;

    /// @param p_W  on the surface [mm]; @param n_W  outward normal there
    /// @par Cost microseconds. Any thread; the same bits on each.
    [[nodiscard]] At at(const Vec3& p_W, const Vec3& n_W) const;

  private:
    [[nodiscard]] bool isThin(const Vec3& p_W, const Vec3& n_W) const;

    struct Patches;
    std::unique_ptr<const Patches> m_patches;
    const geometry::SurfaceIndex& m_index;
    double m_radius_mm;
};

} // namespace palpate::buried
