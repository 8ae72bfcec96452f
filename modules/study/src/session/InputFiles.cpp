// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/InputFiles.h"

#include "palpate/study/RecordedScene.h"

#include <palpate/meshio/MeshFolder.h>
#include <palpate/meshio/SceneFile.h>
#include <palpate/session/RecordingReader.h>

#include <system_error>

namespace palpate::study {

namespace {

namespace fs = std::filesystem;

void addScene(const fs::path& file, std::vector<fs::path>& out)
{
    out.push_back(file);
    std::error_code error;
    if (fs::is_directory(file, error)) {
        const std::vector<fs::path> files = meshio::meshFilesIn(file, error);
        out.insert(out.end(), files.begin(), files.end());
        return;
    }
    if (!meshio::isSceneFile(file) || !fs::is_regular_file(file, error)) {
        return;
    }
    const auto scene = meshio::readScene(file);
    if (!scene.isOk()) {
        return;
    }
    for (const meshio::SceneStructure& structure : scene.value().structures) {
        out.push_back(structure.mesh);
        for (const core::TissueMapping& map : structure.maps.value_or(std::vector<core::TissueMapping>())) {
            out.emplace_back(map.file);
        }
    }
}

} // namespace

std::vector<fs::path> filesOf(const fs::path& input)
{
    std::vector<fs::path> out;
    if (!session::isRecordingByNameOrContent(input)) {
        addScene(input, out);
        return out;
    }
    out.push_back(input);
    const auto reader = session::RecordingReader::open(input);
    if (!reader.isOk()) {
        return out;
    }
    if (const auto scene = recordedSceneFile(*reader.value())) {
        addScene(*scene, out);
    }
    for (const session::SceneRecord& scene : reader.value()->scenes()) {
        for (const session::StructureRecord& structure : scene.structures) {
            const fs::path mesh = recordedMeshFile(*reader.value(), structure);
            out.push_back(mesh);
            out.push_back(input.parent_path() / mesh.filename()); // last location that is searched
        }
    }
    return out;
}

} // namespace palpate::study
