// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/RecordingReader.h"

#include "database/Bounds.h"
#include "database/Database.h"
#include "recording/RecordingSurvey.h"
#include "store/CheckedLines.h"
#include "store/RecordingTables.h"
#include "store/SchemaCheck.h"
#include "tables/MetaTable.h"
#include "tables/Tenths.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
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

/// Adds the next step to an error about a damaged recording.
Status withRecovery(const Status& status)
{
    return {status.code(), PALPATE_TEXT("%1; copy the readable parts with `palpate session recover`"), status.text()};
}

bool hasRecordingExtension(const std::filesystem::path& path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : static_cast<char>(c);
    });
    return extension == ".palpate";
}

constexpr std::string_view kSqliteMagic{"SQLite format 3", 16}; // including the terminating zero

} // namespace

struct RecordingReader::Private
{
    Private(Database opened, std::filesystem::path file)
        : database(std::move(opened))
        , path(std::move(file))
    {
    }

    /// Adds the file name unless it is present.
    Status named(const Status& status) const
    {
        return status.isOk() || status.message().starts_with(path.string()) ? status : status.at(path);
    }
    Status readAll();
    Status readHead();
    Status readMeta();
    Status readScenes();
    Status readEvents();
    void readEnding();
    Status readExtent();
    std::optional<std::size_t> blockUpTo(std::int64_t tick) const;

    Database database;
    internal::RecordingTables tables{database};
    std::filesystem::path path;
    RecordingInfo info;
    RecordingExtent extent;
    internal::MetaTable meta;
    std::vector<SceneRecord> scenes;
    internal::Events eventRows;
    std::vector<RecordingEvent> events;
    core::Message eventsFault; ///< reports a skipped event row
    internal::CheckedLines lines{tables, meta, scenes, eventRows};
};

/// Reads in one transaction for a consistent snapshot while another process records into the file.
Status RecordingReader::Private::readAll()
{
    Status status = database.execute("BEGIN");
    for (const auto read :
         {&Private::readHead, &Private::readMeta, &Private::readScenes, &Private::readEvents, &Private::readExtent}) {
        if (status.isOk()) {
            status = (this->*read)();
        }
    }
    const Status ended = database.execute("COMMIT");
    return named(status.isOk() ? ended : status);
}

Status RecordingReader::Private::readHead()
{
    // The first read also detects a journal left by a crash and rolls it back in memory.
    Statement head = database.prepare("SELECT count(*) FROM sqlite_master");
    if (head.step() != Step::Row) {
        return database.cannotRead();
    }
    head.reset();
    const Status status = tables.readVersion();
    return status.isOk() ? internal::checkSchema(database, tables.version()) : status;
}

Status RecordingReader::Private::readMeta()
{
    if (Status status = tables.readMeta(meta); !status.isOk()) {
        return status;
    }
    auto read = internal::fromMeta(meta);
    if (!read.isOk()) {
        return read.status();
    }
    info = std::move(read).value();
    info.version = tables.version();
    info.tickVersion = std::min(info.tickVersion, info.version);
    extent.isComplete = meta.contains(internal::kComplete);
    return {};
}

Status RecordingReader::Private::readScenes()
{
    return tables.readScenes(scenes);
}

Status RecordingReader::Private::readEvents()
{
    const Status status = tables.readEvents(eventRows);
    for (const auto& [id, event] : eventRows) {
        events.push_back(event);
    }
    if (status.code() == StatusCode::BadFormat && status.message().starts_with("event ")) {
        eventsFault = status.text();
        return {};
    }
    return status;
}

/// Extracts from the events how the recording ended and the timing of the servo.
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
            extent.late = std::clamp<std::int64_t>(late.toInteger(), 0, internal::kMaxTick);
        }
    }
}

/// Uses the checks, because counting rows would read the whole file. Verifies the last block, because its last tick
/// determines the duration.
Status RecordingReader::Private::readExtent()
{
    readEnding();
    if (Status status = lines.read(); !status.isOk()) {
        return status;
    }
    const std::vector<internal::Check>& blocks = lines.blocks();
    std::size_t count = blocks.size();
    while (count > 0 && !lines.block(count - 1)->isIntact) {
        --count;
    }
    if (count == 0) {
        return {};
    }
    extent.firstTick = blocks.front().first;
    extent.lastTick = blocks[count - 1].last;
    for (std::size_t i = 0; i < count; ++i) {
        extent.ticks += blocks[i].rows;
    }
    extent.dropped = std::max<std::int64_t>(0, extent.lastTick - extent.firstTick + 1 - extent.ticks);
    extent.duration_s = static_cast<double>(lines.block(count - 1)->ticks.back().time_ns) * 1e-9 + info.dt_s;
    return {};
}

