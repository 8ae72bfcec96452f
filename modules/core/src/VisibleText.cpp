// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/core/VisibleText.h"

#include <array>
#include <cstddef>
#include <cstdio>

namespace palpate::core {

namespace {

/// Decoded UTF-8 character; an invalid byte is returned as a character of its own.
struct Character
{
    char32_t code;
    std::size_t bytes;
    bool isValid;
};

/// @pre !text.empty()
/// @par Source RFC 3629, section 4: no overlong forms, no surrogates, at most U+10FFFF.
Character firstOf(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) {
        return {lead, 1, true};
    }
    const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    constexpr std::array<char32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
    if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) {
        return {lead, 1, false};
    }
    char32_t code = lead & (0x7fU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0U) != 0x80U) {
            return {lead, 1, false};
        }
        code = (code << 6U) | (byte(i) & 0x3fU);
    }
    const bool isSurrogate = code >= 0xd800 && code <= 0xdfff;
    return code < kLeast[bytes] || isSurrogate || code > 0x10ffff ? Character{lead, 1, false}
                                                                  : Character{code, bytes, true};
}

/// @par Source Unicode Standard Annex #9, table 2: the explicit formatting characters of the bidirectional algorithm.
bool isBidirectional(char32_t code)
{
    return code == 0x061c || code == 0x200e || code == 0x200f || (code >= 0x202a && code <= 0x202e) ||
           (code >= 0x2066 && code <= 0x2069);
}

bool isHidden(char32_t code)
{
    const bool isControl = code < 0x20 || (code >= 0x7f && code < 0xa0);
    return isControl || isBidirectional(code) || code == 0x2028 || code == 0x2029;
}

template<class Escape>
std::string escaped(std::string_view text, Escape&& escape)
{
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const Character next = firstOf(text);
        if (!escape(next, out)) {
            out.append(text.substr(0, next.bytes));
        }
        text.remove_prefix(next.bytes);
    }
    return out;
}

std::string hexEscape(const char* format, char32_t code)
{
    std::array<char, 16> buffer{};
    std::snprintf(buffer.data(), buffer.size(), format, static_cast<unsigned>(code));
    return buffer.data();
}

} // namespace

std::string visible(std::string_view text)
{
    return escaped(text, [](const Character& next, std::string& out) {
        if (next.isValid && !isHidden(next.code)) {
            return false;
        }
        out += next.code == '\n'   ? "\\n"
               : next.code == '\r' ? "\\r"
               : next.code == '\t' ? "\\t"
                                   : hexEscape(next.code < 0x100 ? "\\x%02x" : "\\u%04x", next.code);
        return true;
    });
}

std::string visibleJson(std::string_view json)
{
    return escaped(json, [](const Character& next, std::string& out) {
        if (!next.isValid || next.code < 0x20 || !isHidden(next.code)) {
            return false; // JSON text contains no control characters except whitespace between tokens
        }
        out += hexEscape("\\u%04x", next.code);
        return true;
    });
}

} // namespace palpate::core
