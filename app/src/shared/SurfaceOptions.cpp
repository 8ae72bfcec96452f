// SPDX-License-Identifier: BSD-3-Clause
#include "shared/SurfaceOptions.h"

#include "shared/Console.h"

#include <palpate/geometry/MeshCheck.h>
#include <palpate/study/SceneNotes.h>

#include <cstddef>

namespace palpate::app {

namespace {

/// Shortens a list of names: "liver, spleen, kidney and 3 more".
core::Message named(const std::vector<std::string>& names)
{
    constexpr std::size_t kMost = 3;
    std::string text;
    for (std::size_t i = 0; i < names.size() && i < kMost; ++i) {
        text += (i == 0 ? "" : ", ") + names[i];
    }
    return names.size() > kMost ? core::Message(PALPATE_TEXT("%1 and %2 more"), text, names.size() - kMost)
                                : core::Message(PALPATE_TEXT("%1"), text);
}

} // namespace

void SurfaceOptions::addTo(CLI::App& command)
{
    command.add_flag("--smooth", isSmoothed,
                     "Smooth the surfaces against the steps of voxels, by at most half a voxel; the files stay");
    command.add_flag("--curved", isCurved,
                     "Curve the facets between their normals (PN triangles); sharp edges and the files stay");
    command
        .add_option("--smoothing", smoothing,
                    "Strength of smoothing, by default 0.5 for label maps and 0.7 with --smooth; 0 leaves the steps")
        ->check(CLI::Range(0.0, 1.0));
    command.add_flag("--outwards", turnsOutwards, "Turn closed surfaces that are inside out; the files stay");
    command.add_option("--close-holes", closeHoles_mm, "Close holes of surfaces up to this size in mm; the files stay")
        ->check(CLI::Range(0.0, geometry::kMostCoordinate_mm));
}

void SurfaceOptions::applyTo(meshio::ReadOptions& read) const
{
    read.isSmoothed = isSmoothed;
    read.isCurved = isCurved;
    read.smoothing = smoothing;
    read.turnsOutwards = turnsOutwards;
    read.closeHoles_mm = closeHoles_mm;
}

std::vector<core::Message> surfaceNotes(const meshio::LoadedScene& scene, const haptics::HapticScene& felt)
{
    std::vector<std::string> insideOut, stepped;
    std::vector<core::Message> lines;
    for (std::size_t i = 0; i < scene.structures.size(); ++i) {
        const meshio::LoadedStructure& one = scene.structures[i];
        const std::string& name = one.description.name;
        if (one.closing) {
            lines.push_back({PALPATE_TEXT("%1: %2"), name, one.closing->message()});
        }
        if (one.smoothing) {
            lines.push_back({PALPATE_TEXT("%1: %2"), name, one.smoothing->sentence()});
        }
        if (one.curving) {
            lines.push_back({PALPATE_TEXT("%1: %2"), name, one.curving->message()});
        }
        if (felt.structures()[i].surface == nullptr && !one.isTransmitted) {
            continue;
        }
        if (one.surface->report.insideOutComponents > 0) {
            insideOut.push_back(name);
        }
        if (one.staircase && !one.smoothing) {
            lines.push_back({PALPATE_TEXT("%1: %2"), name, one.staircase->sentence()});
            stepped.push_back(name);
        }
    }
    if (!stepped.empty()) {
        lines.push_back(
            {PALPATE_TEXT("the steps of %1 are felt, with forces that are wrong by a multiple: --smooth smooths them"),
             named(stepped)});
    }
    if (!insideOut.empty()) {
        lines.push_back(
            insideOut.size() == 1
                ? core::Message(PALPATE_TEXT("1 surface is inside out and felt from within only: %1; --outwards turns "
                                             "closed surfaces outwards"),
                                named(insideOut))
                : core::Message(
                      PALPATE_TEXT("%1 surfaces are inside out and felt from within only: %2; --outwards turns "
                                   "closed surfaces outwards"),
                      insideOut.size(), named(insideOut)));
    }
    return lines;
}

std::vector<core::Message> printTouchNotes(const meshio::LoadedScene& scene, const haptics::HapticScene& felt)
{
    std::vector<core::Message> lines = surfaceNotes(scene, felt);
    for (core::Message& line : study::neighbourNotes(scene, felt)) {
        lines.push_back(std::move(line));
    }
    for (const core::Message& line : lines) {
        print("note: %s\n", line.english().c_str());
    }
    return lines;
}

} // namespace palpate::app
