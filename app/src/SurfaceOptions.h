// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace palpate::app {

/// What is done to surfaces before they are touched: the options `--smooth` and `--outwards`.
struct SurfaceOptions
{
    bool isSmoothed = false;
    bool turnsOutwards = false;

    void addTo(CLI::App& command);
    void applyTo(meshio::ReadOptions& read) const;
};

/// @return sentences about surfaces that can be felt but are inside out or staircases, with the options that mend them;
/// about the staircases themselves, too
/// @param felt  made of `scene`, structure by structure
[[nodiscard]] std::vector<std::string> surfaceNotes(const meshio::LoadedScene& scene, const haptics::HapticScene& felt);

/// Prints these and study::neighbourNotes, each as a line "note: …". @return them
std::vector<std::string> printTouchNotes(const meshio::LoadedScene& scene, const haptics::HapticScene& felt);

} // namespace palpate::app
