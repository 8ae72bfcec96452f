// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Message.h>
#include <palpate/core/Status.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace palpate::app {

/// Help text of the option `--layers`.
inline constexpr const char* kLayersHelp =
    "auto: what lies in another structure is felt below it (mesh files; a scene file keeps its own layers)";

/// Checks `--layers`: auto, or empty if not given.
[[nodiscard]] core::Status checkLayers(const std::string& option);

/// Applies `--layers auto`: assigns layers to mesh files by nesting. Scene files and recordings keep their layers.
/// @param felt  made from `scene`; replaced when layers were assigned
/// @return one sentence per assignment
[[nodiscard]] std::vector<core::Message> layOut(const std::filesystem::path& path, meshio::LoadedScene& scene,
                                                std::shared_ptr<const haptics::HapticScene>& felt);

} // namespace palpate::app
