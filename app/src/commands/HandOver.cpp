// SPDX-License-Identifier: BSD-3-Clause
#include "commands/HandOver.h"
#include "shared/Console.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>

#include <unistd.h>

namespace palpate::app {

namespace {

constexpr std::array kEvaluationCommands{kEvaluate, kStability};

} // namespace

bool isEvaluation(std::string_view word)
{
    return std::any_of(kEvaluationCommands.begin(), kEvaluationCommands.end(),
                       [word](const CommandText& c) { return word == c.name; });
}

int execEvaluationProgram(char** argv)
{
    std::error_code error;
    const std::string program =
        std::filesystem::read_symlink("/proc/self/exe", error).replace_filename(kEvaluationProgram).string();
    ::execv(program.c_str(), argv);
    const int why = errno;
    printError(
        PALPATE_TEXT("%1: %2, expected the program that does `palpate %3`: install it beside palpate, or build all "
                     "of Palpate"),
        program, core::systemError(why), argv[1]);
    return kFailed;
}

void addEvaluationCommands(CLI::App& app, Chosen& chosen)
{
    for (const CommandText& text : kEvaluationCommands) {
        CLI::App* const command = app.add_subcommand(text.name, text.description);
        command->prefix_command(); // the other program validates the rest of the command line
        command->callback([&chosen, text] {
            chosen = [text] {
                printError(PALPATE_TEXT("%1: found after an option, expected as the first word after palpate"),
                           text.name);
                return int{kBadInput};
            };
        });
    }
}

} // namespace palpate::app
