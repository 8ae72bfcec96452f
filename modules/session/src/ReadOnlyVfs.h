// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

namespace palpate::session::internal {

/// A file layer (VFS) for one SQLite connection that changes nothing on the disk. It opens the database and the
/// rollback journal beside it, both for reading, and no other file. What SQLite writes, which is what it rolls back
/// from a journal that a crash left, is kept in memory and read from there.
///
/// While nothing was rolled back, locks on the file are those of any reader, so that another process may record into
/// it. Once something was, the shared lock is kept until the connection is closed: nobody may change the file below.
/// @par Source https://www.sqlite.org/vfs.html
class ReadOnlyVfs
{
  public:
    ReadOnlyVfs();
    /// @pre the connection is closed
    ~ReadOnlyVfs();
    ReadOnlyVfs(const ReadOnlyVfs&) = delete;
    ReadOnlyVfs& operator=(const ReadOnlyVfs&) = delete;

    /// @return the name to open one connection with.
    [[nodiscard]] const char* name() const noexcept;
    /// @return why SQLite did not get what it asked for, as one clause; empty while it did.
    [[nodiscard]] const std::string& refusal() const noexcept;

    struct Private;

  private:
    std::unique_ptr<Private> m_d;
};

} // namespace palpate::session::internal
