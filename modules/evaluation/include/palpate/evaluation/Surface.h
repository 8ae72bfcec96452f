// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/Repair.h>

#include <cstdint>
#include <vector>

namespace palpate::evaluation {

using core::Box;
using core::Vec3;

/// Surface for the reference solvers: one or several merged repaired meshes with bounding boxes.
///
/// The boxes only filter the brute-force search: the triangles are sorted along a space-filling curve, with one box
/// around every 64 and one around every 4096 triangles, and all of the latter are tested. Nothing is shared with the
/// product's spatial index.
class Surface
{
  public:
    explicit Surface(geometry::RepairedMesh mesh);

    [[nodiscard]] const geometry::RepairedMesh& repaired() const noexcept { return m_mesh; }
    [[nodiscard]] std::uint32_t triangleCount() const noexcept
    {
        return static_cast<std::uint32_t>(m_mesh.mesh.triangles.size());
    }
    /// @param corner  0 to 2, counter-clockwise seen from the front [mm]
    [[nodiscard]] const Vec3& corner(std::uint32_t triangle, int corner) const noexcept
    {
        return m_mesh.mesh.vertices[m_mesh.mesh.triangles[triangle][static_cast<std::size_t>(corner)]];
    }
    [[nodiscard]] Box box(std::uint32_t triangle) const noexcept;
    [[nodiscard]] bool isTwoSided(std::uint32_t triangle) const noexcept { return m_mesh.twoSided[triangle] != 0; }
    /// True if every component is closed.
    [[nodiscard]] bool isClosed() const noexcept { return m_isClosed; }
    [[nodiscard]] const Box& bounds() const noexcept { return m_bounds; } ///< [mm]
    /// Largest absolute coordinate or box side, the scale of rounding errors. [mm]
    [[nodiscard]] double magnitude_mm() const noexcept { return m_magnitude_mm; }
    /// Side of an equilateral triangle of mean area. [mm]
    [[nodiscard]] double facetSize_mm() const noexcept { return m_facetSize_mm; }

    /// Appends the triangles whose boxes touch `box`, in a deterministic order.
    void appendNear(const Box& box, std::vector<std::uint32_t>& triangles) const;

    /// Winding number of the one-sided surfaces around `p`: 1 inside a closed surface that faces outwards, 0 outside,
    /// -1 in a cavity that faces inwards. Computed from the signed crossings of a long segment, each decided exactly.
    /// @param component  index in `components()`; negative: all components
    [[nodiscard]] int winding(const Vec3& p, int component = -1) const;

    /// Connected component of each triangle, numbered from 0.
    [[nodiscard]] const std::vector<std::uint32_t>& components() const noexcept { return m_components; }
    [[nodiscard]] std::uint32_t componentCount() const noexcept { return m_componentCount; }

  private:
    geometry::RepairedMesh m_mesh;
    std::vector<std::uint32_t> m_order;
    std::vector<Box> m_fine;   ///< boxes around 64 triangles of `m_order`
    std::vector<Box> m_coarse; ///< boxes around 64 boxes of `m_fine`
    std::vector<std::uint32_t> m_components;
    std::uint32_t m_componentCount = 0;
    Box m_bounds;
    double m_magnitude_mm = 0.0;
    double m_facetSize_mm = 0.0;
    bool m_isClosed = true;
};

/// Merges several repaired meshes into one.
[[nodiscard]] geometry::RepairedMesh merged(const std::vector<const geometry::RepairedMesh*>& meshes);

} // namespace palpate::evaluation
