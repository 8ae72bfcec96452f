// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Tissue.h>
#include <palpate/meshio/LoadScene.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace palpate::study {

/// Map values converted to absolute units.
struct FeltMap
{
    std::string unit; ///< "N/mm", "N·s/mm"; "times the tissue's own" if the map scales a force law or friction
    std::vector<float> values; ///< one per map value; NaN: no map value, so that the tissue's own value applies
    double own = 1.0;          ///< value used for NaN
    double least = 0.0, greatest = 0.0; ///< range of the known values; 0 if none is known
};

/// @param most  limit of the device in the unit of `FeltMap`; larger values are clamped
[[nodiscard]] PALPATE_EXPORT FeltMap feltMap(const meshio::SurfaceMap& map, const core::Tissue& tissue,
                                             double most = std::numeric_limits<double>::infinity());

/// Interpolates values at a point on a surface; NaN if unknown.
/// @param values  one per vertex or per triangle
/// @param triangle  index in `surface`
/// @param p_W  point on that triangle [mm]
[[nodiscard]] PALPATE_EXPORT double valueAt(const geometry::RepairedMesh& surface, const std::vector<float>& values,
                                            bool isPerTriangle, std::size_t triangle, const core::Vec3& p_W);

} // namespace palpate::study
