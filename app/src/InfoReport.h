// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/SurfaceExamination.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/study/BuriedLumps.h>

#include <QJsonObject>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace palpate::app {

/// What `palpate info` found out about one file.
struct FileReport
{
    std::filesystem::path path;
    meshio::LoadedScene scene;
    double load_s = 0.0;                                               ///< reading and repairing
    double index_s = 0.0;                                              ///< building the haptic copies
    std::vector<std::optional<geometry::SurfaceExamination>> examined; ///< one a structure; nothing where not palpable
    double examine_s = 0.0;
    std::vector<std::string> surfaceNotes; ///< about surfaces that are inside out or staircases, a sentence each
    std::vector<std::string> neighbours;   ///< about structures of all files that are in each other's way, likewise
    /// What lies in what among all files, a sentence each, where that was asked for.
    std::optional<std::vector<std::string>> layers;
    std::vector<study::FeltOrgan> lumps; ///< what can be felt of the lumps in organs
    std::vector<std::string> lumpNotes;  ///< organs and lumps that cannot be judged, a sentence each
    std::size_t touchBytes = 0;
    std::size_t touchTriangles = 0;
};

/// Prints for a person what was read, before anything is built of it.
void printRead(const FileReport& report);
/// Prints what touching costs, once that is possible.
void printTouch(const FileReport& report);
/// Prints what the examination found.
void printExamination(const FileReport& report);
/// The same as data, with the SHA-256 of each geometry; its fields are described in resources/docs/info.md.
[[nodiscard]] QJsonObject toJson(const FileReport& report);

} // namespace palpate::app
