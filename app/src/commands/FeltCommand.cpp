// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Commands.h"
#include "shared/Console.h"
#include "shared/ProgressLine.h"
#include "shared/SurfaceOptions.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/core/Numbers.h>
#include <palpate/study/FeltFile.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/RecordedScene.h>

#include <CLI/CLI.hpp>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate::app {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

struct FeltCommandOptions
{
    std::filesystem::path scene, vtp, json;
    std::string unit = "mm", frame, radius, press = "0,2,4,8";
    std::vector<std::string> ratios;
    SurfaceOptions surfaces;
};

Result<std::vector<double>> depthsOption(const std::string& text)
{
    std::vector<double> depths;
    std::size_t from = 0;
    while (from <= text.size()) {
        const std::size_t to = std::min(text.find(',', from), text.size());
        const auto depth = numberOption("--press", text.substr(from, to - from), {});
        if (!depth.isOk()) {
            return depth.status();
        }
        depths.push_back(depth.value());
        from = to + 1;
    }
    return depths;
}

/// Parses NAME=R; the name may contain an equals sign.
Result<std::map<std::string, double>> ratiosOption(const std::vector<std::string>& texts)
{
    std::map<std::string, double> ratios;
    for (const std::string& text : texts) {
        const std::size_t at = text.rfind('=');
        if (at == std::string::npos || at == 0) {
            return Status(StatusCode::BadCommandLine,
                          PALPATE_TEXT("--ratio: found \"%1\", expected NAME=R, as \"lump 12 mm=4.4\""), text);
        }
        const auto ratio = numberOption("--ratio " + text.substr(0, at), text.substr(at + 1), {.isAbove = true});
        if (!ratio.isOk()) {
            return ratio.status();
        }
        if (!ratios.emplace(text.substr(0, at), ratio.value()).second) {
            return Status(StatusCode::BadCommandLine, PALPATE_TEXT("--ratio: found %1 twice, expected once"),
                          text.substr(0, at));
        }
    }
    return ratios;
}

void printLump(const buried::FeltSurface& felt, const buried::FeltSurface::Lump& lump, const study::SceneLump& of)
{
    print("%s\n", study::lumpSentence(lump, of).c_str());
    print("  %8s %10s %18s %12s %12s %12s  %s\n", "press mm", "felt", "bounds", "over 7 mm2", "over 14 mm2",
          "over 28 mm2", "a hand finds it");
    for (std::size_t i = 0; i < lump.press.size(); ++i) {
        const auto& press = lump.press[i];
        std::string change = "-", bounds = "-";
        if (press.best.has_value()) {
            char text[64];
            std::snprintf(text, sizeof text, "%+.0f %%", 100.0 * (press.felt.estimate - 1.0));
            change = text;
            std::snprintf(text, sizeof text, "%+.0f ... %+.0f %%", 100.0 * (press.felt.low - 1.0),
                          100.0 * (press.felt.high - 1.0));
            bounds = text;
        }
        print("  %8g %10s %18s %12.0f %12.0f %12.0f  %s\n", felt.press[i].press_mm, change.c_str(), bounds.c_str(),
              press.area_mm2[0], press.area_mm2[1], press.area_mm2[2], buried::verdictText(press, lump.ratio).c_str());
    }
    const auto& last = lump.press.back();
    if (last.best.has_value()) {
        const core::Vec3& p_W = felt.surface.vertices[*last.best];
        print("  best place when pressed %g mm: (%.1f %.1f %.1f) mm\n", felt.press.back().press_mm, p_W.x(), p_W.y(),
              p_W.z());
    }
}

Result<std::vector<study::OrganPalpability>> feelAll(const meshio::LoadedScene& scene,
                                                     const std::vector<study::OrganWithLumps>& organs,
                                                     buried::FeltOptions how, std::optional<double> radius_mm)
{
    std::vector<study::OrganPalpability> felt;
    for (const study::OrganWithLumps& organ : organs) {
        ProgressLine progress;
        how.radius_mm = radius_mm.value_or(organ.radius_mm);
        const std::string& name = scene.structures[organ.organ].description.name;
        how.progress = [&](double share) { return progress.show(share, name); };
        auto one = study::feltSurface(scene, organ, how);
        if (!one.isOk()) {
            return one.status();
        }
        felt.push_back({organ, std::move(one).value()});
    }
    return felt;
}

std::vector<core::Message> leftOutLosses(const meshio::LoadedScene& scene,
                                         const std::vector<study::LumpInOpenSurface>& leftOut)
{
    std::vector<core::Message> losses;
    for (const study::LumpInOpenSurface& one : leftOut) {
        const meshio::LoadedStructure& around = scene.structures[one.around];
        losses.push_back({PALPATE_TEXT("%1: left out, %2; --close-holes closes holes"),
                          scene.structures[one.lump].description.name,
                          study::openSurface(around.description.name, *around.surface)});
    }
    return losses;
}

