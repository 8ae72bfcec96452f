// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace palpate::app {

/// What `--layers` is, for the help of each command that has it.
inline constexpr const char* kLayersHelp =
    "auto: what lies in another structure is felt below it (mesh files; a scene file keeps its own layers)";

/// Checks `--layers`: auto, or empty where it was not given.
[[nodiscard]] core::Status checkLayers(const std::string& option);

/// Does what `--layers auto` asks: mesh files get their layers by what lies in what, a scene file and a recording keep
/// their own.
/// @param felt  made of `scene`; a new one where layers were set
/// @return what was done, a sentence each
[[nodiscard]] std::vector<std::string> layOut(const std::filesystem::path& path, meshio::LoadedScene& scene,
                                              std::shared_ptr<const haptics::HapticScene>& felt);

} // namespace palpate::app
