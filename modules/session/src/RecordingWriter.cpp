// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/RecordingWriter.h"

#include "DiskReserve.h"
#include "MetaTable.h"
#include "RecordingStore.h"
#include "SceneChanges.h"

#include <QDateTime>

#include <algorithm>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <unistd.h>

namespace palpate::session {

using core::Status;
using core::StatusCode;

namespace {

constexpr double kCommitInterval_s = 0.25;
constexpr double kKept_s = 60.0; // of ticks, while the disk cannot take them
/// For the ticks of two commits, of two layers each, and for the journal of the pages that they change.
constexpr std::size_t kReserve_bytes = 128 * 1024;

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
    Status store();
    void deriveEvents(const servo::TickRecord& tick);
    void findChanges();

    std::unique_ptr<internal::RecordingStore> file;
    internal::RecordingBatch pending; ///< not yet committed
    std::size_t ticksPerCommit = 250;
    std::size_t mostPending = 60000;
    std::unique_ptr<internal::DiskReserve> reserve; ///< for `abandon`
    std::optional<servo::TickRecord> stored;        ///< newest tick that is committed
    std::int64_t written = 0;
    std::uint64_t dropped = 0;
    std::optional<std::int64_t> lastTick;
    std::optional<std::uint32_t> sceneSeen;
    bool isHandGone = false;
    Events derive = Events::Derived;
    bool dropsPending = false; ///< the next tick must say that some before it are missing
    bool isFinished = false;
    std::set<std::string> embedded;             ///< hashes of the surfaces that are stored or pending
    std::map<std::uint32_t, SceneRecord> known; ///< scenes told of, without their surfaces
    struct Change
    {
        std::int64_t tick;
        std::uint32_t before, after;
    };
    std::vector<Change> changes; ///< of scene, until both are known
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

/// A tick may come before the description of its scene: what changed is told once both are there.
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

Status RecordingWriter::Private::store()
{
    findChanges();
    const Status status = file->store(pending);
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

core::Result<std::unique_ptr<RecordingWriter>>
RecordingWriter::create(const std::filesystem::path& path, const RecordingInfo& info, Sync sync, Events events)
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
    if (const Status status = internal::RecordingStore::makeFile(temporary, meta); !status.isOk()) {
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

    auto d = std::make_unique<Private>();
    d->ticksPerCommit = static_cast<std::size_t>(std::clamp(kCommitInterval_s * filled.rate_Hz, 1.0, 1e5));
    d->mostPending = static_cast<std::size_t>(std::clamp(kKept_s * filled.rate_Hz, 1e3, 1e6));
    auto opened = internal::RecordingStore::open(path, meta, d->ticksPerCommit);
    if (!opened.isOk()) {
        return opened.status();
    }
    d->file = std::move(opened).value();
    if (Status status = d->file->waitForDisk(sync == Sync::EachCommit); !status.isOk()) {
        return status;
    }
    if (sync == Sync::EachCommit) {
        d->reserve = std::make_unique<internal::DiskReserve>(path, kReserve_bytes);
    }
    d->derive = events;
    return std::unique_ptr<RecordingWriter>(new RecordingWriter(std::move(d)));
}

Status RecordingWriter::append(const servo::TickRecord& tick)
{
    Private& d = *m_d;
    if (d.lastTick && tick.tick <= *d.lastTick) {
        return {StatusCode::OutOfRange, "tick " + std::to_string(tick.tick) + " after tick " +
                                            std::to_string(*d.lastTick) + ": ticks must ascend"};
    }
    if (d.pending.ticks.size() >= d.mostPending) {
        ++d.dropped;
        d.dropsPending = true;
        return {StatusCode::Unreadable, "the disk takes no more: " + std::to_string(d.dropped) + " ticks lost"};
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
    // Only at multiples: while the disk fails, not every tick shall try again.
    return d.pending.ticks.size() % d.ticksPerCommit == 0 ? d.store() : Status();
}

Status RecordingWriter::addScene(const SceneRecord& scene)
{
    const auto [known, isNew] = m_d->known.emplace(scene.generation, scene);
    if (!isNew) {
        return {StatusCode::OutOfRange, "scene " + std::to_string(scene.generation) + " is described already"};
    }
    for (StructureRecord& structure : known->second.structures) {
        structure.source.embed.reset(); // held until it is written, not longer
    }
    SceneRecord& stored = m_d->pending.scenes.emplace_back(scene);
    for (StructureRecord& structure : stored.structures) {
        StructureSource& source = structure.source;
        if (source.embed != nullptr && (source.sha256.empty() || !m_d->embedded.insert(source.sha256).second)) {
            source.embed.reset(); // in the recording already, or about to be
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
    if (Status status = d.file->waitForDisk(true); !status.isOk()) {
        return status;
    }
    if (Status status = commit(); !status.isOk()) {
        return status;
    }
    Status status;
    if (ending == Ending::Complete) {
        status = d.file->markComplete();
    }
    d.isFinished = status.isOk();
    return status;
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
