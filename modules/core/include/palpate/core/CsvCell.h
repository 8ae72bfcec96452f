// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace palpate::core {

/// @return true if a spreadsheet would evaluate the text as a formula: the first character is =, +, -, @, a tab or a
/// line end
[[nodiscard]] inline bool looksLikeFormula(std::string_view text)
{
    return !text.empty() && std::string_view("=+-@\t\r\n").find(text.front()) != std::string_view::npos;
}

/// @return the text as a CSV cell: quoted if necessary, and prefixed with an apostrophe if a spreadsheet would evaluate
/// the text as a formula
[[nodiscard]] inline std::string csvCell(std::string_view text)
{
    std::string cell(looksLikeFormula(text) ? "'" : "");
    cell.append(text);
    if (cell.find_first_of(",\"\r\n") == std::string::npos) {
        return cell;
    }
    for (std::size_t i = 0; (i = cell.find('"', i)) != std::string::npos; i += 2) {
        cell.insert(i, 1, '"');
    }
    return '"' + cell + '"';
}

} // namespace palpate::core
