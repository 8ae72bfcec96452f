// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Commands.h"
#include "commands/JsonOutput.h"
#include "commands/MeasureRun.h"
#include "reports/MeasuresReport.h"
#include "reports/SessionReport.h"
#include "shared/Console.h"
#include "shared/ProgressLine.h"

#include <palpate/study/FindingsFile.h>
#include <palpate/study/MeasureRecording.h>
#include <palpate/study/SessionExport.h>
#include <palpate/study/SessionTable.h>

#include <CLI/CLI.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace palpate::app {

using core::Status;
using core::StatusCode;
using session::RecordingReader;

core::Result<session::SessionMeasures> measureRecording(const RecordingReader& reader, const MeasureSettings& settings,
                                                        bool& isWhole)
{
    study::RecordingMeasureOptions how;
    how.scene = settings.scene;
    if (!settings.distance.empty()) {
        const auto distance = numberOption("--distance", settings.distance, {.isAbove = true});
        if (!distance.isOk()) {
            return distance.status();
        }
        how.distance_mm = distance.value();
    }
    auto measured = study::measureRecording(reader, how);
    if (!measured.isOk()) {
        return measured.status();
    }
    session::SessionMeasures measures = std::move(measured.value().measures);
    std::string names;
    for (const std::string& name : measures.unmeasured) {
        names += (names.empty() ? "" : ", ") + name;
    }
    isWhole = names.empty();
    if (!isWhole) {
        printError(PALPATE_TEXT("%1: no coverage of %2: %3; say where the scene is with --scene"), reader.path(), names,
                   measured.value().unmeasured);
    }
    return measures;
}

namespace {

struct MeasureCommandOptions
{
    std::vector<std::filesystem::path> files;
    std::filesystem::path json, csv, findings;
    MeasureSettings settings;
};

int measureOne(const MeasureCommandOptions& options)
{
    const std::filesystem::path& file = options.files.front();
    const auto opened = RecordingReader::open(file);
    if (!opened.isOk()) {
        return report(opened.status());
    }
    JsonOutput json;
    if (const Status status = json.open(options.json, {file, options.settings.scene}); !status.isOk()) {
        return report(status);
    }
    bool isWhole = true;
    const auto measures = measureRecording(*opened.value(), options.settings, isWhole);
    if (!measures.isOk()) {
        return report(measures.status());
    }
    if (!json.isPiped()) {
        printMeasures(measures.value());
    }
    if (const Status status = json.write(study::measuresJson(measures.value())); !status.isOk()) {
        return report(status);
    }
    return reportDamage(file, measures.value().damaged, isWhole ? kDone : kSomeLost);
}

/// Measures recordings one after the other and writes their tables.
class TableRun
{
  public:
    explicit TableRun(const MeasureCommandOptions& options)
        : m_options(options)
    {
    }

    int run()
    {
        const study::FoundRecordings found = study::findRecordings(m_options.files);
        m_code = reportLosses(found.losses);
        if (const Status status = open(found); !status.isOk()) {
            return report(status);
        }
        {
            ProgressLine line;
            for (std::size_t i = 0; i < found.recordings.size(); ++i) {
                if (found.recordings.size() > 1) {
                    line.show(static_cast<double>(i) / static_cast<double>(found.recordings.size()),
                              found.recordings[i].name);
                }
                measure(found.recordings[i]);
            }
        }
        if (m_measured == 0) {
            printError(PALPATE_TEXT("nothing written: found no recording that can be measured, expected at least one"));
            return kBadInput;
        }
        for (std::optional<core::AtomicFile>* file : {&m_csv, &m_findings}) {
            if (*file) {
                if (const Status status = (*file)->finish(); !status.isOk()) {
                    return report(status);
                }
            }
        }
        print("%s of %s sessions measured\n", grouped(static_cast<std::int64_t>(m_measured)).c_str(),
              grouped(static_cast<std::int64_t>(found.recordings.size())).c_str());
        return m_code;
    }

