// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/HapticCopy.h"

#include <palpate/haptics/ForceTable.h>

#include <utility>
#include <vector>

namespace palpate::study {

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

std::shared_ptr<const geometry::SurfaceIndex> indexed(const geometry::RepairedMesh& surface)
{
    return std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(surface));
}

std::shared_ptr<const haptics::HapticScene> hapticScene(const meshio::LoadedScene& scene)
{
    std::vector<haptics::HapticStructure> structures;
    structures.reserve(scene.structures.size());
    for (const meshio::LoadedStructure& structure : scene.structures) {
        const bool isFelt = structure.description.palpable && structure.surface != nullptr &&
                            !structure.surface->mesh.triangles.empty();
        structures.push_back(hapticStructure(structure.description, isFelt ? indexed(*structure.surface) : nullptr));
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
