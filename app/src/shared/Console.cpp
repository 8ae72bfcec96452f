// SPDX-License-Identifier: BSD-3-Clause
#include "shared/Console.h"

#include <palpate/core/Numbers.h>
#include <palpate/core/VisibleText.h>
#include <palpate/study/InputFiles.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

#include <sys/stat.h>

namespace palpate::app {

using core::Status;
using core::StatusCode;

void printError(const core::Message& message)
{
    // Keep both ends: the location is at the start, the remedy at the end.
    constexpr std::size_t kHead = 1200, kTail = 700;
    std::string line = core::visible(message.english());
    if (line.size() > kHead + kTail) {
        const auto isContinued = [&line](std::size_t i) {
            return (static_cast<unsigned char>(line[i]) & 0xc0U) == 0x80U;
        };
        std::size_t from = kHead, to = line.size() - kTail;
        while (isContinued(from)) {
            --from;
        }
        while (to < line.size() && isContinued(to)) {
            ++to;
        }
        line.replace(from, to - from, " … ");
    }
    std::fprintf(stderr, "palpate: %s\n", line.c_str());
}

int report(const Status& status)
{
    if (status.isOk()) {
        return kDone;
    }
    printError(status.text());
    switch (status.code()) {
    case StatusCode::Internal:
    case StatusCode::DeviceLost:
    case StatusCode::Cancelled:
        return kFailed;
    default:
        return kBadInput;
    }
}

int reportLosses(const std::vector<core::Message>& losses)
{
    for (const core::Message& loss : losses) {
        printError(loss);
    }
    return losses.empty() ? kDone : kSomeLost;
}

namespace {

/// Writes a number without an exponent, in the precision, width and sign of a conversion such as "%-9.2g".
std::string plainNumber(const std::string& spec, double value)
{
    const std::size_t point = spec.find('.');
    const int digits = point == std::string::npos ? 6 : std::atoi(spec.c_str() + point + 1);
    const std::size_t first = spec.find_first_of("123456789.g", 1);
    const std::string flags = spec.substr(1, first - 1);
    const auto width = static_cast<std::size_t>(std::atoi(spec.c_str() + first));
    std::string text = core::shortNumber(value, digits);
    if (flags.find('+') != std::string::npos && !std::signbit(value)) {
        text.insert(0, "+");
    }
    const auto letters = static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xC0) != 0x80; })); // of UTF-8
    if (letters < width) {
        text.insert(flags.find('-') != std::string::npos ? text.size() : 0, width - letters, ' ');
    }
    return text;
}

/// Formats one printf conversion `spec` with arguments taken from `arguments`.
void appendConversion(std::string& out, std::string spec, va_list& arguments)
{
    const auto add = [&out](const char* format, auto value) {
        const int size = std::snprintf(nullptr, 0, format, value);
        if (size > 0) {
            std::string text(static_cast<std::size_t>(size) + 1, '\0');
            std::snprintf(text.data(), text.size(), format, value);
            text.pop_back();
            out += text;
        }
    };
    for (auto star = spec.find('*'); star != std::string::npos; star = spec.find('*')) {
        spec.replace(star, 1, std::to_string(va_arg(arguments, int)));
    }
    const bool isLong = spec.find('l') != std::string::npos || spec.find('z') != std::string::npos;
    switch (spec.back()) {
    case 's':
        add(spec.c_str(), core::visible(va_arg(arguments, const char*)).c_str());
        break;
    case 'e':
    case 'f':
        add(spec.c_str(), va_arg(arguments, double));
        break;
    case 'g':
        out += plainNumber(spec, va_arg(arguments, double));
        break;
    default: // integers; `long`, `long long` and `size_t` have the same size here
        static_assert(sizeof(long) == sizeof(long long) && sizeof(long) == sizeof(std::size_t));
        isLong ? add(spec.c_str(), va_arg(arguments, long)) : add(spec.c_str(), va_arg(arguments, int));
        break;
    }
}

} // namespace

void print(const char* format, ...)
{
    // Uses the C locale, because the program never calls setlocale before a subcommand ends.
    std::string out;
    va_list arguments;
    va_start(arguments, format);
    for (std::string_view rest = format; !rest.empty();) {
        const std::size_t plain = std::min(rest.find('%'), rest.size());
        out += rest.substr(0, plain);
        rest.remove_prefix(plain);
        if (rest.starts_with("%%")) {
            out += '%';
            rest.remove_prefix(2);
        } else if (!rest.empty()) {
            const std::size_t end = rest.find_first_of("diufegsxc") + 1;
            appendConversion(out, std::string(rest.substr(0, end)), arguments);
            rest.remove_prefix(end);
        }
    }
    va_end(arguments);
    std::fwrite(out.data(), 1, out.size(), stdout);
}

