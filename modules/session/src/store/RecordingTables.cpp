// SPDX-License-Identifier: BSD-3-Clause
#include "store/RecordingTables.h"

#include "database/Bounds.h"
#include "database/LawText.h"
#include "palpate/session/GeometryHash.h"
#include "store/MapRows.h"
#include "tables/Packing.h"
#include "tables/Schema.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace palpate::session::internal {

using core::Status;
using core::StatusCode;
using Step = Statement::Step;

namespace {

/// Copies a blob into numbers. @return false if the length is not a multiple of the number size
template<class T>
bool copyBlob(const std::string& bytes, std::vector<T>& out)
{
    out.resize(bytes.size() / sizeof(T));
    if (!out.empty()) { // memcpy requires a non-null pointer even for zero bytes
        std::memcpy(static_cast<void*>(out.data()), bytes.data(), out.size() * sizeof(T));
    }
    return bytes.size() % sizeof(T) == 0;
}

/// Counts the bytes of texts while reading. In a malicious file, rows can share the pages of their texts and exceed the
/// file size by far.
class BytesRead
{
  public:
    explicit BytesRead(const Database& database)
        : m_left(database.fileSize() > 0 ? database.fileSize() : std::numeric_limits<std::int64_t>::max())
    {
    }
    std::string take(std::string bytes)
    {
        m_left -= static_cast<std::int64_t>(bytes.size());
        return bytes;
    }
    [[nodiscard]] bool isTooMany() const noexcept { return m_left < 0; }

  private:
    std::int64_t m_left;
};

} // namespace

Status RecordingTables::tooMany(const core::Message& what, std::size_t most) const
{
    return {StatusCode::BadFormat,
            PALPATE_TEXT("found more than %1 %2, or more bytes of them than the file has, expected what a recorder "
                         "writes"),
            most, what};
}

Status RecordingTables::readVersion()
{
    if (m_database.integer("PRAGMA application_id") != kRecordingApplicationId) {
        return {StatusCode::BadFormat,
                PALPATE_TEXT("found another program's SQLite database, expected a Palpate recording")};
    }
    m_version = static_cast<int>(m_database.integer("PRAGMA user_version"));
    if (m_version > kMovingVersion || m_version < 1) {
        return m_version < 1
                   ? Status(StatusCode::BadFormat,
                            PALPATE_TEXT("found a recording of version %1, expected 1 to %2: damaged"), m_version,
                            kMovingVersion)
                   : Status(StatusCode::Mismatch,
                            PALPATE_TEXT("found a recording of version %1, expected at most %2: a newer Palpate made "
                                         "it"),
                            m_version, kMovingVersion);
    }
    return {};
}

Status RecordingTables::readMeta(MetaTable& out) const
{
    Statement row = m_database.prepare("SELECT key, value FROM meta");
    BytesRead bytes(m_database);
    std::size_t rows = 0;
    Step step = row.step();
    for (; step == Step::Row; step = row.step()) {
        std::string key = bytes.take(row.bytes(0));
        out[std::move(key)] = bytes.take(row.bytes(1));
        if (++rows > kMaxMeta || bytes.isTooMany()) {
            return tooMany(core::Message(PALPATE_TEXT("values of the metadata")), kMaxMeta);
        }
    }
    return step == Step::Failed ? damaged() : Status();
}

