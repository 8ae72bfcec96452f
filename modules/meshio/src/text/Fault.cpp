// SPDX-License-Identifier: BSD-3-Clause
#include "text/Fault.h"

namespace palpate::meshio::internal {

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

} // namespace palpate::meshio::internal
