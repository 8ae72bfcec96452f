// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Message.h>

#include <array>
#include <cstdio>

namespace palpate::session::internal {

/// Returns a number with one decimal as an argument of a message: "12.0".
inline core::MessageArgument tenths(double value)
{
    std::array<char, 48> text{};
    (void)std::snprintf(text.data(), text.size(), "%.1f", value);
    core::MessageArgument argument(text.data());
    argument.kind = core::MessageArgument::Kind::Number;
    return argument;
}

} // namespace palpate::session::internal