namespace {

/// Formats an error: "found -1 for stiffness_N_per_mm, expected 0 to 1000".
core::Message outOfRange(double value, std::string_view key, double least, double most)
{
    return {PALPATE_TEXT("found %1 for %2, expected %3 to %4"), value, key, least, most};
}

/// Checks a structure's numbers against the limits of scene files. @return the error; empty if valid
std::optional<core::Message> wrongNumber(const StructureRecord& structure, const Statement& row)
{
    constexpr double kLeastUnit_mm = 1e-6, kMostUnit_mm = 1e6;
    constexpr int kUnit = 4, kLayer = 8;
    if (!row.isInteger(kLayer) || row.integer(kLayer) < 0 ||
        row.integer(kLayer) > std::numeric_limits<std::uint32_t>::max()) {
        return core::Message(PALPATE_TEXT("found the layer %1, expected one from 0"), row.integer(kLayer));
    }
    for (const core::TissueTerm& term : core::kTissueTerms) {
        const double value = structure.tissue.*term.member;
        if (!(value >= 0.0 && value <= term.most)) {
            return outOfRange(value, term.key, 0.0, term.most);
        }
    }
    if (row.isNull(kUnit)) { // the outer join found no mesh, so a copy of the scene could not refer to any mesh
        return core::Message(PALPATE_TEXT("found no mesh with a unit, expected one of the recording's meshes"));
    }
    const double unit_mm = structure.source.unit_mm;
    if (!(unit_mm >= kLeastUnit_mm && unit_mm <= kMostUnit_mm)) {
        return outOfRange(unit_mm, "unit_mm", kLeastUnit_mm, kMostUnit_mm);
    }
    const auto& X_WM = structure.source.X_WM.matrix();
    for (const double value : X_WM.reshaped()) {
        if (!(std::abs(value) <= kMaxCoordinate_mm)) {
            return outOfRange(value, "pose", -kMaxCoordinate_mm, kMaxCoordinate_mm);
        }
    }
    return std::nullopt;
}

/// Cache of maps by their text, because many scenes of a recording share the same maps.
class ReadMaps
{
  public:
    explicit ReadMaps(std::function<std::optional<std::string>(const std::string&)> find)
        : m_find(std::move(find))
    {
    }
    const StoredMaps& operator()(const std::string& text)
    {
        auto found = m_byText.find(text);
        if (found == m_byText.end()) {
            found = m_byText.emplace(text, mapsOf(text, m_find)).first;
        }
        return found->second;
    }

  private:
    std::function<std::optional<std::string>(const std::string&)> m_find;
    std::map<std::string, StoredMaps> m_byText;
};

} // namespace

Status RecordingTables::readGenerations(std::vector<SceneRecord>& out) const
{
    Statement row =
        m_database.prepare(m_version >= 2 ? "SELECT generation, fingertip_mm FROM scenes ORDER BY generation"
                                          : "SELECT generation, 0.0 FROM scenes ORDER BY generation");
    Step step = row.step();
    for (; step == Step::Row; step = row.step()) {
        const std::int64_t generation = row.integer(0);
        const double fingertip_mm = row.real(1);
        if (!row.isInteger(0) || generation < 0 || generation > std::numeric_limits<std::uint32_t>::max() ||
            (!out.empty() && generation <= out.back().generation)) {
            return {StatusCode::BadFormat,
                    PALPATE_TEXT("found the scene %1, expected ascending generations of 32 bits"), generation};
        }
        if (!(fingertip_mm >= 0.0 && fingertip_mm <= haptics::HapticScene::kMostFingertip_mm)) {
            return {StatusCode::BadFormat, PALPATE_TEXT("scene %1: %2"), generation,
                    outOfRange(fingertip_mm, "fingertip_mm", 0.0, haptics::HapticScene::kMostFingertip_mm)};
        }
        SceneRecord& scene = out.emplace_back();
        scene.generation = static_cast<std::uint32_t>(generation);
        scene.fingertip_mm = fingertip_mm;
        if (out.size() > kMaxScenes) {
            return tooMany(core::Message(PALPATE_TEXT("scenes")), kMaxScenes);
        }
    }
    return step == Step::Failed ? damaged() : Status();
}

Status RecordingTables::readScenes(std::vector<SceneRecord>& out) const
{
    Status status = readGenerations(out);
    Statement rows = m_database.prepare(
        (std::string("SELECT generation, name, path, part, unit_mm, flipped, sha256, pose, layer, palpable") +
         (m_version >= 3 ? ", law, law_table, maps" : ", NULL, NULL, NULL") + tissueColumns(m_version) +
         " FROM structures LEFT JOIN meshes USING(mesh) ORDER BY generation, number")
            .c_str());
    ReadMaps maps([this](const std::string& hash) { return mapBytes(hash); });
    std::size_t structures = 0;
    std::set<std::uint32_t> wrongScenes;
    Step step = rows.step();
    for (; step == Step::Row; step = rows.step()) {
        if (++structures > kMaxStructures) {
            return tooMany(core::Message(PALPATE_TEXT("structures")), kMaxStructures);
        }
        const std::int64_t generation = rows.integer(0);
        const auto found = std::lower_bound(out.begin(), out.end(), generation,
                                            [](const SceneRecord& s, std::int64_t g) { return s.generation < g; });
        if (found == out.end() || found->generation != generation) {
            continue;
        }
        StructureRecord& structure = found->structures.emplace_back();
        structure.name = rows.bytes(1);
        structure.source.mesh = rows.bytes(2);
        structure.source.part = rows.bytes(3);
        structure.source.unit_mm = rows.real(4);
        structure.source.flipped = rows.integer(5) != 0;
        structure.source.sha256 = rows.bytes(6);
        parsePose(rows.bytes(7), structure.source);
        structure.layer = static_cast<std::uint32_t>(rows.integer(8));
        structure.palpable = rows.integer(9) != 0;
        structure.lawTable = rows.bytes(11);
        structure.maps = rows.bytes(12);
        if (!structure.maps.empty()) {
            const StoredMaps& stored = maps(structure.maps);
            structure.tissueMaps = stored.maps;
            structure.motion = stored.motion;
        }
        int column = 13;
        for (const core::TissueTerm& term : tissueTerms(m_version)) {
            structure.tissue.*term.member = rows.real(column++);
        }
        std::optional<core::Message> wrong = wrongNumber(structure, rows);
        if (auto law = parseLaw(rows.bytes(10))) {
            structure.tissue.law = std::move(*law);
        } else {
            wrong =
                core::Message(PALPATE_TEXT("found the law %1, expected one of this version"), oneLine(rows.bytes(10)));
        }
        if (wrong) {
            wrongScenes.insert(found->generation);
        }
        if (wrong && status.isOk()) {
            status = Status(StatusCode::BadFormat, PALPATE_TEXT("scene %1, structure \"%2\": %3"), generation,
                            oneLine(structure.name), *wrong);
        }
    }
    std::erase_if(out, [&](const SceneRecord& scene) { return wrongScenes.contains(scene.generation); });
    return step == Step::Failed ? damaged() : status;
}

