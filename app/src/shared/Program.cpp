// SPDX-License-Identifier: BSD-3-Clause
#include "shared/Program.h"

#include "shared/BuiltWith.h"
#include "shared/CommandDescription.h"
#include "shared/Console.h"

#include <palpate/core/Scratch.h>
#include <palpate/meshio/ImportServer.h>
#include <palpate/session/Recording.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <new>
#include <string_view>

#include <fcntl.h>
#include <unistd.h>

namespace palpate::app {

namespace {

/// Opens closed standard streams on /dev/null. Otherwise another file could get their descriptor and receive the
/// output. Writing to these streams fails.
void reserveStandardStreams()
{
    for (int number = 0; number <= STDERR_FILENO; ++number) {
        if (::fcntl(number, F_GETFD) < 0) {
            (void)::open("/dev/null", O_RDONLY); // takes the lowest free descriptor
        }
    }
}

} // namespace

int runProgram(int argc, char** argv, int (*run)(int argc, char** argv))
{
    reserveStandardStreams();
    // Start the server first, while the process has one thread and no open files. Without a server, files are read in
    // this process.
    if (const core::Status server = meshio::startImportServer(); !server.isOk()) {
        printError(PALPATE_TEXT("%1; meshes are read in this process"), server.text());
    }
    core::removeScratchOnSignals();
    int code = kFailed;
    try {
        code = run(argc, argv);
    } catch (const std::bad_alloc&) {
        printError(PALPATE_TEXT("out of memory"));
    } catch (const std::exception& error) {
        printError(core::Message::untranslated(error.what()));
    } catch (...) {
        printError(PALPATE_TEXT("stopped by an unknown error"));
    }
    const bool isFlushed = std::fflush(stdout) == 0;
    if ((!isFlushed || std::ferror(stdout) != 0) && code == kDone) {
        printError(PALPATE_TEXT("the output could not be written"));
        code = kFailed;
    }
    return code;
}

std::string versionText()
{
    return "palpate " + session::palpateVersion() + " (" + session::buildId() + ")\n" + kBuiltWith;
}

std::optional<int> parse(CLI::App& cli, int argc, char** argv)
{
    if (argc == 2 && std::string_view(argv[1]) == kDescribeWord) {
        std::fputs(describeCommands(cli).c_str(), stdout);
        return kDone;
    }
    try {
        cli.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
            return cli.exit(error); // help or version
        }
        printError(PALPATE_TEXT("%1 (palpate --help lists what there is)"), error.what());
        return kBadInput;
    }
    return std::nullopt;
}

} // namespace palpate::app
