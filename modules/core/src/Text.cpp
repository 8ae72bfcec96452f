// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/core/Text.h"

namespace palpate::core {

std::string internal::grouped(std::uint64_t magnitude, bool isNegative)
{
    std::string digits = std::to_string(magnitude);
    for (std::size_t i = digits.size(); i > 3;) {
        i -= 3;
        digits.insert(i, 1, ',');
    }
    if (isNegative) {
        digits.insert(0, 1, '-');
    }
    return digits;
}

std::string inQuotes(std::string_view text)
{
    constexpr std::size_t kMost = 40;
    const auto isContinued = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; };
    std::size_t end = text.size() > kMost ? kMost : text.size();
    while (end > 0 && end < text.size() && isContinued(text[end])) {
        --end;
    }
    std::string out = "\"";
    for (const char c : text.substr(0, end)) {
        const auto byte = static_cast<unsigned char>(c);
        out += byte < 0x20 || byte == 0x7f ? '?' : c;
    }
    out += end < text.size() ? "…\"" : "\"";
    return out;
}

} // namespace palpate::core
