// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Commands.h"
#include "shared/Console.h"
#include "shared/ProgressLine.h"
#include "shared/QtSetup.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/study/Report.h>
#include <palpate/ui/ReportFile.h>
#include <palpate/ui/ReportViews.h>
#include <palpate/ui/Theme.h>

#include <CLI/CLI.hpp>

#include <QFont>
#include <QGuiApplication>
#include <QImage>
#include <QLocale>

#include <clocale>
#include <filesystem>
#include <memory>
#include <vector>

namespace palpate::app {

using core::Status;

namespace {

struct ReportCommandOptions
{
    std::filesystem::path file, out;
    study::ReportOptions report;
};

Status checkReportOutput(const ReportCommandOptions& options)
{
    if (!ui::reportFormatOf(options.out)) {
        return {core::StatusCode::BadCommandLine,
                PALPATE_TEXT("--out: found \"%1\", expected a name that ends in .pdf or .html"), options.out};
    }
    if (Status status = checkOutputs({options.file, options.report.scene}, {options.out}); !status.isOk()) {
        return status;
    }
    return core::AtomicFile::create(options.out).status(); // before the work, which takes a while
}

/// Draws the pictures of a report. @return null pictures, and the reason, if there is no display with OpenGL
std::vector<QImage> drawPictures(const study::ReportFacts& facts, study::Report& report, core::Message& unpictured,
                                 ProgressLine& line)
{
    if (facts.scene == nullptr) {
        return {};
    }
    auto views = ui::ReportViews::create(facts);
    if (!views.isOk()) {
        unpictured = views.status().text();
        report = study::composeReport(facts, unpictured);
        return {};
    }
    std::vector<QImage> pictures;
    for (std::size_t i = 0; i < report.views.size(); ++i) {
        line.show(static_cast<double>(i) / static_cast<double>(report.views.size()), "Drawing the pictures");
        pictures.push_back(views.value()->draw(report, i));
    }
    return pictures;
}

int runReport(const ReportCommandOptions& options)
{
    if (const Status status = checkReportOutput(options); !status.isOk()) {
        return report(status);
    }
    auto line = std::make_unique<ProgressLine>();
    study::ReportOptions how = options.report;
    how.progress = [&line](double share, const core::Message& step) { line->show(share, step.english()); };
    const auto facts = study::gatherReport(options.file, how);
    if (!facts.isOk()) {
        line.reset();
        return report(facts.status());
    }
    // Fonts and OpenGL without a window, so that a display is not required. With an X server, pictures are drawn.
    qputenv("QT_QPA_PLATFORM", "offscreen");
    useUtf8();
    const RuntimeFolder runtimeFolder;
    int argc = 1;
    char name[] = "palpate";
    char* argv[] = {name, nullptr};
    const QGuiApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C"); // Qt has set the locale of the user; the command line writes English
    QLocale::setDefault(QLocale::c());
    ui::setViewFont(boldFontFile(QGuiApplication::font()));

    study::Report content = study::composeReport(facts.value());
    core::Message unpictured;
    const std::vector<QImage> pictures = drawPictures(facts.value(), content, unpictured, *line);
    const Status written = ui::writeReport(options.out, content, pictures);
    line.reset();
    if (!written.isOk()) {
        return report(written);
    }
    print("%s: report of %s\n", options.out.string().c_str(), options.file.string().c_str());
    std::vector<core::Message> losses = facts.value().missing;
    if (!unpictured.isEmpty()) {
        losses.push_back({PALPATE_TEXT("This report has no pictures: %1."), unpictured});
    }
    return reportLosses(losses);
}

} // namespace

void addReportCommand(CLI::App& session, Chosen& chosen)
{
    auto options = std::make_shared<ReportCommandOptions>();
    CLI::App* command = session.add_subcommand("report", "Write a report for the patient's folder as PDF or HTML");
    command->add_option("FILE", options->file, "Recording")->required();
    command->add_option("--out", options->out, "Where the report goes: a name that ends in .pdf or .html")->required();
    command->add_option("--scene", options->report.scene, "Where the scene is that it was made on");
    command->add_option("--case", options->report.caseText, "Text for the field \"Case\"");
    command->add_option("--examiner", options->report.examiner, "Text for the field \"Examiner\"");
    command->callback([options, &chosen] { chosen = [options] { return runReport(*options); }; });
}

} // namespace palpate::app
