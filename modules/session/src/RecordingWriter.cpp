// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/RecordingWriter.h"

#include "Database.h"
#include "MetaTable.h"
#include "Packing.h"
#include "Schema.h"

#include <QDateTime>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include <unistd.h>

namespace palpate::session {

using core::Status;
using core::StatusCode;
using internal::Database;
using internal::Statement;

namespace {

constexpr double kCommitInterval_s = 0.25;
constexpr double kKept_s = 60.0; // of ticks, while the disk cannot take them

/// The three columns of a vector; NULLs when it equals what they stand for.
void bindVector(Statement& row, int column, const core::Vec3& v, const core::Vec3& implied)
{
    const bool isImplied = internal::sameBits(v, implied);
    for (int i = 0; i < 3; ++i) {
        isImplied ? row.bindNull(column + i) : row.bind(column + i, v[i]);
    }
}

Status makeFile(const std::filesystem::path& path, const internal::MetaTable& meta)
{
    auto opened = Database::open(path, Database::Mode::Create);
    if (!opened.isOk()) {
        return opened.status();
    }
    Database& database = opened.value();
    Status status =
        database.execute("PRAGMA application_id=" + std::to_string(kRecordingApplicationId) +
                         "; PRAGMA user_version=" + std::to_string(kRecordingVersion) + "; BEGIN;" + internal::kSchema);
    Statement insert = database.prepare("INSERT INTO meta VALUES(?, ?)");
    for (auto pair = meta.begin(); status.isOk() && pair != meta.end(); ++pair) {
        insert.bind(0, pair->first);
        pair->first == "start" ? insert.bindBlob(1, pair->second) : insert.bind(1, pair->second);
        if (insert.step() != Statement::Step::Done) {
            status = database.error("cannot be written");
        }
    }
    return status.isOk() ? database.execute("COMMIT") : status;
}

void removeSideFiles(const std::filesystem::path& path)
{
    for (const char* suffix : {"-journal", "-wal", "-shm"}) {
        std::filesystem::path side = path;
        side += suffix;
        std::error_code ignored;
        std::filesystem::remove(side, ignored);
    }
}

} // namespace

struct RecordingWriter::Private
{
    explicit Private(Database opened)
        : database(std::move(opened))
    {
    }

    Status store();
    Status storeScene(const SceneRecord& scene);
    Status storeTicks();
    bool storeTick(const servo::TickRecord& tick);
    Status failed() const { return database.error("cannot be written"); }