void printJson(std::string_view json)
{
    const std::string text = core::visibleJson(json);
    std::fwrite(text.data(), 1, text.size(), stdout);
}

core::Result<double> numberOption(std::string_view option, const std::string& text, const NumberRange& range)
{
    const auto value = core::parseNumber(text);
    const bool isGood = value && std::isfinite(*value) && *value <= range.most &&
                        (range.isAbove ? *value > range.least : *value >= range.least);
    if (isGood) {
        return *value;
    }
    const auto least = static_cast<long long>(range.least);
    if (!std::isfinite(range.most)) {
        return range.isAbove
                   ? Status(StatusCode::BadCommandLine, PALPATE_TEXT("%1: found \"%2\", expected a number above %3"),
                            option, text, least)
                   : Status(StatusCode::BadCommandLine,
                            PALPATE_TEXT("%1: found \"%2\", expected a number of at least %3"), option, text, least);
    }
    const auto most = static_cast<long long>(range.most);
    return range.isAbove ? Status(StatusCode::BadCommandLine,
                                  PALPATE_TEXT("%1: found \"%2\", expected a number above %3 and at most %4"), option,
                                  text, least, most)
                         : Status(StatusCode::BadCommandLine,
                                  PALPATE_TEXT("%1: found \"%2\", expected a number of at least %3 and at most %4"),
                                  option, text, least, most);
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
    return Status(StatusCode::BadCommandLine, PALPATE_TEXT("--unit: found \"%1\", expected m, cm or mm"), text);
}

core::Result<core::FileFrame> frameOption(const std::string& text)
{
    const auto named = core::frameNamed(text);
    if (text.empty() || named) {
        return named.value_or(core::FileFrame::Untagged);
    }
    return Status(StatusCode::BadCommandLine, PALPATE_TEXT("--frame: found \"%1\", expected LPS, RAS or Y-up"), text);
}

namespace {

/// Resolves a path as far as it exists.
std::filesystem::path placeOf(const std::filesystem::path& path)
{
    std::error_code error;
    std::filesystem::path place = std::filesystem::weakly_canonical(path, error);
    return error ? std::filesystem::absolute(path, error).lexically_normal() : place;
}

/// Returns whether writing `output` would replace an input file. Another hard link to the input may be replaced
/// safely.
bool overwritesInput(const std::filesystem::path& output, const std::filesystem::path& read)
{
    struct stat a
    {
    };
    struct stat b
    {
    };
    return ::stat(output.c_str(), &a) == 0 && ::stat(read.c_str(), &b) == 0 && S_ISREG(a.st_mode) &&
           a.st_dev == b.st_dev && a.st_ino == b.st_ino && (a.st_nlink == 1 || placeOf(output) == placeOf(read));
}

} // namespace

Status checkOutputs(const std::vector<std::filesystem::path>& inputs, const std::vector<std::filesystem::path>& outputs)
{
    const bool isAny = std::any_of(outputs.begin(), outputs.end(), [](const auto& output) { return !output.empty(); });
    for (std::size_t k = 0; isAny && k < inputs.size(); ++k) {
        for (const std::filesystem::path& file : study::filesOf(inputs[k])) {
            for (const std::filesystem::path& output : outputs) {
                if (!overwritesInput(output, file)) {
                    continue;
                }
                const bool isNamed = overwritesInput(output, inputs[k]);
                return {StatusCode::BadCommandLine,
                        isNamed ? core::Message(
                                      PALPATE_TEXT("%1: found it as input and output, expected another name for the "
                                                   "output"),
                                      output)
                                : core::Message(
                                      PALPATE_TEXT("%1: found it as output and a file of %2, expected another name for "
                                                   "the output"),
                                      output, inputs[k])};
            }
        }
    }
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (!outputs[i].empty() && placeOf(outputs[i]) == placeOf(outputs[k])) {
                return {StatusCode::BadCommandLine,
                        PALPATE_TEXT("%1: found it as two outputs, expected a name for each"), outputs[i]};
            }
        }
    }
    return {};
}

} // namespace palpate::app