std::optional<std::string> RecordingTables::mapBytes(const std::string& hash) const
{
    Statement row = m_version < 3 ? Statement() : m_database.prepare("SELECT corners FROM maps WHERE sha256 = ?");
    if (!row.isPrepared()) {
        return std::nullopt;
    }
    row.bind(0, std::string_view(hash));
    return row.step() == Step::Row ? std::optional(row.bytes(0)) : std::nullopt;
}

Status RecordingTables::readEvents(Events& out) const
{
    Statement row = m_database.prepare("SELECT id, tick, kind, json FROM events ORDER BY id");
    BytesRead bytes(m_database);
    Status status;
    Step step = row.step();
    for (; step == Step::Row; step = row.step()) {
        const std::int64_t tick = row.integer(1);
        if (!row.isInteger(1) || tick < -1 || tick > kMaxTick || row.type(2) != Statement::Type::Text ||
            row.type(3) != Statement::Type::Text) {
            status = Status(StatusCode::BadFormat,
                            PALPATE_TEXT("event %1: found values of another type or a tick out of range, expected a "
                                         "tick, a kind and its text: left out"),
                            row.integer(0));
            continue;
        }
        out.push_back({row.integer(0), {tick, bytes.take(row.bytes(2)), bytes.take(row.bytes(3))}});
        if (out.size() > kMaxEvents || bytes.isTooMany()) {
            return tooMany(core::Message(PALPATE_TEXT("events")), kMaxEvents);
        }
    }
    // Sorted here because SQLite would buffer all rows before returning the first.
    std::stable_sort(out.begin(), out.end(),
                     [](const auto& a, const auto& b) { return a.second.tick < b.second.tick; });
    return step == Step::Failed ? damaged() : status;
}

Status RecordingTables::readChecks(std::vector<Check>& out) const
{
    constexpr std::size_t kMostBytes = 64; // of a kind or a hash
    // Version 1 has checks for ticks only.
    Statement row = m_database.prepare(
        m_version >= 2
            ? "SELECT id, kind, first, last, rows, sha256 FROM checks ORDER BY id"
            : "SELECT first_tick, 'ticks', first_tick, last_tick, ticks, sha256 FROM checks ORDER BY first_tick");
    Step step = row.step();
    for (; step == Step::Row; step = row.step()) {
        const Check& check = out.emplace_back(
            Check{row.integer(0), row.bytes(1), row.integer(2), row.integer(3), row.integer(4), row.bytes(5)});
        if (out.size() > kMaxChecks || check.kind.size() > kMostBytes || check.hash.size() > kMostBytes) {
            return tooMany(core::Message(PALPATE_TEXT("lines of checks")), kMaxChecks);
        }
    }
    return step == Step::Failed ? damaged() : Status();
}

