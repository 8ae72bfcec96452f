// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/RecordingReader.h"

#include "Database.h"
#include "MetaTable.h"
#include "Packing.h"
#include "Schema.h"

#include <sqlite3.h>

#include <algorithm>
#include <array>
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

core::Vec3 vector(const Statement& row, int column)
{
    return {row.real(column), row.real(column + 1), row.real(column + 2)};
}

/// A vector whose NULLs stand for `implied`.
core::Vec3 vector(const Statement& row, int column, const core::Vec3& implied)
{
    return row.isNull(column) ? implied : vector(row, column);
}

servo::TickRecord readTick(const Statement& row)
{
    using namespace internal;
    servo::TickRecord tick;
    tick.tick = row.integer(kTick);
    tick.time_ns = row.integer(kTime);
    tick.p_WH = vector(row, kHip);
    tick.p_WG = vector(row, kGod, tick.p_WH);
    tick.f_W = vector(row, kForce, core::Vec3::Zero());
    tick.fSent_W = vector(row, kSent, tick.f_W);
    if (!row.isNull(kStructure)) {
        tick.structure = static_cast<std::int32_t>(row.integer(kStructure));
        tick.triangle = static_cast<std::uint32_t>(row.integer(kTriangle));
        const core::Vec3 push = tick.p_WG - tick.p_WH;
        if (const double depth = push.norm(); depth > 0.0) {
            tick.n_W = push / depth;
        }
    }
    tick.constraints = static_cast<std::uint8_t>(row.integer(kConstraints));
    tick.scene = static_cast<std::uint32_t>(row.integer(kScene));
    tick.buttons = static_cast<std::uint32_t>(row.integer(kButtons));
    tick.solve_ns = static_cast<std::uint32_t>(row.integer(kSolve));
    tick.iterations = static_cast<std::uint32_t>(row.integer(kIterations));
    tick.flags = static_cast<std::uint16_t>(row.integer(kFlags));
    return tick;
}

/// What one line of the table `checks` says.
struct Check
{
    std::int64_t first = 0, last = 0, ticks = 0;
    std::string hash;
};

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
    Status readExtent();

    Database database;
    std::filesystem::path path;
    RecordingInfo info;
    RecordingExtent extent;
    std::string metaHash;
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
    if (database.integer("PRAGMA application_id") != kRecordingApplicationId) {
        return wrong(StatusCode::BadFormat, "found another program's SQLite database, expected a Palpate recording");
    }
    info.version = static_cast<int>(database.integer("PRAGMA user_version"));
    if (info.version > kRecordingVersion || info.version < 1) {
        return wrong(StatusCode::Mismatch, "found a recording of version " + std::to_string(info.version) +
                                               ", expected at most " + std::to_string(kRecordingVersion) +
                                               ": a newer Palpate made it");
    }
    return {};
}

Status RecordingReader::Private::readMeta()
{
    Statement row = database.prepare("SELECT key, value FROM meta");
    internal::MetaTable meta;
    Step step = row.step();
    for (; step == Step::Row; step = row.step()) {
        meta[row.bytes(0)] = row.bytes(1);
    }
    if (step == Step::Failed) {
        return damaged();
    }
    auto read = internal::fromMeta(meta);
    if (!read.isOk()) {
        return wrong(read.status().code(), read.status().message());
    }
    const int version = info.version;
    info = std::move(read).value();
    info.version = version;
    extent.isComplete = meta.contains(internal::kComplete);
    metaHash = internal::metaHash(internal::hashedPairs(meta));
    return {};
}

Status RecordingReader::Private::readScenes()
{
    Statement generations = database.prepare("SELECT generation FROM scenes ORDER BY generation");
    Step step = generations.step();
    for (; step == Step::Row; step = generations.step()) {
        scenes.emplace_back().generation = static_cast<std::uint32_t>(generations.integer(0));
    }
    if (step == Step::Failed) {
        return damaged();
    }
    Statement rows = database.prepare(
        "SELECT generation, name, path, part, unit_mm, flipped, sha256, pose, stiffness_N_per_mm, damping_Ns_per_mm, "
        "layer, palpable FROM structures LEFT JOIN meshes USING(mesh) ORDER BY generation, number");
    for (step = rows.step(); step == Step::Row; step = rows.step()) {
        const auto generation = static_cast<std::uint32_t>(rows.integer(0));
        const auto found = std::lower_bound(scenes.begin(), scenes.end(), generation,
                                            [](const SceneRecord& s, std::uint32_t g) { return s.generation < g; });
        if (found == scenes.end() || found->generation != generation) {
            continue;
        }
        StructureRecord& structure = found->structures.emplace_back();
        structure.name = rows.bytes(1);
        structure.source.mesh = rows.bytes(2);
        structure.source.part = rows.bytes(3);
        structure.source.unit_mm = rows.real(4);
        structure.source.flipped = rows.integer(5) != 0;
        structure.source.sha256 = rows.bytes(6);
        structure.source.X_WM = internal::parsePose(rows.bytes(7));
        structure.tissue.stiffness_N_per_mm = rows.real(8);
        structure.tissue.damping_Ns_per_mm = rows.real(9);
        structure.layer = static_cast<std::uint32_t>(rows.integer(10));
        structure.palpable = rows.integer(11) != 0;
    }
    return step == Step::Failed ? damaged() : Status();
}

