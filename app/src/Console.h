// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/FileFrame.h>
#include <palpate/core/Status.h>
#include <palpate/core/Text.h>

#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::app {

/// What `palpate` returns to its caller.
enum ExitCode : int
{
    kDone = 0,
    kFailed = 1,   ///< anything that no other code says
    kBadInput = 2, ///< the command line or an input is wrong
    kSomeLost = 3, ///< finished, but something was lost or skipped
};

/// Writes one line to stderr. Control and bidirectional characters in the message become visible (core::visible);
/// of a message of more than 1,900 bytes, such as one with a path that long, the middle is left out.
void printError(std::string_view message);
/// Writes the status to stderr. @return the exit code that belongs to it
[[nodiscard]] int report(const core::Status& status);
/// Writes what was lost to stderr, a line each. @return the exit code for a run that was fine but for them
[[nodiscard]] int reportLosses(const std::vector<std::string>& losses);
/// Writes to stdout as printf does, always with a decimal point. Control and bidirectional characters in the texts for
/// `%s` become visible (core::visible); those of `format` itself, such as its line ends, are kept.
[[gnu::format(printf, 1, 2)]] void print(const char* format, ...);

/// Writes JSON text to stdout; characters that a terminal would act upon are escaped as JSON allows.
void printJson(std::string_view json);

using core::grouped;

/// What a number on the command line may be; bounds are whole numbers.
struct NumberRange
{
    double least = 0.0;
    double most = std::numeric_limits<double>::infinity();
    bool isAbove = false; ///< `least` itself is not allowed
};

/// Checks a number from the command line.
[[nodiscard]] core::Result<double> numberOption(std::string_view option, const std::string& text,
                                                const NumberRange& range);
/// What `--frame` is, for the help of each command that has it.
inline constexpr const char* kFrameHelp =
    "Axes of a mesh file's coordinates, whatever its tag says: LPS, RAS or Y-up (x left, y up, z front)";
/// @return the frame called `text`; as the files say for an empty one
[[nodiscard]] core::Result<core::FileFrame> frameOption(const std::string& text);
/// @return millimetres of one unit called `text`.
[[nodiscard]] core::Result<double> unitOption(const std::string& text);

/// @return an error when an output is an input or belongs to one (study::filesOf), or another output; empty: left out
[[nodiscard]] core::Status checkOutputs(const std::vector<std::filesystem::path>& inputs,
                                        const std::vector<std::filesystem::path>& outputs);

} // namespace palpate::app
