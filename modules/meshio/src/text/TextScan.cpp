// SPDX-License-Identifier: BSD-3-Clause
#include "text/TextScan.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <system_error>

namespace palpate::meshio::internal {

namespace {

constexpr char kDosEnd = '\x1a';

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Reads "1.#INF", "-1.#IND", "1.#QNAN" and "1.#SNAN", with further digits or rounded to fewer characters.
std::optional<double> microsoftNumber(std::string_view word)
{
    constexpr std::string_view kBegin = "1.#";
    const bool isNegative = word.starts_with('-');
    word.remove_prefix(isNegative ? 1 : 0);
    const bool isOne = word.starts_with(kBegin) && word.size() > kBegin.size();
    word.remove_prefix(isOne ? kBegin.size() : 0);
    if (!isOne || !std::all_of(word.begin(), word.end(),
                               [](char c) { return (c >= '0' && c <= '9') || (lower(c) >= 'a' && lower(c) <= 'z'); })) {
        return std::nullopt;
    }
    const double infinity = std::numeric_limits<double>::infinity();
    return !sameWord(word.substr(0, 3), "inf") ? std::numeric_limits<double>::quiet_NaN()
           : isNegative                        ? -infinity
                                               : infinity;
}

} // namespace

bool LineReader::next()
{
    if (m_next >= m_text.size()) {
        return false;
    }
    m_begin = m_next;
    if (m_feed < m_begin || m_number == 0) {
        m_feed = std::min(m_text.find('\n', m_begin), m_text.size());
    }
    // Searched up to the next LF only, so that a text of either kind is walked over once.
    const std::size_t back = m_text.substr(m_begin, m_feed - m_begin).find('\r');
    const std::size_t stop = back == std::string_view::npos ? m_feed : m_begin + back;
    m_next = std::min(stop + (m_text.substr(stop, 2) == "\r\n" ? 2 : 1), m_text.size());
    m_line = m_text.substr(m_begin, stop - m_begin);
    ++m_number;
    return true;
}

std::string_view takeWord(std::string_view& rest)
{
    std::size_t from = 0;
    while (from < rest.size() && isBlank(rest[from])) {
        ++from;
    }
    std::size_t to = from;
    while (to < rest.size() && !isBlank(rest[to])) {
        ++to;
    }
    const std::string_view word = rest.substr(from, to - from);
    rest.remove_prefix(to);
    return word;
}

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && isBlank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && isBlank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

std::string_view withoutPadding(std::string_view text)
{
    while (!text.empty() && (isBlank(text.back()) || text.back() == '\0' || text.back() == kDosEnd)) {
        text.remove_suffix(1);
    }
    return text;
}

bool isFiller(std::string_view bytes)
{
    return std::all_of(bytes.begin(), bytes.end(),
                       [](char c) { return (c >= ' ' && c < '\x7f') || isBlank(c) || c == '\0' || c == kDosEnd; });
}

bool looksLikeText(std::string_view bytes)
{
    constexpr std::size_t kSample = 4096, kLeastPerControl = 50;
    const std::string_view head = withoutPadding(bytes).substr(0, kSample);
    const auto controls = std::count_if(head.begin(), head.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return (byte < ' ' && !isBlank(c)) || byte == 0x7f;
    });
    return !head.empty() && static_cast<std::size_t>(controls) * kLeastPerControl <= head.size();
}

std::string lowerCase(std::string_view text)
{
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(), lower);
    return out;
}

bool sameWord(std::string_view a, std::string_view b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

std::optional<double> wordToNumber(std::string_view word)
{
    if (word.size() > 1 && word.front() == '+' && word[1] != '-') {
        word.remove_prefix(1);
    }
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || end != word.data() + word.size()) {
        return microsoftNumber(word);
    }
    if (error == std::errc::result_out_of_range) {
        return word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos
                   ? 0.0
                   : std::numeric_limits<double>::infinity();
    }
    return error == std::errc() ? std::optional(value) : std::nullopt;
}

std::optional<std::int64_t> wordToInteger(std::string_view word)
{
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || error != std::errc() || end != word.data() + word.size()) {
        return std::nullopt;
    }
    return value;
}

} // namespace palpate::meshio::internal
