// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Commands.h"
#include "reports/SessionReport.h"
#include "shared/Console.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/meshio/SceneFile.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/study/FindingsFile.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace palpate::app {

using core::Result;
using core::Status;
using core::StatusCode;

namespace {

struct FindingsOptions
{
    std::filesystem::path file, csv, markups, import, out;
};

constexpr const char* kStdout = "-";

/// Reads the findings of a scene file or recording. @param damage  gets the damage of a recording
Result<std::vector<core::Finding>> findingsIn(const std::filesystem::path& file, std::vector<core::Message>& damage)
{
    if (session::isRecordingByNameOrContent(file)) {
        const auto reader = session::RecordingReader::open(file);
        if (!reader.isOk()) {
            return reader.status();
        }
        damage = reader.value()->faults();
        return study::recordedFindings(*reader.value());
    }
    if (!meshio::isSceneFile(file)) {
        return Status(StatusCode::BadFormat,
                      PALPATE_TEXT("%1: found neither a scene nor a recording, expected a file that keeps findings "
                                   "(.palpate.json or .palpate)"),
                      file.filename());
    }
    auto scene = meshio::readScene(file);
    return scene.isOk() ? Result<std::vector<core::Finding>>(std::move(scene).value().findings)
                        : Result<std::vector<core::Finding>>(scene.status());
}

/// Writes to stdout or atomically to a file.
Status writeTo(const std::filesystem::path& path, const std::string& text)
{
    if (path != kStdout) {
        return core::writeAtomically(path, text);
    }
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size()
               ? Status()
               : Status(StatusCode::Unreadable, PALPATE_TEXT("stdout: the findings could not be written"));
}

void printFindings(const std::vector<core::Finding>& findings)
{
    print("%s finding%s\n", grouped(findings.size()).c_str(), findings.size() == 1 ? "" : "s");
    std::size_t number = 0;
    for (const core::Finding& one : findings) {
        print("%zu. %s (%s)", ++number, one.name.c_str(), one.hasPlace ? core::nameOf(one.type).data() : "note");
        if (!one.structure.empty()) {
            print(" on %s", one.structure.c_str());
            if (const std::string organ = study::organOf(one); !organ.empty()) {
                print(" in %s", organ.c_str());
            }
        }
        if (one.hasPlace) {
            print(" at (%.1f %.1f %.1f) mm", one.p_W.x(), one.p_W.y(), one.p_W.z());
        }
        if (one.size_mm) {
            print(", %.3g mm across", *one.size_mm);
        }
        if (one.force_N && one.depth_mm) {
            print(", %.4g N at %.4g mm", *one.force_N, *one.depth_mm);
        }
        if (one.recording) {
            print(", marked at %.1f s", one.recording->time_s);
        }
        print("%s%s\n", one.note.empty() ? "" : ": ", one.note.c_str());
    }
}

int runImport(const FindingsOptions& options)
{
    if (!meshio::isSceneFile(options.file)) {
        return report({StatusCode::BadCommandLine,
                       PALPATE_TEXT("findings --import: found %1, expected a scene (.palpate.json)"), options.file});
    }
    auto scene = meshio::readScene(options.file);
    if (!scene.isOk()) {
        return report(scene.status());
    }
    auto markups = study::readMarkups(options.import);
    if (!markups.isOk()) {
        return report(markups.status());
    }
    meshio::SceneFile& out = scene.value();
    const std::size_t count = markups.value().findings.size();
    for (core::Finding& finding : markups.value().findings) {
        const bool isTaken = std::any_of(out.findings.begin(), out.findings.end(),
                                         [&](const core::Finding& one) { return one.id == finding.id; });
        if (isTaken) {
            finding.id.clear();
        }
        out.findings.push_back(std::move(finding));
    }
    if (const Status status = meshio::writeScene(options.out, out); !status.isOk()) {
        return report(status);
    }
    print("%s: %s finding%s taken, %s in all\n", options.out.string().c_str(), grouped(count).c_str(),
          count == 1 ? "" : "s", grouped(out.findings.size()).c_str());
    return reportLosses(markups.value().losses);
}

int runFindings(const FindingsOptions& options)
{
    if (options.import.empty() != options.out.empty()) {
        return report(
            {StatusCode::BadCommandLine, PALPATE_TEXT("findings: found one of --import and --out, expected both: the "
                                                      "scene with what is taken is another file")});
    }
    if (options.csv == kStdout && options.markups == kStdout) {
        return report({StatusCode::BadCommandLine,
                       PALPATE_TEXT("findings: found - for --csv and --markups, expected it for one")});
    }
    const auto fileOf = [](const std::filesystem::path& path) {
        return path == kStdout ? std::filesystem::path() : path;
    };
    if (const Status status =
            checkOutputs({options.file, options.import}, {fileOf(options.csv), fileOf(options.markups), options.out});
        !status.isOk()) {
        return report(status);
    }
    if (!options.import.empty()) {
        if (!options.csv.empty() || !options.markups.empty()) {
            return report(
                {StatusCode::BadCommandLine,
                 PALPATE_TEXT(
                     "findings --import: found --csv or --markups too, expected --out alone: export from there")});
        }
        return runImport(options);
    }
    std::vector<core::Message> damage;
    const auto findings = findingsIn(options.file, damage);
    if (!findings.isOk()) {
        return report(findings.status());
    }
    if (!options.csv.empty()) {
        if (const Status status = writeTo(options.csv, study::findingsCsv(findings.value())); !status.isOk()) {
            return report(status);
        }
    }
    if (!options.markups.empty()) {
        if (const Status status = writeTo(options.markups, study::findingsMarkups(findings.value())); !status.isOk()) {
            return report(status);
        }
    }
    if (options.csv != kStdout && options.markups != kStdout) {
        printFindings(findings.value());
    }
    return reportDamage(options.file, damage, kDone);
}

} // namespace

void addFindingsCommand(CLI::App& app, Chosen& chosen)
{
    auto options = std::make_shared<FindingsOptions>();
    CLI::App* command =
        app.add_subcommand("findings", "List what was marked, write it for other programs, take markups of 3D Slicer");
    command->add_option("FILE", options->file, "Scene or recording")->required();
    command->add_option("--csv", options->csv, "Write a table, a row a finding; - is the standard output");
    command->add_option("--markups", options->markups,
                        "Write point lists for 3D Slicer (.mrk.json); - is the standard output");
    command->add_option("--import", options->import, "Take the points of a .mrk.json into the scene");
    command->add_option("--out", options->out, "Where the scene with them goes");
    command->callback([options, &chosen] { chosen = [options] { return runFindings(*options); }; });
}

} // namespace palpate::app
