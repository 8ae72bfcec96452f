// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace palpate::core {

/// @return true where a spreadsheet would compute a text instead of showing it: it begins with =, +, -, @, a tab or a
/// line end
[[nodiscard]] inline bool looksLikeFormula(std::string_view text)
{
    return !text.empty() && std::string_view("=+-@\t\r\n").find(text.front()) != std::string_view::npos;
}

/// @return a text as a cell of a CSV table: in quotes where it needs them, and with an apostrophe before what would be
/// a formula
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
