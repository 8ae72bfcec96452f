// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace palpate::meshio::internal {

/// Walks over a text line by line. Lines end in LF, CR LF or CR alone; the end is not part of the line.
class LineReader
{
  public:
    explicit LineReader(std::string_view text)
        : m_text(text)
    {
    }
    /// @return false at the end of the text.
    bool next();
    [[nodiscard]] std::string_view line() const noexcept { return m_line; }
    [[nodiscard]] std::uint64_t number() const noexcept { return m_number; } ///< from 1
    [[nodiscard]] std::size_t begin() const noexcept { return m_begin; }     ///< byte at which the line starts
    [[nodiscard]] std::size_t end() const noexcept { return m_next; }        ///< byte at which the next one starts

  private:
    std::string_view m_text;
    std::string_view m_line;
    std::uint64_t m_number = 0;
    std::size_t m_begin = 0;
    std::size_t m_next = 0;
    std::size_t m_feed = 0; ///< the first LF from m_begin on, or the end of the text
};

/// Removes the next word, a run of non-blank characters, from the front of `rest`. @return empty at the end
[[nodiscard]] std::string_view takeWord(std::string_view& rest);

[[nodiscard]] std::string_view trimmed(std::string_view text);

/// @return `text` without blanks, zero bytes and DOS end-of-file characters (0x1A) at the end, which some programs
/// write to fill the last block of a text file.
[[nodiscard]] std::string_view withoutPadding(std::string_view text);

/// @return true if every byte is zero, a blank, a DOS end-of-file character or printable ASCII: filler or a text behind
/// binary numbers, but no further numbers.
[[nodiscard]] bool isFiller(std::string_view bytes);

/// @return true if the first kilobytes are those of a text in one byte per character: hardly any zeros and control
/// characters, apart from padding at the end
[[nodiscard]] bool looksLikeText(std::string_view bytes);

/// @return the text with small ASCII letters.
[[nodiscard]] std::string lowerCase(std::string_view text);

/// @return true when both are equal but for the case of ASCII letters.
[[nodiscard]] bool sameWord(std::string_view a, std::string_view b);

/// Reads a decimal number that fills `word`, as strtod would: a leading '+', and "nan" and "inf", are allowed; too
/// large gives infinity, too small zero. Also reads what older Microsoft libraries write for other numbers than finite
/// ones, also rounded: "-1.#INF" as infinity, "-1.#IND", "1.#QNAN", "1.#QNAN0" and "1.#J" as NaN.
[[nodiscard]] std::optional<double> wordToNumber(std::string_view word);
[[nodiscard]] std::optional<std::int64_t> wordToInteger(std::string_view word);

} // namespace palpate::meshio::internal
