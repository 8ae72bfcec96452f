// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "commands/Commands.h"

#include <string_view>

namespace palpate::app {

/// Name of the evaluation program in the same folder. A separate program, because the reference solvers are not
/// needed for palpation.
inline constexpr const char* kEvaluationProgram = "palpate-evaluation";

/// Returns whether `word`, the first argument of `palpate`, is a subcommand of that program.
[[nodiscard]] bool isEvaluation(std::string_view word);

/// Replaces this process by that program with the same command line. Returns only on failure.
/// @return an exit code, after printing an error with a remedy
[[nodiscard]] int execEvaluationProgram(char** argv);

/// Adds that program's subcommands to the help of `app`. If one is given after an option, `chosen` prints an error.
void addEvaluationCommands(CLI::App& app, Chosen& chosen);

} // namespace palpate::app
