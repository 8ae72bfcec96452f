// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Message.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>

#include <CLI/App.hpp>

#include <optional>
#include <vector>

namespace palpate::app {

/// Surface processing before contact: options `--smooth`, `--smoothing`, `--curved`, `--outwards` and
/// `--close-holes`.
struct SurfaceOptions
{
    bool isSmoothed = false;
    bool isCurved = false;
    bool turnsOutwards = false;
    double closeHoles_mm = 0.0;
    std::optional<double> smoothing{};

    void addTo(CLI::App& command);
    void applyTo(meshio::ReadOptions& read) const;
};

/// Describes palpable surfaces that are inverted or stair-stepped, with the options that fix them, and the voxel
/// staircases.
/// @param felt  made from `scene`, structure by structure
[[nodiscard]] std::vector<core::Message> surfaceNotes(const meshio::LoadedScene& scene,
                                                      const haptics::HapticScene& felt);

/// Prints these sentences and study::neighbourNotes, each as a line "note: …". @return the sentences
std::vector<core::Message> printTouchNotes(const meshio::LoadedScene& scene, const haptics::HapticScene& felt);

} // namespace palpate::app
