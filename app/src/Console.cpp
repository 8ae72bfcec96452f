// SPDX-License-Identifier: BSD-3-Clause
#include "Console.h"

#include <palpate/core/Numbers.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace palpate::app {

using core::Status;
using core::StatusCode;

void printError(std::string_view message)
{
    std::string line = "palpate: " + std::string(message);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    std::fprintf(stderr, "%s\n", line.c_str());
}

int report(const Status& status)
{
    if (status.isOk()) {
        return kDone;
    }
    printError(status.message());
    switch (status.code()) {
    case StatusCode::Internal:
    case StatusCode::DeviceLost:
    case StatusCode::Cancelled:
        return kFailed;
    default:
        return kBadInput;
    }
}

int reportLosses(const std::vector<std::string>& losses)
{
    for (const std::string& loss : losses) {
        printError(loss);
    }
    return losses.empty() ? kDone : kSomeLost;
}

void print(const char* format, ...)
{
    // The program never calls setlocale before a subcommand ends, so that this is the C locale.
    va_list arguments;
    va_start(arguments, format);
    std::vprintf(format, arguments);
    va_end(arguments);
}

core::Result<double> numberOption(std::string_view option, const std::string& text, const NumberRange& range)
{
    const auto value = core::parseNumber(text);
    const bool isGood = value && std::isfinite(*value) && *value <= range.most &&
                        (range.isAbove ? *value > range.least : *value >= range.least);
    if (isGood) {
        return *value;
    }
    const auto whole = [](double bound) { return std::to_string(static_cast<long long>(bound)); };
    std::string expected = (range.isAbove ? "above " : "of at least ") + whole(range.least);
    if (std::isfinite(range.most)) {
        expected += " and at most " + whole(range.most);
    }
    return Status(StatusCode::BadCommandLine,
                  std::string(option) + ": found \"" + text + "\", expected a number " + expected);
}

core::Result<double> unitOption(const std::string& text)
{
    if (text == "mm") {
        return 1.0;
    }
    if (text == "cm") {
        return 10.0;
    }
    if (text == "m") {
        return 1000.0;
    }
    return Status(StatusCode::BadCommandLine, "--unit: found \"" + text + "\", expected m, cm or mm");
}

core::Result<core::FileFrame> frameOption(const std::string& text)
{
    const auto named = core::frameNamed(text);
    if (text.empty() || named) {
        return named.value_or(core::FileFrame::Untagged);
    }
    return Status(StatusCode::BadCommandLine, "--frame: found \"" + text + "\", expected LPS, RAS or Y-up");
}

Status checkOutputs(const std::vector<std::filesystem::path>& inputs, const std::vector<std::filesystem::path>& outputs)
{
    const auto isSame = [](const std::filesystem::path& a, const std::filesystem::path& b) {
        std::error_code error;
        return !a.empty() && std::filesystem::weakly_canonical(a, error) == std::filesystem::weakly_canonical(b, error);
    };
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        for (const auto& input : inputs) {
            if (isSame(outputs[i], input)) {
                return {StatusCode::BadCommandLine, outputs[i].string() + ": found it as input and output, "
                                                                          "expected another name for the output"};
            }
        }
        for (std::size_t k = 0; k < i; ++k) {
            if (isSame(outputs[i], outputs[k])) {
                return {StatusCode::BadCommandLine,
                        outputs[i].string() + ": found it as two outputs, expected a name for each"};
            }
        }
    }
    return {};
}

} // namespace palpate::app
