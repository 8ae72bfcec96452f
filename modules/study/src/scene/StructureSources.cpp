// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/StructureSources.h"

#include "palpate/study/HapticCopy.h"

#include <palpate/session/GeometryHash.h>

#include <utility>

namespace palpate::study {

session::StructureSource sourceOf(const meshio::SceneStructure& description, std::string sha256)
{
    return {description.mesh.string(), description.part,  description.unit_mm, description.frame,
            description.flipped,       std::move(sha256), description.X_WM,    nullptr};
}

std::vector<session::StructureSource> sourcesOf(const meshio::LoadedScene& scene, bool embeds)
{
    std::vector<session::StructureSource> sources;
    for (const meshio::LoadedStructure& structure : scene.structures) {
        const bool isThere = structure.surface != nullptr;
        sources.push_back(
            sourceOf(structure.description, isThere ? session::geometryHash(structure.surface->mesh) : std::string()));
        sources.back().embed = embeds ? structure.surface : nullptr;
    }
    return sources;
}

meshio::SceneStructure descriptionOf(const session::StructureRecord& record)
{
    meshio::SceneStructure description;
    description.mesh = record.source.mesh;
    description.part = record.source.part;
    description.unit_mm = record.source.unit_mm;
    description.frame = record.source.frame;
    description.flipped = record.source.flipped;
    description.X_WM = record.source.X_WM;
    description.name = record.name;
    description.tissue = record.tissue;
    description.layer = record.layer;
    description.palpable = record.palpable;
    return description;
}

session::MeshesByHash meshesByHash(const meshio::LoadedScene& scene)
{
    session::MeshesByHash meshes;
    for (const meshio::LoadedStructure& structure : scene.structures) {
        if (structure.surface != nullptr) {
            meshes[session::geometryHash(structure.surface->mesh)] = structure.surface;
        }
    }
    return meshes;
}

session::SurfacesByHash surfacesByHash(const haptics::HapticScene& scene,
                                       const std::vector<session::StructureSource>& sources)
{
    session::SurfacesByHash surfaces;
    for (std::size_t i = 0; i < scene.structures().size() && i < sources.size(); ++i) {
        if (scene.structures()[i].surface != nullptr) {
            surfaces.emplace(sources[i].sha256, scene.structures()[i].surface);
        }
    }
    return surfaces;
}

session::SurfacesByHash indexedByHash(const session::MeshesByHash& meshes)
{
    session::SurfacesByHash surfaces;
    for (const auto& [hash, mesh] : meshes) {
        surfaces[hash] = indexed(*mesh);
    }
    return surfaces;
}

} // namespace palpate::study
