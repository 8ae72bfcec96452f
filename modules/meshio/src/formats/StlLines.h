// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "text/TextScan.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace palpate::meshio::internal {

/// Walks over the lines of an ASCII STL. On request, a line also ends before each further keyword, because some
/// programs write several keywords on a line, or the whole file on one.
class StlLines
{
  public:
    StlLines(std::string_view text, bool isSplit)
        : m_text(text)
        , m_lines(text)
        , m_isSplit(isSplit)
    {
    }
    /// @return false at the end of the text.
    bool next();
    [[nodiscard]] std::string_view line() const noexcept { return m_line; }
    [[nodiscard]] std::uint64_t number() const noexcept { return m_lines.number(); } ///< of the line in the file
    /// Byte at which the line starts.
    [[nodiscard]] std::size_t begin() const noexcept { return static_cast<std::size_t>(m_line.data() - m_text.data()); }

  private:
    std::string_view m_text;
    LineReader m_lines;
    bool m_isSplit;
    std::string_view m_line, m_rest;
};

/// @param word  the first word of a line @return true if the line is a comment of a program
[[nodiscard]] bool isStlComment(std::string_view word);

/// @return true if the text contains the begin of a facet up to the first vertex, on any number of lines
[[nodiscard]] bool hasStlFacet(std::string_view text);

} // namespace palpate::meshio::internal
