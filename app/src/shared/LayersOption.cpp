// SPDX-License-Identifier: BSD-3-Clause
#include "shared/LayersOption.h"

#include <palpate/meshio/SceneFile.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/study/Layers.h>

namespace palpate::app {

core::Status checkLayers(const std::string& option)
{
    if (option.empty() || option == "auto") {
        return {};
    }
    return {core::StatusCode::BadCommandLine, PALPATE_TEXT("--layers: found \"%1\", expected auto"), option};
}

std::vector<std::string> layOut(const std::filesystem::path& path, meshio::LoadedScene& scene,
                                std::shared_ptr<const haptics::HapticScene>& felt)
{
    const bool isRecording = session::isRecordingFile(path);
    if (isRecording || meshio::isSceneFile(path)) {
        return {path.filename().string() + (isRecording ? " is a recording" : " is a scene file") +
                " and keeps its own layers"};
    }
    std::vector<std::string> lines = study::setLayers(scene, felt);
    if (lines.empty()) {
        lines.emplace_back("nothing lies in another structure: all is in one layer");
    }
    return lines;
}

} // namespace palpate::app
