// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/RecordingWriter.h"

#include "palpate/session/GeometryHash.h"

#include "recording/RenamedFile.h"
#include "recording/SceneChanges.h"
#include "recording/StoredPath.h"
#include "store/DiskReserve.h"
#include "store/RecordingPlace.h"
#include "store/RecordingStore.h"
#include "tables/MetaTable.h"

#include <QDateTime>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace palpate::session {

using core::Status;
using core::StatusCode;

namespace {

constexpr double kCommitInterval_s = 0.25;
constexpr double kMaxPending_s = 60.0; // duration of ticks kept while the disk accepts no data
/// Enough for the ticks of two commits with two layers each, and for the journal of the changed pages.
constexpr std::size_t kReserve_bytes = 128 * 1024;

/// Replaces the temporary file name in an SQLite error by the requested name.
Status named(const Status& status, const std::filesystem::path& made, const std::filesystem::path& path)
{
    return status.isOk() ? status
                         : Status(status.code(), internal::renamed(status.text(), made.string(), path.string()));
}

} // namespace

struct RecordingWriter::Private
{
    Status begin(const internal::MetaTable& meta, Sync sync, core::ExistingFile old);
    Status store();
    void deriveEvents(const servo::TickRecord& tick);
    void findChanges();

    std::filesystem::path path;                      ///< path from the caller
    std::unique_ptr<internal::RecordingPlace> place; ///< declared before `file`, which must be closed first
    std::unique_ptr<internal::RecordingStore> file;
    internal::RecordingBatch pending; ///< uncommitted data
    std::size_t ticksPerCommit = 250;
    std::size_t mostPending = 60000;
    std::unique_ptr<internal::DiskReserve> reserve; ///< for `abandon`
    std::optional<servo::TickRecord> stored;        ///< latest committed tick
    std::int64_t written = 0;
    std::uint64_t dropped = 0;
    std::optional<std::int64_t> lastTick;
    std::optional<std::uint32_t> sceneSeen;
    bool isHandGone = false;
    Events derive = Events::Derived;
    bool dropsPending = false; ///< the next tick must carry kDroppedBefore
    bool isFinished = false;
    std::set<std::string> embedded;             ///< hashes of the stored or pending surfaces
    std::map<std::uint32_t, SceneRecord> known; ///< described scenes, without their surfaces
    struct Change
    {
        std::int64_t tick;
        std::uint32_t before, after;
    };
    std::vector<Change> changes; ///< scene changes, until both scenes are known
};

void RecordingWriter::Private::deriveEvents(const servo::TickRecord& tick)
{
    if (sceneSeen != tick.scene) {
        if (sceneSeen) {
            changes.push_back({tick.tick, *sceneSeen, tick.scene});
        }
        sceneSeen = tick.scene;
        pending.events.push_back({tick.tick, "scene", "{\"generation\": " + std::to_string(tick.scene) + "}"});
    }
    const bool isGone = (tick.flags & servo::kNoHand) != 0;
    if (lastTick && isGone != isHandGone) {
        pending.events.push_back({tick.tick, "clutch", isGone ? "{\"engaged\": false}" : "{\"engaged\": true}"});
    }
    isHandGone = isGone;
}

/// Adds the changes of scenes that are now known. A tick may precede the description of its scene.
void RecordingWriter::Private::findChanges()
{
    std::erase_if(changes, [this](const Change& change) {
        const auto before = known.find(change.before);
        const auto after = known.find(change.after);
        if (before == known.end() || after == known.end()) {
            return false;
        }
        for (RecordingEvent& event : internal::sceneChanges(change.tick, before->second, after->second)) {
            pending.events.push_back(std::move(event));
        }
        return true;
    });
}

/// Creates the schema, moves a new file to its name and opens the file.
Status RecordingWriter::Private::begin(const internal::MetaTable& meta, Sync sync, core::ExistingFile old)
{
    if (Status status = internal::RecordingStore::makeFile(place->file(), meta); !status.isOk()) {
        return status;
    }
    if (old == core::ExistingFile::Refuse) {
        if (Status status = place->settle(); !status.isOk()) {
            return status;
        }
    }
    auto opened = internal::RecordingStore::open(place->file(), meta, ticksPerCommit);
    if (!opened.isOk()) {
        return opened.status();
    }
    file = std::move(opened).value();
    if (sync == Sync::EachCommit) {
        reserve = std::make_unique<internal::DiskReserve>(path, kReserve_bytes);
    }
    return file->waitForDisk(sync == Sync::EachCommit);
}

