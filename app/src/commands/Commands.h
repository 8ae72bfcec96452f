// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shared/Program.h"

#include <CLI/App.hpp>

namespace palpate::app {

/// Name and description of a subcommand in `palpate --help`.
struct CommandText
{
    const char* name;
    const char* description;
};
inline constexpr CommandText kEvaluate{"evaluate",
                                       "Measure speed against error: every solver and setting, on your meshes"};
inline constexpr CommandText kStability{"stability",
                                        "Find the largest stiffness that a device holds without oscillating"};

/// Each function adds its subcommand to `app`. If the command line contains the subcommand, parsing sets `chosen` to
/// its action. The subcommand's options live as long as `app`.
void addDevicesCommand(CLI::App& app, Chosen& chosen);
void addEvaluateCommand(CLI::App& app, Chosen& chosen);
void addFeltCommand(CLI::App& app, Chosen& chosen);
void addFindingsCommand(CLI::App& app, Chosen& chosen);
void addInfoCommand(CLI::App& app, Chosen& chosen);
void addMeasureCommand(CLI::App& session, Chosen& chosen); ///< a subcommand of `session`
void addReplayCommand(CLI::App& app, Chosen& chosen);
void addReportCommand(CLI::App& session, Chosen& chosen); ///< a subcommand of `session`
void addSessionCommand(CLI::App& app, Chosen& chosen);
void addStabilityCommand(CLI::App& app, Chosen& chosen);
void addThumbnailCommand(CLI::App& app, Chosen& chosen);

} // namespace palpate::app
