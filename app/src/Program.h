// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace palpate::app {

/// What the command line asked for; run after it was parsed. @return the exit code
using Chosen = std::function<int()>;

/// The whole of a program's main: begins the server that reads files, runs `run`, says what it throws and makes sure
/// that its output is written. @return the exit code
[[nodiscard]] int runProgram(int argc, char** argv, int (*run)(int argc, char** argv));

/// What `--version` prints.
[[nodiscard]] std::string versionText();

/// @return the exit code where there is no more to do: help was asked for, or the command line is wrong and that was
/// said
[[nodiscard]] std::optional<int> parse(CLI::App& cli, int argc, char** argv);

} // namespace palpate::app
