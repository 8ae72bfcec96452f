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

std::vector<core::Message> layOut(const std::filesystem::path& path, meshio::LoadedScene& scene,
                                  std::shared_ptr<const haptics::HapticScene>& felt)
{
    if (session::isRecordingByNameOrContent(path)) {
        return {{PALPATE_TEXT("%1 is a recording and keeps its own layers"), path.filename()}};
    }
    if (meshio::isSceneFile(path)) {
        return {{PALPATE_TEXT("%1 is a scene file and keeps its own layers"), path.filename()}};
    }
    std::vector<core::Message> lines = study::setLayers(scene, felt);
    if (lines.empty()) {
        lines.push_back({PALPATE_TEXT("nothing lies in another structure: all is in one layer")});
    }
    return lines;
}

} // namespace palpate::app
