// SPDX-License-Identifier: BSD-3-Clause
#include "text/Encoding.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate::meshio::internal {

namespace {

/// Code points of the bytes 0x80 to 0x9f in Windows-1252; all other bytes are code points of Latin-1. The WHATWG
/// Encoding Standard maps the five unassigned bytes to control characters; here they become U+FFFD.
constexpr std::array<char16_t, 32> kWindows1252{0x20ac, 0xfffd, 0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021,
                                                0x02c6, 0x2030, 0x0160, 0x2039, 0x0152, 0xfffd, 0x017d, 0xfffd,
                                                0xfffd, 0x2018, 0x2019, 0x201c, 0x201d, 0x2022, 0x2013, 0x2014,
                                                0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0xfffd, 0x017e, 0x0178};

void appendUtf8(std::string& out, std::uint32_t code)
{
    const auto put = [&out](std::uint32_t byte) { out += static_cast<char>(byte); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xc0U | code >> 6U);
        put(0x80U | (code & 0x3fU));
    } else if (code < 0x10000) {
        put(0xe0U | code >> 12U);
        put(0x80U | (code >> 6U & 0x3fU));
        put(0x80U | (code & 0x3fU));
    } else {
        put(0xf0U | code >> 18U);
        put(0x80U | (code >> 12U & 0x3fU));
        put(0x80U | (code >> 6U & 0x3fU));
        put(0x80U | (code & 0x3fU));
    }
}

/// Byte order of a text in UTF-16 without a byte order mark: nearly all characters at its begin are ASCII, with a zero
/// byte each. @return true for little-endian, false for big-endian, nothing for other content
std::optional<bool> isLittleUtf16(std::string_view bytes)
{
    constexpr std::size_t kSample = 512, kLeast = 8; // characters
    const std::size_t characters = std::min(bytes.size() / 2, kSample);
    const auto isAscii = [](char c) { return (c >= ' ' && c < '\x7f') || (c >= '\t' && c <= '\r'); };
    std::array<std::size_t, 2> count = {}; // with the zero byte first, second
    for (std::size_t i = 0; i < characters; ++i) {
        const char a = bytes[2 * i], b = bytes[2 * i + 1];
        count[0] += a == '\0' && isAscii(b) ? 1 : 0;
        count[1] += b == '\0' && isAscii(a) ? 1 : 0;
    }
    for (const std::size_t order : {0U, 1U}) {
        if (characters >= kLeast && count[order] * 10 >= characters * 9 && bytes[order] == '\0') {
            return order == 1;
        }
    }
    return std::nullopt;
}

/// @return bytes of the UTF-8 character at the front of `text`; 0 if there is no valid one (RFC 3629, section 4)
std::size_t utf8Length(std::string_view text)
{
    const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    const std::size_t length = first < 0x80   ? 1
                               : first < 0xc2 ? 0
                               : first < 0xe0 ? 2
                               : first < 0xf0 ? 3
                               : first < 0xf5 ? 4
                                              : 0;
    if (length == 0 || length > text.size()) {
        return 0;
    }
    for (std::size_t i = 1; i < length; ++i) {
        // The second byte is bounded further: no overlong forms, no surrogates, nothing above U+10FFFF.
        const unsigned char least = i > 1 ? 0x80 : first == 0xe0 ? 0xa0 : first == 0xf0 ? 0x90 : 0x80;
        const unsigned char most = i > 1 ? 0xbf : first == 0xed ? 0x9f : first == 0xf4 ? 0x8f : 0xbf;
        if (byte(i) < least || byte(i) > most) {
            return 0;
        }
    }
    return length;
}

bool isUtf8(std::string_view text)
{
    while (!text.empty()) {
        const std::size_t length = utf8Length(text);
        if (length == 0) {
            return false;
        }
        text.remove_prefix(length);
    }
    return true;
}

} // namespace

std::string utf8Of(std::string_view name)
{
    if (isUtf8(name)) {
        return std::string(name);
    }
    std::string out;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        appendUtf8(out, byte >= 0x80 && byte < 0xa0 ? kWindows1252[byte - 0x80U] : byte);
    }
    return out;
}

std::optional<std::string> fromUtf16(std::string_view bytes)
{
    const bool hasMark = bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff");
    const std::optional<bool> order = hasMark ? std::optional(bytes.starts_with("\xff\xfe")) : isLittleUtf16(bytes);
    if (!order) {
        return std::nullopt;
    }
    const bool isLittle = *order;
    const auto unit = [&](std::size_t at) -> std::uint32_t {
        const auto a = static_cast<unsigned char>(bytes[at]);
        const auto b = static_cast<unsigned char>(bytes[at + 1]);
        return isLittle ? a | std::uint32_t{b} << 8U : b | std::uint32_t{a} << 8U;
    };
    constexpr std::uint32_t kHigh = 0xd800, kLow = 0xdc00, kEnd = 0xe000, kReplacement = 0xfffd;
    std::string out;
    out.reserve(bytes.size() / 2);
    for (std::size_t at = hasMark ? 2 : 0; at + 1 < bytes.size(); at += 2) {
        std::uint32_t code = unit(at);
        if (code >= kHigh && code < kEnd) {
            const std::uint32_t next = code < kLow && at + 3 < bytes.size() ? unit(at + 2) : 0;
            if (next >= kLow && next < kEnd) {
                code = 0x10000 + ((code - kHigh) << 10U) + (next - kLow);
                at += 2;
            } else {
                code = kReplacement;
            }
        }
        appendUtf8(out, code);
    }
    return out;
}

void dropXmlEncoding(std::string& text)
{
    const std::size_t end = text.starts_with("<?xml") ? text.find("?>") : std::string::npos;
    const std::size_t begin = text.find("encoding");
    const std::size_t open = text.find_first_of("\"'", begin);
    if (end == std::string::npos || begin > end || open > end) {
        return;
    }
    const std::size_t close = text.find(text[open], open + 1);
    if (close < end) {
        std::fill_n(text.begin() + static_cast<std::ptrdiff_t>(begin), close + 1 - begin, ' ');
    }
}

} // namespace palpate::meshio::internal
