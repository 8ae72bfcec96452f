// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace palpate::app {

/// Action chosen by the command line, to run after parsing. @return the exit code
using Chosen = std::function<int()>;

/// Body of main: starts the file-reading server, calls `run`, reports exceptions and checks that all output was
/// written.
/// @return the exit code
[[nodiscard]] int runProgram(int argc, char** argv, int (*run)(int argc, char** argv));

/// Output of `--version`: a line with version and build, and one with the libraries that the program was built with.
[[nodiscard]] std::string versionText();

/// Parses the command line. @return the exit code if the program is done: help or a description of the commands was
/// printed, or the command line was invalid and an error was printed
[[nodiscard]] std::optional<int> parse(CLI::App& cli, int argc, char** argv);

} // namespace palpate::app
