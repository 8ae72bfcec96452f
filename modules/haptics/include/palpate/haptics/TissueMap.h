// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/SurfaceIndex.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace palpate::haptics {

/// A number that varies over a surface: given at each corner of each triangle, linear between the corners but for
/// `bends`.
struct TissueMap
{
    /// By the triangle's position in the SurfaceIndex; finite; null: no map.
    std::shared_ptr<const std::vector<std::array<float, 3>>> corners;
    double factor = 1.0; ///< that each number is multiplied by
    /// What makes the gradient continuous over the edges, see `withBends`; null: not computed, empty: none, and the map
    /// is linear on each triangle. By triangle, for edge e from corner e to the next: [2 e] how far the cubic's control
    /// value next to the edge's start lies above the straight line, [2 e + 1] the same next to its end.
    std::shared_ptr<const std::vector<std::array<float, 6>>> bends{};

    [[nodiscard]] bool isEmpty() const noexcept { return corners == nullptr; }
    /// The map with `bends`: over edges that turn by less than 40 degrees, between triangles with the same numbers at
    /// their common corners, value and gradient are continuous. Numbers given for each triangle are left as they are.
    ///
    /// At each vertex the gradient is the mean over the triangles around it, by area, shortened where the cubic's
    /// control values would lie beyond the numbers around. Between, the map is a cubic whose slope across each edge is
    /// linear along it. A HapticScene makes the bends of its maps of stiffness and of felt maps that have none.
    /// @par Source Farin, Curves and Surfaces for CAGD, Bezier triangles; Foley & Opitz 1992 for the middle control
    /// value, blended so that each edge has its own.
    [[nodiscard]] TissueMap withBends(const geometry::SurfaceIndex& surface) const;
    /// True where it is not linear on a triangle.
    [[nodiscard]] bool bendsOn(std::uint32_t triangle) const noexcept
    {
        return bends != nullptr && !bends->empty() && (*bends)[triangle] != std::array<float, 6>{};
    }
    /// The largest number, with the factor; 0 without a map.
    [[nodiscard]] double greatest() const noexcept;

    /// A copy with no number above `most`; unchanged where none is.
    [[nodiscard]] TissueMap atMost(double most) const;

    /// The same with each number above 1 brought nearer to it: 1 + share (number - 1). @pre 0 <= share <= 1; factor 1
    [[nodiscard]] TissueMap towardsOne(double share) const;

    /// @param repaired  the mesh that `surface` was built from
    /// @param values  one for each of its vertices
    [[nodiscard]] static TissueMap atVertices(const geometry::SurfaceIndex& surface,
                                              const geometry::RepairedMesh& repaired, std::span<const float> values);
    /// The same value all over each triangle: at the edges it steps, and no gradient tells of it.
    /// @param values  one for each triangle of the repaired mesh
    [[nodiscard]] static TissueMap atTriangles(const geometry::SurfaceIndex& surface, std::span<const float> values);

  private:
    template<class Value, class Bend>
    [[nodiscard]] TissueMap mapped(const Value& value, const Bend& bend) const;
};

/// Press depths at which a felt map gives how much stiffer lumps below make the surface [mm]; linear between them,
/// constant beyond the last.
inline constexpr std::array<double, 4> kFeltPress_mm{0.0, 2.0, 4.0, 8.0};

/// What varies over a structure.
struct TissueMaps
{
    TissueMap stiffness; ///< s [1]: scales the law's force and energy; > 0
    TissueMap damping;   ///< b [N·s/mm]: stands for the tissue's own; >= 0
    TissueMap friction;  ///< scales both coefficients [1]; >= 0
    /// What lumps below make of the law's force, k/k0 at each of kFeltPress_mm [1]; > 0. All four or none.
    std::array<TissueMap, kFeltPress_mm.size()> felt{};

    [[nodiscard]] bool hasFelt() const noexcept { return !felt[0].isEmpty(); }
    /// True when a term of the force asks for one: all but friction's.
    [[nodiscard]] bool hasOfForce() const noexcept { return !stiffness.isEmpty() || !damping.isEmpty() || hasFelt(); }
    [[nodiscard]] bool isEmpty() const noexcept { return friction.isEmpty() && !hasOfForce(); }
    /// All of them, in the order in which they are declared.
    [[nodiscard]] std::array<TissueMap*, 7> all() noexcept
    {
        return {&stiffness, &damping, &friction, &felt[0], &felt[1], &felt[2], &felt[3]};
    }
    [[nodiscard]] std::array<const TissueMap*, 7> all() const noexcept
    {
        return {&stiffness, &damping, &friction, &felt[0], &felt[1], &felt[2], &felt[3]};
    }
};

} // namespace palpate::haptics
