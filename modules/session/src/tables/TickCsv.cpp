// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/TickCsv.h"

#include "tables/TickColumns.h"

#include <palpate/core/CsvCell.h>
#include <palpate/core/Numbers.h>

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace palpate::session {

namespace {

/// Returns the CSV columns in order.
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
    // `layers` needs structure names: see `appendLayers`.
}

/// Formats the column `slides`.
const char* slides(haptics::Friction friction)
{
    switch (friction) {
    case haptics::Friction::Slides:
        return "1";
    case haptics::Friction::Holds:
        return "0";
    case haptics::Friction::None:
        break;
    }
    return "";
}

/// Appends a list item within a cell. Separators, '%' and characters that would start a formula at the beginning of a
/// cell are percent-encoded as in a URL.
void appendEscaped(std::string& line, std::string_view text, bool isAtStart, std::string_view also = {})
{
    constexpr char kDigits[] = "0123456789ABCDEF";
    static constexpr auto kIsSeparator = [] {
        std::array<bool, 256> is{};
        for (const unsigned char c : {'%', ';', '=', ',', '"'}) {
            is[c] = true;
        }
        return is;
    }();
    std::size_t begin = 0; // of the characters that are not yet appended
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const auto byte = static_cast<unsigned char>(c);
        if (byte < ' ' || (std::exchange(isAtStart, false) && core::looksLikeFormula({&c, 1})) || kIsSeparator[byte] ||
            also.find(c) != std::string_view::npos) {
            line += text.substr(begin, i - begin);
            line += {'%', kDigits[byte / 16], kDigits[byte % 16]};
            begin = i + 1;
        }
    }
    line += text.substr(begin);
}

/// Appends `name=force_N=depth_mm` for each structure in contact.
void appendLayers(std::string& line, const haptics::TickResult& felt, const StructureNames& names)
{
    for (std::size_t i = 0; i < felt.contactCount; ++i) {
        const haptics::Contact& contact = felt.contacts[i];
        line += i > 0 ? ";" : "";
        appendEscaped(line, names(contact.structure), i == 0);
        line += '=';
        core::appendNumber(line, contact.f_W.norm());
        line += '=';
        core::appendNumber(line, contact.depth_mm);
    }
}

/// Returns the subject of an event: text of a note, name of a finding or of a structure; empty for other kinds.
std::string subjectOf(const RecordingEvent& event)
{
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(event.json)).object();
    for (const char* key : {"text", "name", "structure", "what"}) {
        if (const QJsonValue value = json[QLatin1String(key)]; value.isString()) {
            return value.toString().toStdString();
        }
    }
    return {};
}

/// Appends `kind` or `kind=subject` for each event.
void appendEvents(std::string& line, std::span<const RecordingEvent> events)
{
    bool isFirst = true;
    for (const RecordingEvent& event : events) {
        line += isFirst ? "" : "|";
        appendEscaped(line, event.kind, std::exchange(isFirst, false), "|");
        if (const std::string subject = subjectOf(event); !subject.empty()) {
            line += '=';
            appendEscaped(line, subject, false, "|");
        }
    }
}

/// Appends a value of `kCsvColumns`.
void appendCsvColumn(std::string& line, std::string_view column, const servo::TickRecord& tick,
                     const StructureNames& names, std::span<const RecordingEvent> events)
{
    const bool isTouching = tick.felt.structure >= 0;
    const double depth_mm = isTouching ? (tick.felt.p_WG - tick.p_WH).norm() : 0.0;
    if (column == "slides") {
        line += slides(tick.felt.friction());
    } else if (column == "layers") {
        appendLayers(line, tick.felt, names);
    } else if (column == "time_s") {
        core::appendNumber(line, static_cast<double>(tick.time_ns) * 1e-9);
    } else if (column.starts_with("sent_")) {
        core::appendNumber(line, tick.fSent_W[column[5] - 'x']);
    } else if (column == "force_N") {
        core::appendNumber(line, tick.felt.f_W.norm());
    } else if (column == "depth_mm") {
        core::appendNumber(line, depth_mm);
    } else if (column == "felt_N_per_mm" && depth_mm > 0.0) {
        core::appendNumber(line, tick.felt.f_W.norm() / depth_mm);
    } else if (column == "events") {
        appendEvents(line, events);
    }
}

std::string joined(std::span<const std::string> names)
{
    std::string out;
    for (const std::string& name : names) {
        out += (out.empty() ? "" : ",") + name;
    }
    return out;
}

