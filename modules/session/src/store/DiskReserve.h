// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>

namespace palpate::session::internal {

/// Disk space reserved for the final events of a recording: an unnamed file that disappears with the process. Without
/// free space or without support by the file system, nothing is reserved.
class DiskReserve
{
  public:
    /// @param beside  any path on the same disk
    DiskReserve(const std::filesystem::path& beside, std::size_t bytes);
    ~DiskReserve() { release(); }
    DiskReserve(const DiskReserve&) = delete;
    DiskReserve& operator=(const DiskReserve&) = delete;

    /// Releases the disk space.
    void release() noexcept;

  private:
    int m_file = -1;
};

} // namespace palpate::session::internal
