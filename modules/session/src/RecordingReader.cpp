// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/RecordingReader.h"

#include "Database.h"
#include "MetaTable.h"
#include "RecordingSurvey.h"
#include "RecordingTables.h"
#include "Schema.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string_view>
#include <utility>

namespace palpate::session {

using core::Status;
using core::StatusCode;
using internal::Database;
using internal::Statement;
using Step = internal::Statement::Step;

namespace {

constexpr std::string_view kSqliteMagic{"SQLite format 3", 16}; // with the zero at its end

} // namespace

struct RecordingReader::Private
{
    Private(Database opened, std::filesystem::path file)
        : database(std::move(opened))
        , path(std::move(file))
    {
    }

    Status damaged() const { return database.error("cannot be read"); }
    Status wrong(StatusCode code, const std::string& what) const { return {code, path.string() + ": " + what}; }
    Status readHead();
    Status readMeta();
    Status readScenes();
    Status readEvents();
    void readEnding();
    Status readExtent();

    Database database;
    internal::RecordingTables tables{database};
    std::filesystem::path path;
    RecordingInfo info;
    RecordingExtent extent;
    internal::MetaTable meta;
    std::vector<SceneRecord> scenes;
    std::vector<RecordingEvent> events;
};

Status RecordingReader::Private::readHead()
{
    // The first read: it also finds a journal that a crash left and that only a writer may roll back.
    Statement head = database.prepare("SELECT count(*) FROM sqlite_master");
    if (head.step() != Step::Row) {
        return damaged();
    }
    head.reset();
    const Status status = tables.readVersion();
    return status.isOk() ? status : wrong(status.code(), status.message());
}

Status RecordingReader::Private::readMeta()
{
    if (Status status = tables.readMeta(meta); !status.isOk()) {
        return status;
    }
    auto read = internal::fromMeta(meta);
    if (!read.isOk()) {
        return wrong(read.status().code(), read.status().message());
    }
    info = std::move(read).value();
    info.version = tables.version();
    extent.isComplete = meta.contains(internal::kComplete);
    return {};
}

Status RecordingReader::Private::readScenes()
{
    const Status status = tables.readScenes(scenes);
    return status.code() == StatusCode::BadFormat ? wrong(status.code(), status.message()) : status;
}

Status RecordingReader::Private::readEvents()
{
    std::vector<std::pair<std::int64_t, RecordingEvent>> read;
    const Status status = tables.readEvents(read);
    for (auto& [id, event] : read) {
        events.push_back(std::move(event));
    }
    return status;
}

/// Takes from the events how the recording ended and how the servo kept time.
void RecordingReader::Private::readEnding()
{
    extent.end = extent.isComplete ? RecordingEnd::Closed : RecordingEnd::CutOff;
    for (const RecordingEvent& event : events) {
        const bool isEnd = event.kind == "ended";
        if (!isEnd && event.kind != "timing") {
            continue;
        }
        const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(event.json)).object();
        if (isEnd) {
            extent.end = json[QLatin1String("why")].toString() == QLatin1String("disk-full") ? RecordingEnd::DiskFull
                                                                                             : RecordingEnd::DiskFailed;
        } else if (const QJsonValue late = json[QLatin1String("late")]; late.isDouble()) {
            extent.late = late.toInteger();
        }
    }
}

Status RecordingReader::Private::readExtent()
{
    readEnding();
    // From the checks: counting the rows would read the whole file.
    std::vector<internal::Check> checks;
    if (Status status = tables.readChecks(checks); !status.isOk()) {
        return status;
    }
    std::erase_if(checks, [](const internal::Check& check) { return check.kind != internal::kTicksCheck; });
    if (checks.empty()) {
        return {};
    }
    extent.firstTick = checks.front().first;
    extent.lastTick = checks.back().last;
    for (const internal::Check& check : checks) {
        extent.ticks += check.rows;
    }
    if (extent.lastTick < extent.firstTick || extent.firstTick < 0 || extent.ticks < 0) {
        return wrong(StatusCode::BadFormat, "found checks of " +
                                                internal::tickRange(extent.firstTick, extent.lastTick) +
                                                ", expected an ascending range");
    }
    extent.dropped = std::max<std::int64_t>(0, extent.lastTick - extent.firstTick + 1 - extent.ticks);
    Statement times = database.prepare("SELECT time_ns FROM ticks WHERE tick = ?");
    if (!times.isPrepared()) {
        return damaged();
    }
    times.bind(0, extent.lastTick);
    if (const Step step = times.step(); step == Step::Row) {
        extent.duration_s = static_cast<double>(times.integer(0)) * 1e-9 + info.dt_s;
    } else if (step == Step::Failed) {
        return damaged();
    }
    return {};
}

RecordingReader::RecordingReader(std::unique_ptr<Private> d)
    : m_d(std::move(d))
{
}

RecordingReader::~RecordingReader() = default;

core::Result<std::unique_ptr<RecordingReader>> RecordingReader::open(const std::filesystem::path& path)
{
    std::error_code error;
    const auto kind = std::filesystem::status(path, error);
    if (!std::filesystem::exists(kind)) {
        return Status(StatusCode::NotFound, path.string() + ": no such file, expected a recording");
    }
    if (!isRecordingFile(path)) {
        return Status(StatusCode::BadFormat, path.string() + ": found no SQLite database, expected a recording");
    }
    for (const auto mode : {Database::Mode::Read, Database::Mode::ReadWrite}) {
        auto opened = Database::open(path, mode);
        if (!opened.isOk()) {
            return opened.status();
        }
        auto d = std::make_unique<Private>(std::move(opened).value(), path);
        Status status = d->readHead();
        const int code = d->database.errorCode();
        if (!status.isOk() && mode == Database::Mode::Read &&
            (code == SQLITE_READONLY_ROLLBACK || code == SQLITE_READONLY_RECOVERY || code == SQLITE_CANTOPEN)) {
            continue; // a crash left a journal: opened for writing, SQLite rolls it back
        }
        for (const auto read : {&Private::readMeta, &Private::readScenes, &Private::readEvents, &Private::readExtent}) {
            if (status.isOk()) {
                status = (d.get()->*read)();
            }
        }
        if (!status.isOk()) {
            return status;
        }
        return std::unique_ptr<RecordingReader>(new RecordingReader(std::move(d)));
    }
    return Status(StatusCode::Internal, path.string() + ": cannot be opened");
}

