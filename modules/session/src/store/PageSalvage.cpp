// SPDX-License-Identifier: BSD-3-Clause
#include "store/PageSalvage.h"

#include "database/Database.h"
#include "palpate/session/Recording.h"
#include "tables/Schema.h"
#include "tables/TickTable.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace palpate::session::internal {

using core::Status;
using core::StatusCode;

namespace {

constexpr std::size_t kPage = 4096; // SQLite's default, also used by Palpate
constexpr std::size_t kFileHeader = 100;
constexpr int kOldestForm = 2; // version 1 has the same ticks, but its other rows cannot be identified by their form
constexpr std::uint64_t kMostPayload = 1U << 30U; // limit in SQLite

// B-tree page types with rows. A table WITHOUT ROWID also has rows in inner pages.
constexpr std::uint8_t kIndexInner = 0x02;
constexpr std::uint8_t kIndexLeaf = 0x0a;
constexpr std::uint8_t kTableLeaf = 0x0d;

struct Blob
{
    std::string bytes;
};
using Value = std::variant<std::monostate, std::int64_t, double, std::string, Blob>;

/// Decodes a big-endian number, the byte order of the whole file format.
std::uint64_t number(std::string_view bytes)
{
    std::uint64_t out = 0;
    for (const char c : bytes) {
        out = (out << 8U) | static_cast<std::uint8_t>(c);
    }
    return out;
}

/// Removes a varint from the front. @return empty if truncated
std::optional<std::uint64_t> takeVarint(std::string_view& bytes)
{
    std::uint64_t out = 0;
    for (std::size_t i = 0; i < 9 && i < bytes.size(); ++i) {
        const auto byte = static_cast<std::uint8_t>(bytes[i]);
        if (i == 8) {
            out = (out << 8U) | byte;
        } else {
            out = (out << 7U) | (byte & 0x7fU);
        }
        if (i == 8 || byte < 0x80) {
            bytes.remove_prefix(i + 1);
            return out;
        }
    }
    return std::nullopt;
}

/// Removes a value of a serial type from the front. @return empty if truncated or of unknown type
std::optional<Value> takeValue(std::uint64_t type, std::string_view& body)
{
    constexpr std::size_t kSizes[] = {0, 1, 2, 3, 4, 6, 8, 8, 0, 0};
    if (type == 10 || type == 11) {
        return std::nullopt;
    }
    const std::uint64_t size = type < 10 ? kSizes[type] : (type - 12) / 2;
    if (size > body.size()) {
        return std::nullopt;
    }
    const std::string_view bytes = body.substr(0, size);
    body.remove_prefix(size);
    if (type == 0) {
        return Value();
    }
    if (type < 7) {
        const unsigned unused = 64U - 8U * static_cast<unsigned>(size); // shifts the first bit into the sign position
        return Value(static_cast<std::int64_t>(number(bytes) << unused) >> unused);
    }
    if (type == 7) {
        return Value(std::bit_cast<double>(number(bytes)));
    }
    if (type < 10) {
        return Value(static_cast<std::int64_t>(type - 8));
    }
    return type % 2 == 0 ? Value(Blob{std::string(bytes)}) : Value(std::string(bytes));
}

std::optional<std::vector<Value>> parseRecord(std::string_view payload)
{
    std::string_view types = payload;
    const auto size = takeVarint(types);
    if (!size || *size > payload.size() || *size < payload.size() - types.size()) {
        return std::nullopt;
    }
    std::string_view body = payload.substr(*size);
    types = types.substr(0, *size - (payload.size() - types.size()));
    std::vector<Value> values;
    while (!types.empty()) {
        const auto type = takeVarint(types);
        auto value = type ? takeValue(*type, body) : std::nullopt;
        if (!value) {
            return std::nullopt;
        }
        values.push_back(std::move(*value));
    }
    return values;
}

template<class T>
bool is(const Value& value)
{
    return std::holds_alternative<T>(value);
}

/// Identifies the table of a row by its form. @param version  of the recording
const char* tableOf(const std::vector<Value>& row, bool hasRowid, int version)
{
    constexpr std::size_t kHashDigits = 64;
    const std::size_t columns = row.size();
    if (columns == 0) {
        return nullptr;
    }
    if (!hasRowid) {
        if (columns == 2 && is<std::string>(row[0])) {
            const bool isIndexOfEmbedded =
                is<std::int64_t>(row[1]) && std::get<std::string>(row[0]).size() == kHashDigits;
            return isIndexOfEmbedded ? nullptr : "meta";
        }
        const std::size_t structures = tissueTerms(version).size() + (version >= 3 ? 9 : 6);
        return columns == structures && is<std::int64_t>(row[0]) && is<std::int64_t>(row[1]) ? "structures" : nullptr;
    }
    if (columns == 6 && is<std::string>(row[0]) && is<Blob>(row[1])) {
        return "embedded";
    }
    if (!is<std::monostate>(row[0])) {
        return nullptr; // in other tables, the first column is the rowid, which is stored separately
    }
    if (columns == tickColumnCount(version)) {
        return "ticks";
    }
    switch (columns) {
    case 7:
        return "meshes";
    case 6:
        return is<std::string>(row[1]) && is<Blob>(row[5]) ? "checks" : nullptr;
    case 4:
        return is<std::int64_t>(row[1]) && is<std::string>(row[2]) && is<std::string>(row[3]) ? "events" : nullptr;
    case 3:
        return is<std::string>(row[1]) && is<Blob>(row[2]) ? "maps" : "scenes";
    default:
        return nullptr;
    }
}

/// Receives a row; the rowid is empty for a table without one.
using RowSink = std::function<void(std::vector<Value>& row, std::optional<std::uint64_t> rowid)>;

/// Iterates over the rows in the pages of a file.
class PageRows
{
  public:
    explicit PageRows(std::ifstream& file)
        : m_file(file)
    {
        m_file.seekg(0, std::ios::end);
        m_pages = static_cast<std::int64_t>(m_file.tellg()) / static_cast<std::int64_t>(kPage);
    }

