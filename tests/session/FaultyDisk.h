// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace palpate::test {

/// While it lives, SQLite's file layer (a VFS over the ordinary one): it logs what is asked of the disk, fails the k-th
/// of it, or holds everything up. Reading always works.
class FaultyDisk
{
  public:
    /// What changed the disk.
    struct Operation
    {
        enum Kind
        {
            Create,
            Write,
            Truncate,
            Sync,
            Delete,
            Mark, ///< not of the disk: a number of the test's own
        };
        Kind kind = Mark;
        std::string file;        ///< name without folder
        std::int64_t offset = 0; ///< of Write; size of Truncate; number of Mark
        std::string bytes;       ///< of Write
    };

    FaultyDisk();
    ~FaultyDisk();
    FaultyDisk(const FaultyDisk&) = delete;
    FaultyDisk& operator=(const FaultyDisk&) = delete;

    void startLog() { m_isLogging = true; }
    void mark(std::int64_t number);
    /// Ends the logging.
    std::vector<Operation> takeLog();

    /// Fails the k-th operation from now, counting from 0, and with `isLasting` all after it. @param code SQLite's
    void failAt(std::int64_t k, bool isLasting, int code);
    void heal() { m_failAt = -1; }
    /// Operations since failAt.
    [[nodiscard]] std::int64_t operations() const { return m_operations; }

    /// Lets every write and sync wait until `release`.
    void hold();
    void release();

    /// For the file layer. @return 0, or the code to fail with
    int ask(Operation::Kind kind, const std::string& file, std::int64_t offset, const void* bytes, int size);

  private:
    std::atomic<bool> m_isLogging{false};
    std::vector<Operation> m_log;
    std::atomic<std::int64_t> m_operations{0};
    std::atomic<std::int64_t> m_failAt{-1};
    bool m_isLasting = false;
    int m_code = 0;
    std::mutex m_mutex;
    std::condition_variable m_released;
    bool m_isHeld = false;
};

/// What may be on the disk after the power went: files by name.
using DiskState = std::map<std::string, std::string>;

/// Replays a log up to its operation `end` and lets the power go. What was synced is there. Of what was not, by `seed`:
/// 0 nothing, 1 everything, else an arbitrary part of the writes, the last sectors of some of them torn off; a deleted
/// file may be there again.
/// @param before  the files when the log began, synced
[[nodiscard]] DiskState afterPowerLoss(const DiskState& before, const std::vector<FaultyDisk::Operation>& log,
                                       std::size_t end, std::uint32_t seed);

} // namespace palpate::test
