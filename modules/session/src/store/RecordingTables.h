// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "database/Database.h"
#include "palpate/session/Recording.h"
#include "tables/MetaTable.h"

#include <palpate/core/Status.h>
#include <palpate/servo/TickRecord.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace palpate::session::internal {

/// Row of the table `checks`.
struct Check
{
    std::int64_t id = 0;
    std::string kind;
    std::int64_t first = 0, last = 0, rows = 0;
    std::string hash;
};

/// Events with their row ids.
using Events = std::vector<std::pair<std::int64_t, RecordingEvent>>;

/// Reads the tables of a recording as far as possible: rows before an error are returned. Tables of older versions are
/// converted to the current form.
class RecordingTables
{
  public:
    /// @param database  must outlive this object
    explicit RecordingTables(const Database& database)
        : m_database(database)
    {
    }

    /// Checks the application id and reads the version. @return BadFormat or Mismatch without the file name
    core::Status readVersion();
    [[nodiscard]] int version() const noexcept { return m_version; }

    core::Status readMeta(MetaTable& out) const;
    /// Reads the scenes by generation. @return BadFormat without the file name for numbers that are invalid in scene
    /// files; such a scene is skipped
    core::Status readScenes(std::vector<SceneRecord>& out) const;
    /// Reads the events with their row ids by tick. @return BadFormat without the file name if a row was skipped
    /// because of a wrong type or a value out of range
    core::Status readEvents(Events& out) const;
    core::Status readChecks(std::vector<Check>& out) const;
    /// Passes the ticks first … last in order to `sink` until `sink` returns false.
    /// @param stoppedAt  set to the tick of an invalid row; may be null
    /// @return BadFormat without the file name if a row has a wrong type or a value out of range; reading stops there
    core::Status readTicks(std::int64_t first, std::int64_t last,
                           const std::function<bool(const servo::TickRecord&)>& sink,
                           std::int64_t* stoppedAt = nullptr) const;
    /// Returns the numbers of the first and last tick row, without validation; empty without rows.
    [[nodiscard]] std::optional<std::pair<std::int64_t, std::int64_t>> tickNumbers() const;
    /// Returns the hashes of the embedded surfaces.
    [[nodiscard]] std::vector<std::string> embeddedHashes() const;
    /// @return NotFound, or Mismatch if the checksum failed; without the file name
    [[nodiscard]] core::Result<geometry::RepairedMesh> readEmbedded(const std::string& sha256) const;

  private:
    [[nodiscard]] std::optional<std::string> mapBytes(const std::string& hash) const;
    core::Status readGenerations(std::vector<SceneRecord>& out) const;
    [[nodiscard]] core::Status tooMany(const core::Message& what, std::size_t most) const;
    [[nodiscard]] core::Status damaged() const { return m_database.cannotRead(); }

    const Database& m_database;
    int m_version = kRecordingVersion;
    mutable Statement m_ticks; ///< reused by readTicks for each block of ticks
};

} // namespace palpate::session::internal
