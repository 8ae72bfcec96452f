// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/TissueMap.h"

#include <algorithm>

namespace palpate::haptics {

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
    std::vector<std::array<float, 3>> bounded = *corners;
    const auto raw = static_cast<float>(most / factor);
    for (std::array<float, 3>& at : bounded) {
        at = {std::min(at[0], raw), std::min(at[1], raw), std::min(at[2], raw)};
    }
    return {std::make_shared<const std::vector<std::array<float, 3>>>(std::move(bounded)), factor};
}

TissueMap TissueMap::towardsOne(double share) const
{
    std::vector<std::array<float, 3>> nearer = *corners;
    for (std::array<float, 3>& at : nearer) {
        for (float& value : at) {
            value = value > 1.0F ? static_cast<float>(1.0 + share * (double{value} - 1.0)) : value;
        }
    }
    return {std::make_shared<const std::vector<std::array<float, 3>>>(std::move(nearer)), factor};
}

TissueMap TissueMap::atVertices(const geometry::SurfaceIndex& surface, const geometry::RepairedMesh& repaired,
                                std::span<const float> values)
{
    std::vector<std::array<float, 3>> corners(surface.triangleCount());
    for (std::uint32_t i = 0; i < surface.triangleCount(); ++i) {
        const geometry::Triangle& from = repaired.mesh.triangles[surface.sourceTriangle(i)];
        corners[i] = {values[from[0]], values[from[1]], values[from[2]]};
    }
    return {std::make_shared<const std::vector<std::array<float, 3>>>(std::move(corners))};
}

TissueMap TissueMap::atTriangles(const geometry::SurfaceIndex& surface, std::span<const float> values)
{
    std::vector<std::array<float, 3>> corners(surface.triangleCount());
    for (std::uint32_t i = 0; i < surface.triangleCount(); ++i) {
        const float value = values[surface.sourceTriangle(i)];
        corners[i] = {value, value, value};
    }
    return {std::make_shared<const std::vector<std::array<float, 3>>>(std::move(corners))};
}

} // namespace palpate::haptics
