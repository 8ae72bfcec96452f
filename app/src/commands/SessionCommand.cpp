// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Commands.h"
#include "commands/JsonOutput.h"
#include "commands/MeasureRun.h"
#include "reports/ComparisonReport.h"
#include "reports/ExerciseReport.h"
#include "reports/SessionReport.h"
#include "shared/Console.h"

#include <palpate/meshio/SceneFile.h>
#include <palpate/session/MeasureSession.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/Recovery.h>
#include <palpate/session/Replay.h>
#include <palpate/session/SharedCopy.h>
#include <palpate/study/CompareRecordings.h>
#include <palpate/study/ExerciseScore.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/study/SessionExport.h>
#include <palpate/study/StructureSources.h>

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace palpate::app {

using core::Status;
using core::StatusCode;
using session::RecordingReader;

namespace {

struct SessionOptions
{
    std::filesystem::path file, second, scene, csv, vtp, json, out;
    std::string distance;  ///< empty: fingertip radius of the recording
    std::string within;    ///< of a target; empty: default
    bool isForced = false; ///< allows replacing files
    std::vector<std::string> columns;
};

int runInfo(const SessionOptions& options)
{
    const auto reader = RecordingReader::open(options.file);
    if (!reader.isOk()) {
        return report(reader.status());
    }
    printRecording(options.file, *reader.value());
    return reportDamage(options.file, reader.value()->faults(), kDone);
}

int runVerify(const SessionOptions& options)
{
    const auto opened = RecordingReader::open(options.file);
    if (!opened.isOk()) {
        return report(opened.status());
    }
    const RecordingReader& reader = *opened.value();
    if (const Status status = reader.verify(); !status.isOk()) {
        printError(status.text());
        return kFailed;
    }
    print("%s: database sound, checksums of %s ticks right\n", options.file.string().c_str(),
          grouped(reader.extent().ticks).c_str());
    const auto surfaces = study::recordedSurfaces(reader, options.scene);
    if (!surfaces.isOk()) {
        if (!options.scene.empty()) {
            return report(surfaces.status());
        }
        printError(PALPATE_TEXT("not computed again: %1; say where the scene is with --scene"),
                   surfaces.status().text());
        return kSomeLost;
    }
    const auto result = session::resimulate(reader, study::indexedByHash(surfaces.value()));
    if (!result.isOk()) {
        return report(result.status().at(options.file));
    }
    const session::Resimulation& again = result.value();
    if (const int code = reportAgreement(options.file, reader.info(), again); code != kDone) {
        return code;
    }
    if (reader.extent().dropped > 0 || again.unverified > 0) {
        printError(PALPATE_TEXT("%1: %2 ticks are missing and %3 after them could not be computed again"), options.file,
                   reader.extent().dropped, again.unverified);
        return kSomeLost;
    }
    return kDone;
}

/// Checks the name of a copy, which may replace a recording.
Status checkCopy(const SessionOptions& options)
{
    if (Status status = checkOutputs({options.file}, {options.out}); !status.isOk()) {
        return status;
    }
    std::error_code error;
    const bool isThere = std::filesystem::is_regular_file(std::filesystem::symlink_status(options.out, error));
    if (isThere && !options.isForced && std::filesystem::file_size(options.out, error) > 0 &&
        !session::isRecordingFile(options.out)) {
        return {StatusCode::BadCommandLine,
                PALPATE_TEXT("%1: found a file that is no recording, expected another name for the copy, or --force to "
                             "replace it"),
                options.out};
    }
    return {};
}

int runRecover(const SessionOptions& options)
{
    if (const Status status = checkCopy(options); !status.isOk()) {
        return report(status);
    }
    const auto recovered = session::recoverRecording(options.file, options.out);
    if (!recovered.isOk()) {
        return report(recovered.status());
    }
    print("%s: %s ticks recovered\n", options.out.string().c_str(), grouped(recovered.value().ticks).c_str());
    for (const core::Message& loss : recovered.value().losses) {
        printError(PALPATE_TEXT("%1: %2"), options.file, loss);
    }
    return recovered.value().losses.empty() ? kDone : kSomeLost;
}

int runCompare(const SessionOptions& options)
{
    study::CompareOptions how;
    how.scene = options.scene;
    if (!options.distance.empty()) {
        const auto distance = numberOption("--distance", options.distance, {.isAbove = true});
        if (!distance.isOk()) {
            return report(distance.status());
        }
        how.distance_mm = distance.value();
    }
    JsonOutput json;
    if (const Status status = json.open(options.json, {options.file, options.second, options.scene}); !status.isOk()) {
        return report(status);
    }
    const auto compared = study::compareRecordings(options.file, options.second, how);
    if (!compared.isOk()) {
        return report(compared.status());
    }
    if (!json.isPiped()) {
        print("A: %s\nB: %s\n", options.file.string().c_str(), options.second.string().c_str());
        printCompared(compared.value());
    }
    if (const Status status = json.write(study::comparisonJson(compared.value())); !status.isOk()) {
        return report(status);
    }
    return reportLosses(compared.value().missing);
}

/// Reads the exercise of the scene that a recording was made on.
core::Result<meshio::Exercise> exerciseOf(const RecordingReader& reader, const SessionOptions& options)
{
    const auto scene =
        options.scene.empty() ? study::recordedSceneFile(reader) : std::optional<std::filesystem::path>(options.scene);
    if (!scene || !meshio::isSceneFile(*scene)) {
        return Status(StatusCode::NotFound,
                      PALPATE_TEXT("%1: found no scene file with an exercise; say where it is with --scene"),
                      options.file);
    }
    const auto read = meshio::readScene(*scene);
    if (!read.isOk()) {
        return read.status();
    }
    if (!read.value().exercise) {
        return Status(StatusCode::NotFound,
                      PALPATE_TEXT("%1: exercise: found nothing, expected the targets of an exercise"), *scene);
    }
    return *read.value().exercise;
}

core::Result<study::ExerciseScore> scored(const RecordingReader& reader, const SessionOptions& options)
{
    const auto exercise = exerciseOf(reader, options);
    if (!exercise.isOk()) {
        return exercise.status();
    }
    const auto surfaces = study::recordedSurfaces(reader, options.scene);
    if (!surfaces.isOk()) {
        return surfaces.status();
    }
    study::ExerciseOptions how;
    how.coverageDistance_mm = study::defaultDistance_mm(reader, surfaces.value());
    const std::pair<const char*, double*> distances[]{{"--distance", &how.coverageDistance_mm},
                                                      {"--within", &how.within_mm}};
    for (const auto& [name, value] : distances) {
        const std::string& text = value == &how.within_mm ? options.within : options.distance;
        if (!text.empty()) {
            const auto number = numberOption(name, text, {.isAbove = true});
            if (!number.isOk()) {
                return number.status();
            }
            *value = number.value();
        }
    }
    return study::scoreExercise(reader, surfaces.value(), exercise.value(), how);
}

int runShare(const SessionOptions& options)
{
    if (const Status status = checkCopy(options); !status.isOk()) {
        return report(status);
    }
    const auto shared = session::shareRecording(options.file, options.out);
    if (!shared.isOk()) {
        return report(shared.status());
    }
    print("%s: %s ticks copied without the names of folders\n", options.out.string().c_str(),
          grouped(shared.value()).c_str());
    return kDone;
}

int runExercise(const SessionOptions& options)
{
    const auto opened = RecordingReader::open(options.file);
    if (!opened.isOk()) {
        return report(opened.status());
    }
    JsonOutput json;
    if (const Status status = json.open(options.json, {options.file, options.scene}); !status.isOk()) {
        return report(status);
    }
    const auto score = scored(*opened.value(), options);
    if (!score.isOk()) {
        return report(score.status());
    }
    if (!json.isPiped()) {
        printExercise(score.value());
    }
    if (const Status status = json.write(study::exerciseJson(score.value())); !status.isOk()) {
        return report(status);
    }
    for (const std::string& name : score.value().unmeasured) {
        printError(PALPATE_TEXT("%1: no coverage of %2: its surface is missing or another one now; say where the scene "
                                "is with --scene"),
                   options.file, name);
    }
    return reportDamage(options.file, score.value().damaged, score.value().unmeasured.empty() ? kDone : kSomeLost);
}

int exportAll(const SessionOptions& options, const RecordingReader& reader)
{
    if (options.csv.empty() && options.vtp.empty()) {
        return report(
            {StatusCode::BadCommandLine, PALPATE_TEXT("session export: found no output, expected --csv or --vtp")});
    }
    if (options.csv.empty() && !options.columns.empty()) {
        return report({StatusCode::BadCommandLine,
                       PALPATE_TEXT("--columns: found no --csv, expected the file with these columns")});
    }
    // Path and touched surface are separate data sets, so each gets its own file.
    const std::filesystem::path surface = study::surfaceFileOf(options.vtp);
    std::vector<std::filesystem::path> outputs;
    if (!options.csv.empty()) {
        outputs.push_back(options.csv);
    }
    if (!options.vtp.empty()) {
        outputs.insert(outputs.end(), {options.vtp, surface});
    }
    if (const Status status = checkOutputs({options.file, options.scene}, outputs); !status.isOk()) {
        return report(status);
    }
    if (!options.vtp.empty()) {
        if (const Status status = study::checkSurfaceFile(surface); !status.isOk()) {
            return report(status);
        }
    }
    if (!options.csv.empty()) {
        if (const Status status = study::exportTicks(reader, options.csv, {}, options.columns); !status.isOk()) {
            return report(status);
        }
    }
    if (options.vtp.empty()) {
        return kDone;
    }
    if (const Status status = study::exportPath(reader, options.vtp); !status.isOk()) {
        return report(status);
    }
    bool isWhole = true;
    const auto measures = measureRecording(reader, {options.scene, options.distance}, isWhole);
    Status status = measures.isOk() ? study::exportSurface(measures.value(), surface) : measures.status();
    if (status.code() == StatusCode::Empty) {
        printError(status.text());
        return kSomeLost;
    }
    return !status.isOk() ? report(status) : isWhole ? kDone : kSomeLost;
}

int runExport(const SessionOptions& options)
{
    const auto opened = RecordingReader::open(options.file);
    if (!opened.isOk()) {
        return report(opened.status());
    }
    const int code = exportAll(options, *opened.value());
    return reportDamage(options.file, opened.value()->faults(), code);
}

} // namespace

void addSessionCommand(CLI::App& app, Chosen& chosen)
{
    auto options = std::make_shared<SessionOptions>();
    CLI::App* command = app.add_subcommand("session", "Look into a recording (*.palpate)");
    command->require_subcommand(1);
    const auto add = [&](const char* name, const char* help, int (*run)(const SessionOptions&)) {
        CLI::App* sub = command->add_subcommand(name, help);
        sub->add_option("FILE", options->file, "Recording")->required();
        sub->callback([options, &chosen, run] { chosen = [options, run] { return run(*options); }; });
        return sub;
    };
    add("info", "Say what it holds", runInfo);
    add("verify", "Check every bit, then compute it again and compare", runVerify)
        ->add_option("--scene", options->scene, "Where the scene is that it was made on");
    CLI::App* recover = add("recover", "Make the best readable copy of a damaged or cut-off one", runRecover);
    recover->add_option("--out", options->out, "Where the copy goes; an older recording there is replaced")->required();
    recover->add_flag("--force", options->isForced, "Replace a file that is no recording, too");
    CLI::App* share = add("share", "Copy it without the names of folders, to give to others", runShare);
    share->add_option("--out", options->out, "Where the copy goes; an older recording there is replaced")->required();
    share->add_flag("--force", options->isForced, "Replace a file that is no recording, too");
    const auto addSurfaceOptions = [&](CLI::App* sub) {
        sub->add_option("--scene", options->scene, "Where the scene is that it was made on");
        sub->add_option("--distance", options->distance,
                        "How near the contact must come to count as touched [mm]; else the fingertip's radius, 5 for a "
                        "point");
    };
    addMeasureCommand(*command, chosen);
    CLI::App* compare = add("compare", "Compare two recordings of the same surfaces", runCompare);
    compare->add_option("SECOND", options->second, "Second recording")->required();
    compare->add_option("--json", options->json, "Write the comparison as JSON; - for stdout, and nothing else there");
    addSurfaceOptions(compare);
    CLI::App* exercise = add("exercise", "Score a search for the hidden targets of the scene", runExercise);
    exercise->add_option("--json", options->json, "Write the score as JSON; - for stdout, and nothing else there");
    exercise->add_option("--within", options->within,
                         "How far from a target a finding may lie to count as found [mm]; else 10");
    addSurfaceOptions(exercise);
    CLI::App* exporter = add("export", "Write its ticks, path and touched surface in other forms", runExport);
    exporter->add_option("--csv", options->csv, "Write the ticks as CSV");
    exporter->add_option("--columns", options->columns, "Write only these columns of the CSV, as time_s,force_N")
        ->delimiter(',')
        ->allow_extra_args(false);
    exporter->add_option("--vtp", options->vtp,
                         "Write the path as VTP, and the touched surface beside it as NAME-surface.vtp");
    addSurfaceOptions(exporter);
    addReportCommand(*command, chosen);
}

} // namespace palpate::app