/// @return the index of the last block that begins at or before `tick`; empty before the first block
std::optional<std::size_t> RecordingReader::Private::blockUpTo(std::int64_t tick) const
{
    const std::vector<internal::Check>& blocks = lines.blocks();
    const auto after = std::upper_bound(blocks.begin(), blocks.end(), tick,
                                        [](std::int64_t t, const internal::Check& check) { return t < check.first; });
    return after == blocks.begin() ? std::nullopt : std::optional(static_cast<std::size_t>(after - blocks.begin()) - 1);
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
        return Status(StatusCode::NotFound, PALPATE_TEXT("%1: no such file, expected a recording"), path);
    }
    if (std::filesystem::is_regular_file(kind) && !std::ifstream(path)) {
        return Status(StatusCode::Unreadable, PALPATE_TEXT("%1: cannot be opened: %2"), path, core::systemError(errno));
    }
    if (!isRecordingFile(path)) {
        const Status none(StatusCode::BadFormat, PALPATE_TEXT("%1: found no SQLite database, expected a recording"),
                          path);
        return hasRecordingExtension(path) ? withRecovery(none) : none; // the first page may be damaged
    }
    auto opened = Database::open(path, Database::Mode::Read);
    if (!opened.isOk()) {
        return opened.status();
    }
    auto d = std::make_unique<Private>(std::move(opened).value(), path);
    if (const Status status = d->readAll(); !status.isOk()) {
        const bool isDamaged = status.code() == StatusCode::Unreadable || status.code() == StatusCode::BadFormat;
        return isDamaged ? withRecovery(status) : status;
    }
    return std::unique_ptr<RecordingReader>(new RecordingReader(std::move(d)));
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
    const std::size_t count = m_d->lines.blocks().size();
    for (std::size_t i = m_d->blockUpTo(first).value_or(0); i < count && m_d->lines.blocks()[i].first <= last; ++i) {
        const auto block = m_d->lines.block(i);
        for (const servo::TickRecord& tick : block->ticks) {
            if (tick.tick >= first && tick.tick <= last && !sink(tick)) {
                return {};
            }
        }
    }
    return {};
}

double RecordingReader::shareBefore(std::int64_t tick) const noexcept
{
    const RecordingExtent& extent = m_d->extent;
    return std::clamp(static_cast<double>(tick - extent.firstTick) /
                          static_cast<double>(std::max<std::int64_t>(1, extent.lastTick - extent.firstTick)),
                      0.0, 1.0);
}

std::optional<servo::TickRecord> RecordingReader::at(std::int64_t tick) const
{
    for (auto number = m_d->blockUpTo(tick); number; number = *number > 0 ? std::optional(*number - 1) : std::nullopt) {
        const auto& ticks = m_d->lines.block(*number)->ticks;
        const auto after = std::upper_bound(ticks.begin(), ticks.end(), tick,
                                            [](std::int64_t t, const servo::TickRecord& one) { return t < one.tick; });
        if (after != ticks.begin()) {
            return *std::prev(after);
        }
    }
    return std::nullopt;
}

std::vector<core::Message> RecordingReader::faults() const
{
    std::vector<core::Message> faults = m_d->lines.faults();
    if (!m_d->eventsFault.isEmpty()) {
        faults.insert(faults.begin(), m_d->eventsFault);
    }
    return faults;
}

std::vector<std::string> RecordingReader::embeddedHashes() const
{
    return m_d->tables.embeddedHashes();
}

core::Result<geometry::RepairedMesh> RecordingReader::embedded(const std::string& sha256) const
{
    auto read = m_d->tables.readEmbedded(sha256);
    return read.isOk() ? std::move(read) : m_d->named(read.status());
}

core::Result<Motion> RecordingReader::motion() const
{
    Motion motion;
    motion.dt_s = m_d->info.dt_s;
    const Status status = forEach(0, std::numeric_limits<std::int64_t>::max(), [&](const servo::TickRecord& tick) {
        if ((tick.flags & servo::kNoHand) == 0) {
            motion.p_WH.push_back(tick.p_WH);
        }
        return true;
    });
    if (!status.isOk()) {
        return status;
    }
    if (motion.p_WH.empty()) {
        return Status(StatusCode::Empty, PALPATE_TEXT("%1: found no tick with a hand, expected at least one"),
                      m_d->path);
    }
    return motion;
}

Status RecordingReader::verify(const std::function<bool(double)>& progress) const
{
    bool isCancelled = false;
    const internal::Survey found = internal::survey(m_d->tables, m_d->meta, [&](double share) {
        isCancelled = progress && !progress(share);
        return !isCancelled;
    });
    if (isCancelled) {
        return {StatusCode::Cancelled, PALPATE_TEXT("the check was cancelled")};
    }
    m_d->lines.know(found.known);
    if (!found.faults.empty()) {
        const core::Message& first = found.faults.front();
        return m_d->named({StatusCode::Mismatch,
                           found.faults.size() > 1
                               ? core::Message(PALPATE_TEXT("%1 (and %2 more places)"), first, found.faults.size() - 1)
                               : first});
    }
    Statement integrity = m_d->database.prepare("PRAGMA integrity_check(1)");
    if (integrity.step() != Step::Row || integrity.bytes(0) != "ok") {
        const std::string what = integrity.isPrepared() ? internal::oneLine(integrity.bytes(0)) : std::string();
        return what.empty() ? m_d->database.cannotRead()
                            : Status(StatusCode::BadFormat, PALPATE_TEXT("%1: damaged: %2"), m_d->path, what);
    }
    return {};
}

core::Message endingText(const RecordingExtent& extent)
{
    const core::MessageArgument end_s = internal::tenths(extent.duration_s);
    switch (extent.end) {
    case RecordingEnd::Closed:
        return core::Message(PALPATE_TEXT("complete"));
    case RecordingEnd::DiskFull:
        return core::Message(PALPATE_TEXT("ended at %1 s because the disk was full; what was felt after is not in it"),
                             end_s);
    case RecordingEnd::DiskFailed:
        return core::Message(
            PALPATE_TEXT("ended at %1 s because the disk could not be written; what was felt after is not in it"),
            end_s);
    case RecordingEnd::CutOff:
        break;
    }
    return core::Message(
        PALPATE_TEXT("ended at %1 s without being closed (a crash, or a full disk); what was felt after "
                     "is not in it"),
        end_s);
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

bool isRecordingByNameOrContent(const std::filesystem::path& path)
{
    std::error_code error;
    return isRecordingFile(path) || (hasRecordingExtension(path) && std::filesystem::is_regular_file(path, error));
}

} // namespace palpate::session
