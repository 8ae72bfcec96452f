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

void appendValue(std::string&, const haptics::TickResult&)
{
    // `layers` needs names: see `appendLayer`.
}

/// The column `slides` between its commas.
const char* slides(haptics::Friction friction)
{
    switch (friction) {
    case haptics::Friction::Slides:
        return ",1,";
    case haptics::Friction::Holds:
        return ",0,";
    case haptics::Friction::None:
        break;
    }
    return ",,";
}

/// Appends `name=force_N=depth_mm`. What would be read as a part of the line, and '%' itself, stands as % and two
/// hexadecimal digits in the name, as in a URL.
void appendLayer(std::string& line, const haptics::Contact& contact, const StructureNames& names)
{
    constexpr char kDigits[] = "0123456789ABCDEF";
    for (const char c : names(contact.structure)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < ' ' || std::string_view("%;=,\"").find(c) != std::string_view::npos) {
            line += {'%', kDigits[byte / 16], kDigits[byte % 16]};
        } else {
            line += c;
        }
    }
    line += '=';
    core::appendNumber(line, contact.f_W.norm());
    line += '=';
    core::appendNumber(line, contact.depth_mm);
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
    csv.m_line += ",slides,layers\n";
    csv.m_file.write(csv.m_line);
    return csv;
}

void TickCsv::write(const servo::TickRecord& tick, const StructureNames& names)
{
    m_line.clear();
    for (const internal::TickColumn& column : shownColumns()) {
        m_line += m_line.empty() ? "" : ",";
        if (column.name == "structure") {
            appendText(m_line, tick.felt.structure < 0 ? std::string_view()
                                                       : names(static_cast<std::uint32_t>(tick.felt.structure)));
        } else {
            internal::useValue(column, tick, [this](const auto& value) { appendValue(m_line, value); });
        }
    }
    m_line += slides(tick.felt.friction());
    for (std::size_t i = 0; i < tick.felt.contactCount; ++i) {
        appendLayer(m_line, tick.felt.contacts[i], names);
        m_line += i + 1 < tick.felt.contactCount ? ";" : "";
    }
    m_line += '\n';
    m_file.write(m_line);
}

core::Status TickCsv::finish()
{
    return m_file.finish();
}

} // namespace palpate::session
