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
