// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/SurfaceIndex.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace palpate::haptics {

/// A number that varies over a surface: given at each corner of each triangle, linear between.
struct TissueMap
{
    /// By the triangle's position in the SurfaceIndex; finite; null: no map.
    std::shared_ptr<const std::vector<std::array<float, 3>>> corners;
    double factor = 1.0; ///< that each number is multiplied by

    [[nodiscard]] bool isEmpty() const noexcept { return corners == nullptr; }
    /// The largest number, with the factor; 0 without a map.
    [[nodiscard]] double greatest() const noexcept;

    /// @param repaired  the mesh that `surface` was built from
    /// @param values  one for each of its vertices
    [[nodiscard]] static TissueMap atVertices(const geometry::SurfaceIndex& surface,
                                              const geometry::RepairedMesh& repaired, std::span<const float> values);
    /// The same value all over each triangle: at the edges it steps, and no gradient tells of it.
    /// @param values  one for each triangle of the repaired mesh
    [[nodiscard]] static TissueMap atTriangles(const geometry::SurfaceIndex& surface, std::span<const float> values);
};

/// What varies over a structure.
struct TissueMaps
{
    TissueMap stiffness; ///< s [1]: scales the law's force and energy; > 0
    TissueMap damping;   ///< b [N·s/mm]: stands for the tissue's own; >= 0
    TissueMap friction;  ///< scales both coefficients [1]; >= 0

    [[nodiscard]] bool isEmpty() const noexcept
    {
        return stiffness.isEmpty() && damping.isEmpty() && friction.isEmpty();
    }
};

} // namespace palpate::haptics
