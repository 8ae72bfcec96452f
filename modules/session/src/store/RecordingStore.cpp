// SPDX-License-Identifier: BSD-3-Clause
#include "store/RecordingStore.h"

#include "database/LawText.h"
#include "store/MapRows.h"
#include "tables/Packing.h"
#include "tables/Schema.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace palpate::session::internal {

using core::Status;

namespace {

/// Views numbers as the bytes of a blob.
template<class T>
std::string_view blobOf(const std::vector<T>& values)
{
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// Returns the start of the checksum chain, which covers the metadata.
std::string firstLink(const MetaTable& meta)
{
    return sha256(metaHash(hashedPairs(meta)));
}

} // namespace

Status RecordingStore::makeFile(const std::filesystem::path& path, const MetaTable& meta)
{
    auto opened = Database::open(path, Database::Mode::Create);
    if (!opened.isOk()) {
        return opened.status();
    }
    Database& database = opened.value();
    Status status =
        database.execute("PRAGMA application_id=" + std::to_string(kRecordingApplicationId) +
                         "; PRAGMA user_version=" + std::to_string(kRecordingVersion) + "; BEGIN;" + schema());
    Statement insert = database.prepare("INSERT INTO meta VALUES(?, ?)");
    for (auto pair = meta.begin(); status.isOk() && pair != meta.end(); ++pair) {
        insert.bind(0, pair->first);
        pair->first == "start" ? insert.bindBlob(1, pair->second) : insert.bind(1, pair->second);
        if (insert.step() != Statement::Step::Done) {
            status = database.cannotWrite();
        }
    }
    Statement check = database.prepare(kInsertCheck);
    if (status.isOk()) {
        check.bind(0, std::string_view(kMetaCheck));
        check.bindNull(1);
        check.bindNull(2);
        check.bind(3, static_cast<std::int64_t>(meta.size()));
        check.bindBlob(4, firstLink(meta));
        status = check.step() == Statement::Step::Done ? Status() : database.cannotWrite();
    }
    return status.isOk() ? database.execute("COMMIT") : status;
}

core::Result<std::unique_ptr<RecordingStore>> RecordingStore::open(const std::filesystem::path& path,
                                                                   const MetaTable& meta, std::size_t ticksPerCheck)
{
    auto opened = Database::open(path, Database::Mode::ReadWrite);
    if (!opened.isOk()) {
        return opened.status();
    }
    std::unique_ptr<RecordingStore> store(new RecordingStore(std::move(opened).value()));
    store->m_ticksPerCheck = ticksPerCheck;
    store->m_chain = firstLink(meta);
    return store;
}

RecordingStore::RecordingStore(Database database)
    : m_database(std::move(database))
    , m_insertTick(m_database.prepare(insertTick().c_str()))
    , m_insertCheck(m_database.prepare(kInsertCheck))
    , m_insertEvent(m_database.prepare("INSERT INTO events VALUES(?, ?, ?, ?)"))
    , m_insertScene(m_database.prepare("INSERT INTO scenes VALUES(?, ?, ?)"))
    , m_insertMesh(m_database.prepare("INSERT OR IGNORE INTO meshes(path, part, unit_mm, flipped, pose, sha256) "
                                      "VALUES(?1, ?2, ?3, ?4, ?5, ?6)"))
    , m_insertStructure(m_database.prepare(
          ("INSERT INTO structures(generation, number, name, mesh, layer, palpable, law, law_table, maps" +
           tissueColumns(kRecordingVersion) + ") SELECT ?7, ?8, ?9, mesh, ?10, ?11, ?12, ?13, ?14" + tissuePlaces(15) +
           " FROM meshes WHERE path = ?1 AND part = ?2 AND unit_mm = ?3 AND flipped = ?4 AND pose = ?5 AND sha256 = ?6")
              .c_str()))
    , m_insertEmbedded(m_database.prepare("INSERT OR IGNORE INTO embedded VALUES(?, ?, ?, ?, ?, ?)"))
{
}

Status RecordingStore::waitForDisk(bool isWaiting)
{
    return m_database.execute(isWaiting ? "PRAGMA synchronous=FULL" : "PRAGMA synchronous=OFF");
}

Status RecordingStore::markComplete()
{
    return m_database.execute(std::string("INSERT OR REPLACE INTO meta VALUES('") + kComplete + "', '1')");
}

/// Appends a row to the checksum chain.
Status RecordingStore::storeCheck(const char* kind, std::int64_t first, std::int64_t last, std::size_t rows,
                                  const std::string& content, std::string& hash)
{
    hash = sha256(hash + content);
    m_insertCheck.bind(0, std::string_view(kind));
    m_insertCheck.bind(1, first);
    m_insertCheck.bind(2, last);
    m_insertCheck.bind(3, static_cast<std::int64_t>(rows));
    m_insertCheck.bindBlob(4, hash);
    return m_insertCheck.step() == Statement::Step::Done ? Status() : failed();
}

Status RecordingStore::storeScenes(const RecordingBatch& batch, std::string& hash)
{
    for (const SceneRecord& scene : batch.scenes) {
        std::string content;
        packScene(content, scene, kRecordingVersion);
        Status status = storeScene(scene);
        if (status.isOk()) {
            status =
                storeCheck(kSceneCheck, scene.generation, scene.generation, scene.structures.size(), content, hash);
        }
        if (!status.isOk()) {
            return status;
        }
    }
    return {};
}

Status RecordingStore::storeMaps(const StructureRecord& structure)
{
    if (structure.tissueMaps.isEmpty() && structure.motion == nullptr) {
        return {};
    }
    Status status = m_database.execute(kCreateMaps);
    if (status.isOk() && structure.motion != nullptr) { // an older Palpate must not replay it without the motion
        status = m_database.execute("PRAGMA user_version=" + std::to_string(kMovingVersion));
    }
    if (!m_insertMap.isPrepared()) {
        m_insertMap = m_database.prepare("INSERT OR IGNORE INTO maps(sha256, corners) VALUES(?, ?)");
    }
    forEachMap({structure.tissueMaps, structure.motion}, [&](const std::string& hash, std::string_view bytes) {
        m_insertMap.bind(0, std::string_view(hash));
        m_insertMap.bindBlob(1, bytes);
        if (m_insertMap.step() != Statement::Step::Done) {
            status = failed();
        }
    });
    return status;
}

Status RecordingStore::storeEmbedded(const StructureSource& source)
{
    const geometry::RepairedMesh& surface = *source.embed;
    m_insertEmbedded.bind(0, std::string_view(source.sha256));
    m_insertEmbedded.bindBlob(1, blobOf(surface.mesh.vertices));
    m_insertEmbedded.bindBlob(2, blobOf(surface.mesh.triangles));
    m_insertEmbedded.bindBlob(3, blobOf(surface.twoSided));
    m_insertEmbedded.bindBlob(4, blobOf(surface.source));
    m_insertEmbedded.bindBlob(5, embeddedHash(surface));
    return m_insertEmbedded.step() == Statement::Step::Done ? Status() : failed();
}

Status RecordingStore::storeEvents(const RecordingBatch& batch, std::string& hash)
{
    std::string content;
    std::int64_t id = m_nextEvent;
    for (const RecordingEvent& event : batch.events) {
        m_insertEvent.bind(0, id);
        m_insertEvent.bind(1, event.tick);
        m_insertEvent.bind(2, std::string_view(event.kind));
        m_insertEvent.bind(3, std::string_view(event.json));
        if (m_insertEvent.step() != Statement::Step::Done) {
            return failed();
        }
        packEvent(content, id++, event);
    }
    return batch.events.empty() ? Status()
                                : storeCheck(kEventsCheck, m_nextEvent, id - 1, batch.events.size(), content, hash);
}

Status RecordingStore::storeScene(const SceneRecord& scene)
{
    m_insertScene.bind(0, std::int64_t{scene.generation});
    m_insertScene.bind(1, static_cast<std::int64_t>(scene.structures.size()));
    m_insertScene.bind(2, scene.fingertip_mm);
    if (m_insertScene.step() != Statement::Step::Done) {
        return failed();
    }
    std::int64_t number = 0;
    for (const StructureRecord& structure : scene.structures) {
        const StructureSource& source = structure.source;
        const std::string pose = poseText(source);
        for (Statement* statement : {&m_insertMesh, &m_insertStructure}) {
            statement->bind(0, source.mesh);
            statement->bind(1, source.part);
            statement->bind(2, source.unit_mm);
            statement->bind(3, std::int64_t{source.flipped});
            statement->bind(4, pose);
            statement->bind(5, source.sha256);
        }
        m_insertStructure.bind(6, std::int64_t{scene.generation});
        m_insertStructure.bind(7, number++);
        m_insertStructure.bind(8, structure.name);
        m_insertStructure.bind(9, std::int64_t{structure.layer});
        m_insertStructure.bind(10, std::int64_t{structure.palpable});
        const std::string law = lawText(structure.tissue.law);
        law.empty() ? m_insertStructure.bindNull(11) : m_insertStructure.bind(11, std::string_view(law));
        structure.lawTable.empty() ? m_insertStructure.bindNull(12)
                                   : m_insertStructure.bindBlob(12, structure.lawTable);
        structure.maps.empty() ? m_insertStructure.bindNull(13) : m_insertStructure.bind(13, structure.maps);
        int column = 14;
        for (const core::TissueTerm& term : core::kTissueTerms) {
            m_insertStructure.bind(column++, structure.tissue.*term.member);
        }
        if (m_insertMesh.step() != Statement::Step::Done || m_insertStructure.step() != Statement::Step::Done) {
            return failed();
        }
        if (Status status = storeMaps(structure); !status.isOk()) {
            return status;
        }
        if (source.embed != nullptr) {
            if (Status status = storeEmbedded(source); !status.isOk()) {
                return status;
            }
        }
    }
    return {};
}

Status RecordingStore::storeTicks(const RecordingBatch& batch, std::string& hash)
{
    std::string content;
    for (std::size_t first = 0; first < batch.ticks.size(); first += m_ticksPerCheck) {
        const std::size_t end = std::min(batch.ticks.size(), first + m_ticksPerCheck);
        content.clear();
        for (std::size_t i = first; i < end; ++i) {
            servo::TickRecord tick = batch.ticks[i];
            tick.time_ns -= m_firstTime_ns;
            bindTick(m_insertTick, tick);
            if (m_insertTick.step() != Statement::Step::Done) {
                return failed();
            }
            packTick(content, tick);
        }
        if (Status status =
                storeCheck(kTicksCheck, batch.ticks[first].tick, batch.ticks[end - 1].tick, end - first, content, hash);
            !status.isOk()) {
            return status;
        }
    }
    return {};
}

Status RecordingStore::store(const RecordingBatch& batch)
{
    std::string hash = m_chain;
    Status status = m_database.execute("BEGIN IMMEDIATE");
    for (const auto step : {&RecordingStore::storeScenes, &RecordingStore::storeEvents, &RecordingStore::storeTicks}) {
        if (status.isOk()) {
            status = (this->*step)(batch, hash);
        }
    }
    if (status.isOk()) {
        status = m_database.execute("COMMIT");
    }
    if (!status.isOk()) {
        if (!m_database.isIdle()) {
            (void)m_database.execute("ROLLBACK");
        }
        return status;
    }
    m_chain = hash;
    m_nextEvent += static_cast<std::int64_t>(batch.events.size());
    return {};
}

} // namespace palpate::session::internal
