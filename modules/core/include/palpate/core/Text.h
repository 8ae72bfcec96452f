// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Export.h"

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace palpate::core {

namespace internal {
[[nodiscard]] PALPATE_EXPORT std::string grouped(std::uint64_t magnitude, bool isNegative);
}

/// @return whole number with a comma every three digits: "1,234,567"
template<std::integral T>
[[nodiscard]] std::string grouped(T value)
{
    const auto bits = static_cast<std::uint64_t>(value);
    return std::cmp_less(value, 0) ? internal::grouped(std::uint64_t{0} - bits, true) : internal::grouped(bits, false);
}

/// @return `text` in quotes, safe for a one-line message: at most 40 bytes, cut at UTF-8 character boundaries, with "?"
/// for control characters and "…" for omitted text
[[nodiscard]] PALPATE_EXPORT std::string inQuotes(std::string_view text);

} // namespace palpate::core