Status RecordingTables::readTicks(std::int64_t first, std::int64_t last,
                                  const std::function<bool(const servo::TickRecord&)>& sink,
                                  std::int64_t* stoppedAt) const
{
    if (!m_ticks.isPrepared()) {
        m_ticks = m_database.prepare(selectTicks("WHERE tick BETWEEN ? AND ? ORDER BY tick", m_version).c_str());
    }
    Statement& row = m_ticks;
    m_database.startWork();
    row.bind(0, first);
    row.bind(1, last);
    Step step = row.step();
    std::int64_t before = std::numeric_limits<std::int64_t>::min();
    core::Message wrong;
    for (; step == Step::Row; step = row.step()) {
        const std::int64_t number = row.integer(0);
        const servo::TickRecord tick = readTick(row, m_version, wrong);
        if (number <= before) { // a damaged b-tree returns rows in arbitrary order
            row.reset();
            return {StatusCode::BadFormat,
                    PALPATE_TEXT("tick %1: found behind tick %2, expected ascending ticks: damaged"), number, before};
        }
        before = number;
        if (!wrong.isEmpty()) {
            row.reset();
            if (stoppedAt != nullptr) {
                *stoppedAt = number;
            }
            return {StatusCode::BadFormat, PALPATE_TEXT("tick %1: %2"), number, wrong};
        }
        if (!sink(tick)) {
            row.reset();
            return {};
        }
    }
    return step == Step::Failed ? damaged() : Status();
}

std::optional<std::pair<std::int64_t, std::int64_t>> RecordingTables::tickNumbers() const
{
    const auto one = [this](const char* sql) {
        Statement row = m_database.prepare(sql);
        return row.step() == Step::Row ? std::optional(row.integer(0)) : std::nullopt;
    };
    const auto first = one("SELECT tick FROM ticks ORDER BY tick LIMIT 1");
    const auto last = one("SELECT tick FROM ticks ORDER BY tick DESC LIMIT 1");
    return first && last ? std::optional(std::pair(*first, *last)) : std::nullopt;
}

std::vector<std::string> RecordingTables::embeddedHashes() const
{
    std::vector<std::string> hashes;
    if (m_version >= 2) {
        Statement row = m_database.prepare("SELECT sha256 FROM embedded ORDER BY sha256");
        while (hashes.size() < kMaxSurfaces && row.step() == Step::Row) {
            hashes.push_back(row.bytes(0));
        }
    }
    return hashes;
}

core::Result<geometry::RepairedMesh> RecordingTables::readEmbedded(const std::string& sha256) const
{
    const std::string name = oneLine(sha256.substr(0, 12));
    Statement row = m_version < 2 ? Statement()
                                  : m_database.prepare("SELECT vertices, triangles, two_sided, source, all_sha256 "
                                                       "FROM embedded WHERE sha256 = ?");
    if (row.isPrepared()) {
        row.bind(0, std::string_view(sha256));
    }
    if (row.step() != Step::Row) {
        return Status(StatusCode::NotFound, PALPATE_TEXT("embedded surface %1...: is not in the recording"), name);
    }
    geometry::RepairedMesh surface;
    const bool isWhole = copyBlob(row.bytes(0), surface.mesh.vertices) &&
                         copyBlob(row.bytes(1), surface.mesh.triangles) && copyBlob(row.bytes(2), surface.twoSided) &&
                         copyBlob(row.bytes(3), surface.source);
    if (!isWhole || embeddedHash(surface) != row.bytes(4) || geometryHash(surface.mesh) != sha256) {
        return Status(StatusCode::Mismatch,
                      PALPATE_TEXT("embedded surface %1...: found other bits than were written (checksum)"), name);
    }
    // The hash does not authenticate the data: a malicious file must not cause an index out of range.
    const std::size_t triangles = surface.mesh.triangles.size();
    bool isInRange = surface.twoSided.size() == triangles && surface.source.size() == triangles;
    for (const geometry::Triangle& triangle : surface.mesh.triangles) {
        for (const std::uint32_t corner : triangle) {
            isInRange = isInRange && corner < surface.mesh.vertices.size();
        }
        isInRange = isInRange && triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0];
    }
    for (const core::Vec3& p : surface.mesh.vertices) {
        for (const double coordinate : p) {
            isInRange = isInRange && std::abs(coordinate) <= kMaxCoordinate_mm;
        }
    }
    if (!isInRange || triangles == 0) {
        return Status(StatusCode::BadFormat,
                      PALPATE_TEXT("embedded surface %1...: found indices or coordinates out of range, expected "
                                   "triangles of three vertices within 10⁷ mm"),
                      name);
    }
    surface.report.bounds = surface.mesh.bounds();
    surface.report.vertices = surface.report.inputVertices = surface.mesh.vertices.size();
    surface.report.triangles = surface.report.inputTriangles = triangles;
    return surface;
}

} // namespace palpate::session::internal
