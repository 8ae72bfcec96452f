// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/meshio/SceneFile.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::study {

/// How a structure was drawn while a recording was made, and how its surface was made of its mesh.
struct RecordedLook
{
    std::string name;
    std::array<double, 3> colour{}; ///< red, green, blue in 0 … 1
    double opacity = 1.0;           ///< 0 … 1
    bool outwards = false;          ///< see meshio::SceneStructure
    meshio::SurfaceKind surface = meshio::SurfaceKind::Facets;
    double smoothing = meshio::kUsualSmoothing;
};

/// Writes looks for RecordingInfo::looks, in the order of the recording's structures. See resources/docs/recording.md.
[[nodiscard]] std::string looksText(const std::vector<RecordedLook>& looks);
/// Reads them. @return as many as the text has; one that is not valid has no name and is to be left out.
[[nodiscard]] std::vector<RecordedLook> looksFrom(std::string_view text);
/// @return the look of a structure of a scene.
[[nodiscard]] RecordedLook lookOf(const meshio::SceneStructure& structure);

} // namespace palpate::study
