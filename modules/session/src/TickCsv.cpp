// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/TickCsv.h"

#include "TickColumns.h"

#include <palpate/core/Numbers.h>

#include <algorithm>
#include <concepts>
#include <iterator>
#include <utility>
#include <vector>

namespace palpate::session {

namespace {

void appendText(std::string& line, std::string_view text)
{
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
        line.append(text);
        return;
    }
    line += '"';
    for (const char c : text) {
        line.append(c == '"' ? 2 : 1, c);
    }
    line += '"';
}

/// What the CSV shows, in its order.
const std::vector<internal::TickColumn>& shownColumns()
{
    static const std::vector<internal::TickColumn> kShown = [] {
        std::vector<internal::TickColumn> columns;
        std::copy_if(std::begin(internal::kTickColumns), std::end(internal::kTickColumns), std::back_inserter(columns),
                     [](const internal::TickColumn& column) { return column.csv > 0; });
        std::sort(columns.begin(), columns.end(), [](const auto& a, const auto& b) { return a.csv < b.csv; });
        return columns;
    }();
    return kShown;
}

void appendValue(std::string& line, const core::Vec3& v)
{
    for (int i = 0; i < 3; ++i) {
        line += i > 0 ? "," : "";
        core::appendNumber(line, v[i]);
    }
}

void appendValue(std::string& line, double value)
{
    core::appendNumber(line, value);
}

void appendValue(std::string& line, std::integral auto value)
{
    line += std::to_string(value);
}

} // namespace

TickCsv::TickCsv(AtomicFile file)
    : m_file(std::move(file))
{
}

core::Result<TickCsv> TickCsv::create(const std::filesystem::path& path)
{
    auto file = AtomicFile::create(path);
    if (!file.isOk()) {
        return file.status();
    }
    TickCsv csv(std::move(file).value());
    for (const internal::TickColumn& column : shownColumns()) {
        for (const std::string& name : internal::columnNames(column)) {
            csv.m_line += (csv.m_line.empty() ? "" : ",") + name;
        }
    }
    csv.m_file.write(csv.m_line + '\n');
    return csv;
}

void TickCsv::write(const servo::TickRecord& tick, std::string_view structure)
{
    m_line.clear();
    for (const internal::TickColumn& column : shownColumns()) {
        m_line += m_line.empty() ? "" : ",";
        if (column.name == "structure") {
            appendText(m_line, structure);
        } else {
            internal::useValue(column, tick, [this](const auto& value) { appendValue(m_line, value); });
        }
    }
    m_line += '\n';
    m_file.write(m_line);
}

core::Status TickCsv::finish()
{
    return m_file.finish();
}

} // namespace palpate::session
