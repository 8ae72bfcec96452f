// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"
#include "Console.h"
#include "Devices.h"
#ifdef PALPATE_HAS_WINDOW
#include "Window.h"
#endif

#include <palpate/meshio/ImportServer.h>
#include <palpate/meshio/MeshFormats.h>
#include <palpate/servo/RealtimeSetup.h>
#include <palpate/session/Recording.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>

namespace {

using namespace palpate;

#ifdef PALPATE_HAS_WINDOW
struct WindowCommandLine
{
    WindowOptions options;
    std::string unit = "mm";
    std::string frame;
    std::string screenshot;
    std::string size;
};

void addWindowOptions(CLI::App& app, WindowCommandLine& line)
{
    app.add_option("FILE", line.options.files,
                   "Meshes (" + meshio::meshFormatNames("or") + ") or a scene to open, and a recording to play");
    app.add_option("--unit", line.unit, "Unit of a mesh file's numbers: m, cm or mm")->capture_default_str();
    app.add_option("--frame", line.frame, app::kFrameHelp);
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
    line.options.unit_mm = unit.value();
    const auto frame = app::frameOption(line.frame);
    if (!frame.isOk()) {
        return app::report(frame.status());
    }
    line.options.frame = frame.value();
    for (const auto& file : line.options.files) {
        std::error_code error;
        if (!std::filesystem::exists(file, error)) {
            app::printError(file.string() + ": no such file, expected a mesh, a scene or a recording");
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
        line.options.screenshot = line.screenshot;
    }
    if (!line.size.empty()) {
        int width = 0;
        int height = 0;
        char end = 0;
        constexpr int kLargest = 8192;
        if (std::sscanf(line.size.c_str(), "%5dx%5d%c", &width, &height, &end) != 2 || width < 1 || height < 1 ||
            width > kLargest || height > kLargest) {
            app::printError("--size: found \"" + line.size + "\", expected width x height, as 1280x800");
            return app::kBadInput;
        }
        line.options.screenshotWidth = width;
        line.options.screenshotHeight = height;
    }
    return runWindow(argc, argv, line.options);
}
#endif

int run(int argc, char** argv)
{
    if (argc == 3 && argv[1] == app::kProbeWord) {
        return app::probe(argv[2]);
    }
    CLI::App cli("Palpate: feel segmented anatomy. Research, training and planning rehearsal; not a medical device.",
                 "palpate");
    cli.set_version_flag("--version", "palpate " + session::palpateVersion() + " (" + session::buildId() + ")");
    cli.require_subcommand(0, 1);
    app::Chosen chosen;
    app::addDevicesCommand(cli, chosen);
    app::addEvaluateCommand(cli, chosen);
    app::addFeltCommand(cli, chosen);
    app::addFindingsCommand(cli, chosen);
    app::addInfoCommand(cli, chosen);
    app::addReplayCommand(cli, chosen);
    app::addSessionCommand(cli, chosen);
    app::addStabilityCommand(cli, chosen);
#ifdef PALPATE_HAS_WINDOW
    WindowCommandLine window;
    addWindowOptions(cli, window);
#endif
    try {
        cli.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
            return cli.exit(error); // help or version
        }
        app::printError(std::string(error.what()) + " (palpate --help lists what there is)");
        return app::kBadInput;
    }
    if (chosen) {
        return chosen();
    }
#ifdef PALPATE_HAS_WINDOW
    return openWindow(argc, argv, window);
#else
    app::printError("this build has no window: give a subcommand (palpate --help lists them)");
    return app::kBadInput;
#endif
}

} // namespace

int main(int argc, char** argv)
{
    // First, while there is one thread and nothing is open. Without a server files are read here.
    if (const core::Status server = meshio::startImportServer(); !server.isOk()) {
        app::printError(server.message() + "; meshes are read in this process");
    }
    int code = app::kFailed;
    try {
        code = run(argc, argv);
    } catch (const std::bad_alloc&) {
        app::printError("out of memory");
    } catch (const std::exception& error) {
        app::printError(error.what());
    } catch (...) {
        app::printError("stopped by an unknown error");
    }
    if (std::fflush(stdout) != 0 && code == app::kDone) {
        app::printError("the output could not be written");
        code = app::kFailed;
    }
    return code;
}
