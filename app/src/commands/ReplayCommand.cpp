// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Commands.h"
#include "commands/ReplayRun.h"
#include "shared/Console.h"
#include "shared/LayersOption.h"

#include <CLI/CLI.hpp>

#include <cctype>
#include <memory>
#include <string>

namespace palpate::app {

void addReplayCommand(CLI::App& app, Chosen& chosen)
{
    auto options = std::make_shared<ReplayOptions>();
    CLI::App* command = app.add_subcommand("replay", "Feed a motion to the solver that the servo thread runs");
    command->add_option("SCENE", options->scene, "Mesh file, scene file or folder of meshes")->required();
    command->add_option("--motion", options->motion, "CSV with x,y,z in mm, one row a servo tick; or a recording")
        ->required();
    command->add_option("--out", options->out, "Write the ticks as CSV");
    command->add_option("--unit", options->unit, "Unit of a mesh file's numbers: m, cm or mm")->capture_default_str();
    command->add_option("--frame", options->frame, kFrameHelp);
    for (std::size_t i = 0; i < core::kTissueTerms.size(); ++i) {
        const core::TissueTerm& term = core::kTissueTerms[i];
        if (term.option.empty()) {
            continue;
        }
        std::string what(term.option.substr(2));
        what.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(what.front())));
        command->add_option(std::string(term.option), options->tissue[i],
                            what + " of every tissue [" + std::string(term.unit) + "]");
    }
    command->add_option("--radius", options->radius, "Radius of the fingertip [mm]; 0 touches with a point");
    command->add_option("--layers", options->layers, kLayersHelp);
    options->surfaces.addTo(*command);
    command->add_option("--json", options->json, "Write the summary as JSON");
    command->add_option("--record", options->record,
                        "Write a recording (*.palpate); a file of this name is replaced with --force only");
    command->add_flag("--embed", options->embeds, "Put the surfaces into the recording, so that one file is all")
        ->needs("--record");
    command->add_flag("--live", options->isLive, "In real time, through the servo thread and the safety gate");
    command->add_flag("--partial", options->isPartial,
                      "Read what is whole of a mesh that was cut off; exit code 3 then");
    command
        ->add_option(
            "--device", options->device,
            "With --live, the hand: simulated or a device's name (drawn along the motion), or a plugin's device "
            "(moved by whoever holds it, as long as the motion lasts)")
        ->needs("--live");
    command
        ->add_option("--cpu", options->cpu, "With --live, the CPU that the servo loop runs on alone, from 0; -1: any")
        ->needs("--live");
    command->add_option("--plugin-path", options->pluginFolders, "Folder to look for device plugins in first")
        ->allow_extra_args(false);
    command->add_flag("--force", options->isForced,
                      "Replay a recording's motion on another scene than it was made on, without comparing; with "
                      "--record, replace an older file once the new one is complete");
    command->callback([options, &chosen] { chosen = [options] { return ReplayRun(*options).run(); }; });
}

} // namespace palpate::app
