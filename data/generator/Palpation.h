// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <palpate/device/HandScript.h>
#include <palpate/meshio/LoadScene.h>

#include <filesystem>

namespace palpate::phantom {

/// Hand motion of the bundled recording, 20 s: approaches the organ, searches the front in strokes, presses and
/// circles over each lump, and leaves.
[[nodiscard]] device::HandScript palpationScript();

/// Runs a simulated hand along the script on a scene, with the tick of the servo loop, and writes the recording.
[[nodiscard]] core::Status recordPalpation(const meshio::LoadedScene& scene, const device::HandScript& script,
                                           const std::filesystem::path& path);

} // namespace palpate::phantom
