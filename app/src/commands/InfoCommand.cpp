// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Commands.h"
#include "reports/DistancesReport.h"
#include "reports/InfoReport.h"
#include "shared/Console.h"
#include "shared/LayersOption.h"
#include "shared/SurfaceOptions.h"

#include <palpate/meshio/MeshFormats.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/study/Distances.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/study/SceneNotes.h>

#include <CLI/CLI.hpp>
#include <QJsonArray>
#include <QJsonDocument>

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace palpate::app {

using core::Status;
using core::StatusCode;

namespace {

struct InfoOptions
{
    std::vector<std::filesystem::path> files;
    std::string unit = "mm", frame, layers, bands = "5,10";
    SurfaceOptions surfaces;
    bool isPartial = false;
    bool isJson = false;
    bool hasDistances = false;
};

double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Intermediate data of one file.
struct Examined
{
    FileReport report;
    std::shared_ptr<const haptics::HapticScene> felt;
    std::vector<study::OrganPalpability> organs; ///< computed when the scene was opened
};

core::Result<Examined> readFile(const std::filesystem::path& file, const meshio::ReadOptions& options)
{
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
        return Status(StatusCode::NotFound, PALPATE_TEXT("%1: no such file, expected a mesh, a scene or a folder"),
                      file);
    }
    if (session::isRecordingByNameOrContent(file)) {
        return Status(StatusCode::Unsupported,
                      PALPATE_TEXT("%1: found a recording, expected a mesh (palpate session info reads recordings)"),
                      file);
    }
    Examined one;
    one.report.path = file;
    const auto start = std::chrono::steady_clock::now();
    auto loaded = study::openScene(file, options, &one.organs);
    if (!loaded.isOk()) {
        return loaded.status();
    }
    one.report.scene = std::move(loaded).value();
    one.report.load_s = secondsSince(start);
    return one;
}

void indexFile(Examined& one)
{
    const auto start = std::chrono::steady_clock::now();
    one.felt = study::hapticScene(one.report.scene);
    one.report.index_s = secondsSince(start);
    one.report.touchBytes = one.felt->byteSize();
    one.report.touchTriangles = study::triangleCount(*one.felt);
    one.report.surfaceNotes = surfaceNotes(one.report.scene, *one.felt);
    for (const meshio::LoadedStructure& structure : one.report.scene.structures) {
        const std::string name = structure.description.name + ": ";
        std::erase_if(one.report.surfaceNotes, [&name](const core::Message& note) { // already listed with the structure
            return note.english().starts_with(name);
        });
    }
}

void examineFile(Examined& one)
{
    const auto start = std::chrono::steady_clock::now();
    for (const auto& structure : one.felt->structures()) {
        one.report.examined.push_back(
            structure.surface != nullptr ? std::optional(geometry::examine(*structure.surface)) : std::nullopt);
    }
    one.report.examine_s = secondsSince(start);
    auto lumps = study::computePalpability(one.report.scene, std::move(one.organs), &one.report.lumpNotes);
    if (lumps.isOk()) {
        one.report.lumps = std::move(lumps).value();
    }
}

/// Groups files into scenes as the window does: files without layer information form one scene, each scene file its
/// own.
/// @return indices of the files of each scene
std::vector<std::vector<std::size_t>> scenesOf(const std::vector<Examined>& files)
{
    std::vector<std::vector<std::size_t>> scenes;
    std::vector<std::size_t> meshes;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (meshio::isSceneFile(files[i].report.path)) {
            scenes.push_back({i});
        } else {
            meshes.push_back(i);
        }
    }
    if (!meshes.empty()) {
        scenes.push_back(std::move(meshes));
    }
    return scenes;
}

/// Measures sizes, least distances and margins among the structures of several files.
study::DistanceTable distancesOf(const meshio::LoadedScene& scene, const haptics::HapticScene& felt,
                                 const std::vector<double>& limits_mm)
{
    std::vector<std::shared_ptr<const geometry::SurfaceIndex>> indices;
    for (const haptics::HapticStructure& structure : felt.structures()) {
        indices.push_back(structure.surface);
    }
    return study::measureDistances(scene, indices, limits_mm);
}

