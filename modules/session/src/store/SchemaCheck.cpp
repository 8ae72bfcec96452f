// SPDX-License-Identifier: BSD-3-Clause
#include "store/SchemaCheck.h"

#include "tables/Schema.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace palpate::session::internal {

namespace {

using core::Status;
using core::StatusCode;
using Step = Statement::Step;

/// Column name, position in the primary key (0: none), and whether the column is generated.
using Column = std::tuple<std::string, std::int64_t, bool>;
using Columns = std::vector<Column>;

constexpr std::string_view kView = "tick_values";
constexpr std::string_view kOptionalTable = "maps"; // exists only in a recording with maps

Status refuse(const core::Message& wrong)
{
    return {StatusCode::BadFormat, PALPATE_TEXT("%1: not made by Palpate, or damaged"), wrong};
}

/// @pre `table` is a table name of Palpate
Columns columnsOf(const Database& database, const std::string& table)
{
    Columns columns;
    Statement row = database.prepare(("PRAGMA table_xinfo(" + table + ")").c_str());
    while (row.step() == Step::Row) {
        columns.emplace_back(row.bytes(1), row.integer(5), row.integer(6) != 0);
    }
    return columns;
}

/// Collapses white space to single blanks and removes it at both ends.
std::string squeezed(std::string_view text)
{
    std::string out;
    for (const char c : text) {
        const bool isBlank = std::isspace(static_cast<unsigned char>(c)) != 0;
        if (!isBlank) {
            out += c;
        } else if (!out.empty() && out.back() != ' ') {
            out += ' ';
        }
    }
    while (out.ends_with(' ') || out.ends_with(';')) {
        out.pop_back();
    }
    return out;
}

/// Row of sqlite_master.
struct Entry
{
    std::string type, name, sql;
};

Status readEntries(const Database& database, std::vector<Entry>& out)
{
    constexpr std::size_t kMostEntries = 100;
    Statement row = database.prepare("SELECT type, name, sql FROM sqlite_master");
    Step step = row.step();
    for (; step == Step::Row && out.size() < kMostEntries; step = row.step()) {
        out.push_back({row.bytes(0), row.bytes(1), row.bytes(2)});
    }
    if (step == Step::Row) {
        return refuse(core::Message(
            PALPATE_TEXT("found more than %1 tables and views, expected the tables of a recording"), kMostEntries));
    }
    return step == Step::Failed ? database.cannotRead() : Status();
}

using Tables = std::map<std::string, Columns>;

/// Returns the tables and columns of a version, derived from the SQL that creates them.
Tables tablesOf(int version)
{
    Tables tables;
    auto opened = Database::open(":memory:", Database::Mode::Create);
    std::vector<Entry> entries;
    if (opened.isOk() && opened.value().execute(schema(version) + kCreateMaps).isOk() &&
        readEntries(opened.value(), entries).isOk()) {
        for (const Entry& entry : entries) {
            if (entry.type == "table" && (entry.name != kOptionalTable || version >= kMapsSince)) {
                tables.emplace(entry.name, columnsOf(opened.value(), entry.name));
            }
        }
    }
    return tables;
}

/// Caches the result of tablesOf.
const Tables& expectedTables(int version)
{
    static std::mutex mutex;
    static std::map<int, Tables> known;
    const std::lock_guard lock(mutex);
    auto found = known.find(version);
    if (found == known.end()) {
        found = known.emplace(version, tablesOf(version)).first;
    }
    return found->second;
}

bool isOwnView(const Entry& entry, int version)
{
    const std::string text = squeezed(entry.sql);
    const std::vector<std::string> known = knownTickValues(version);
    return entry.name == kView &&
           std::any_of(known.begin(), known.end(), [&](const std::string& own) { return text == squeezed(own); });
}

} // namespace

Status checkSchema(const Database& database, int version)
{
    const Tables& expected = expectedTables(version);
    std::vector<Entry> entries;
    if (Status status = readEntries(database, entries); !status.isOk()) {
        return status;
    }
    std::vector<std::string> tables;
    for (const Entry& entry : entries) {
        // Only the SQL text determines how SQLite treats an entry; its other columns may contain anything.
        const bool isTable = entry.sql.starts_with("CREATE TABLE " + entry.name + "(") && entry.type == "table";
        const bool isIndexOfKey = entry.sql.empty() && entry.type == "index" && entry.name.starts_with("sqlite_auto");
        if (isTable && expected.contains(entry.name) &&
            std::find(tables.begin(), tables.end(), entry.name) == tables.end()) {
            tables.push_back(entry.name);
        } else if (!isIndexOfKey && !isOwnView(entry, version)) {
            const std::string what = entry.sql.empty() ? entry.type : squeezed(entry.sql).substr(0, 60);
            return refuse(
                core::Message(PALPATE_TEXT("found \"%1\" for %2 \"%3\", expected only the tables of version %4 "
                                           "and the view tick_values"),
                              oneLine(what), oneLine(entry.type), oneLine(entry.name), version));
        }
    }
    for (const auto& [name, columns] : expected) {
        if (std::find(tables.begin(), tables.end(), name) == tables.end()) {
            if (name != kOptionalTable) {
                return refuse(core::Message(PALPATE_TEXT("found no table \"%1\", expected the tables of version %2"),
                                            name, version));
            }
        } else if (columnsOf(database, name) != columns) {
            return refuse(core::Message(
                PALPATE_TEXT("found other columns in the table \"%1\", expected those of version %2"), name, version));
        }
    }
    return {};
}

} // namespace palpate::session::internal