    [[nodiscard]] std::int64_t pages() const noexcept { return m_pages; }

    void forEach(const RowSink& sink)
    {
        std::string page;
        for (std::int64_t i = 1; i <= m_pages; ++i) {
            if (readPage(static_cast<std::uint64_t>(i), page)) {
                takeRows(page, i == 1 ? kFileHeader : 0, sink);
            }
        }
    }

  private:
    bool readPage(std::uint64_t index, std::string& page)
    {
        if (index < 1 || index > static_cast<std::uint64_t>(m_pages)) {
            return false;
        }
        page.resize(kPage);
        m_file.clear();
        m_file.seekg(static_cast<std::streamoff>((index - 1) * kPage));
        return static_cast<bool>(m_file.read(page.data(), static_cast<std::streamsize>(kPage)));
    }

    void takeRows(std::string_view page, std::size_t start, const RowSink& sink)
    {
        const auto kind = static_cast<std::uint8_t>(page[start]);
        if (kind != kTableLeaf && kind != kIndexLeaf && kind != kIndexInner) {
            return;
        }
        const std::size_t header = start + (kind == kIndexInner ? 12 : 8);
        const std::size_t cells = number(page.substr(start + 3, 2));
        for (std::size_t i = 0; i < cells && header + 2 * i + 2 <= kPage; ++i) {
            const std::size_t at = number(page.substr(header + 2 * i, 2)) + (kind == kIndexInner ? 4 : 0);
            if (at < kPage) {
                takeRow(page.substr(at), kind == kTableLeaf, sink);
            }
        }
    }

    void takeRow(std::string_view cell, bool hasRowid, const RowSink& sink)
    {
        const auto size = takeVarint(cell);
        const auto rowid = hasRowid ? takeVarint(cell) : std::optional<std::uint64_t>(0);
        if (!size || !rowid || *size > kMostPayload) {
            return;
        }
        const auto payload = gather(cell, *size, hasRowid);
        auto row = payload ? parseRecord(*payload) : std::nullopt;
        if (row && !row->empty()) {
            sink(*row, hasRowid ? rowid : std::nullopt);
        }
    }

    /// Returns the bytes of a row: the local part in the page, then the overflow pages.
    std::optional<std::string> gather(std::string_view cell, std::uint64_t size, bool hasRowid)
    {
        const std::size_t most = hasRowid ? kPage - 35 : (kPage - 12) * 64 / 255 - 23;
        if (size <= most) {
            return size <= cell.size() ? std::optional(std::string(cell.substr(0, size))) : std::nullopt;
        }
        const std::size_t least = (kPage - 12) * 32 / 255 - 23;
        const std::size_t fitting = least + (size - least) % (kPage - 4);
        const std::size_t local = fitting <= most ? fitting : least;
        if (local + 4 > cell.size() || size > static_cast<std::uint64_t>(m_pages) * kPage) {
            return std::nullopt;
        }
        std::string out(cell.substr(0, local));
        std::uint64_t next = number(cell.substr(local, 4));
        std::string page;
        while (out.size() < size) { // terminates: each page adds bytes, and `size` is at most the file size
            if (!readPage(next, page)) {
                return std::nullopt;
            }
            next = number(std::string_view(page).substr(0, 4));
            out.append(page, 4, std::min<std::size_t>(kPage - 4, size - out.size()));
        }
        return out;
    }

