// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <palpate/device/HandScript.h>
#include <palpate/meshio/LoadScene.h>

#include <filesystem>

namespace palpate::phantom {

/// What the hand of the bundled recording does in 20 s: comes to the organ, searches its front in strokes, presses and
/// circles over each of the lumps, and leaves.
[[nodiscard]] device::HandScript palpationScript();

/// Lets a simulated hand follow the script on a scene, through the servo's own tick, and writes what it felt.
[[nodiscard]] core::Status recordPalpation(const meshio::LoadedScene& scene, const device::HandScript& script,
                                           const std::filesystem::path& path);

} // namespace palpate::phantom
