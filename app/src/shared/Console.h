// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/FileFrame.h>
#include <palpate/core/Message.h>
#include <palpate/core/Status.h>
#include <palpate/core/Text.h>

#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace palpate::app {

/// Exit codes of `palpate`.
enum ExitCode : int
{
    kDone = 0,
    kFailed = 1,   ///< any other failure
    kBadInput = 2, ///< invalid command line or input
    kSomeLost = 3, ///< finished, but some data was lost or skipped
};

/// Prints one line to stderr. Control and bidirectional characters are made visible (core::visible). The middle of
/// messages of more than 1,900 bytes, for example with very long paths, is omitted.
void printError(const core::Message& message);
template<class... Arguments>
void printError(core::MessageText<std::type_identity_t<Arguments>...> text, const Arguments&... arguments)
{
    printError(core::Message(text, arguments...));
}
/// Prints the status to stderr. @return the exit code of the status
[[nodiscard]] int report(const core::Status& status);
/// Prints losses to stderr, one per line. @return the exit code of an otherwise successful run
[[nodiscard]] int reportLosses(const std::vector<core::Message>& losses);
/// Prints to stdout like printf, always with a decimal point. Control and bidirectional characters in `%s` arguments
/// are made visible (core::visible); characters of `format`, such as line ends, are not changed.
[[gnu::format(printf, 1, 2)]] void print(const char* format, ...);

/// Prints JSON to stdout; characters that could control a terminal are JSON-escaped.
void printJson(std::string_view json);

using core::grouped;

/// Valid range of a numeric option; bounds are integers.
struct NumberRange
{
    double least = 0.0;
    double most = std::numeric_limits<double>::infinity();
    bool isAbove = false; ///< `least` is excluded
};

/// Parses and checks a numeric option.
[[nodiscard]] core::Result<double> numberOption(std::string_view option, const std::string& text,
                                                const NumberRange& range);
/// Help text of the option `--frame`.
inline constexpr const char* kFrameHelp =
    "Axes of a mesh file's coordinates, whatever its tag says: LPS, RAS or Y-up (x left, y up, z front)";
/// Parses `--frame`. @return the frame `text`; for an empty text, the frame tag of each file applies
[[nodiscard]] core::Result<core::FileFrame> frameOption(const std::string& text);
/// Parses `--unit`. @return millimetres per unit
[[nodiscard]] core::Result<double> unitOption(const std::string& text);

/// Checks output paths; empty paths are ignored. @return an error when an output is an input, belongs to an input
/// (study::filesOf) or is another output
[[nodiscard]] core::Status checkOutputs(const std::vector<std::filesystem::path>& inputs,
                                        const std::vector<std::filesystem::path>& outputs);

} // namespace palpate::app