    std::ifstream& m_file;
    std::int64_t m_pages = 0;
};

/// Returns the recording version that matches the most rows. Versions can differ in the ticks or in the tissues only.
int versionOf(PageRows& pages)
{
    std::array<std::int64_t, kRecordingVersion + 1> rows{};
    pages.forEach([&](std::vector<Value>& row, std::optional<std::uint64_t> rowid) {
        for (int version = kOldestForm; version <= kRecordingVersion; ++version) {
            rows[static_cast<std::size_t>(version)] += tableOf(row, rowid.has_value(), version) != nullptr ? 1 : 0;
        }
    });
    return static_cast<int>(std::max_element(rows.begin() + kOldestForm, rows.end()) - rows.begin());
}

/// Inserts rows into their tables.
class Salvager
{
  public:
    Salvager(Database& database, int version)
        : m_database(database)
        , m_version(version)
    {
    }

    Salvage run(PageRows& pages)
    {
        m_result.pages = pages.pages();
        pages.forEach([this](std::vector<Value>& row, std::optional<std::uint64_t> rowid) {
            const char* table = tableOf(row, rowid.has_value(), m_version);
            if (table == nullptr) {
                return;
            }
            if (rowid && is<std::monostate>(row.front())) {
                row.front() = static_cast<std::int64_t>(*rowid);
            }
            insert(table, row);
        });
        return m_result;
    }

  private:
    void insert(const char* table, const std::vector<Value>& row)
    {
        auto found = m_inserts.find(table);
        if (found == m_inserts.end()) {
            std::string sql = std::string("INSERT OR IGNORE INTO ") + table + " VALUES(?";
            for (std::size_t i = 1; i < row.size(); ++i) {
                sql += ",?";
            }
            found = m_inserts.emplace(table, m_database.prepare((sql + ')').c_str())).first;
        }
        Statement& insert = found->second;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const int column = static_cast<int>(i);
            if (const auto* whole = std::get_if<std::int64_t>(&row[i])) {
                insert.bind(column, *whole);
            } else if (const auto* real = std::get_if<double>(&row[i])) {
                insert.bind(column, *real);
            } else if (const auto* text = std::get_if<std::string>(&row[i])) {
                insert.bind(column, std::string_view(*text));
            } else if (const auto* blob = std::get_if<Blob>(&row[i])) {
                insert.bindBlob(column, blob->bytes);
            } else {
                insert.bindNull(column);
            }
        }
        if (insert.step() == Statement::Step::Done) {
            ++m_result.rows;
            m_result.ticks += std::string_view(table) == "ticks" ? 1 : 0;
        }
    }

    Database& m_database;
    const int m_version;
    std::map<std::string, Statement> m_inserts;
    Salvage m_result;
};

} // namespace

core::Result<Salvage> salvagePages(const std::filesystem::path& from, const std::filesystem::path& to)
{
    std::ifstream file(from, std::ios::binary);
    if (!file) {
        return Status(StatusCode::Unreadable, PALPATE_TEXT("%1: cannot be read"), from);
    }
    auto opened = Database::open(to, Database::Mode::Create);
    if (!opened.isOk()) {
        return opened.status();
    }
    Database& database = opened.value();
    PageRows pages(file);
    const int version = versionOf(pages);
    // Temporary database, needs no crash safety.
    if (Status status = database.execute("PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; PRAGMA application_id=" +
                                         std::to_string(kRecordingApplicationId) +
                                         "; PRAGMA user_version=" + std::to_string(version) + "; BEGIN;" +
                                         schema(version) + (version >= kMapsSince ? kCreateMaps : ""));
        !status.isOk()) {
        return status;
    }
    const Salvage result = Salvager(database, version).run(pages);
    if (Status status = database.execute("COMMIT"); !status.isOk()) {
        return status;
    }
    return result;
}

} // namespace palpate::session::internal