    Database database;
    Statement insertTick, insertCheck, insertEvent, insertScene, insertMesh, insertStructure;
    std::size_t ticksPerCommit = 250;
    std::size_t mostPending = 60000;
    std::string chain; ///< hash of the last stored check
    std::int64_t firstTime_ns = 0;
    std::int64_t written = 0;
    std::uint64_t dropped = 0;
    std::optional<std::int64_t> lastTick;
    std::optional<std::uint32_t> sceneSeen;
    bool dropsPending = false; ///< the next tick must say that some before it are missing
    bool isFinished = false;
    std::vector<servo::TickRecord> ticks;
    std::vector<SceneRecord> scenes;
    std::vector<RecordingEvent> events;
};

Status RecordingWriter::Private::storeScene(const SceneRecord& scene)
{
    insertScene.bind(0, std::int64_t{scene.generation});
    insertScene.bind(1, static_cast<std::int64_t>(scene.structures.size()));
    if (insertScene.step() != Statement::Step::Done) {
        return failed();
    }
    std::int64_t number = 0;
    for (const StructureRecord& structure : scene.structures) {
        const StructureSource& source = structure.source;
        const std::string pose = internal::poseText(source.X_WM);
        for (Statement* statement : {&insertMesh, &insertStructure}) {
            statement->bind(0, source.mesh);
            statement->bind(1, source.part);
            statement->bind(2, source.unit_mm);
            statement->bind(3, std::int64_t{source.flipped});
            statement->bind(4, pose);
            statement->bind(5, source.sha256);
        }
        insertStructure.bind(6, std::int64_t{scene.generation});
        insertStructure.bind(7, number++);
        insertStructure.bind(8, structure.name);
        insertStructure.bind(9, structure.tissue.stiffness_N_per_mm);
        insertStructure.bind(10, structure.tissue.damping_Ns_per_mm);
        insertStructure.bind(11, std::int64_t{structure.layer});
        insertStructure.bind(12, std::int64_t{structure.palpable});
        if (insertMesh.step() != Statement::Step::Done || insertStructure.step() != Statement::Step::Done) {
            return failed();
        }
    }
    return {};
}

bool RecordingWriter::Private::storeTick(const servo::TickRecord& tick)
{
    using namespace internal;
    Statement& row = insertTick;
    row.bind(kTick, tick.tick);
    row.bind(kTime, tick.time_ns - firstTime_ns);
    for (int i = 0; i < 3; ++i) {
        row.bind(kHip + i, tick.p_WH[i]);
    }
    bindVector(row, kGod, tick.p_WG, tick.p_WH);
    bindVector(row, kForce, tick.f_W, core::Vec3::Zero());
    bindVector(row, kSent, tick.fSent_W, tick.f_W);
    if (tick.structure >= 0) {
        row.bind(kStructure, std::int64_t{tick.structure});
        row.bind(kTriangle, std::int64_t{tick.triangle});
    } else {
        row.bindNull(kStructure);
        row.bindNull(kTriangle);
    }
    row.bind(kConstraints, std::int64_t{tick.constraints});
    row.bind(kScene, std::int64_t{tick.scene});
    row.bind(kButtons, std::int64_t{tick.buttons});
    row.bind(kSolve, std::int64_t{tick.solve_ns});
    row.bind(kIterations, std::int64_t{tick.iterations});
    row.bind(kFlags, std::int64_t{tick.flags});
    return row.step() == Statement::Step::Done;
}

Status RecordingWriter::Private::storeTicks()
{
    std::string hash = chain;
    for (std::size_t first = 0; first < ticks.size(); first += ticksPerCommit) {
        const std::size_t end = std::min(ticks.size(), first + ticksPerCommit);
        std::string covered = hash;
        for (std::size_t i = first; i < end; ++i) {
            if (!storeTick(ticks[i])) {
                return failed();
            }
            internal::packTick(covered, ticks[i], firstTime_ns);
        }
        hash = internal::sha256(covered);
        insertCheck.bind(0, ticks[first].tick);
        insertCheck.bind(1, ticks[end - 1].tick);
        insertCheck.bind(2, static_cast<std::int64_t>(end - first));
        insertCheck.bindBlob(3, hash);
        if (insertCheck.step() != Statement::Step::Done) {
            return failed();
        }
    }
    if (Status status = database.execute("COMMIT"); !status.isOk()) {
        return status;
    }
    chain = hash;
    return {};
}

Status RecordingWriter::Private::store()
{
    Status status = database.execute("BEGIN IMMEDIATE");
    for (auto scene = scenes.begin(); status.isOk() && scene != scenes.end(); ++scene) {
        status = storeScene(*scene);
    }
    for (auto event = events.begin(); status.isOk() && event != events.end(); ++event) {
        insertEvent.bind(0, event->tick);
        insertEvent.bind(1, event->kind);
        insertEvent.bind(2, event->json);
        if (insertEvent.step() != Statement::Step::Done) {
            status = failed();
        }
    }
    if (status.isOk()) {
        status = storeTicks();
    }
    if (!status.isOk()) {
        if (!database.isIdle()) {
            (void)database.execute("ROLLBACK"); // what was added stays pending and is tried again
        }
        return status;
    }
    scenes.clear();
    events.clear();
    ticks.clear();
    return {};
}

RecordingWriter::RecordingWriter(std::unique_ptr<Private> d)
    : m_d(std::move(d))
{
}

RecordingWriter::~RecordingWriter()
{
    if (!m_d->isFinished) {
        (void)commit();
    }
}

core::Result<std::unique_ptr<RecordingWriter>> RecordingWriter::create(const std::filesystem::path& path,
                                                                       const RecordingInfo& info, Sync sync)
{
    std::error_code error;
    const auto kind = std::filesystem::status(path, error);
    if (std::filesystem::exists(kind) && !std::filesystem::is_regular_file(kind)) {
        return Status(StatusCode::Unreadable, path.string() + ": cannot be written: not a file");
    }
    if (std::filesystem::exists(kind) && ::access(path.c_str(), W_OK) != 0) {
        return Status(StatusCode::Unreadable, path.string() + ": cannot be written: " + std::strerror(errno));
    }
    RecordingInfo filled = info;
    if (filled.startedUtc.empty()) {
        filled.startedUtc = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    }
    const internal::MetaTable meta = internal::toMeta(filled);

    // Made beside and renamed, so that the name never stands for a file without its schema.
    std::filesystem::path temporary = path;
    for (const std::string& part : {std::string("."), std::to_string(::getpid()), std::string(".part")}) {
        temporary += part;
    }
    std::filesystem::remove(temporary, error);
    if (const Status status = makeFile(temporary, meta); !status.isOk()) {
        std::filesystem::remove(temporary, error);
        removeSideFiles(temporary);
        std::string message = status.message();
        if (const auto at = message.find(temporary.string()); at != std::string::npos) {
            message.replace(at, temporary.string().size(), path.string());
        }
        return Status(status.code(), message);
    }
    removeSideFiles(path); // an old journal would be rolled back into the new file
    std::filesystem::rename(temporary, path, error);
    if (error) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        return Status(StatusCode::Unreadable, path.string() + ": cannot be written: " + error.message());
    }