  private:
    Status open(const study::FoundRecordings& found)
    {
        std::vector<std::filesystem::path> inputs{m_options.settings.scene};
        for (const study::NamedRecording& one : found.recordings) {
            inputs.push_back(one.path);
        }
        if (Status status = checkOutputs(inputs, {m_options.csv, m_options.findings}); !status.isOk()) {
            return status;
        }
        const auto create = [](const std::filesystem::path& path, std::string head,
                               std::optional<core::AtomicFile>& out) {
            if (path.empty()) {
                return Status();
            }
            auto file = core::AtomicFile::create(path);
            if (file.isOk()) {
                out = std::move(file).value();
                out->write(head + "\r\n");
            }
            return file.status();
        };
        Status status = create(m_options.csv, study::kMeasureColumns, m_csv);
        return status.isOk() ? create(m_options.findings,
                                      std::string(study::kFindingSession) + ',' + study::kFindingColumns + ',' +
                                          study::kFindingMeasures,
                                      m_findings)
                             : status;
    }

    void measure(const study::NamedRecording& recording)
    {
        const auto opened = RecordingReader::open(recording.path);
        if (!opened.isOk()) {
            lose(opened.status());
            return;
        }
        bool isWhole = true;
        const auto measures = measureRecording(*opened.value(), m_options.settings, isWhole);
        if (!measures.isOk()) {
            lose(measures.status());
            return;
        }
        if (reportDamage(recording.path, measures.value().damaged, isWhole ? kDone : kSomeLost) != kDone) {
            m_code = kSomeLost;
        }
        const study::TableSession session = study::tableSession(*opened.value(), recording.name);
        if (m_csv) {
            m_csv->write(study::measureRows(session, measures.value()));
        }
        if (m_findings) {
            m_findings->write(study::findingRows(session, measures.value(), recording.path));
        }
        ++m_measured;
    }

    void lose(const Status& status)
    {
        (void)report(status);
        m_code = kSomeLost;
    }

    const MeasureCommandOptions& m_options;
    std::optional<core::AtomicFile> m_csv, m_findings;
    std::size_t m_measured = 0;
    int m_code = kDone;
};

int runMeasure(const MeasureCommandOptions& options)
{
    const bool hasTables = !options.csv.empty() || !options.findings.empty();
    std::error_code error;
    if (!hasTables && options.files.size() == 1 && !std::filesystem::is_directory(options.files.front(), error)) {
        return measureOne(options);
    }
    if (!hasTables) {
        return report({StatusCode::BadCommandLine,
                       PALPATE_TEXT("session measure: found several recordings or a folder, expected --csv or "
                                    "--findings for their tables")});
    }
    if (!options.json.empty()) {
        return report({StatusCode::BadCommandLine,
                       PALPATE_TEXT("session measure: found --json with --csv or --findings, expected one form")});
    }
    if (!options.settings.distance.empty()) { // once, not for each recording
        const auto distance = numberOption("--distance", options.settings.distance, {.isAbove = true});
        if (!distance.isOk()) {
            return report(distance.status());
        }
    }
    return TableRun(options).run();
}

} // namespace

void addMeasureCommand(CLI::App& session, Chosen& chosen)
{
    auto options = std::make_shared<MeasureCommandOptions>();
    CLI::App* command = session.add_subcommand("measure", "Say what the hand did, in numbers");
    command->add_option("FILE", options->files, "Recordings, or folders of them for the tables")->required();
    command->add_option("--json", options->json, "Write the measures as JSON; - for stdout, and nothing else there");
    command->add_option("--csv", options->csv, "Write a table: one row per session, structure and measure");
    command->add_option("--findings", options->findings, "Write a table: one row per finding");
    command->add_option("--scene", options->settings.scene, "Where the scene is that it was made on");
    command->add_option("--distance", options->settings.distance,
                        "How near the contact must come to count as touched [mm]; else the fingertip's radius, 5 for a "
                        "point");
    command->callback([options, &chosen] { chosen = [options] { return runMeasure(*options); }; });
}

} // namespace palpate::app
