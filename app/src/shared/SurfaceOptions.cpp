// SPDX-License-Identifier: BSD-3-Clause
#include "shared/SurfaceOptions.h"

#include "shared/Console.h"

#include <palpate/study/SceneNotes.h>

#include <cstddef>

namespace palpate::app {

namespace {

/// Shortens a list of names: "liver, spleen, kidney and 3 more".
std::string named(const std::vector<std::string>& names)
{
    constexpr std::size_t kMost = 3;
    std::string text;
    for (std::size_t i = 0; i < names.size() && i < kMost; ++i) {
        text += (i == 0 ? "" : ", ") + names[i];
    }
    return names.size() > kMost ? text + " and " + std::to_string(names.size() - kMost) + " more" : text;
}

} // namespace

void SurfaceOptions::addTo(CLI::App& command)
{
    command.add_flag("--smooth", isSmoothed,
                     "Smooth the surfaces against the steps of voxels, by at most half a voxel; the files stay");
    command
        .add_option("--smoothing", smoothing,
                    "Strength of smoothing, by default 0.5 for label maps and 0.7 with --smooth; 0 leaves the steps")
        ->check(CLI::Range(0.0, 1.0));
    command.add_flag("--outwards", turnsOutwards, "Turn closed surfaces that are inside out; the files stay");
}

void SurfaceOptions::applyTo(meshio::ReadOptions& read) const
{
    read.isSmoothed = isSmoothed;
    read.smoothing = smoothing;
    read.turnsOutwards = turnsOutwards;
}

std::vector<std::string> surfaceNotes(const meshio::LoadedScene& scene, const haptics::HapticScene& felt)
{
    std::vector<std::string> insideOut, stepped, lines;
    for (std::size_t i = 0; i < scene.structures.size(); ++i) {
        const meshio::LoadedStructure& one = scene.structures[i];
        const std::string& name = one.description.name;
        if (one.smoothing) {
            lines.push_back(name + ": " + one.smoothing->sentence());
        }
        if (felt.structures()[i].surface == nullptr && !one.isTransmitted) {
            continue;
        }
        if (one.surface->report.insideOutComponents > 0) {
            insideOut.push_back(name);
        }
        if (one.staircase && !one.smoothing) {
            lines.push_back(name + ": " + one.staircase->sentence());
            stepped.push_back(name);
        }
    }
    if (!stepped.empty()) {
        lines.push_back("the steps of " + named(stepped) +
                        " are felt, with forces that are wrong by a multiple: --smooth smooths them");
    }
    if (!insideOut.empty()) {
        lines.push_back((insideOut.size() == 1 ? "1 surface is" : std::to_string(insideOut.size()) + " surfaces are") +
                        " inside out and felt from within only: " + named(insideOut) +
                        "; --outwards turns closed surfaces outwards");
    }
    return lines;
}

std::vector<std::string> printTouchNotes(const meshio::LoadedScene& scene, const haptics::HapticScene& felt)
{
    std::vector<std::string> lines = surfaceNotes(scene, felt);
    for (std::string& line : study::neighbourNotes(scene, felt)) {
        lines.push_back(std::move(line));
    }
    for (const std::string& line : lines) {
        print("note: %s\n", line.c_str());
    }
    return lines;
}

} // namespace palpate::app
