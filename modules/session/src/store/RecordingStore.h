// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "database/Database.h"
#include "palpate/session/Recording.h"
#include "tables/MetaTable.h"

#include <palpate/core/Status.h>
#include <palpate/servo/TickRecord.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace palpate::session::internal {

/// Content of one transaction.
struct RecordingBatch
{
    std::vector<servo::TickRecord> ticks;
    std::vector<SceneRecord> scenes;
    std::vector<RecordingEvent> events;
    void clear() noexcept { ticks.clear(), scenes.clear(), events.clear(); }
    [[nodiscard]] bool isEmpty() const noexcept { return ticks.empty() && scenes.empty() && events.empty(); }
};

/// Writes the tables of a recording: rows and the chain of checksums.
class RecordingStore
{
  public:
    /// Creates a file with the schema and the metadata.
    static core::Status makeFile(const std::filesystem::path& path, const MetaTable& meta);
    /// Opens a newly created file. @param ticksPerCheck  number of ticks per row of `checks`
    static core::Result<std::unique_ptr<RecordingStore>> open(const std::filesystem::path& path, const MetaTable& meta,
                                                              std::size_t ticksPerCheck);

    /// Sets whether each transaction waits for the disk.
    core::Status waitForDisk(bool isWaiting);
    /// Sets the time of the first tick, the origin of stored times [ns].
    void setFirstTime(std::int64_t time_ns) noexcept { m_firstTime_ns = time_ns; }
    /// Stores the whole batch, or nothing in case of an error.
    core::Status store(const RecordingBatch& batch);
    core::Status markComplete();

  private:
    explicit RecordingStore(Database database);
    core::Status storeScenes(const RecordingBatch& batch, std::string& hash);
    core::Status storeScene(const SceneRecord& scene);
    core::Status storeMaps(const StructureRecord& structure);
    core::Status storeEmbedded(const StructureSource& source);
    core::Status storeEvents(const RecordingBatch& batch, std::string& hash);
    core::Status storeTicks(const RecordingBatch& batch, std::string& hash);
    core::Status storeCheck(const char* kind, std::int64_t first, std::int64_t last, std::size_t rows,
                            const std::string& content, std::string& hash);
    [[nodiscard]] core::Status failed() const { return m_database.cannotWrite(); }

    Database m_database;
    Statement m_insertTick, m_insertCheck, m_insertEvent, m_insertScene, m_insertMesh, m_insertStructure,
        m_insertEmbedded, m_insertMap;
    std::size_t m_ticksPerCheck = 250;
    std::string m_chain; ///< hash of the last stored check
    std::int64_t m_firstTime_ns = 0;
    std::int64_t m_nextEvent = 1; ///< next event id
};

} // namespace palpate::session::internal
