// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"
#include "Console.h"
#include "InfoReport.h"
#include "LayersOption.h"

#include <palpate/meshio/MeshFormats.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/RecordedScene.h>

#include <CLI/CLI.hpp>
#include <QJsonArray>
#include <QJsonDocument>

#include <chrono>
#include <utility>

namespace palpate::app {

using core::Status;
using core::StatusCode;

namespace {

struct InfoOptions
{
    std::vector<std::filesystem::path> files;
    std::string unit = "mm", frame, layers;
    bool isPartial = false;
    bool isJson = false;
};

double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

core::Result<FileReport> examine(const std::filesystem::path& file, const meshio::ReadOptions& options, bool setsLayers)
{
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
        return Status(StatusCode::NotFound, file.string() + ": no such file, expected a mesh, a scene or a folder");
    }
    if (session::isRecordingFile(file)) {
        return Status(StatusCode::Unsupported,
                      file.string() + ": found a recording, expected a mesh (palpate session info reads recordings)");
    }
    FileReport report;
    report.path = file;
    auto start = std::chrono::steady_clock::now();
    auto loaded = study::openScene(file, options);
    if (!loaded.isOk()) {
        return loaded.status();
    }
    report.scene = std::move(loaded).value();
    report.load_s = secondsSince(start);
    start = std::chrono::steady_clock::now();
    auto scene = study::hapticScene(report.scene);
    report.index_s = secondsSince(start);
    if (setsLayers) {
        report.layers = layOut(file, report.scene, scene);
    }
    start = std::chrono::steady_clock::now();
    for (const auto& structure : scene->structures()) {
        report.examined.push_back(structure.surface != nullptr ? std::optional(geometry::examine(*structure.surface))
                                                               : std::nullopt);
    }
    report.examine_s = secondsSince(start);
    report.touchBytes = scene->byteSize();
    report.touchTriangles = study::triangleCount(*scene);
    return report;
}

int runMeshInfo(const InfoOptions& options)
{
    const auto unit = unitOption(options.unit);
    if (!unit.isOk()) {
        return report(unit.status());
    }
    const auto frame = frameOption(options.frame);
    if (!frame.isOk()) {
        return report(frame.status());
    }
    if (const Status status = checkLayers(options.layers); !status.isOk()) {
        return report(status);
    }
    meshio::ReadOptions read;
    read.unit_mm = unit.value();
    read.frame = frame.value();
    read.isPartial = options.isPartial;
    QJsonArray all;
    std::vector<std::string> losses;
    for (const auto& file : options.files) {
        const auto examined = examine(file, read, !options.layers.empty());
        if (!examined.isOk()) {
            return report(examined.status());
        }
        const std::vector<std::string>& lost = examined.value().scene.losses;
        losses.insert(losses.end(), lost.begin(), lost.end());
        if (options.isJson) {
            all.append(toJson(examined.value()));
        } else {
            printReport(examined.value());
        }
    }
    if (options.isJson) {
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
    command->add_flag("--partial", options->isPartial,
                      "Read what is whole of a file that was cut off; exit code 3 then");
    command->add_flag("--json", options->isJson, "Print the report as JSON");
    command->callback([options, &chosen] { chosen = [options] { return runMeshInfo(*options); }; });
}

} // namespace palpate::app