    auto opened = Database::open(path, Database::Mode::ReadWrite);
    if (!opened.isOk()) {
        return opened.status();
    }
    auto d = std::make_unique<Private>(std::move(opened).value());
    if (Status status =
            d->database.execute(sync == Sync::EachCommit ? "PRAGMA synchronous=FULL" : "PRAGMA synchronous=OFF");
        !status.isOk()) {
        return status;
    }
    d->insertTick = d->database.prepare(internal::kInsertTick);
    d->insertCheck = d->database.prepare("INSERT INTO checks VALUES(?, ?, ?, ?)");
    d->insertEvent = d->database.prepare("INSERT INTO events(tick, kind, json) VALUES(?, ?, ?)");
    d->insertScene = d->database.prepare("INSERT OR REPLACE INTO scenes VALUES(?, ?)");
    d->insertMesh = d->database.prepare("INSERT OR IGNORE INTO meshes(path, part, unit_mm, flipped, pose, sha256) "
                                        "VALUES(?1, ?2, ?3, ?4, ?5, ?6)");
    d->insertStructure = d->database.prepare(
        "INSERT OR REPLACE INTO structures SELECT ?7, ?8, ?9, mesh, ?10, ?11, ?12, ?13 FROM meshes "
        "WHERE path = ?1 AND part = ?2 AND unit_mm = ?3 AND flipped = ?4 AND pose = ?5 AND sha256 = ?6");
    d->ticksPerCommit = static_cast<std::size_t>(std::clamp(kCommitInterval_s * filled.rate_Hz, 1.0, 1e5));
    d->mostPending = static_cast<std::size_t>(std::clamp(kKept_s * filled.rate_Hz, 1e3, 1e6));
    d->chain = internal::metaHash(internal::hashedPairs(meta));
    return std::unique_ptr<RecordingWriter>(new RecordingWriter(std::move(d)));
}

Status RecordingWriter::append(const servo::TickRecord& tick)
{
    Private& d = *m_d;
    if (d.lastTick && tick.tick <= *d.lastTick) {
        return {StatusCode::OutOfRange, "tick " + std::to_string(tick.tick) + " after tick " +
                                            std::to_string(*d.lastTick) + ": ticks must ascend"};
    }
    if (d.ticks.size() >= d.mostPending) {
        ++d.dropped;
        d.dropsPending = true;
        return {StatusCode::Unreadable, "the disk takes no more: " + std::to_string(d.dropped) + " ticks lost"};
    }
    if (!d.lastTick) {
        d.firstTime_ns = tick.time_ns;
    }
    if (d.sceneSeen != tick.scene) {
        d.sceneSeen = tick.scene;
        d.events.push_back({tick.tick, "scene", "{\"generation\": " + std::to_string(tick.scene) + "}"});
    }
    d.lastTick = tick.tick;
    d.ticks.push_back(tick);
    if (d.dropsPending) {
        d.ticks.back().flags |= servo::kDroppedBefore;
        d.dropsPending = false;
    }
    ++d.written;
    // Only at multiples: while the disk fails, not every tick shall try again.
    return d.ticks.size() % d.ticksPerCommit == 0 ? d.store() : Status();
}

Status RecordingWriter::addScene(const SceneRecord& scene)
{
    m_d->scenes.push_back(scene);
    return {};
}

Status RecordingWriter::addEvent(const RecordingEvent& event)
{
    m_d->events.push_back(event);
    return {};
}

Status RecordingWriter::commit()
{
    const Private& d = *m_d;
    return d.ticks.empty() && d.scenes.empty() && d.events.empty() ? Status() : m_d->store();
}

Status RecordingWriter::finish()
{
    Private& d = *m_d;
    if (Status status = d.database.execute("PRAGMA synchronous=FULL"); !status.isOk()) {
        return status;
    }
    if (Status status = commit(); !status.isOk()) {
        return status;
    }
    Status status =
        d.database.execute(std::string("INSERT OR REPLACE INTO meta VALUES('") + internal::kComplete + "', '1')");
    d.isFinished = status.isOk();
    return status;
}

std::int64_t RecordingWriter::ticksWritten() const noexcept
{
    return m_d->written;
}

std::uint64_t RecordingWriter::ticksDropped() const noexcept
{
    return m_d->dropped;
}

std::size_t RecordingWriter::ticksPending() const noexcept
{
    return m_d->ticks.size();
}

} // namespace palpate::session
