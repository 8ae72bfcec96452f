// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace palpate::app {

/// Hidden first argument of both programs: prints `describeCommands`. The build makes the manual page and the
/// completions of bash and zsh from this output (resources/desktop/command_texts.pl).
inline constexpr const char* kDescribeWord = "--describe-commands";

/// Describes a command line with all subcommands, one subcommand or option per line, fields separated by tabs:
///
///     command <TAB> PATH <TAB> description
///     option <TAB> PATH <TAB> names <TAB> type <TAB> flags <TAB> default <TAB> description
///
/// PATH names a subcommand, such as "session measure"; the program itself has an empty path. Names are separated by
/// commas; positional arguments have a name without dashes. The type is empty for options without a value. Flags are
/// separated by commas: "required", and "several" for several values. Hidden options are omitted.
[[nodiscard]] std::string describeCommands(const CLI::App& app);

} // namespace palpate::app
