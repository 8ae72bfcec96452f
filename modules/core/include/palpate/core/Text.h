// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace palpate::core {

namespace internal {
[[nodiscard]] std::string grouped(std::uint64_t magnitude, bool isNegative);
}

/// @return a whole number with a comma every three digits: "1,234,567"
template<std::integral T>
[[nodiscard]] std::string grouped(T value)
{
    const auto bits = static_cast<std::uint64_t>(value);
    return std::cmp_less(value, 0) ? internal::grouped(std::uint64_t{0} - bits, true) : internal::grouped(bits, false);
}

/// @return `text` in quotes, fit for a message of one line: at most 40 bytes of it, whole characters of UTF-8, with "?"
/// for control characters and "…" for what is left out
[[nodiscard]] std::string inQuotes(std::string_view text);

} // namespace palpate::core
