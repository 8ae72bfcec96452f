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

/// While the object lives, a SQLite VFS over the default one: logs disk operations, fails the k-th operation, or blocks
/// all. Reads always work.
class FaultyDisk
{
  public:
    /// A change of the disk.
    struct Operation
    {
        enum Kind
        {
            Create,
            Write,
            Truncate,
            Sync,
            Delete,
            Mark, ///< no disk operation: a number set by the test
        };
        Kind kind = Mark;
        std::string file;        ///< name without folder
        std::int64_t offset = 0; ///< Write: offset; Truncate: size; Mark: number
        std::string bytes;       ///< Write: content
    };

    FaultyDisk();
    ~FaultyDisk();
    FaultyDisk(const FaultyDisk&) = delete;
    FaultyDisk& operator=(const FaultyDisk&) = delete;

    void startLog() { m_isLogging = true; }
    void mark(std::int64_t number);
    /// Stops logging and returns the log.
    std::vector<Operation> takeLog();

    /// Fails the k-th operation from now, counting from 0, and with `isLasting` all later ones.
    /// @param code  SQLite error code
    void failAt(std::int64_t k, bool isLasting, int code);
    void heal() { m_failAt = -1; }
    /// Returns the number of operations since failAt.
    [[nodiscard]] std::int64_t operations() const { return m_operations; }

    /// Blocks every write and sync until `release`.
    void hold();
    void release();
    /// Delays every write. @param delay_ms  0: no longer
    void slowDown(int delay_ms) { m_delay_ms = delay_ms; }
    /// From now on errno is gone when SQLite asks for it after an error, as if another call had overwritten it.
    void loseErrno();

    /// Called by the VFS.
    /// @return 0, or the error code to fail with
    int ask(Operation::Kind kind, const std::string& file, std::int64_t offset, const void* bytes, int size);

  private:
    std::atomic<bool> m_isLogging{false};
    std::vector<Operation> m_log;
    std::atomic<std::int64_t> m_operations{0};
    std::atomic<std::int64_t> m_failAt{-1};
    bool m_isLasting = false;
    int m_code = 0;
    std::atomic<int> m_delay_ms{0};
    std::mutex m_mutex;
    std::condition_variable m_released;
    bool m_isHeld = false;
};

/// Possible content of the disk after a power loss: files by name.
using DiskState = std::map<std::string, std::string>;

/// Replays a log up to operation `end` and simulates a power loss. Synced data are kept. Unsynced data depend on
/// `seed`: 0 none, 1 all, else an arbitrary subset of the writes, some with their last sectors torn off; a deleted file
/// may reappear.
/// @param before  files at the start of the log, synced
[[nodiscard]] DiskState afterPowerLoss(const DiskState& before, const std::vector<FaultyDisk::Operation>& log,
                                       std::size_t end, std::uint32_t seed);

} // namespace palpate::test
