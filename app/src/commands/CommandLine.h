// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate::app {

/// Runs the program `palpate`: opens the window, runs a subcommand, or replaces the process by the program that
/// implements the subcommand. @return the exit code
[[nodiscard]] int runCommandLine(int argc, char** argv);

} // namespace palpate::app