const std::filesystem::path& RecordingReader::path() const noexcept
{
    return m_d->path;
}

const RecordingInfo& RecordingReader::info() const noexcept
{
    return m_d->info;
}

const RecordingExtent& RecordingReader::extent() const noexcept
{
    return m_d->extent;
}

const std::vector<SceneRecord>& RecordingReader::scenes() const noexcept
{
    return m_d->scenes;
}

const std::vector<RecordingEvent>& RecordingReader::events() const noexcept
{
    return m_d->events;
}

const SceneRecord* RecordingReader::scene(std::uint32_t generation) const noexcept
{
    const auto& scenes = m_d->scenes;
    const auto found = std::lower_bound(scenes.begin(), scenes.end(), generation,
                                        [](const SceneRecord& s, std::uint32_t g) { return s.generation < g; });
    return found == scenes.end() || found->generation != generation ? nullptr : &*found;
}

std::string_view RecordingReader::structureName(std::uint32_t generation, std::uint32_t number) const noexcept
{
    const SceneRecord* felt = scene(generation);
    return felt == nullptr || number >= felt->structures.size() ? std::string_view() : felt->structures[number].name;
}

std::string RecordingReader::structureName(const servo::TickRecord& tick) const
{
    return tick.felt.structure < 0
               ? std::string()
               : std::string(structureName(tick.scene, static_cast<std::uint32_t>(tick.felt.structure)));
}

Status RecordingReader::forEach(std::int64_t first, std::int64_t last,
                                const std::function<bool(const servo::TickRecord&)>& sink) const
{
    return m_d->tables.readTicks(first, last, sink);
}

std::optional<servo::TickRecord> RecordingReader::at(std::int64_t tick) const
{
    return m_d->tables.tickAt(tick);
}

std::vector<std::string> RecordingReader::embeddedHashes() const
{
    return m_d->tables.embeddedHashes();
}

core::Result<geometry::RepairedMesh> RecordingReader::embedded(const std::string& sha256) const
{
    auto read = m_d->tables.readEmbedded(sha256);
    return read.isOk() ? std::move(read) : m_d->wrong(read.status().code(), read.status().message());
}

core::Result<Motion> RecordingReader::motion() const
{
    Motion motion;
    motion.dt_s = m_d->info.dt_s;
    std::optional<std::int64_t> bad;
    const Status status = forEach(0, std::numeric_limits<std::int64_t>::max(), [&](const servo::TickRecord& tick) {
        if ((tick.flags & servo::kNoHand) == 0) {
            if (!tick.p_WH.allFinite()) {
                bad = tick.tick;
                return false;
            }
            motion.p_WH.push_back(tick.p_WH);
        }
        return true;
    });
    if (!status.isOk()) {
        return status;
    }
    if (bad) {
        return m_d->wrong(StatusCode::NonFinite,
                          "tick " + std::to_string(*bad) + ": found a HIP that is not finite, expected numbers");
    }
    if (motion.p_WH.empty()) {
        return m_d->wrong(StatusCode::Empty, "found no tick with a hand, expected at least one");
    }
    return motion;
}

Status RecordingReader::verify() const
{
    const internal::Survey found = internal::survey(m_d->tables, m_d->meta);
    if (!found.faults.empty()) {
        const std::string more = found.faults.size() > 1
                                     ? " (and " + std::to_string(found.faults.size() - 1) + " more places)"
                                     : std::string();
        return m_d->wrong(StatusCode::Mismatch, found.faults.front() + more);
    }
    Statement integrity = m_d->database.prepare("PRAGMA integrity_check(1)");
    if (integrity.step() != Step::Row || integrity.bytes(0) != "ok") {
        const std::string what = integrity.isPrepared() ? integrity.bytes(0) : std::string();
        return what.empty() ? m_d->damaged() : m_d->wrong(StatusCode::BadFormat, "damaged: " + what);
    }
    return {};
}

std::string endingText(const RecordingExtent& extent)
{
    std::array<char, 48> at{};
    std::snprintf(at.data(), at.size(), "ended at %.1f s", extent.duration_s);
    switch (extent.end) {
    case RecordingEnd::Closed:
        return "complete";
    case RecordingEnd::DiskFull:
        return at.data() + std::string(" because the disk was full; what was felt after is not in it");
    case RecordingEnd::DiskFailed:
        return at.data() + std::string(" because the disk could not be written; what was felt after is not in it");
    case RecordingEnd::CutOff:
        break;
    }
    return at.data() + std::string(" without being closed (a crash, or a full disk); what was felt after is not in it");
}

bool isRecordingFile(const std::filesystem::path& path)
{
    std::array<char, kSqliteMagic.size()> start{};
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        return false;
    }
    std::ifstream file(path, std::ios::binary);
    return file.read(start.data(), start.size()) && std::string_view(start.data(), start.size()) == kSqliteMagic;
}

} // namespace palpate::session
