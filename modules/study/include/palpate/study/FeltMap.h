// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Tissue.h>
#include <palpate/meshio/LoadScene.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace palpate::study {

/// A map's numbers as a hand feels them.
struct FeltMap
{
    std::string unit; ///< "N/mm", "N·s/mm"; "times the tissue's own" where the tissue's law or friction is scaled
    std::vector<float> values; ///< one for each of the map's; NaN: the map says nothing there, the tissue's own is felt
    double own = 1.0;          ///< what is felt there
    double least = 0.0, greatest = 0.0; ///< of the known values; 0 without any
};

/// @param most  in the unit of `FeltMap`, what the device holds; values above it are felt as it
[[nodiscard]] FeltMap feltMap(const meshio::SurfaceMap& map, const core::Tissue& tissue,
                              double most = std::numeric_limits<double>::infinity());

/// A number over a surface at a place on it; NaN where it is not known.
/// @param values  one for each vertex, or each triangle; @param triangle  number in `surface`; @param p_W  on it [mm]
[[nodiscard]] double valueAt(const geometry::RepairedMesh& surface, const std::vector<float>& values,
                             bool isPerTriangle, std::size_t triangle, const core::Vec3& p_W);

} // namespace palpate::study