Status RecordingWriter::Private::store()
{
    findChanges();
    const Status status = named(file->store(pending), place->file(), path);
    if (status.isOk()) {
        if (!pending.ticks.empty()) {
            stored = pending.ticks.back();
        }
        pending.clear();
    }
    return status;
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
                                                                       const RecordingInfo& info, Sync sync,
                                                                       Events events, core::ExistingFile old)
{
    RecordingInfo filled = info;
    if (filled.startedUtc.empty()) {
        filled.startedUtc = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    }
    filled.scene = internal::storedPath(filled.scene, path);
    auto claimed = internal::RecordingPlace::claim(path, old);
    if (!claimed.isOk()) {
        return claimed.status();
    }
    auto d = std::make_unique<Private>();
    d->path = path;
    d->place = std::move(claimed).value();
    d->derive = events;
    d->ticksPerCommit = static_cast<std::size_t>(std::clamp(kCommitInterval_s * filled.rate_Hz, 1.0, 1e5));
    d->mostPending = static_cast<std::size_t>(std::clamp(kMaxPending_s * filled.rate_Hz, 1e3, 1e6));
    if (const Status status = d->begin(internal::toMeta(filled), sync, old); !status.isOk()) {
        const Status said = named(status, d->place->file(), path);
        d->file.reset();
        d->place->discard();
        return said;
    }
    return std::unique_ptr<RecordingWriter>(new RecordingWriter(std::move(d)));
}

Status RecordingWriter::append(const servo::TickRecord& tick)
{
    Private& d = *m_d;
    if (d.lastTick && tick.tick <= *d.lastTick) {
        return {StatusCode::OutOfRange, PALPATE_TEXT("tick %1 after tick %2: ticks must ascend"), tick.tick,
                *d.lastTick};
    }
    if (d.pending.ticks.size() >= d.mostPending) {
        ++d.dropped;
        d.dropsPending = true;
        return {StatusCode::Unreadable, PALPATE_TEXT("the disk takes no more: %1 ticks lost"), d.dropped};
    }
    if (!d.lastTick) {
        d.file->setFirstTime(tick.time_ns);
    }
    if (d.derive == Events::Derived) {
        d.deriveEvents(tick);
    }
    d.lastTick = tick.tick;
    d.pending.ticks.push_back(tick);
    if (d.dropsPending) {
        d.pending.ticks.back().flags |= servo::kDroppedBefore;
        d.dropsPending = false;
    }
    ++d.written;
    // Only at multiples, so that not every tick retries while the disk fails.
    return d.pending.ticks.size() % d.ticksPerCommit == 0 ? d.store() : Status();
}

Status RecordingWriter::addScene(const SceneRecord& given)
{
    SceneRecord scene = given;
    for (StructureRecord& structure : scene.structures) {
        StructureSource& source = structure.source;
        source.mesh = internal::storedPath(source.mesh, m_d->path);
        if (source.embed != nullptr && source.sha256.empty()) {
            source.sha256 = geometryHash(source.embed->mesh);
        }
    }
    const auto [known, isNew] = m_d->known.emplace(scene.generation, scene);
    if (!isNew) {
        return {StatusCode::OutOfRange, PALPATE_TEXT("scene %1 is described already"), scene.generation};
    }
    for (StructureRecord& structure : known->second.structures) {
        structure.source.embed.reset(); // release the surface after writing
    }
    SceneRecord& stored = m_d->pending.scenes.emplace_back(scene);
    for (StructureRecord& structure : stored.structures) {
        StructureSource& source = structure.source;
        if (source.embed != nullptr && !m_d->embedded.insert(source.sha256).second) {
            source.embed.reset(); // already stored or pending
        }
    }
    return {};
}

Status RecordingWriter::addEvent(const RecordingEvent& event)
{
    m_d->pending.events.push_back(event);
    return {};
}

Status RecordingWriter::commit()
{
    return m_d->pending.isEmpty() ? Status() : m_d->store();
}

Status RecordingWriter::finish(Ending ending)
{
    Private& d = *m_d;
    if (d.file != nullptr) {
        Status status = d.file->waitForDisk(true);
        if (status.isOk()) {
            status = commit();
        }
        if (status.isOk() && ending == Ending::Complete) {
            status = d.file->markComplete();
        }
        if (!status.isOk()) {
            return named(status, d.place->file(), d.path);
        }
        d.isFinished = true;
        d.file.reset();
    }
    return d.place->complete();
}

void RecordingWriter::discard()
{
    m_d->isFinished = true;
    m_d->reserve.reset();
    m_d->file.reset();
    m_d->place->discard();
}

Status RecordingWriter::abandon(RecordingEvent why)
{
    Private& d = *m_d;
    d.isFinished = true;
    d.reserve.reset();
    why.tick = d.lastTick.value_or(why.tick);
    d.pending.events.push_back(why);
    Status status = d.store();
    if (!status.isOk()) {
        d.written -= static_cast<std::int64_t>(d.pending.ticks.size());
        d.pending.ticks.clear();
        d.pending.scenes.clear();
        const std::int64_t last = d.stored ? d.stored->tick : why.tick;
        for (RecordingEvent& event : d.pending.events) {
            event.tick = std::min(event.tick, last);
        }
        status = d.store();
    }
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

std::optional<std::int64_t> RecordingWriter::newestStored_ns() const noexcept
{
    return m_d->stored ? std::optional(m_d->stored->time_ns) : std::nullopt;
}

} // namespace palpate::session
