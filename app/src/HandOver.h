// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands.h"

#include <string_view>

namespace palpate::app {

/// The program beside this one that measures: the solvers that others are compared with are no part of what a hand
/// needs.
inline constexpr const char* kEvaluationProgram = "palpate-evaluation";

/// @return whether `word`, the first after `palpate`, names a subcommand of that program
[[nodiscard]] bool isEvaluation(std::string_view word);

/// Becomes that program, with the same command line. @return only if it can't: an exit code, after saying what to do
[[nodiscard]] int handOver(char** argv);

/// Lists that program's subcommands in the help of `app`. Where one is given behind an option, `chosen` says so.
void addHandedOver(CLI::App& app, Chosen& chosen);

} // namespace palpate::app
