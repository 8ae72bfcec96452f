// SPDX-License-Identifier: BSD-3-Clause
#include "text/Fault.h"

namespace palpate::meshio::internal {

core::Status fault(core::StatusCode code, std::string_view file, std::string_view place, std::string_view found,
                   std::string_view expected)
{
    std::string line(file);
    if (!place.empty()) {
        line.append(": ").append(place);
    }
    line.append(": ").append(found);
    if (!expected.empty()) {
        line.append("; expected ").append(expected);
    }
    return {code, std::move(line)};
}

core::Status fault(core::StatusCode code, std::string_view file, const core::Message& place, const core::Message& found,
                   const core::Message& expected)
{
    const core::Message what =
        expected.isEmpty() ? found : core::Message(PALPATE_TEXT("%1; expected %2"), found, expected);
    return place.isEmpty() ? core::Status(code, PALPATE_TEXT("%1: %2"), file, what)
                           : core::Status(code, PALPATE_TEXT("%1: %2: %3"), file, place, what);
}

core::Message onLine(std::uint64_t line)
{
    return {PALPATE_TEXT("line %1"), line};
}

core::Message onByte(std::uint64_t byte)
{
    return {PALPATE_TEXT("byte %1"), byte};
}

std::string atLine(std::uint64_t line)
{
    return "line " + std::to_string(line);
}

std::string atByte(std::uint64_t byte)
{
    return "byte " + std::to_string(byte);
}

std::string counted(std::uint64_t value, std::string_view noun)
{
    std::string text = grouped(value).append(" ").append(noun);
    if (value != 1) {
        text += 's';
    }
    return text;
}

} // namespace palpate::meshio::internal
