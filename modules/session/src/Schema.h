// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate::session::internal {

/// The tables of resources/docs/recording.md, version 2. The columns of ticks have no declared type on purpose: a
/// column declared REAL keeps whole numbers as integers and so loses the sign of a zero.
inline constexpr const char* kSchema = R"sql(
CREATE TABLE meta(key TEXT PRIMARY KEY, value) WITHOUT ROWID;
CREATE TABLE ticks(tick INTEGER PRIMARY KEY, time_ns, hip_x, hip_y, hip_z, god_x, god_y, god_z,
  force_x, force_y, force_z, sent_x, sent_y, sent_z, structure, triangle, constraints, scene, buttons, solve_ns,
  iterations, flags);
CREATE TABLE scenes(generation INTEGER PRIMARY KEY, structures INTEGER NOT NULL, fingertip_mm REAL NOT NULL);
CREATE TABLE meshes(mesh INTEGER PRIMARY KEY, path TEXT, part TEXT, unit_mm REAL, flipped INTEGER, pose TEXT,
  sha256 TEXT, UNIQUE(path, part, unit_mm, flipped, pose, sha256));
CREATE TABLE structures(generation INTEGER, number INTEGER, name TEXT, mesh INTEGER REFERENCES meshes(mesh),
  stiffness_N_per_mm REAL, damping_Ns_per_mm REAL, layer INTEGER, palpable INTEGER,
  PRIMARY KEY(generation, number)) WITHOUT ROWID;
CREATE TABLE events(id INTEGER PRIMARY KEY, tick INTEGER NOT NULL, kind TEXT NOT NULL, json TEXT NOT NULL);
CREATE TABLE checks(id INTEGER PRIMARY KEY, kind TEXT NOT NULL, first INTEGER, last INTEGER, rows INTEGER NOT NULL,
  sha256 BLOB NOT NULL);
CREATE TABLE embedded(sha256 TEXT PRIMARY KEY, vertices BLOB NOT NULL, triangles BLOB NOT NULL,
  two_sided BLOB NOT NULL, source BLOB NOT NULL, all_sha256 BLOB NOT NULL);
CREATE VIEW tick_values AS SELECT tick, time_ns * 1e-9 AS time_s, hip_x, hip_y, hip_z,
  coalesce(god_x, hip_x) AS god_x, coalesce(god_y, hip_y) AS god_y, coalesce(god_z, hip_z) AS god_z,
  coalesce(force_x, 0.0) AS force_x, coalesce(force_y, 0.0) AS force_y, coalesce(force_z, 0.0) AS force_z,
  coalesce(sent_x, force_x, 0.0) AS sent_x, coalesce(sent_y, force_y, 0.0) AS sent_y,
  coalesce(sent_z, force_z, 0.0) AS sent_z, structure,
  (SELECT name FROM structures s WHERE s.generation = t.scene AND s.number = t.structure) AS name,
  triangle, constraints, scene, buttons, solve_ns, iterations, flags FROM ticks t;
)sql";

/// What a line of `checks` covers, as its column `kind` says it.
inline constexpr const char* kMetaCheck = "meta";
inline constexpr const char* kSceneCheck = "scene";
inline constexpr const char* kEventsCheck = "events";
inline constexpr const char* kTicksCheck = "ticks";

/// Columns of `ticks`, by their place in kSelectTicks and kInsertTick.
enum TickColumn
{
    kTick,
    kTime,
    kHip,
    kGod = kHip + 3,
    kForce = kGod + 3,
    kSent = kForce + 3,
    kStructure = kSent + 3,
    kTriangle,
    kConstraints,
    kScene,
    kButtons,
    kSolve,
    kIterations,
    kFlags,
};
inline constexpr const char* kInsertTick = "INSERT INTO ticks VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)";
inline constexpr const char* kInsertCheck = "INSERT INTO checks(kind, first, last, rows, sha256) VALUES(?, ?, ?, ?, ?)";
inline constexpr const char* kSelectTicks =
    "SELECT tick, time_ns, hip_x, hip_y, hip_z, god_x, god_y, god_z, force_x, force_y, force_z, sent_x, sent_y, "
    "sent_z, structure, triangle, constraints, scene, buttons, solve_ns, iterations, flags FROM ticks ";

} // namespace palpate::session::internal
