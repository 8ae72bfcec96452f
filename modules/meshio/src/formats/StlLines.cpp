// SPDX-License-Identifier: BSD-3-Clause
#include "formats/StlLines.h"

#include <algorithm>
#include <array>

namespace palpate::meshio::internal {

namespace {

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words)
{
    return std::any_of(words.begin(), words.end(), [word](std::string_view other) { return sameWord(word, other); });
}

/// @param after  the words behind `word`
bool isStlKeyword(std::string_view word, std::string_view after)
{
    constexpr std::string_view kEndSolid = "endsolid"; // a name may be glued to it
    return isOneOf(word, {"facet", "outer", "outerloop", "vertex", "endloop", "endfacet"}) ||
           sameWord(word.substr(0, kEndSolid.size()), kEndSolid) ||
           (sameWord(word, "end") && isOneOf(takeWord(after), {"loop", "facet", "solid"}));
}

/// @return the position of the first keyword behind the first word of the line, or else the size
std::size_t secondKeyword(std::string_view line)
{
    std::string_view rest = line;
    const std::string_view first = takeWord(rest);
    if (isStlComment(first)) {
        return line.size();
    }
    std::string_view before = first;
    bool isEndOfSolid = sameWord(first.substr(0, 8), "endsolid");
    for (std::string_view word = takeWord(rest); !word.empty(); before = word, word = takeWord(rest)) {
        const bool isBehindEnd = before.data() == first.data() && sameWord(first, "end"); // "end facet"
        const bool isSolid = sameWord(word, "solid");
        if (!isBehindEnd && (isStlKeyword(word, rest) || (isSolid && isEndOfSolid))) {
            return static_cast<std::size_t>(word.data() - line.data());
        }
        isEndOfSolid = isEndOfSolid || (isBehindEnd && isSolid);
    }
    return line.size();
}

} // namespace

bool StlLines::next()
{
    if (m_rest.empty()) {
        if (!m_lines.next()) {
            return false;
        }
        m_rest = m_lines.line();
    }
    m_line = m_rest.substr(0, m_isSplit ? secondKeyword(m_rest) : m_rest.size());
    m_rest.remove_prefix(m_line.size());
    return true;
}

bool isStlComment(std::string_view word)
{
    return word.starts_with('#') || word.starts_with(';') || word.starts_with("//");
}

bool hasStlFacet(std::string_view text)
{
    constexpr int kMostBetween = 4; // "normal" and three numbers
    for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text)) {
        if (!sameWord(word, "facet")) {
            continue;
        }
        std::string_view rest = text;
        std::string_view next = takeWord(rest);
        for (int k = 0; k < kMostBetween && !isOneOf(next, {"outer", "outerloop"}); ++k) {
            next = takeWord(rest);
        }
        if (isOneOf(next, {"outer", "outerloop"})) {
            next = takeWord(rest);
            next = sameWord(next, "loop") ? takeWord(rest) : next;
        }
        if (sameWord(next, "vertex")) {
            return true;
        }
    }
    return false;
}

} // namespace palpate::meshio::internal
