// SPDX-License-Identifier: BSD-3-Clause
#include "Database.h"

#include <sqlite3.h>

#include <algorithm>
#include <cerrno>
#include <limits>

namespace palpate::session::internal {

namespace {
constexpr int kBusyTimeout_ms = 2000;
}

std::string oneLine(std::string_view text)
{
    constexpr std::size_t kMost = 160;
    std::string out(text.substr(0, kMost));
    std::replace_if(
        out.begin(), out.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    return out + (text.size() > kMost ? "..." : "");
}

Statement::Statement(sqlite3_stmt* statement)
    : m_statement(statement)
{
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const
{
    sqlite3_finalize(statement);
}

void Statement::bind(int index, std::int64_t value)
{
    sqlite3_bind_int64(m_statement.get(), index + 1, value);
}

void Statement::bind(int index, double value)
{
    sqlite3_bind_double(m_statement.get(), index + 1, value);
}

void Statement::bind(int index, std::string_view text)
{
    sqlite3_bind_text64(m_statement.get(), index + 1, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
}

void Statement::bindBlob(int index, std::string_view bytes)
{
    sqlite3_bind_blob64(m_statement.get(), index + 1, bytes.data(), bytes.size(), SQLITE_TRANSIENT);
}

void Statement::bindNull(int index)
{
    sqlite3_bind_null(m_statement.get(), index + 1);
}

Statement::Step Statement::step()
{
    if (m_statement == nullptr) {
        return Step::Failed;
    }
    const int code = sqlite3_step(m_statement.get());
    if (code == SQLITE_ROW) {
        return Step::Row;
    }
    sqlite3_reset(m_statement.get());
    return code == SQLITE_DONE ? Step::Done : Step::Failed;
}

void Statement::reset()
{
    sqlite3_reset(m_statement.get());
}

bool Statement::isNull(int column) const
{
    return sqlite3_column_type(m_statement.get(), column) == SQLITE_NULL;
}

std::int64_t Statement::integer(int column) const
{
    return sqlite3_column_int64(m_statement.get(), column);
}

double Statement::real(int column) const
{
    return isNull(column) ? std::numeric_limits<double>::quiet_NaN() : sqlite3_column_double(m_statement.get(), column);
}

std::string Statement::bytes(int column) const
{
    const void* data = sqlite3_column_blob(m_statement.get(), column);
    const int size = sqlite3_column_bytes(m_statement.get(), column);
    return data == nullptr ? std::string()
                           : std::string(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

void Database::Close::operator()(sqlite3* database) const
{
    sqlite3_close_v2(database);
}

core::Result<Database> Database::open(const std::filesystem::path& path, Mode mode)
{
    Database database;
    database.m_path = path;
    sqlite3* handle = nullptr;
    const int flags = mode == Mode::Read        ? SQLITE_OPEN_READONLY
                      : mode == Mode::ReadWrite ? SQLITE_OPEN_READWRITE
                                                : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    const int code = sqlite3_open_v2(path.c_str(), &handle, flags | SQLITE_OPEN_NOMUTEX, nullptr);
    database.m_database.reset(handle);
    if (code != SQLITE_OK) {
        return database.error(mode == Mode::Create ? "cannot be written" : "cannot be read");
    }
    sqlite3_extended_result_codes(handle, 1);
    sqlite3_busy_timeout(handle, kBusyTimeout_ms);
    // A damaged or hostile file must not run code of its own through views and triggers.
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    return database;
}

core::Status Database::execute(const std::string& sql)
{
    return sqlite3_exec(m_database.get(), sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK
               ? core::Status()
               : error("cannot be written");
}

Statement Database::prepare(const char* sql) const
{
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v3(m_database.get(), sql, -1, SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
    return Statement(statement);
}

std::int64_t Database::integer(const char* sql) const
{
    Statement statement = prepare(sql);
    return statement.step() == Statement::Step::Row ? statement.integer(0) : 0;
}

core::Status Database::error(std::string_view doing) const
{
    const char* const what = m_database ? sqlite3_errmsg(m_database.get()) : "out of memory";
    if (isFull()) {
        return {core::StatusCode::NoSpace, m_path.string() + ": " + std::string(doing) + ": the disk is full"};
    }
    return {core::StatusCode::Unreadable, m_path.string() + ": " + std::string(doing) + ": " + oneLine(what)};
}

bool Database::isFull() const
{
    if (!m_database) {
        return false;
    }
    const int code = sqlite3_errcode(m_database.get());
    // A journal that cannot be made, or a quota, has a code that says less.
    const bool isOfSystem = (code & 0xff) == SQLITE_IOERR || (code & 0xff) == SQLITE_CANTOPEN;
    const int system = isOfSystem ? sqlite3_system_errno(m_database.get()) : 0;
    return code == SQLITE_FULL || system == ENOSPC || system == EDQUOT || system == EFBIG;
}

int Database::errorCode() const
{
    return sqlite3_extended_errcode(m_database.get());
}

bool Database::isIdle() const
{
    return sqlite3_get_autocommit(m_database.get()) != 0;
}

} // namespace palpate::session::internal
