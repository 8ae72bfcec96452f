// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReadOnlyVfs.h"

#include <palpate/core/Status.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace palpate::session::internal {

/// A text of the file's or of SQLite's, which quotes the file, fit for a one-line message: without control characters,
/// cut to what fits.
[[nodiscard]] std::string oneLine(std::string_view text);

/// A prepared statement. Columns and parameters count from 0.
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
    /// Runs to the next row. After Done or Failed the statement is ready for new values.
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
    [[nodiscard]] std::int64_t integer(int column) const; ///< 0 for what is no number
    [[nodiscard]] double real(int column) const;          ///< NaN for what is no number
    [[nodiscard]] std::string bytes(int column) const;    ///< of a text or blob
    [[nodiscard]] bool isPrepared() const noexcept { return m_statement != nullptr; }

  private:
    struct Finalize
    {
        void operator()(sqlite3_stmt* statement) const;
    };
    std::unique_ptr<sqlite3_stmt, Finalize> m_statement;
};

/// A SQLite connection whose errors become one line that names the file.
class Database
{
  public:
    enum class Mode
    {
        Read,      ///< a file of anyone's: see ReadOnlyVfs
        ReadWrite, ///< one that this process has made
        Create
    };

    /// @return for Read also BadFormat, for a database with a write-ahead log or with a journal that checkJournal
    ///         refuses
    [[nodiscard]] static core::Result<Database> open(const std::filesystem::path& path, Mode mode);

    core::Status execute(const std::string& sql);
    /// Lets the coming statements take as many steps as any honest file of this size needs, and no more: pages that
    /// lead to each other in circles are then an error rather than an endless scan. `prepare` does the same.
    void startWork() const;
    /// Bytes of the file when it was opened; 0 for one that is created.
    [[nodiscard]] std::int64_t fileSize() const noexcept { return m_fileSize; }
    /// @return a statement that is not prepared after an error; see `error`.
    [[nodiscard]] Statement prepare(const char* sql) const;
    /// @return the first column of the first row, 0 without one
    [[nodiscard]] std::int64_t integer(const char* sql) const;
    /// The newest error as one line, with the code NoSpace for a full disk. @param doing  "cannot be written"
    [[nodiscard]] core::Status error(std::string_view doing) const;
    [[nodiscard]] bool isFull() const;   ///< the newest error is that of a full disk, quota or file size
    [[nodiscard]] int errorCode() const; ///< SQLite's extended code
    /// True after SQLite rolled back on its own or outside of a transaction.
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

    std::filesystem::path m_path;
    std::int64_t m_fileSize = 0;
    std::unique_ptr<ReadOnlyVfs> m_files; ///< of Mode::Read; outlives the connection
    std::unique_ptr<Work, FreeWork> m_work;
    std::unique_ptr<sqlite3, Close> m_database;
};

} // namespace palpate::session::internal
