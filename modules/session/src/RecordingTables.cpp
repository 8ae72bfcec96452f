// SPDX-License-Identifier: BSD-3-Clause
#include "RecordingTables.h"

#include "LawText.h"
#include "MapRows.h"
#include "Packing.h"
#include "Schema.h"
#include "palpate/session/GeometryHash.h"

#include <palpate/core/Numbers.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>
#include <string>

namespace palpate::session::internal {

using core::Status;
using core::StatusCode;
using Step = Statement::Step;

namespace {

/// Copies a blob into numbers. @return false when its length is no whole number of them
template<class T>
bool copyBlob(const std::string& bytes, std::vector<T>& out)
{
    out.resize(bytes.size() / sizeof(T));
    std::memcpy(static_cast<void*>(out.data()), bytes.data(), out.size() * sizeof(T));
    return bytes.size() % sizeof(T) == 0;
}

} // namespace

Status RecordingTables::readVersion()
{
    if (m_database.integer("PRAGMA application_id") != kRecordingApplicationId) {
        return {StatusCode::BadFormat, "found another program's SQLite database, expected a Palpate recording"};
    }
    m_version = static_cast<int>(m_database.integer("PRAGMA user_version"));
    if (m_version > kRecordingVersion || m_version < 1) {
        return {StatusCode::Mismatch, "found a recording of version " + std::to_string(m_version) +
                                          ", expected at most " + std::to_string(kRecordingVersion) +
                                          ": a newer Palpate made it"};
    }
    return {};
}

Status RecordingTables::readMeta(MetaTable& out) const
{
    Statement row = m_database.prepare("SELECT key, value FROM meta");
    Step step = row.step();
    for (; step == Step::Row; step = row.step()) {
        out[row.bytes(0)] = row.bytes(1);
    }
    return step == Step::Failed ? damaged() : Status();
}

namespace {

constexpr double kMostTissue = 1e9; // far beyond what a scene file may hold, and no force or energy overflows

/// @return what is wrong with a structure's numbers, or nothing.
std::optional<std::string> wrongNumber(const StructureRecord& structure, std::int64_t layer)
{
    if (layer < 0 || layer > std::numeric_limits<std::uint32_t>::max()) {
        return "found the layer " + std::to_string(layer) + ", expected one from 0";
    }
    for (const core::TissueTerm& term : core::kTissueTerms) {
        const double value = structure.tissue.*term.member;
        if (!(value >= 0.0 && value <= kMostTissue)) {
            return "found " + core::shortNumber(value) + " for " + std::string(term.key) + ", expected 0 to 1e9";
        }
    }
    return std::nullopt;
}

} // namespace

Status RecordingTables::readScenes(std::vector<SceneRecord>& out) const
{
    Statement generations =
        m_database.prepare(m_version >= 2 ? "SELECT generation, fingertip_mm FROM scenes ORDER BY generation"
                                          : "SELECT generation, 0.0 FROM scenes ORDER BY generation");
    Step step = generations.step();
    for (; step == Step::Row; step = generations.step()) {
        SceneRecord& scene = out.emplace_back();
        scene.generation = static_cast<std::uint32_t>(generations.integer(0));
        scene.fingertip_mm = generations.real(1);
    }
    Status status = step == Step::Failed ? damaged() : Status();
    Statement rows = m_database.prepare(
        (std::string("SELECT generation, name, path, part, unit_mm, flipped, sha256, pose, layer, palpable") +
         (m_version >= 3 ? ", law, law_table, maps" : ", NULL, NULL, NULL") + tissueColumns(m_version) +
         " FROM structures LEFT JOIN meshes USING(mesh) ORDER BY generation, number")
            .c_str());
    for (step = rows.step(); step == Step::Row; step = rows.step()) {
        const auto generation = static_cast<std::uint32_t>(rows.integer(0));
        const auto found = std::lower_bound(out.begin(), out.end(), generation,
                                            [](const SceneRecord& s, std::uint32_t g) { return s.generation < g; });
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
            std::string wrong; // why it can't be read; reported by the caller that needs the table
            structure.tissueMaps = mapsOf(
                structure.maps, [this](const std::string& hash) { return mapBytes(hash); }, wrong);
        }
        int column = 13;
        for (const core::TissueTerm& term : tissueTerms(m_version)) {
            structure.tissue.*term.member = rows.real(column++);
        }
        std::optional<std::string> wrong = wrongNumber(structure, rows.integer(8));
        if (auto law = parseLaw(rows.bytes(10))) {
            structure.tissue.law = std::move(*law);
        } else {
            wrong = "found the law " + oneLine(rows.bytes(10)) + ", expected one of this version";
        }
        if (wrong && status.isOk()) {
            status = Status(StatusCode::BadFormat, "scene " + std::to_string(generation) + ", structure \"" +
                                                       oneLine(structure.name) + "\": " + *wrong);
        }
    }
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

Status RecordingTables::readEvents(std::vector<std::pair<std::int64_t, RecordingEvent>>& out) const
{
    Statement row = m_database.prepare("SELECT id, tick, kind, json FROM events ORDER BY tick, id");
    Step step = row.step();
    for (; step == Step::Row; step = row.step()) {
        out.push_back({row.integer(0), {row.integer(1), row.bytes(2), row.bytes(3)}});
    }
    return step == Step::Failed ? damaged() : Status();
}

Status RecordingTables::readChecks(std::vector<Check>& out) const
{
    // Version 1 had checks of ticks alone.
    Statement row = m_database.prepare(
        m_version >= 2
            ? "SELECT id, kind, first, last, rows, sha256 FROM checks ORDER BY id"
            : "SELECT first_tick, 'ticks', first_tick, last_tick, ticks, sha256 FROM checks ORDER BY first_tick");
    Step step = row.step();
    for (; step == Step::Row; step = row.step()) {
        out.push_back({row.integer(0), row.bytes(1), row.integer(2), row.integer(3), row.integer(4), row.bytes(5)});
    }
    return step == Step::Failed ? damaged() : Status();
}

Status RecordingTables::readTicks(std::int64_t first, std::int64_t last,
                                  const std::function<bool(const servo::TickRecord&)>& sink) const
{
    Statement row = m_database.prepare(selectTicks("WHERE tick BETWEEN ? AND ? ORDER BY tick", m_version).c_str());
    row.bind(0, first);
    row.bind(1, last);
    Step step = row.step();
    std::int64_t before = std::numeric_limits<std::int64_t>::min();
    for (; step == Step::Row; step = row.step()) {
        const servo::TickRecord tick = readTick(row, m_version);
        if (tick.tick <= before) { // a damaged tree gives its rows in any order
            return damaged();
        }
        before = tick.tick;
        if (!sink(tick)) {
            return {};
        }
    }
    return step == Step::Failed ? damaged() : Status();
}

std::optional<servo::TickRecord> RecordingTables::tickAt(std::int64_t tick) const
{
    Statement row = m_database.prepare(selectTicks("WHERE tick <= ? ORDER BY tick DESC LIMIT 1", m_version).c_str());
    row.bind(0, tick);
    return row.step() == Step::Row ? std::optional(readTick(row, m_version)) : std::nullopt;
}

std::vector<std::string> RecordingTables::embeddedHashes() const
{
    std::vector<std::string> hashes;
    if (m_version >= 2) {
        Statement row = m_database.prepare("SELECT sha256 FROM embedded ORDER BY sha256");
        while (row.step() == Step::Row) {
            hashes.push_back(row.bytes(0));
        }
    }
    return hashes;
}

core::Result<geometry::RepairedMesh> RecordingTables::readEmbedded(const std::string& sha256) const
{
    const std::string name = "embedded surface " + oneLine(sha256.substr(0, 12)) + "...";
    Statement row = m_version < 2 ? Statement()
                                  : m_database.prepare("SELECT vertices, triangles, two_sided, source, all_sha256 "
                                                       "FROM embedded WHERE sha256 = ?");
    if (row.isPrepared()) {
        row.bind(0, std::string_view(sha256));
    }
    if (row.step() != Step::Row) {
        return Status(StatusCode::NotFound, name + ": is not in the recording");
    }
    geometry::RepairedMesh surface;
    const bool isWhole = copyBlob(row.bytes(0), surface.mesh.vertices) &&
                         copyBlob(row.bytes(1), surface.mesh.triangles) && copyBlob(row.bytes(2), surface.twoSided) &&
                         copyBlob(row.bytes(3), surface.source);
    if (!isWhole || embeddedHash(surface) != row.bytes(4) || geometryHash(surface.mesh) != sha256) {
        return Status(StatusCode::Mismatch, name + ": found other bits than were written (checksum)");
    }
    // The hash is no signature: what a hostile file says must not become an index out of range.
    const std::size_t triangles = surface.mesh.triangles.size();
    bool isInRange = surface.twoSided.size() == triangles && surface.source.size() == triangles;
    for (const geometry::Triangle& triangle : surface.mesh.triangles) {
        for (const std::uint32_t corner : triangle) {
            isInRange = isInRange && corner < surface.mesh.vertices.size();
        }
    }
    for (const core::Vec3& p : surface.mesh.vertices) {
        isInRange = isInRange && p.allFinite();
    }
    if (!isInRange || triangles == 0) {
        return Status(StatusCode::BadFormat, name + ": found indices or coordinates out of range");
    }
    surface.report.bounds = surface.mesh.bounds();
    surface.report.vertices = surface.report.inputVertices = surface.mesh.vertices.size();
    surface.report.triangles = surface.report.inputTriangles = triangles;
    return surface;
}

} // namespace palpate::session::internal
