// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/App.hpp>

#include <functional>

namespace palpate::app {

/// What the command line asked for; run after it was parsed. @return the exit code
using Chosen = std::function<int()>;

/// Each adds its subcommand; when that is given on the command line, `chosen` becomes what it does. The subcommand's
/// options live as long as `app`.
void addDevicesCommand(CLI::App& app, Chosen& chosen);
void addEvaluateCommand(CLI::App& app, Chosen& chosen);
void addFeltCommand(CLI::App& app, Chosen& chosen);
void addFindingsCommand(CLI::App& app, Chosen& chosen);
void addInfoCommand(CLI::App& app, Chosen& chosen);
void addReplayCommand(CLI::App& app, Chosen& chosen);
void addSessionCommand(CLI::App& app, Chosen& chosen);
void addStabilityCommand(CLI::App& app, Chosen& chosen);

} // namespace palpate::app
