// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Message.h>

#include <memory>
#include <string>

namespace palpate::session::internal {

/// SQLite file layer (VFS) for one connection without changes to the disk. Opens only the database and its rollback
/// journal, both read-only. Writes by SQLite, which occur when a journal from a crash is rolled back, stay in memory
/// and are visible to later reads.
///
/// Before any rollback, file locks are those of a normal reader, so another process may record into the file. After a
/// rollback, the shared lock is held until the connection closes, because the file must not change below the memory
/// overlay.
/// @par Source https://www.sqlite.org/vfs.html
class ReadOnlyVfs
{
  public:
    ReadOnlyVfs();
    /// @pre the connection is closed
    ~ReadOnlyVfs();
    ReadOnlyVfs(const ReadOnlyVfs&) = delete;
    ReadOnlyVfs& operator=(const ReadOnlyVfs&) = delete;

    /// Returns the VFS name for opening one connection.
    [[nodiscard]] const char* name() const noexcept;
    /// Returns the reason why a request of SQLite was refused, as one clause; empty if there was no refusal.
    [[nodiscard]] const core::Message& refusal() const noexcept;

    struct Private;

  private:
    std::unique_ptr<Private> m_d;
};

} // namespace palpate::session::internal
