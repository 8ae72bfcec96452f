// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"
#include "Console.h"
#include "RecordedScene.h"
#include "SessionReport.h"

#include <palpate/session/AtomicFile.h>
#include <palpate/session/Measures.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/Recovery.h>
#include <palpate/session/Replay.h>
#include <palpate/session/TickCsv.h>

#include <CLI/CLI.hpp>

#include <limits>
#include <memory>
#include <optional>

namespace palpate::app {

using core::Status;
using core::StatusCode;
using session::RecordingReader;

namespace {

struct SessionOptions
{
    std::filesystem::path file, scene, csv, json, out;
};

constexpr std::int64_t kFirst = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t kLast = std::numeric_limits<std::int64_t>::max();

int runInfo(const SessionOptions& options)
{
    const auto reader = RecordingReader::open(options.file);
    if (!reader.isOk()) {
        return report(reader.status());
    }
    printRecording(options.file, *reader.value());
    return kDone;
}

int runVerify(const SessionOptions& options)
{
    const auto opened = RecordingReader::open(options.file);
    if (!opened.isOk()) {
        return report(opened.status());
    }
    const RecordingReader& reader = *opened.value();
    if (const Status status = reader.verify(); !status.isOk()) {
        printError(status.message());
        return kFailed;
    }
    print("%s: database sound, checksums of %s ticks right\n", options.file.string().c_str(),
          grouped(reader.extent().ticks).c_str());
    const auto surfaces = recordedSurfaces(reader, options.scene);
    if (!surfaces.isOk()) {
        if (!options.scene.empty()) {
            return report(surfaces.status());
        }
        printError("not computed again: " + surfaces.status().message() + "; say where the scene is with --scene");
        return kSomeLost;
    }
    const auto result = session::resimulate(reader, indexed(surfaces.value()));
    if (!result.isOk()) {
        return report({result.status().code(), options.file.string() + ": " + result.status().message()});
    }
    const session::Resimulation& again = result.value();
    if (!again.isSame()) {
        printError(options.file.string() + ": " + again.difference + builtDifferently(reader.info()));
        return kFailed;
    }
    print("%s ticks computed again: every god-object and force is the same bit for bit\n",
          grouped(again.compared).c_str());
    if (reader.extent().dropped > 0 || again.unverified > 0) {
        printError(options.file.string() + ": " + std::to_string(reader.extent().dropped) + " ticks are missing and " +
                   std::to_string(again.unverified) + " after them could not be computed again");
        return kSomeLost;
    }
    return kDone;
}

int runRecover(const SessionOptions& options)
{
    if (const Status status = checkOutputs({options.file}, {options.out}); !status.isOk()) {
        return report(status);
    }
    const auto recovered = session::recoverRecording(options.file, options.out);
    if (!recovered.isOk()) {
        return report(recovered.status());
    }
    print("%s: %s ticks recovered\n", options.out.string().c_str(), grouped(recovered.value().ticks).c_str());
    for (const std::string& loss : recovered.value().losses) {
        printError(options.file.string() + ": missing in the copy: " + loss);
    }
    return recovered.value().losses.empty() ? kDone : kSomeLost;
}

int runMeasure(const SessionOptions& options)
{
    const auto opened = RecordingReader::open(options.file);
    if (!opened.isOk()) {
        return report(opened.status());
    }
    if (const Status status = checkOutputs({options.file}, {options.json}); !status.isOk()) {
        return report(status);
    }
    std::optional<session::AtomicFile> json;
    if (!options.json.empty()) {
        auto file = session::AtomicFile::create(options.json);
        if (!file.isOk()) {
            return report(file.status());
        }
        json = std::move(file).value();
    }
    const RecordingReader& reader = *opened.value();
    session::MeasureAccumulator measures(reader.info().dt_s);
    const Status status = reader.forEach(kFirst, kLast, [&](const servo::TickRecord& tick) {
        measures.add(tick, reader.structureName(tick));
        return true;
    });
    if (!status.isOk()) {
        return report(status);
    }
    printMeasures(measures.result());
    if (json) {
        json->write(measuresJson(measures.result()));
        return report(json->finish());
    }
    return kDone;
}

int runExport(const SessionOptions& options)
{
    const auto opened = RecordingReader::open(options.file);
    if (!opened.isOk()) {
        return report(opened.status());
    }
    if (const Status status = checkOutputs({options.file}, {options.csv}); !status.isOk()) {
        return report(status);
    }
    auto csv = session::TickCsv::create(options.csv);
    if (!csv.isOk()) {
        return report(csv.status());
    }
    const RecordingReader& reader = *opened.value();
    const Status status = reader.forEach(kFirst, kLast, [&](const servo::TickRecord& tick) {
        if ((tick.flags & servo::kNoHand) == 0) {
            const std::string name = reader.structureName(tick);
            csv.value().write({tick.tick, tick.p_WH, tick.p_WG, tick.f_W, tick.constraints, name, tick.solve_ns});
        }
        return true;
    });
    return report(status.isOk() ? csv.value().finish() : status);
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
    add("recover", "Make the best readable copy of a damaged or cut-off one", runRecover)
        ->add_option("--out", options->out, "Where the copy goes")
        ->required();
    add("measure", "Say what the hand did, in numbers", runMeasure)
        ->add_option("--json", options->json, "Write the measures as JSON");
    add("export", "Write its ticks in another form", runExport)
        ->add_option("--csv", options->csv, "Write the ticks as CSV")
        ->required();
}

} // namespace palpate::app
