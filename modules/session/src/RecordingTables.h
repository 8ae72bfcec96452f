// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Database.h"
#include "MetaTable.h"
#include "palpate/session/Recording.h"

#include <palpate/core/Status.h>
#include <palpate/servo/TickRecord.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace palpate::session::internal {

/// One line of the table `checks`.
struct Check
{
    std::int64_t id = 0;
    std::string kind;
    std::int64_t first = 0, last = 0, rows = 0;
    std::string hash;
};

/// Events, each with the id of its row.
using Events = std::vector<std::pair<std::int64_t, RecordingEvent>>;

/// The tables of a recording, read one by one and as far as they can be read: what came before an error is given.
/// Tables of an older version come in the form of this one.
class RecordingTables
{
  public:
    /// @param database  must outlive this
    explicit RecordingTables(const Database& database)
        : m_database(database)
    {
    }

    /// Looks whose database it is and of which version. @return BadFormat or Mismatch without the file's name
    core::Status readVersion();
    [[nodiscard]] int version() const noexcept { return m_version; }

    core::Status readMeta(MetaTable& out) const;
    /// By generation. @return BadFormat, without the file's name, for numbers that no scene file may hold; a scene with
    ///         such is left out
    core::Status readScenes(std::vector<SceneRecord>& out) const;
    /// By tick; the first of each pair is the row's id. @return BadFormat, without the file's name, when a row was left
    ///         out: its values are of another type or out of range
    core::Status readEvents(Events& out) const;
    core::Status readChecks(std::vector<Check>& out) const;
    /// Gives the ticks first … last in order, until `sink` returns false.
    /// @param stoppedAt  set to the tick whose row is wrong; may be null
    /// @return BadFormat, without the file's name, for a row with values of another type or out of range, at which it
    ///         stops
    core::Status readTicks(std::int64_t first, std::int64_t last,
                           const std::function<bool(const servo::TickRecord&)>& sink,
                           std::int64_t* stoppedAt = nullptr) const;
    /// Numbers of the first and the last row of ticks, whatever they are. @return nothing without rows
    [[nodiscard]] std::optional<std::pair<std::int64_t, std::int64_t>> tickNumbers() const;
    /// @return hashes of the surfaces that the recording holds itself.
    [[nodiscard]] std::vector<std::string> embeddedHashes() const;
    /// @return NotFound, or Mismatch when its bits are not those that were written; without the file's name
    [[nodiscard]] core::Result<geometry::RepairedMesh> readEmbedded(const std::string& sha256) const;

  private:
    [[nodiscard]] std::optional<std::string> mapBytes(const std::string& hash) const;
    core::Status readGenerations(std::vector<SceneRecord>& out) const;
    [[nodiscard]] core::Status tooMany(const char* what, std::size_t most) const;
    [[nodiscard]] core::Status damaged() const { return m_database.error("cannot be read"); }

    const Database& m_database;
    int m_version = kRecordingVersion;
    mutable Statement m_ticks; ///< of readTicks, which is called for each block of ticks
};

} // namespace palpate::session::internal
