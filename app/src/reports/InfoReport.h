// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Message.h>
#include <palpate/geometry/SurfaceExamination.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/study/BuriedLumps.h>
#include <palpate/study/Distances.h>

#include <QJsonObject>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace palpate::app {

/// Results of `palpate info` for one file.
struct FileReport
{
    std::filesystem::path path;
    meshio::LoadedScene scene;
    double load_s = 0.0;                                               ///< time for reading and repairing
    double index_s = 0.0;                                              ///< time for building the haptic surfaces
    std::vector<std::optional<geometry::SurfaceExamination>> examined; ///< per structure; empty if not palpable
    double examine_s = 0.0;
    std::vector<core::Message> surfaceNotes; ///< inverted or stair-stepped surfaces, one sentence each
    std::vector<core::Message> neighbours;   ///< structures of all files that obstruct each other, one sentence each
    /// Nesting of structures across all files, one sentence each, if requested.
    std::optional<std::vector<core::Message>> layers;
    std::vector<study::OrganPalpability> lumps;    ///< palpability of lumps in organs
    std::vector<core::Message> lumpNotes;          ///< organs and lumps that cannot be evaluated, one sentence each
    std::optional<study::DistanceTable> distances; ///< among the structures of all files of the scene, if requested
    std::size_t touchBytes = 0;
    std::size_t touchTriangles = 0;
};

/// Prints the file contents, before any processing.
void printRead(const FileReport& report);
/// Prints notes on the surfaces, memory and times, after the haptic surfaces were built.
void printTouch(const FileReport& report);
/// Prints the results of the examination, the verdicts on buried lumps, and all other notes.
void printExamination(const FileReport& report);
/// Converts the report to JSON, including the SHA-256 of each geometry. Fields: resources/docs/info.md.
[[nodiscard]] QJsonObject toJson(const FileReport& report);

} // namespace palpate::app