/// Computes the relations between structures of several files.
/// @param limits_mm  borders of the bands of margins; empty: no distances
void compareFiles(std::vector<Examined>& files, const std::vector<std::size_t>& numbers, bool setsLayers,
                  const std::vector<double>& limits_mm)
{
    meshio::LoadedScene together;
    std::vector<haptics::HapticStructure> structures;
    for (const std::size_t i : numbers) {
        const meshio::LoadedScene& one = files[i].report.scene;
        together.structures.insert(together.structures.end(), one.structures.begin(), one.structures.end());
        together.scene.structures.insert(together.scene.structures.end(), one.scene.structures.begin(),
                                         one.scene.structures.end());
        together.scene.tapes.insert(together.scene.tapes.end(), one.scene.tapes.begin(), one.scene.tapes.end());
        structures.insert(structures.end(), files[i].felt->structures().begin(), files[i].felt->structures().end());
    }
    auto felt = std::make_shared<const haptics::HapticScene>(std::move(structures));
    std::optional<std::vector<core::Message>> layers;
    if (setsLayers) {
        layers = layOut(files[numbers.front()].report.path, together, felt);
    }
    const std::vector<core::Message> notes = study::neighbourNotes(together, *felt);
    std::optional<study::DistanceTable> distances;
    if (!limits_mm.empty()) {
        distances = distancesOf(together, *felt, limits_mm);
    }
    std::size_t next = 0;
    for (const std::size_t i : numbers) {
        for (meshio::LoadedStructure& structure : files[i].report.scene.structures) {
            structure.description.layer = together.structures[next++].description.layer;
        }
        files[i].report.layers = layers;
        files[i].report.neighbours = notes;
        files[i].report.distances = distances;
    }
}

void printComparison(const std::vector<Examined>& files, const std::vector<std::size_t>& numbers)
{
    const FileReport& first = files[numbers.front()].report;
    for (const core::Message& line : first.layers.value_or(std::vector<core::Message>())) {
        print("  layers: %s\n", line.english().c_str());
    }
    for (const core::Message& line : first.neighbours) {
        print("  note: %s\n", line.english().c_str());
    }
    if (first.distances) {
        printDistances(*first.distances);
    }
}

core::Result<meshio::ReadOptions> readOptions(const InfoOptions& options)
{
    const auto unit = unitOption(options.unit);
    const auto frame = frameOption(options.frame);
    for (const Status& status : {unit.status(), frame.status(), checkLayers(options.layers)}) {
        if (!status.isOk()) {
            return status;
        }
    }
    meshio::ReadOptions read;
    read.unit_mm = unit.value();
    read.frame = frame.value();
    read.isPartial = options.isPartial;
    options.surfaces.applyTo(read);
    return read;
}

int runMeshInfo(const InfoOptions& options)
{
    const auto read = readOptions(options);
    if (!read.isOk()) {
        return report(read.status());
    }
    const auto bands = bandsOption(options.bands);
    if (!bands.isOk()) {
        return report(bands.status());
    }
    // Print available results immediately: the examination takes much longer than all previous steps.
    const auto show = [&options](void (*part)(const FileReport&), const Examined& one) {
        if (!options.isJson) {
            part(one.report);
            std::fflush(stdout);
        }
    };
    std::vector<Examined> files;
    std::vector<core::Message> losses;
    for (const auto& file : options.files) {
        auto one = readFile(file, read.value());
        if (!one.isOk()) {
            return report(one.status());
        }
        files.push_back(std::move(one).value());
        const std::vector<core::Message>& lost = files.back().report.scene.losses;
        losses.insert(losses.end(), lost.begin(), lost.end());
        show(printRead, files.back());
        indexFile(files.back());
        show(printTouch, files.back());
        examineFile(files.back());
        show(printExamination, files.back());
    }
    for (const std::vector<std::size_t>& numbers : scenesOf(files)) {
        compareFiles(files, numbers, !options.layers.empty(),
                     options.hasDistances ? bands.value() : std::vector<double>());
        if (!options.isJson) {
            printComparison(files, numbers);
        }
    }
    if (options.isJson) {
        QJsonArray all;
        for (const Examined& one : files) {
            all.append(toJson(one.report));
        }
        printJson(QJsonDocument(all).toJson().toStdString());
    }
    return reportLosses(losses);
}

} // namespace

void addInfoCommand(CLI::App& app, Chosen& chosen)
{
    auto options = std::make_shared<InfoOptions>();
    CLI::App* command = app.add_subcommand("info", "Health report of meshes: what they hold and how they will feel");
    command
        ->add_option("FILE", options->files,
                     "Mesh files (" + meshio::meshFormatNames("or") + "), scene files or folders of meshes")
        ->required();
    command->add_option("--unit", options->unit, "Unit of a mesh file's numbers: m, cm or mm")->capture_default_str();
    command->add_option("--frame", options->frame, kFrameHelp);
    command->add_option("--layers", options->layers, kLayersHelp);
    options->surfaces.addTo(*command);
    command->add_flag("--partial", options->isPartial,
                      "Read what is whole of a file that was cut off; exit code 3 then");
    auto* distances = command->add_flag("--distances", options->hasDistances,
                                        "Also sizes, least distances, and margins of lumps to other structures");
    command->add_option("--bands", options->bands, "Borders of the bands of the margins [mm], ascending")
        ->needs(distances)
        ->capture_default_str();
    command->add_flag("--json", options->isJson, "Print the report as JSON");
    command->callback([options, &chosen] { chosen = [options] { return runMeshInfo(*options); }; });
}

} // namespace palpate::app
