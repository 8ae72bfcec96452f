// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/meshio/SceneFile.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::study {

/// Appearance of a structure during a recording, the conversion of the mesh to a surface, and how the structure is a
/// lump of an organ. A lump felt through its organ has no contact surface, so the recorded scene itself does not name
/// the lump.
struct RecordedLook
{
    std::string name;
    std::array<double, 3> colour{}; ///< RGB, 0 … 1
    double opacity = 1.0;           ///< 0 … 1
    bool outwards = false;          ///< see meshio::SceneStructure
    meshio::SurfaceKind surface = meshio::SurfaceKind::Facets;
    double smoothing = meshio::kDefaultSmoothing;
    double crease_deg = meshio::kDefaultCrease_deg;
    double closeHoles_mm = 0.0; ///< [mm]
    std::string inside{};       ///< name of the organ; empty: not a lump, or not named
    std::optional<double> youngRatio{}, young_kPa{}, feltContactRadius_mm{}; ///< see meshio::SceneStructure
};

/// Serializes looks for RecordingInfo::looks, in the order of the recording's structures. See
/// docs/recording.md.
[[nodiscard]] PALPATE_EXPORT std::string looksText(const std::vector<RecordedLook>& looks);
/// Parses the output of `looksText`. @return one entry per structure; invalid entries have no name and must be ignored
[[nodiscard]] PALPATE_EXPORT std::vector<RecordedLook> looksFrom(std::string_view text);
/// Returns the look of a structure of a scene.
[[nodiscard]] PALPATE_EXPORT RecordedLook lookOf(const meshio::SceneStructure& structure);

} // namespace palpate::study