/// Returns the indices of the columns among all names.
core::Result<std::vector<std::size_t>> chosenCells(const std::vector<std::string>& names,
                                                   std::span<const std::string> columns)
{
    std::vector<std::size_t> chosen;
    for (const std::string& column : columns) {
        const auto found = std::find(names.begin(), names.end(), column);
        if (found == names.end()) {
            return core::Status(core::StatusCode::BadCommandLine,
                                PALPATE_TEXT("--columns: found \"%1\", expected some of %2"), column, joined(names));
        }
        const auto cell = static_cast<std::size_t>(found - names.begin());
        if (std::find(chosen.begin(), chosen.end(), cell) != chosen.end()) {
            return core::Status(core::StatusCode::BadCommandLine,
                                PALPATE_TEXT("--columns: found \"%1\" twice, expected each column once"), column);
        }
        chosen.push_back(cell);
    }
    return chosen;
}

bool isIn(const internal::CsvColumn& column, TickCsv::Rows rows)
{
    return column.in == internal::InCsv::All ||
           rows == (column.in == internal::InCsv::OfSession ? TickCsv::Rows::Session : TickCsv::Rows::Device);
}

} // namespace

std::string layersText(const haptics::TickResult& felt, const StructureNames& names)
{
    std::string text;
    appendLayers(text, felt, names);
    return text;
}

std::string eventsText(std::span<const RecordingEvent> events)
{
    std::string text;
    appendEvents(text, events);
    return text;
}

TickCsv::TickCsv(core::AtomicFile file, Rows rows)
    : m_file(std::move(file))
    , m_rows(rows)
{
}

core::Result<TickCsv> TickCsv::create(const std::filesystem::path& path, Rows rows,
                                      std::span<const std::string> columns)
{
    std::vector<std::string> names;
    for (const internal::TickColumn& column : shownColumns()) {
        for (const std::string& name : internal::columnNames(column)) {
            names.push_back(name);
        }
    }
    for (const internal::CsvColumn& column : internal::kCsvColumns) {
        if (isIn(column, rows)) {
            names.emplace_back(column.name);
        }
    }
    auto chosen = chosenCells(names, columns);
    if (!chosen.isOk()) {
        return chosen.status();
    }
    auto file = core::AtomicFile::create(path);
    if (!file.isOk()) {
        return file.status();
    }
    TickCsv csv(std::move(file).value(), rows);
    csv.m_chosen = std::move(chosen).value();
    csv.m_file.write(joined(columns.empty() ? std::span<const std::string>(names) : columns) + '\n');
    return csv;
}

/// Stores the ends of the last cells of the line. @param count  more than one for a vector, whose numbers have no
/// commas
void TickCsv::endCells(std::size_t count)
{
    const std::size_t first = m_ends.size();
    m_ends.resize(first + count, m_line.size());
    for (std::size_t i = first + count - 1; i > first; --i) {
        m_ends[i - 1] = m_line.rfind(',', m_ends[i] - 1);
    }
}

/// Writes the chosen cells of the line.
void TickCsv::writeChosen()
{
    std::string line;
    for (const std::size_t cell : m_chosen) {
        const std::size_t begin = cell == 0 ? 0 : m_ends[cell - 1] + 1;
        line += line.empty() && cell == m_chosen.front() ? "" : ",";
        line.append(m_line, begin, m_ends[cell] - begin);
    }
    m_file.write(line + '\n');
}

void TickCsv::write(const servo::TickRecord& tick, const StructureNames& names, std::span<const RecordingEvent> events)
{
    m_line.clear();
    m_ends.clear();
    const bool isChosen = !m_chosen.empty();
    const bool isEmpty = m_rows == Rows::Session && (tick.flags & servo::kNoHand) != 0;
    for (const internal::TickColumn& column : shownColumns()) {
        m_line += m_line.empty() ? "" : ",";
        if (isEmpty && column.name != "tick") {
            m_line.append(internal::columnNames(column).size() - 1, ',');
        } else if (column.name == "structure") {
            m_line += tick.felt.structure < 0 ? std::string()
                                              : core::csvCell(names(static_cast<std::uint32_t>(tick.felt.structure)));
        } else {
            internal::useValue(column, tick, [this](const auto& value) { appendValue(m_line, value); });
        }
        if (isChosen) {
            endCells(internal::columnNames(column).size());
        }
    }
    for (const internal::CsvColumn& column : internal::kCsvColumns) {
        if (!isIn(column, m_rows)) {
            continue;
        }
        m_line += ',';
        if (!isEmpty || column.isWithoutHand) {
            appendCsvColumn(m_line, column.name, tick, names, events);
        }
        if (isChosen) {
            m_ends.push_back(m_line.size());
        }
    }
    if (isChosen) {
        writeChosen();
        return;
    }
    m_line += '\n';
    m_file.write(m_line);
}

core::Status TickCsv::finish()
{
    return m_file.finish();
}

} // namespace palpate::session
