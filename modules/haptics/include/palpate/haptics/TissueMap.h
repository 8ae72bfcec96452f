// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/TissueMapping.h>
#include <palpate/geometry/SurfaceIndex.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace palpate::haptics {

/// A scalar that varies over a surface, given at each corner of each triangle. Linear on each triangle, or cubic where
/// `bends` is set.
struct PALPATE_EXPORT TissueMap
{
    /// Values by triangle index in the SurfaceIndex; finite; null: no map.
    std::shared_ptr<const std::vector<std::array<float, 3>>> corners;
    double factor = 1.0; ///< multiplier of all values
    /// Bezier coefficients that make the gradient continuous across edges, see `withBends`; null: not computed; empty:
    /// no bends, the map is linear on each triangle. Stored by triangle, for edge e from corner e to the next: [2 e] is
    /// the offset of the cubic's control value next to the start of the edge from the straight line, [2 e + 1] the
    /// offset of the control value next to the end.
    std::shared_ptr<const std::vector<std::array<float, 6>>> bends{};

    [[nodiscard]] bool isEmpty() const noexcept { return corners == nullptr; }
    /// Returns the map with computed `bends`. Value and gradient are continuous across edges whose dihedral turn is
    /// less than 40 degrees and whose two triangles have equal values at the shared corners. Values given per triangle
    /// are left unchanged.
    ///
    /// The gradient at each vertex is the area-weighted mean over the adjacent triangles, shortened where the cubic's
    /// control values would exceed the range of the surrounding values. Between vertices the map is a cubic whose
    /// cross-edge slope is linear along each edge. HapticScene computes missing bends for stiffness maps and for
    /// transmission maps (`felt`).
    /// @par Source Farin, Curves and Surfaces for CAGD, Bezier triangles; Foley & Opitz 1992 for the middle control
    /// value, blended so that each edge has its own.
    [[nodiscard]] TissueMap withBends(const geometry::SurfaceIndex& surface) const;
    /// Returns true if the map is not linear on the triangle.
    [[nodiscard]] bool bendsOn(std::uint32_t triangle) const noexcept
    {
        return bends != nullptr && !bends->empty() && (*bends)[triangle] != std::array<float, 6>{};
    }
    /// Returns the maximum value including the factor; 0 without a map.
    [[nodiscard]] double greatest() const noexcept;

    /// Returns a copy with all values limited to `most`; an identical copy if no value exceeds the limit.
    [[nodiscard]] TissueMap atMost(double most) const;

    /// Returns a copy in which each value above 1 is reduced to 1 + share (value - 1).
    /// @pre 0 <= share <= 1; factor is 1
    [[nodiscard]] TissueMap towardsOne(double share) const;

    /// Builds a map from one value per vertex.
    /// @param surface  index built from `repaired`
    /// @param repaired  repaired mesh
    /// @param values  one value per vertex of `repaired`
    [[nodiscard]] static TissueMap atVertices(const geometry::SurfaceIndex& surface,
                                              const geometry::RepairedMesh& repaired, std::span<const float> values);
    /// Builds a map that is constant on each triangle. Such a map has steps at the edges that the gradient does not
    /// contain.
    /// @param surface  index of the repaired mesh
    /// @param values  one value per triangle of the repaired mesh
    [[nodiscard]] static TissueMap atTriangles(const geometry::SurfaceIndex& surface, std::span<const float> values);

  private:
    template<class Value, class Bend>
    [[nodiscard]] TissueMap mapped(const Value& value, const Bend& bend) const;
};

/// Penetration depths [mm] at which the transmission maps give the stiffness ratio caused by buried lumps; interpolated
/// linearly, constant beyond the last.
inline constexpr std::array<double, 4> kFeltPress_mm{0.0, 2.0, 4.0, 8.0};

/// All maps of one structure.
struct TissueMaps
{
    TissueMap stiffness; ///< factor s of the law's force and energy [1]; > 0
    TissueMap damping;   ///< damping b [N·s/mm], replaces the tissue's value; >= 0
    TissueMap friction;  ///< factor of both friction coefficients [1]; >= 0
    /// Stiffness ratio k/k0 caused by buried lumps, at each depth of kFeltPress_mm [1]; > 0. Either all four are set or
    /// none is.
    std::array<TissueMap, kFeltPress_mm.size()> felt{};

    /// Member of each quantity, in the order of core::MappedQuantity.
    static constexpr std::array kQuantities{&TissueMaps::stiffness, &TissueMaps::damping, &TissueMaps::friction};
    [[nodiscard]] TissueMap& of(core::MappedQuantity quantity) noexcept
    {
        return this->*kQuantities[static_cast<std::size_t>(quantity)];
    }
    [[nodiscard]] const TissueMap& of(core::MappedQuantity quantity) const noexcept
    {
        return this->*kQuantities[static_cast<std::size_t>(quantity)];
    }
    [[nodiscard]] bool hasFelt() const noexcept { return !felt[0].isEmpty(); }
    /// Returns true if a map other than friction is set.
    [[nodiscard]] bool hasForceMaps() const noexcept { return !stiffness.isEmpty() || !damping.isEmpty() || hasFelt(); }
    [[nodiscard]] bool isEmpty() const noexcept { return friction.isEmpty() && !hasForceMaps(); }
    /// Returns all maps in declaration order.
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
