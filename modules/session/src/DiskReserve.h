// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>

namespace palpate::session::internal {

/// Room on a disk that is kept for the last words of a recording: a file without a name, gone with the program however
/// it ends. Where there is no room, or the file system keeps none, there is no reserve.
class DiskReserve
{
  public:
    /// @param beside  on the disk that is meant
    DiskReserve(const std::filesystem::path& beside, std::size_t bytes);
    ~DiskReserve() { release(); }
    DiskReserve(const DiskReserve&) = delete;
    DiskReserve& operator=(const DiskReserve&) = delete;

    /// Gives the room back to the disk.
    void release() noexcept;

  private:
    int m_file = -1;
};

} // namespace palpate::session::internal
