// SPDX-License-Identifier: BSD-3-Clause
#include "database/Database.h"

#include "database/JournalCheck.h"

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <fstream>
#include <limits>

#include <sys/stat.h>

namespace palpate::session::internal {

namespace {
constexpr int kBusyTimeout_ms = 2000;

// Steps of SQLite's virtual machine. A full scan takes about 40 steps per row, and each row has at least 40 bytes.
constexpr std::int64_t kFreeSteps = 100'000'000;
constexpr std::int64_t kStepsPerByte = 16;
constexpr int kStepsPerCall = 10'000;

/// Returns the allocated size of a file; less than the length for a sparse file.
std::int64_t bytesOnDisk(const std::filesystem::path& path)
{
    struct stat found
    {
    };
    return ::stat(path.c_str(), &found) == 0 ? std::int64_t{found.st_blocks} * 512 : 0;
}

/// Returns true if the header selects a write-ahead log.
bool hasWriteAheadLog(const std::filesystem::path& path)
{
    constexpr std::size_t kWriteVersion = 18, kReadVersion = 19; // 1: rollback journal, 2: write-ahead log
    std::array<char, kReadVersion + 1> head{};
    std::ifstream file(path, std::ios::binary);
    return file.read(head.data(), head.size()) && (head[kWriteVersion] == 2 || head[kReadVersion] == 2);
}

/// Returns an error text of SQLite; translatable if files cause it frequently.
core::Message messageOfSqlite(const char* text)
{
    const std::array known{core::Message(PALPATE_TEXT("file is not a database")),
                           core::Message(PALPATE_TEXT("database disk image is malformed")),
                           core::Message(PALPATE_TEXT("unable to open database file")),
                           core::Message(PALPATE_TEXT("database or disk is full")),
                           core::Message(PALPATE_TEXT("attempt to write a readonly database")),
                           core::Message(PALPATE_TEXT("disk I/O error"))};
    const auto* const found =
        std::find_if(known.begin(), known.end(), [text](const core::Message& one) { return one.text() == text; });
    return found != known.end() ? *found : core::Message::untranslated(oneLine(text));
}
} // namespace

struct Database::Work
{
    std::int64_t most = 0; ///< step budget between two calls of startWork
    std::int64_t left = 0;
};

void Database::FreeWork::operator()(Work* work) const
{
    delete work;
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

Statement::Type Statement::type(int column) const
{
    switch (sqlite3_column_type(m_statement.get(), column)) {
    case SQLITE_INTEGER:
        return Type::Integer;
    case SQLITE_FLOAT:
        return Type::Real;
    case SQLITE_TEXT:
        return Type::Text;
    case SQLITE_BLOB:
        return Type::Blob;
    default:
        return Type::Null;
    }
}

std::int64_t Statement::integer(int column) const
{
    const Type kind = type(column);
    return kind == Type::Integer || kind == Type::Real ? sqlite3_column_int64(m_statement.get(), column) : 0;
}

double Statement::real(int column) const
{
    const Type kind = type(column);
    return kind == Type::Integer || kind == Type::Real ? sqlite3_column_double(m_statement.get(), column)
                                                       : std::numeric_limits<double>::quiet_NaN();
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
    int flags = SQLITE_OPEN_READWRITE | (mode == Mode::Create ? SQLITE_OPEN_CREATE : 0);
    if (mode == Mode::Read) {
        if (core::Status status = checkJournal(path); !status.isOk()) {
            return status;
        }
        if (hasWriteAheadLog(path)) {
            return core::Status(core::StatusCode::BadFormat,
                                PALPATE_TEXT("%1: found a database with a write-ahead log, expected one with a "
                                             "rollback journal, as Palpate writes it: another program changed it"),
                                path);
        }
        database.m_files = std::make_unique<ReadOnlyVfs>();
        struct stat found
        {
        };
        database.m_fileSize = ::stat(path.c_str(), &found) == 0 ? std::int64_t{found.st_size} : 0;
    }
    sqlite3* handle = nullptr;
    const int code = sqlite3_open_v2(path.c_str(), &handle, flags | SQLITE_OPEN_NOMUTEX,
                                     database.m_files == nullptr ? nullptr : database.m_files->name());
    database.m_database.reset(handle);
    if (code != SQLITE_OK) {
        return mode == Mode::Create ? database.cannotWrite() : database.cannotRead();
    }
    sqlite3_extended_result_codes(handle, 1);
    sqlite3_busy_timeout(handle, kBusyTimeout_ms);
    // Prevents a damaged or malicious file from running code through views and triggers.
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    if (mode == Mode::Read) {
        database.limit();
    }
    return database;
}

/// Sets limits for untrusted files.
void Database::limit()
{
    constexpr std::int64_t kLeastLength = 1'000'000; // for SQLite's own schema and error texts
    sqlite3* const handle = m_database.get();
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_limit(handle, SQLITE_LIMIT_LENGTH,
                  static_cast<int>(std::clamp<std::int64_t>(m_fileSize, kLeastLength, 1'000'000'000)));
    sqlite3_limit(handle, SQLITE_LIMIT_SQL_LENGTH, 100'000);
    sqlite3_limit(handle, SQLITE_LIMIT_COLUMN, 100);
    sqlite3_limit(handle, SQLITE_LIMIT_EXPR_DEPTH, 50);
    sqlite3_limit(handle, SQLITE_LIMIT_COMPOUND_SELECT, 2);
    sqlite3_limit(handle, SQLITE_LIMIT_VDBE_OP, 10'000);
    sqlite3_limit(handle, SQLITE_LIMIT_ATTACHED, 0);
    sqlite3_limit(handle, SQLITE_LIMIT_TRIGGER_DEPTH, 1);
    sqlite3_limit(handle, SQLITE_LIMIT_WORKER_THREADS, 0);
    m_work.reset(new Work);
    m_work->most = kFreeSteps + kStepsPerByte * bytesOnDisk(m_path);
    startWork();
    sqlite3_progress_handler(
        handle, kStepsPerCall, [](void* work) { return (static_cast<Work*>(work)->left -= kStepsPerCall) < 0 ? 1 : 0; },
        m_work.get());
    // No temporary files. No memory mapping either, because truncating a mapped file crashes the reader.
    sqlite3_exec(handle, "PRAGMA temp_store=MEMORY; PRAGMA mmap_size=0; PRAGMA cell_size_check=ON", nullptr, nullptr,
                 nullptr);
}

void Database::startWork() const
{
    if (m_work != nullptr) {
        m_work->left = m_work->most;
    }
}

core::Status Database::execute(const std::string& sql)
{
    if (sqlite3_exec(m_database.get(), sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK) {
        return core::Status();
    }
    const bool isReadOnly = m_files != nullptr;
    return isReadOnly ? cannotRead() : cannotWrite();
}

Statement Database::prepare(const char* sql) const
{
    sqlite3_stmt* statement = nullptr;
    startWork();
    sqlite3_prepare_v3(m_database.get(), sql, -1, SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
    return Statement(statement);
}

std::int64_t Database::integer(const char* sql) const
{
    Statement statement = prepare(sql);
    return statement.step() == Statement::Step::Row ? statement.integer(0) : 0;
}

/// Returns the cause of the latest error.
core::Message Database::cause() const
{
    if (isFull()) {
        return core::Message(PALPATE_TEXT("the disk is full"));
    }
    if (m_files != nullptr && !m_files->refusal().isEmpty()) {
        return m_files->refusal();
    }
    if (!m_database) {
        return core::Message(PALPATE_TEXT("out of memory"));
    }
    if (sqlite3_errcode(m_database.get()) == SQLITE_INTERRUPT) {
        return core::Message(PALPATE_TEXT("its pages lead to more rows than a file of its size holds"));
    }
    return messageOfSqlite(sqlite3_errmsg(m_database.get()));
}

core::Status Database::cannotRead() const
{
    return {isFull() ? core::StatusCode::NoSpace : core::StatusCode::Unreadable, PALPATE_TEXT("%1: cannot be read: %2"),
            m_path, cause()};
}

core::Status Database::cannotWrite() const
{
    return {isFull() ? core::StatusCode::NoSpace : core::StatusCode::Unreadable,
            PALPATE_TEXT("%1: cannot be written: %2"), m_path, cause()};
}

bool Database::isFull() const
{
    if (!m_database) {
        return false;
    }
    const int code = sqlite3_errcode(m_database.get());
    // SQLite's code is unspecific for a journal that cannot be created or an exceeded quota, so check errno: the one at
    // the time of the error, which a rollback may have overwritten, and the one that the file has kept.
    if ((code & 0xff) != SQLITE_IOERR && (code & 0xff) != SQLITE_CANTOPEN) {
        return code == SQLITE_FULL;
    }
    int ofFile = 0;
    sqlite3_file_control(m_database.get(), "main", SQLITE_FCNTL_LAST_ERRNO, &ofFile);
    const std::array causes{sqlite3_system_errno(m_database.get()), ofFile};
    return std::any_of(causes.begin(), causes.end(),
                       [](int cause) { return cause == ENOSPC || cause == EDQUOT || cause == EFBIG; });
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
