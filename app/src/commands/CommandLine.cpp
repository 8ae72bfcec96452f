// SPDX-License-Identifier: BSD-3-Clause
#include "commands/CommandLine.h"

#include "commands/Commands.h"
#include "commands/HandOver.h"
#include "shared/Console.h"
#include "shared/Devices.h"
#include "shared/Program.h"
#include "shared/SurfaceOptions.h"
#include "window/Window.h"

#include <palpate/meshio/MeshFormats.h>
#include <palpate/servo/RealtimeSetup.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>

namespace palpate {

namespace {

struct WindowCommandLine
{
    WindowOptions options;
    std::string unit = "mm";
    std::string frame;
    app::SurfaceOptions surfaces;
    std::string screenshot;
    std::string size;
};

void addWindowOptions(CLI::App& app, WindowCommandLine& line)
{
    app.add_option("FILE", line.options.files,
                   "Meshes (" + meshio::meshFormatNames("or") + ") or a scene to open, and a recording to play");
    app.add_option("--unit", line.unit, "Unit of a mesh file's numbers: m, cm or mm")->capture_default_str();
    app.add_option("--frame", line.frame, app::kFrameHelp);
    line.surfaces.addTo(app);
    app.add_option("--device", line.options.device, "The hand's device: mouse, simulated, playback or a plugin's");
    app.add_option("--plugin-path", line.options.pluginFolders, "Folder to look for device plugins in first")
        ->allow_extra_args(false);
    app.add_option("--cpu", line.options.cpu, "CPU that the servo loop runs on alone, from 0; -1: any");
    app.add_option("--screenshot", line.screenshot, "Touch the scene with a scripted hand, write a PNG and exit");
    app.add_option("--size", line.size, "Size of the screenshot, as 1280x800");
    app.add_flag("--dark", line.options.darkPalette, "Dark palette for the screenshot");
}

int openWindow(int argc, char** argv, WindowCommandLine& line)
{
    const auto unit = app::unitOption(line.unit);
    if (!unit.isOk()) {
        return app::report(unit.status());
    }
    line.options.read.unit_mm = unit.value();
    const auto frame = app::frameOption(line.frame);
    if (!frame.isOk()) {
        return app::report(frame.status());
    }
    line.options.read.frame = frame.value();
    line.surfaces.applyTo(line.options.read);
    for (const auto& file : line.options.files) {
        std::error_code error;
        if (!std::filesystem::exists(file, error)) {
            app::printError(PALPATE_TEXT("%1: no such file, expected a mesh, a scene or a recording"), file);
            return app::kBadInput;
        }
    }
    if (const core::Status status = app::checkPluginFolders(line.options.pluginFolders); !status.isOk()) {
        return app::report(status);
    }
    if (const core::Status status = servo::checkCpu(line.options.cpu.value_or(-1)); !status.isOk()) {
        return app::report(status);
    }
    if (!line.screenshot.empty()) {
        if (const core::Status status = app::checkOutputs(line.options.files, {line.screenshot}); !status.isOk()) {
            return app::report(status);
        }
        line.options.screenshot = line.screenshot;
    }
    if (!line.size.empty()) {
        int width = 0;
        int height = 0;
        char end = 0;
        constexpr int kLargest = 8192;
        if (std::sscanf(line.size.c_str(), "%5dx%5d%c", &width, &height, &end) != 2 || width < 1 || height < 1 ||
            width > kLargest || height > kLargest) {
            app::printError(PALPATE_TEXT("--size: found \"%1\", expected width x height, as 1280x800"), line.size);
            return app::kBadInput;
        }
        line.options.screenshotWidth = width;
        line.options.screenshotHeight = height;
    }
    return runWindow(argc, argv, line.options);
}

int run(int argc, char** argv)
{
    if (argc == 3 && argv[1] == app::kProbeWord) {
        return app::probe(argv[2]);
    }
    CLI::App cli("Palpate: feel segmented anatomy. Research, training and planning rehearsal; not a medical device.",
                 "palpate");
    cli.set_version_flag("--version", app::versionText());
    cli.require_subcommand(0, 1);
    app::Chosen chosen;
    app::addDevicesCommand(cli, chosen);
    app::addEvaluationCommands(cli, chosen);
    app::addFeltCommand(cli, chosen);
    app::addFindingsCommand(cli, chosen);
    app::addInfoCommand(cli, chosen);
    app::addReplayCommand(cli, chosen);
    app::addSessionCommand(cli, chosen);
    app::addThumbnailCommand(cli, chosen);
    WindowCommandLine window;
    addWindowOptions(cli, window);
    if (const auto code = app::parse(cli, argc, argv)) {
        return *code;
    }
    if (chosen) {
        return chosen();
    }
    return openWindow(argc, argv, window);
}

} // namespace

int app::runCommandLine(int argc, char** argv)
{
    if (argc > 1 && isEvaluation(argv[1])) {
        return execEvaluationProgram(argv);
    }
    return runProgram(argc, argv, run);
}

} // namespace palpate
