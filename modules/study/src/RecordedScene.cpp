// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/RecordedScene.h"

#include "palpate/study/StructureSources.h"

#include <algorithm>
#include <utility>

namespace palpate::study {

using core::Result;
using core::Status;
using core::StatusCode;
using session::MeshesByHash;
using session::RecordingReader;

namespace {

/// @return hashes of all surfaces that were felt.
std::vector<std::string> feltHashes(const RecordingReader& reader)
{
    std::vector<std::string> hashes;
    for (const session::SceneRecord& scene : reader.scenes()) {
        for (const session::StructureRecord& structure : scene.structures) {
            if (structure.palpable) {
                hashes.push_back(structure.source.sha256);
            }
        }
    }
    return hashes;
}

/// How a mesh file was read for a recording. One that it does not name (a scene or a folder) as its first.
meshio::ReadOptions readAs(const RecordingReader& reader, const std::filesystem::path& file)
{
    meshio::ReadOptions options;
    options.readsScale = false; // the unit is said
    if (reader.scenes().empty() || reader.scenes().front().structures.empty()) {
        return options;
    }
    const std::vector<session::StructureRecord>& all = reader.scenes().front().structures;
    const auto named =
        std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.source.mesh == file.string(); });
    const session::StructureSource& source = (named == all.end() ? all.front() : *named).source;
    options.unit_mm = source.unit_mm;
    options.frame = source.frame;
    return options;
}

} // namespace

Result<meshio::LoadedScene> openScene(const std::filesystem::path& path, const meshio::ReadOptions& options)
{
    return session::isRecordingFile(path) ? sceneOfRecording(path) : meshio::loadScene(path, options);
}

Result<MeshesByHash> recordedSurfaces(const RecordingReader& reader, const std::filesystem::path& scene)
{
    MeshesByHash meshes;
    for (const std::string& hash : reader.embeddedHashes()) {
        auto surface = reader.embedded(hash);
        if (!surface.isOk()) {
            return surface.status();
        }
        meshes[hash] = std::make_shared<const geometry::RepairedMesh>(std::move(surface).value());
    }
    const std::vector<std::string> felt = feltHashes(reader);
    const bool isWhole =
        std::all_of(felt.begin(), felt.end(), [&](const std::string& hash) { return meshes.contains(hash); });
    if (scene.empty() && isWhole && !meshes.empty()) {
        return meshes;
    }
    // One scene file, or the mesh files that were opened one by one.
    std::vector<std::filesystem::path> files;
    if (!scene.empty() || !reader.info().scene.empty()) {
        files.push_back(scene.empty() ? std::filesystem::path(reader.info().scene) : scene);
    } else if (!reader.scenes().empty()) {
        for (const session::StructureRecord& structure : reader.scenes().front().structures) {
            if (const std::filesystem::path file = structure.source.mesh;
                !file.empty() && std::find(files.begin(), files.end(), file) == files.end()) {
                files.push_back(file);
            }
        }
    }
    if (files.empty()) {
        return Status(StatusCode::NotFound, "the recording does not say what scene it was made on");
    }
    for (std::filesystem::path file : files) {
        const meshio::ReadOptions options = readAs(reader, file);
        std::error_code error;
        if (!std::filesystem::exists(file, error)) { // as it was said then; else beside the recording
            const std::filesystem::path beside = reader.path().parent_path() / file;
            if (!std::filesystem::exists(beside, error)) {
                return Status(StatusCode::NotFound, file.string() + ": no such file");
            }
            file = beside;
        }
        const auto loaded = openScene(file, options);
        if (!loaded.isOk()) {
            return loaded.status();
        }
        meshes.merge(meshesByHash(loaded.value()));
    }
    return meshes;
}

Result<meshio::LoadedScene> sceneOfRecording(const std::filesystem::path& recording)
{
    const auto opened = RecordingReader::open(recording);
    if (!opened.isOk()) {
        return opened.status();
    }
    const RecordingReader& reader = *opened.value();
    meshio::LoadedScene out;
    const auto structures =
        reader.scenes().empty() ? std::vector<session::StructureRecord>() : reader.scenes().front().structures;
    for (const session::StructureRecord& structure : structures) {
        auto surface = reader.embedded(structure.source.sha256);
        if (!surface.isOk()) {
            out.losses.push_back(structure.name + ": " + surface.status().message());
            continue;
        }
        meshio::LoadedStructure& loaded = out.structures.emplace_back();
        loaded.description = descriptionOf(structure);
        loaded.surface = std::make_shared<const geometry::RepairedMesh>(std::move(surface).value());
        out.scene.structures.push_back(loaded.description);
    }
    if (out.structures.empty()) {
        return Status(StatusCode::NotFound,
                      recording.string() + ": found no embedded surface, expected a recording made with --embed");
    }
    return out;
}

} // namespace palpate::study
