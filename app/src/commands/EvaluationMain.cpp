// SPDX-License-Identifier: BSD-3-Clause
// Program palpate-evaluation, which runs `palpate evaluate` and `palpate stability`.
#include "commands/Commands.h"
#include "shared/Program.h"

#include <CLI/CLI.hpp>

namespace {

using namespace palpate;

int run(int argc, char** argv)
{
    CLI::App cli("Palpate: measures what a hand would feel and how fast. Not a medical device.", "palpate");
    cli.set_version_flag("--version", app::versionText());
    cli.require_subcommand(1);
    app::Chosen chosen;
    app::addEvaluateCommand(cli, chosen);
    app::addStabilityCommand(cli, chosen);
    if (const auto code = app::parse(cli, argc, argv)) {
        return *code;
    }
    return chosen();
}

} // namespace

int main(int argc, char** argv)
{
    return app::runProgram(argc, argv, run);
}
