// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/TissueMap.h"

#include <algorithm>

namespace palpate::haptics {

/// Returns a copy with `value` applied to each number, and the bends of an edge multiplied by `bend` of the numbers at
/// its ends.
template<class Value, class Bend>
TissueMap TissueMap::mapped(const Value& value, const Bend& bend) const
{
    std::vector<std::array<float, 3>> changed = *corners;
    std::vector<std::array<float, 6>> bent = bends == nullptr ? std::vector<std::array<float, 6>>() : *bends;
    for (std::size_t i = 0; i < changed.size(); ++i) {
        const std::array<float, 3> was = changed[i];
        for (std::size_t k = 0; k < was.size(); ++k) {
            changed[i][k] = value(was[k]);
            for (std::size_t j = 2 * k; !bent.empty() && j < 2 * k + 2; ++j) {
                bent[i][j] *= bend(was[k], was[(k + 1) % 3]);
            }
        }
    }
    return {std::make_shared<const std::vector<std::array<float, 3>>>(std::move(changed)), factor,
            bends == nullptr ? nullptr : std::make_shared<const std::vector<std::array<float, 6>>>(std::move(bent))};
}

double TissueMap::greatest() const noexcept
{
    float most = 0.0F;
    if (corners != nullptr) {
        for (const std::array<float, 3>& at : *corners) {
            most = std::max({most, at[0], at[1], at[2]});
        }
    }
    return factor * double{most};
}

TissueMap TissueMap::atMost(double most) const
{
    if (greatest() <= most) {
        return *this;
    }
    const auto raw = static_cast<float>(most / factor);
    return mapped([raw](float value) { return std::min(value, raw); },
                  [raw](float from, float to) { return from <= raw && to <= raw ? 1.0F : 0.0F; });
}

TissueMap TissueMap::towardsOne(double share) const
{
    return mapped(
        [share](float value) { return value > 1.0F ? static_cast<float>(1.0 + share * (double{value} - 1.0)) : value; },
        [share](float from, float to) {
            return from <= 1.0F && to <= 1.0F ? 1.0F : from > 1.0F && to > 1.0F ? static_cast<float>(share) : 0.0F;
        });
}

TissueMap TissueMap::atVertices(const geometry::SurfaceIndex& surface, const geometry::RepairedMesh& repaired,
                                std::span<const float> values)
{
    std::vector<std::array<float, 3>> corners(surface.triangleCount());
    for (std::uint32_t i = 0; i < surface.triangleCount(); ++i) {
        const geometry::Triangle& from = repaired.mesh.triangles[surface.sourceTriangle(i)];
        corners[i] = {values[from[0]], values[from[1]], values[from[2]]};
    }
    return TissueMap{std::make_shared<const std::vector<std::array<float, 3>>>(std::move(corners))};
}

TissueMap TissueMap::atTriangles(const geometry::SurfaceIndex& surface, std::span<const float> values)
{
    std::vector<std::array<float, 3>> corners(surface.triangleCount());
    for (std::uint32_t i = 0; i < surface.triangleCount(); ++i) {
        const float value = values[surface.sourceTriangle(i)];
        corners[i] = {value, value, value};
    }
    return TissueMap{std::make_shared<const std::vector<std::array<float, 3>>>(std::move(corners))};
}

} // namespace palpate::haptics
