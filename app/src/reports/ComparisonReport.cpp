// SPDX-License-Identifier: BSD-3-Clause
#include "reports/ComparisonReport.h"

#include "shared/Console.h"

#include <palpate/core/VisibleText.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace palpate::app {

namespace {

/// Number of columns of a UTF-8 text on a terminal: bytes that do not continue a character.
std::size_t widthOf(const std::string& text)
{
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

void printTable(const study::ReportTable& table)
{
    std::vector<std::vector<std::string>> rows(1);
    for (const study::ReportTable::Column& column : table.columns) {
        rows.front().push_back(column.heading.english());
    }
    for (const std::vector<core::MessageArgument>& row : table.rows) {
        rows.emplace_back();
        for (const core::MessageArgument& cell : row) {
            rows.back().push_back(core::visible(cell.english));
        }
    }
    std::vector<std::size_t> widths(table.columns.size());
    for (const std::vector<std::string>& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            widths[i] = std::max(widths[i], widthOf(row[i]));
        }
    }
    print("%s\n", table.caption.english().c_str());
    for (const std::vector<std::string>& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string gap(widths[i] - widthOf(row[i]), ' ');
            line += "  " + (table.columns[i].isNumber ? gap + row[i] : row[i] + gap);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        print("%s\n", line.c_str());
    }
}

} // namespace

void printCompared(const study::RecordingComparison& comparison)
{
    for (const study::ReportTable& table : study::comparisonTables(comparison.sessions)) {
        printTable(table);
    }
    for (const core::Message& one : comparison.conditions) {
        print("%s\n", one.english().c_str());
    }
}

} // namespace palpate::app