Status RecordingReader::Private::readEvents()
{
    Statement row = database.prepare("SELECT tick, kind, json FROM events ORDER BY tick, id");
    Step step = row.step();
    for (; step == Step::Row; step = row.step()) {
        events.push_back({row.integer(0), row.bytes(1), row.bytes(2)});
    }
    return step == Step::Failed ? damaged() : Status();
}

Status RecordingReader::Private::readExtent()
{
    // From the checks: counting the rows would read the whole file.
    Statement checks = database.prepare("SELECT min(first_tick), max(last_tick), sum(ticks) FROM checks");
    Statement times = database.prepare("SELECT time_ns FROM ticks WHERE tick = ?");
    if (checks.step() != Step::Row || !times.isPrepared()) {
        return damaged();
    }
    if (checks.isNull(0)) {
        return {};
    }
    extent.firstTick = checks.integer(0);
    extent.lastTick = checks.integer(1);
    extent.ticks = checks.integer(2);
    if (extent.lastTick < extent.firstTick || extent.firstTick < 0 || extent.ticks < 0) {
        return wrong(StatusCode::BadFormat, "found checks of ticks " + std::to_string(extent.firstTick) + " to " +
                                                std::to_string(extent.lastTick) + ", expected an ascending range");
    }
    extent.dropped = std::max<std::int64_t>(0, extent.lastTick - extent.firstTick + 1 - extent.ticks);
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

std::string RecordingReader::structureName(const servo::TickRecord& tick) const
{
    const SceneRecord* felt = scene(tick.scene);
    const auto number = static_cast<std::size_t>(tick.structure);
    return tick.structure < 0 || felt == nullptr || number >= felt->structures.size() ? std::string()
                                                                                      : felt->structures[number].name;
}

Status RecordingReader::forEach(std::int64_t first, std::int64_t last,
                                const std::function<bool(const servo::TickRecord&)>& sink) const
{
    static const std::string kSql = std::string(internal::kSelectTicks) + "WHERE tick BETWEEN ? AND ? ORDER BY tick";
    Statement row = m_d->database.prepare(kSql.c_str());
    row.bind(0, first);
    row.bind(1, last);
    Step step = row.step();
    for (; step == Step::Row; step = row.step()) {
        if (!sink(readTick(row))) {
            return {};
        }
    }
    return step == Step::Failed ? m_d->damaged() : Status();
}

std::optional<servo::TickRecord> RecordingReader::at(std::int64_t tick) const
{
    static const std::string kSql = std::string(internal::kSelectTicks) + "WHERE tick <= ? ORDER BY tick DESC LIMIT 1";
    Statement row = m_d->database.prepare(kSql.c_str());
    row.bind(0, tick);
    return row.step() == Step::Row ? std::optional(readTick(row)) : std::nullopt;
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
    Statement integrity = m_d->database.prepare("PRAGMA integrity_check(1)");
    if (integrity.step() != Step::Row || integrity.bytes(0) != "ok") {
        const std::string what = integrity.isPrepared() ? integrity.bytes(0) : std::string();
        return what.empty() ? m_d->damaged() : m_d->wrong(StatusCode::BadFormat, "damaged: " + what);
    }
    std::vector<Check> checks;
    Statement row =
        m_d->database.prepare("SELECT first_tick, last_tick, ticks, sha256 FROM checks ORDER BY first_tick");
    Step step = row.step();
    for (; step == Step::Row; step = row.step()) {
        checks.push_back({row.integer(0), row.integer(1), row.integer(2), row.bytes(3)});
    }
    if (step == Step::Failed) {
        return m_d->damaged();
    }
    std::string chain = m_d->metaHash;
    std::int64_t expected = std::numeric_limits<std::int64_t>::min(); // no tick may lie between two checks
    const auto name = [](std::int64_t first, std::int64_t last) {
        return "ticks " + std::to_string(first) + " to " + std::to_string(last);
    };
    for (const Check& check : checks) {
        std::string covered = chain;
        std::int64_t ticks = 0;
        const Status status = forEach(expected, check.last, [&](const servo::TickRecord& tick) {
            internal::packTick(covered, tick, 0);
            ++ticks;
            return true;
        });
        if (!status.isOk()) {
            return status;
        }
        if (ticks != check.ticks) {
            return m_d->wrong(StatusCode::Mismatch, name(check.first, check.last) + ": found " + std::to_string(ticks) +
                                                        " rows, expected " + std::to_string(check.ticks));
        }
        if (internal::sha256(covered) != check.hash) {
            const std::string where = &check == checks.data() ? "metadata or " : "";
            return m_d->wrong(StatusCode::Mismatch, where + name(check.first, check.last) +
                                                        ": found other bits than were written (checksum)");
        }
        chain = check.hash;
        expected = check.last + 1;
    }
    const auto after = at(std::numeric_limits<std::int64_t>::max());
    if (after && after->tick >= expected) {
        return m_d->wrong(StatusCode::Mismatch, name(expected, after->tick) + ": found rows without a checksum");
    }
    return {};
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
