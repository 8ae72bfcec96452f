// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "database/ReadOnlyVfs.h"

#include <palpate/core/Status.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace palpate::session::internal {

/// Converts text from the file or from SQLite messages (which quote the file) to a single line: removes control
/// characters and limits the length.
[[nodiscard]] std::string oneLine(std::string_view text);

/// Prepared statement. Columns and parameters count from 0.
class Statement
{
  public:
    Statement() = default;
    explicit Statement(sqlite3_stmt* statement);

    void bind(int index, std::int64_t value);
    void bind(int index, double value);
    void bind(int index, std::string_view text);
    void bindBlob(int index, std::string_view bytes);
    void bindNull(int index);

    enum class Step
    {
        Row,
        Done,
        Failed
    };
    /// Runs to the next row. After Done or Failed, the statement can be bound again.
    Step step();
    void reset();

    enum class Type : std::uint8_t
    {
        Null,
        Integer,
        Real,
        Text,
        Blob
    };
    [[nodiscard]] Type type(int column) const;
    [[nodiscard]] bool isNull(int column) const { return type(column) == Type::Null; }
    [[nodiscard]] bool isInteger(int column) const { return type(column) == Type::Integer; }
    [[nodiscard]] std::int64_t integer(int column) const; ///< 0 if not a number
    [[nodiscard]] double real(int column) const;          ///< NaN if not a number
    [[nodiscard]] std::string bytes(int column) const;    ///< of a text or blob
    [[nodiscard]] bool isPrepared() const noexcept { return m_statement != nullptr; }

  private:
    struct Finalize
    {
        void operator()(sqlite3_stmt* statement) const;
    };
    std::unique_ptr<sqlite3_stmt, Finalize> m_statement;
};

/// SQLite connection that reports errors as one line with the file name.
class Database
{
  public:
    enum class Mode
    {
        Read,      ///< untrusted file: see ReadOnlyVfs
        ReadWrite, ///< file created by this process
        Create
    };

    /// @return for Read also BadFormat, for a database with a write-ahead log or with a journal that checkJournal
    ///         rejects
    [[nodiscard]] static core::Result<Database> open(const std::filesystem::path& path, Mode mode);

    core::Status execute(const std::string& sql);
    /// Resets the step budget for the following statements to the maximum that a valid file of this size needs. Cyclic
    /// pages then cause an error instead of an endless scan. `prepare` also resets the budget.
    void startWork() const;
    /// Size of the file when opened [bytes]; 0 for a new file.
    [[nodiscard]] std::int64_t fileSize() const noexcept { return m_fileSize; }
    /// @return an unprepared statement after an error; see `cannotRead`.
    [[nodiscard]] Statement prepare(const char* sql) const;
    /// @return first column of the first row, 0 without rows
    [[nodiscard]] std::int64_t integer(const char* sql) const;
    /// Returns the latest error as one line; code NoSpace for a full disk.
    [[nodiscard]] core::Status cannotRead() const;
    [[nodiscard]] core::Status cannotWrite() const; ///< same for an error when writing
    [[nodiscard]] bool isFull() const;              ///< the latest error is a full disk, quota or file size limit
    [[nodiscard]] int errorCode() const;            ///< extended error code of SQLite
    /// Returns true outside of a transaction, for example after an automatic rollback.
    [[nodiscard]] bool isIdle() const;

  private:
    struct Close
    {
        void operator()(sqlite3* database) const;
    };
    struct Work;
    struct FreeWork
    {
        void operator()(Work* work) const;
    };
    void limit();
    [[nodiscard]] core::Message cause() const;

    std::filesystem::path m_path;
    std::int64_t m_fileSize = 0;
    std::unique_ptr<ReadOnlyVfs> m_files; ///< for Mode::Read; must outlive the connection
    std::unique_ptr<Work, FreeWork> m_work;
    std::unique_ptr<sqlite3, Close> m_database;
};

} // namespace palpate::session::internal