/// Prints what the hand meets at the surfaces. The table says how lumps are felt through their organ: notes that the
/// surface of the organ hides them would contradict it.
void printNotes(const meshio::LoadedScene& scene, const std::vector<study::OrganWithLumps>& organs)
{
    meshio::LoadedScene others = scene;
    for (const study::OrganWithLumps& organ : organs) {
        for (const auto& lump : organ.lumps) {
            others.structures[lump.structure].description.layer =
                std::numeric_limits<std::uint32_t>::max() - static_cast<std::uint32_t>(lump.structure);
        }
    }
    printTouchNotes(others, *study::hapticScene(scene));
}

int writeAndPrint(const FeltCommandOptions& options, const meshio::LoadedScene& scene,
                  const std::vector<study::OrganPalpability>& felt, std::vector<core::Message> losses)
{
    losses.insert(losses.begin(), scene.losses.begin(), scene.losses.end());
    for (const study::OrganPalpability& one : felt) {
        losses.insert(losses.end(), one.felt.notes.begin(), one.felt.notes.end());
    }
    const std::vector<core::Message> questions = study::ratioQuestions(scene, felt);
    losses.insert(losses.end(), questions.begin(), questions.end());
    if (!options.vtp.empty()) {
        const auto bytes = study::feltVtp(felt);
        const Status status = bytes.isOk() ? core::writeAtomically(options.vtp, bytes.value()) : bytes.status();
        if (!status.isOk()) {
            return report(status);
        }
    }
    if (!options.json.empty()) {
        if (const Status status = core::writeAtomically(options.json, study::feltJson(scene, felt)); !status.isOk()) {
            return report(status);
        }
    }
    for (const study::OrganPalpability& one : felt) {
        print("%s, finger of %g mm contact radius\n", scene.structures[one.organ.organ].description.name.c_str(),
              one.felt.radius_mm);
        for (const buried::FeltSurface::Lump& lump : one.felt.lumps) {
            printLump(one.felt, lump, one.organ.lumps[lump.given]);
        }
    }
    print("estimate for research and rehearsal, not for diagnosis: resources/docs/felt.md says what it rests on\n");
    return reportLosses(losses);
}

int runFelt(const FeltCommandOptions& options)
{
    const auto unit = unitOption(options.unit);
    const auto frame = frameOption(options.frame);
    const auto depths = depthsOption(options.press);
    const auto ratios = ratiosOption(options.ratios);
    for (const Status* status : {&unit.status(), &frame.status(), &depths.status(), &ratios.status()}) {
        if (!status->isOk()) {
            return report(*status);
        }
    }
    std::optional<double> radius_mm;
    if (!options.radius.empty()) {
        const auto radius = numberOption("--radius", options.radius, {.isAbove = true});
        if (!radius.isOk()) {
            return report(radius.status());
        }
        radius_mm = radius.value();
    }
    if (const Status status = checkOutputs({options.scene}, {options.vtp, options.json}); !status.isOk()) {
        return report(status);
    }
    meshio::ReadOptions read;
    read.unit_mm = unit.value();
    read.frame = frame.value();
    options.surfaces.applyTo(read);
    const auto scene = study::openScene(options.scene, read);
    if (!scene.isOk()) {
        return report(scene.status());
    }
    std::vector<study::LumpInOpenSurface> leftOut;
    const auto organs = study::organsWithLumps(scene.value(), ratios.value(), &leftOut);
    printNotes(scene.value(), organs.isOk() ? organs.value() : std::vector<study::OrganWithLumps>());
    if (!organs.isOk()) {
        return report(organs.status().at(options.scene.filename()));
    }
    buried::FeltOptions how;
    how.press_mm = depths.value();
    const auto felt = feelAll(scene.value(), organs.value(), how, radius_mm);
    if (!felt.isOk()) {
        return report(felt.status().at(options.scene.filename()));
    }
    return writeAndPrint(options, scene.value(), felt.value(), leftOutLosses(scene.value(), leftOut));
}

} // namespace

void addFeltCommand(CLI::App& app, Chosen& chosen)
{
    auto options = std::make_shared<FeltCommandOptions>();
    CLI::App* command = app.add_subcommand("felt", "Say which lumps a hand can find through an organ, and where");
    command->add_option("SCENE", options->scene, "Scene file, or folder of meshes, with lumps inside an organ")
        ->required();
    command->add_option("--radius", options->radius,
                        "Contact radius of the finger [mm], at most 30; without it as the scene says, else 5");
    command->add_option("--press", options->press, "How deep the finger is pressed in [mm], ascending, with commas")
        ->capture_default_str();
    command
        ->add_option("--ratio", options->ratios,
                     "NAME=R: how many times as stiff as its organ a lump is; may be given for several")
        ->allow_extra_args(false);
    command->add_option("--vtp", options->vtp, "Write the organ's surface with FeltRatio and the like");
    command->add_option("--json", options->json, "Write lumps, best places, areas and verdicts");
    command->add_option("--unit", options->unit, "Unit of a mesh file's numbers: m, cm or mm")->capture_default_str();
    command->add_option("--frame", options->frame, kFrameHelp);
    options->surfaces.addTo(*command);
    command->callback([options, &chosen] { chosen = [options] { return runFelt(*options); }; });
}

} // namespace palpate::app
