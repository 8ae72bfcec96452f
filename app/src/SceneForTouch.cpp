// SPDX-License-Identifier: BSD-3-Clause
#include "SceneForTouch.h"

#include "RecordedScene.h"

#include <palpate/session/GeometryHash.h>
#include <palpate/session/RecordingReader.h>

#include <utility>

namespace palpate::app {

core::Result<meshio::LoadedScene> loadSceneOrFolder(const std::filesystem::path& path,
                                                    const meshio::ReadOptions& options)
{
    return session::isRecordingFile(path) ? sceneOfRecording(path) : meshio::loadScene(path, options);
}

haptics::HapticStructure structureForTouch(const meshio::LoadedStructure& structure)
{
    const meshio::SceneStructure& description = structure.description;
    haptics::HapticStructure out;
    out.name = description.name;
    out.tissue.stiffness_N_per_mm = description.stiffness_N_per_mm;
    out.tissue.damping_Ns_per_mm = description.damping_Ns_per_mm;
    out.layer = description.layer;
    if (description.palpable && structure.surface != nullptr && !structure.surface->mesh.triangles.empty()) {
        out.surface = std::make_shared<geometry::SurfaceIndex>(geometry::SurfaceIndex::build(*structure.surface));
    }
    return out;
}

std::shared_ptr<const haptics::HapticScene> sceneForTouch(const meshio::LoadedScene& scene)
{
    std::vector<haptics::HapticStructure> structures;
    structures.reserve(scene.structures.size());
    for (const auto& structure : scene.structures) {
        structures.push_back(structureForTouch(structure));
    }
    return std::make_shared<haptics::HapticScene>(std::move(structures));
}

std::vector<session::StructureSource> structureSources(const meshio::LoadedScene& scene)
{
    std::vector<session::StructureSource> sources;
    for (const auto& structure : scene.structures) {
        const meshio::SceneStructure& description = structure.description;
        session::StructureSource& source = sources.emplace_back();
        source.mesh = description.mesh.string();
        source.part = description.part;
        source.unit_mm = description.unit_mm;
        source.flipped = description.flipped;
        source.X_WM = description.X_WM;
        if (structure.surface != nullptr) {
            source.sha256 = session::geometryHash(structure.surface->mesh);
        }
    }
    return sources;
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

std::size_t triangleCount(const haptics::HapticScene& scene)
{
    std::size_t triangles = 0;
    for (const auto& structure : scene.structures()) {
        triangles += structure.surface != nullptr ? structure.surface->triangleCount() : 0;
    }
    return triangles;
}

} // namespace palpate::app
