// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/HapticCopy.h"

#include <palpate/haptics/ForceTable.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace palpate::study {

bool canBeFelt(const meshio::SceneStructure& structure) noexcept
{
    return structure.palpable && (structure.visible || structure.isHiddenTarget);
}

bool isDrawn(const meshio::SceneStructure& structure) noexcept
{
    return structure.visible && !structure.isHiddenTarget;
}

haptics::HapticStructure hapticStructure(const meshio::SceneStructure& description,
                                         std::shared_ptr<const geometry::SurfaceIndex> surface)
{
    haptics::HapticStructure out;
    out.name = description.name;
    out.surface = std::move(surface);
    out.tissue = description.tissue;
    out.layer = description.layer;
    out.law = haptics::ForceTable::build(out.tissue);
    return out;
}

haptics::TissueMaps tissueMaps(const meshio::LoadedStructure& structure, const geometry::SurfaceIndex& surface)
{
    using core::MappedQuantity;
    const core::Tissue& tissue = structure.description.tissue;
    haptics::TissueMaps maps;
    for (const meshio::SurfaceMap& map : structure.maps) {
        const bool isScale = map.mapping.unit == core::MapUnit::Scale;
        const bool isStiffness = map.mapping.quantity == MappedQuantity::Stiffness;
        const double own = isScale ? 1.0 : isStiffness ? tissue.stiffness_N_per_mm : tissue.damping_Ns_per_mm;
        if (isStiffness && !(own > 0.0)) {
            continue; // nothing to scale
        }
        std::vector<float> values = map.values;
        std::replace_if(
            values.begin(), values.end(), [](float v) { return std::isnan(v); }, static_cast<float>(own));
        haptics::TissueMap& to = maps.of(map.mapping.quantity);
        to = map.isPerTriangle ? haptics::TissueMap::atTriangles(surface, values)
                               : haptics::TissueMap::atVertices(surface, *structure.surface, values);
        to.factor = isStiffness && !isScale ? 1.0 / own : 1.0;
        to = isStiffness ? to.withBends(surface) : to;
    }
    for (std::size_t j = 0; j < maps.felt.size() && j < structure.feltBelow.size(); ++j) {
        maps.felt[j] =
            haptics::TissueMap::atVertices(surface, *structure.surface, structure.feltBelow[j]).withBends(surface);
    }
    return maps;
}

std::shared_ptr<const geometry::SurfaceIndex> indexed(const geometry::RepairedMesh& surface)
{
    return std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(surface));
}

std::shared_ptr<const haptics::HapticScene>
hapticScene(const meshio::LoadedScene& scene,
            const std::function<std::shared_ptr<const geometry::SurfaceIndex>(std::size_t)>& indexOf)
{
    std::vector<haptics::HapticStructure> structures;
    structures.reserve(scene.structures.size());
    for (const meshio::LoadedStructure& structure : scene.structures) {
        const bool isFelt = canBeFelt(structure.description) && !structure.isTransmitted &&
                            structure.surface != nullptr && !structure.surface->mesh.triangles.empty();
        auto index = !isFelt ? nullptr : indexOf ? indexOf(structures.size()) : indexed(*structure.surface);
        structures.push_back(hapticStructure(structure.description, std::move(index)));
        if (isFelt) {
            structures.back().maps = tissueMaps(structure, *structures.back().surface);
            structures.back().motion = structure.motion;
        }
    }
    return std::make_shared<const haptics::HapticScene>(std::move(structures));
}

std::size_t triangleCount(const haptics::HapticScene& scene)
{
    std::size_t triangles = 0;
    for (const haptics::HapticStructure& structure : scene.structures()) {
        triangles += structure.surface != nullptr ? structure.surface->triangleCount() : 0;
    }
    return triangles;
}

} // namespace palpate::study
