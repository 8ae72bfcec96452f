// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/FeltMap.h"

#include <algorithm>
#include <cmath>

namespace palpate::study {

using core::MappedQuantity;

namespace {

/// Returns barycentric weights of a point on a triangle; the sum is 1.
core::Vec3 weightsAt(const geometry::RepairedMesh& surface, std::size_t triangle, const core::Vec3& p_W)
{
    const geometry::Triangle& corners = surface.mesh.triangles[triangle];
    const core::Vec3& a = surface.mesh.vertices[corners[0]];
    const core::Vec3 u = surface.mesh.vertices[corners[1]] - a, v = surface.mesh.vertices[corners[2]] - a;
    const core::Vec3 n = u.cross(v);
    const double area = n.squaredNorm(); // > 0 after repair
    const double second = std::clamp((p_W - a).cross(v).dot(n) / area, 0.0, 1.0);
    const double third = std::clamp(u.cross(p_W - a).dot(n) / area, 0.0, 1.0 - second);
    return {1.0 - second - third, second, third};
}

} // namespace

FeltMap feltMap(const meshio::SurfaceMap& map, const core::Tissue& tissue, double most)
{
    const bool isScale = map.mapping.unit == core::MapUnit::Scale;
    const bool isLinear = tissue.law.kind == core::LawKind::Linear;
    FeltMap felt{"times the tissue's own", map.values};
    double factor = 1.0;
    if (map.mapping.quantity == MappedQuantity::Damping) {
        felt.unit = "N·s/mm";
        felt.own = tissue.damping_Ns_per_mm;
    } else if (map.mapping.quantity == MappedQuantity::Stiffness) {
        const double stiffness = tissue.stiffness_N_per_mm;
        if (isLinear) { // a linear law has a single stiffness
            felt.unit = "N/mm";
            felt.own = stiffness;
            factor = isScale ? stiffness : 1.0;
        } else if (!isScale && stiffness > 0.0) {
            factor = 1.0 / stiffness;
        }
    }
    bool isAny = false;
    for (float& value : felt.values) {
        if (std::isnan(value)) {
            continue;
        }
        value = static_cast<float>(std::min(most, factor * double{value}));
        felt.least = isAny ? std::min(felt.least, double{value}) : value;
        felt.greatest = isAny ? std::max(felt.greatest, double{value}) : value;
        isAny = true;
    }
    return felt;
}

double valueAt(const geometry::RepairedMesh& surface, const std::vector<float>& values, bool isPerTriangle,
               std::size_t triangle, const core::Vec3& p_W)
{
    if (isPerTriangle) {
        return values[triangle];
    }
    const geometry::Triangle& corners = surface.mesh.triangles[triangle];
    const core::Vec3 weights = weightsAt(surface, triangle, p_W);
    return weights[0] * values[corners[0]] + weights[1] * values[corners[1]] + weights[2] * values[corners[2]];
}

} // namespace palpate::study
