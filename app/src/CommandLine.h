// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate::app {

/// What the program `palpate` does with its command line: opens the window, runs a subcommand, or becomes the program
/// that has it. @return the exit code
[[nodiscard]] int runCommandLine(int argc, char** argv);

} // namespace palpate::app
