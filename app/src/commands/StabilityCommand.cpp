// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Commands.h"
#include "shared/Console.h"
#include "shared/ProgressLine.h"

#include <palpate/evaluation/Stability.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/RecordedScene.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <memory>

namespace palpate::app {

namespace {

namespace fs = std::filesystem;
namespace stability = evaluation::stability;
using core::Status;
using core::StatusCode;

struct StabilityOptions
{
    fs::path scene, out = "out/stability";
    std::string device, unit = "mm", frame, rate = "1000", delay = "1";
};

core::Result<std::vector<device::DevicePreset>> presetsOf(const std::string& id)
{
    const auto all = device::devicePresets();
    if (id.empty()) {
        return std::vector<device::DevicePreset>(all.begin(), all.end());
    }
    if (const device::DevicePreset* preset = device::findDevicePreset(id)) {
        return std::vector<device::DevicePreset>{*preset};
    }
    std::string names;
    for (const device::DevicePreset& preset : all) {
        names += (names.empty() ? "" : ", ") + std::string(preset.id);
    }
    return Status(StatusCode::BadCommandLine, PALPATE_TEXT("--device: found \"%1\", expected one of %2"), id, names);
}

void printResult(const stability::Result& result)
{
    const auto held = [](double k) {
        char text[32];
        std::snprintf(text, sizeof text, k >= stability::kStiffest_N_per_mm ? ">= %.3g" : "%.3g", k);
        return std::string(k > 0.0 ? text : "< 0.05");
    };
    print("%g Hz, %d tick of delay; stiffness in N/mm, motion at rest in mm, force error in %%\n", result.rate_Hz,
          result.delayTicks);
    print("%-20s %-26s %7s %8s %8s  %-9s %-8s %6s %6s\n", "device", "shape", "stated", "without", "with", "at rest", "",
          "mean", "99 %");
    for (const stability::Row& row : result.rows) {
        print("%-20s %-26s %7.3g %8s %8s  %-9.2g %-8s %6.2f %6.2f\n", row.device.c_str(), row.shape.c_str(),
              row.stated_N_per_mm, held(row.without_N_per_mm).c_str(), held(row.with_N_per_mm).c_str(), row.restless_mm,
              std::isfinite(row.restless_mm) ? (row.isHeld() ? "held" : "NOT HELD") : "no touch", row.cost.mean_percent,
              row.cost.p99_percent);
    }
    for (const stability::Sweep& sweep : result.sweeps) {
        print("\n%s, wall, against %s\n%12s %8s %8s %8s %8s\n", sweep.device.c_str(), sweep.what.c_str(),
              sweep.unit.c_str(), "passive", "without", "with", "window");
        for (const stability::SweepPoint& p : sweep.points) {
            print("%12.4g %8.3g %8s %8s %8.3g\n", p.x, p.passive_N_per_mm, held(p.without_N_per_mm).c_str(),
                  held(p.with_N_per_mm).c_str(), p.held_N_per_mm);
        }
    }
}

int runStability(const StabilityOptions& options)
{
    const auto unit = unitOption(options.unit);
    if (!unit.isOk()) {
        return report(unit.status());
    }
    const auto frame = frameOption(options.frame);
    if (!frame.isOk()) {
        return report(frame.status());
    }
    const auto rate = numberOption("--rate", options.rate, {.least = 1.0, .most = 10000.0});
    if (!rate.isOk()) {
        return report(rate.status());
    }
    constexpr double kMostDelay = 16.0;
    const auto delay = numberOption("--delay", options.delay, {.least = 0.0, .most = kMostDelay});
    if (!delay.isOk()) {
        return report(delay.status());
    }
    auto presets = presetsOf(options.device);
    if (!presets.isOk()) {
        return report(presets.status());
    }
    if (const Status status = checkOutputs({options.scene}, stability::reportFiles(options.out)); !status.isOk()) {
        return report(status);
    }
    std::error_code error;
    fs::create_directories(options.out, error);
    if (!fs::is_directory(options.out)) {
        return report(Status(StatusCode::BadCommandLine, PALPATE_TEXT("--out: %1 cannot be made: %2"), options.out,
                             core::systemError(error.value())));
    }
    std::vector<stability::Shape> shapes;
    std::string subject = "standard shapes";
    std::shared_ptr<const haptics::HapticScene> scene;
    if (options.scene.empty()) {
        shapes = stability::standardShapes();
    } else {
        meshio::ReadOptions read;
        read.unit_mm = unit.value();
        read.frame = frame.value();
        const auto loaded = study::openScene(options.scene, read);
        if (!loaded.isOk()) {
            return report(loaded.status());
        }
        subject = options.scene.filename().string();
        scene = study::hapticScene(loaded.value());
        shapes.push_back(stability::shapeOf(subject, *scene));
        if (shapes.front().holds.empty()) {
            return report(Status(StatusCode::Empty,
                                 PALPATE_TEXT("%1: found nothing to press, expected a palpable surface"),
                                 options.scene));
        }
    }
    stability::Options how;
    how.presets = std::move(presets).value();
    how.rate_Hz = rate.value();
    how.delayTicks = static_cast<int>(std::lround(delay.value()));
    stability::Result result;
    {
        ProgressLine progress;
        how.progress = [&](double share, const std::string& what) { progress.show(share, what); };
        result = stability::measure(subject, shapes, how);
    }
    if (const Status status = stability::writeReport(options.out, result); !status.isOk()) {
        return report(status);
    }
    printResult(result);
    if (scene != nullptr) {
        print("the scene itself has %.3g N/mm where it is stiffest; all its tissues are scaled together\n",
              shapes.front().own_N_per_mm);
        for (const std::string& line : stability::mapWarnings(*scene, how)) {
            print("%s\n", line.c_str());
        }
    }
    print("%s\n", (options.out / "stability.html").string().c_str());
    for (const stability::Row& row : result.rows) {
        if (!std::isfinite(row.restless_mm)) {
            return report(Status(StatusCode::Empty,
                                 PALPATE_TEXT("%1: a hand on %2 slips off it wherever it presses; is it the size it "
                                              "should be (--unit)?"),
                                 row.shape, row.device));
        }
    }
    return kDone;
}

} // namespace

void addStabilityCommand(CLI::App& app, Chosen& chosen)
{
    auto options = std::make_shared<StabilityOptions>();
    CLI::App* command = app.add_subcommand(kStability.name, kStability.description);
    command->add_option("SCENE", options->scene,
                        "Mesh file, scene file or folder of meshes; without one, walls, corners, a groove, a lump, "
                        "a fine sphere and two layers");
    command->add_option("--device", options->device, "Kind of device, as touch or omega; without it, all of them");
    command->add_option("--rate", options->rate, "Servo rate [Hz]")->capture_default_str();
    command
        ->add_option("--delay", options->delay,
                     "Ticks from computing a force until it acts, as `devices --check` states")
        ->capture_default_str();
    command->add_option("--unit", options->unit, "Unit of a mesh file's numbers: m, cm or mm")->capture_default_str();
    command->add_option("--frame", options->frame, kFrameHelp);
    command->add_option("--out", options->out, "Folder for stability.html and stability.csv")->capture_default_str();
    command->callback([options, &chosen] { chosen = [options] { return runStability(*options); }; });
}

} // namespace palpate::app
