// SPDX-License-Identifier: BSD-3-Clause
// An input is either a raw database file or, after an 'S', a list of choices: the valid recording to start from, the
// changes to schema, rows and pages, and whether to restore the checksums, as any program can. Changes thus get past
// the first checksum and reach every reader.
#include "Fuzz.h"
#include "HostileRecordings.h"

#include <palpate/session/MeasureSession.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/RecordingWriter.h>
#include <palpate/session/Recovery.h>
#include <palpate/session/Replay.h>

#include <QByteArray>

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>

namespace palpate::fuzz {

namespace recording {

std::string contentOf(const std::filesystem::path& path)
{
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string recording(std::int64_t ticks)
{
    const InputFile file("seed.palpate");
    session::RecordingInfo info;
    info.scene = "box.stl";
    info.firstGeneration = 1;
    auto writer = session::RecordingWriter::create(file.path(), info, session::RecordingWriter::Sync::AtEnd);
    require(writer.isOk(), "a recording can be made");
    for (std::int64_t i = 0; i < ticks; ++i) {
        servo::TickRecord tick;
        tick.tick = i;
        tick.p_WH = core::Vec3(0.1 * static_cast<double>(i), 0.0, std::sin(0.01 * static_cast<double>(i)));
        tick.felt.p_WG = tick.p_WH;
        require(writer.value()->append(tick).isOk(), "a tick can be written");
    }
    require(writer.value()->finish().isOk(), "a recording can be ended");
    return contentOf(file.path());
}

/// Writes a recording with two scenes, an embedded surface, a note and a finding.
std::string richRecording(int ticks)
{
    const InputFile file("seed.palpate");
    require(test::writeRichRecording(file.path(), ticks), "a recording can be made");
    return contentOf(file.path());
}

/// Removes the first page, which leads to all others.
std::string headless(std::string recording)
{
    constexpr std::size_t kPage = 4096;
    std::fill_n(recording.begin(), kPage, '\0');
    return recording;
}

/// Puts a quote into the SQL text of a table: SQLite's error message quotes the rest, which has several lines.
std::string openQuote(std::string recording)
{
    recording.at(recording.find("part TEXT") + 3) = '\'';
    return recording;
}

/// Checks that the recovery of a damaged recording is a valid recording.
void recover(const std::filesystem::path& path)
{
    const std::filesystem::path copy = path.parent_path() / "copy.palpate";
    const auto recovered = session::recoverRecording(path, copy);
    if (!recovered.isOk()) {
        require(recovered.status().message().find('\n') == std::string::npos, "a refusal is one line");
        return;
    }
    for (const core::Message& loss : recovered.value().losses) {
        require(loss.english().find('\n') == std::string::npos, "a loss is one line");
    }
    const auto reader = session::RecordingReader::open(copy);
    require(reader.isOk(), "a recovered copy can be opened");
    require(reader.value()->extent().ticks == recovered.value().ticks, "it holds what was said");
    require(reader.value()->verify().isOk(), "its checksums hold");
}

/// Reads the input number by number; returns zeros after the end.
class Choices
{
  public:
    explicit Choices(std::string_view bytes)
        : m_bytes(bytes)
    {
    }
    std::uint32_t number()
    {
        std::uint32_t out = 0;
        for (int i = 0; i < 2; ++i) {
            out = out * 256U + (m_bytes.empty() ? 0U : static_cast<std::uint8_t>(m_bytes.front()));
            m_bytes.remove_prefix(m_bytes.empty() ? 0 : 1);
        }
        return out;
    }
    std::size_t below(std::size_t count) { return count == 0 ? 0 : number() % count; }
    template<class T, std::size_t N>
    const T& of(const std::array<T, N>& all)
    {
        return all[below(N)];
    }
    [[nodiscard]] bool isEmpty() const noexcept { return m_bytes.empty(); }

  private:
    std::string_view m_bytes;
};

constexpr std::array kColumns{"ticks.tick",
                              "ticks.time_ns",
                              "ticks.hip_x",
                              "ticks.god_y",
                              "ticks.force_z",
                              "ticks.sent_x",
                              "ticks.structure",
                              "ticks.triangle",
                              "ticks.constraints",
                              "ticks.scene",
                              "ticks.buttons",
                              "ticks.solve_ns",
                              "ticks.iterations",
                              "ticks.flags",
                              "ticks.normal_x",
                              "ticks.layers",
                              "meta.key",
                              "meta.value",
                              "scenes.generation",
                              "scenes.structures",
                              "scenes.fingertip_mm",
                              "meshes.mesh",
                              "meshes.path",
                              "meshes.unit_mm",
                              "meshes.flipped",
                              "meshes.pose",
                              "meshes.sha256",
                              "structures.name",
                              "structures.number",
                              "structures.mesh",
                              "structures.layer",
                              "structures.palpable",
                              "structures.law",
                              "structures.law_table",
                              "structures.maps",
                              "structures.stiffness_N_per_mm",
                              "structures.damping_Ns_per_mm",
                              "structures.friction_static",
                              "structures.friction_drag_Ns_per_mm",
                              "events.id",
                              "events.tick",
                              "events.kind",
                              "events.json",
                              "checks.id",
                              "checks.kind",
                              "checks.first",
                              "checks.last",
                              "checks.rows",
                              "checks.sha256",
                              "embedded.sha256",
                              "embedded.vertices",
                              "embedded.triangles",
                              "embedded.two_sided",
                              "embedded.source",
                              "embedded.all_sha256"};

/// New values for a column; %c is the column.
constexpr std::array kValues{"NULL",
                             "0",
                             "1",
                             "-1",
                             "3",
                             "255",
                             "65536",
                             "2147483647",
                             "-2147483648",
                             "4294967295",
                             "9007199254740992",
                             "9007199254740993",
                             "9223372036854775807",
                             "-9223372036854775807 - 1",
                             "0.5",
                             "-0.0",
                             "1e7",
                             "1e10",
                             "1e300",
                             "9e999",
                             "-9e999",
                             "'text'",
                             "''",
                             "'[]'",
                             "'{\"kind\": \"hertz\", \"young_kPa\": 1}'",
                             "'1e-300'",
                             "'nan'",
                             "x''",
                             "x'00'",
                             "zeroblob(88)",
                             "zeroblob(264)",
                             "zeroblob(100000)",
                             "%c + 1",
                             "%c * 2",
                             "%c - 250",
                             "-%c",
                             "CAST(%c AS TEXT)",
                             "CAST(substr(%c, 2) AS BLOB)",
                             "CAST(%c || x'00' AS BLOB)",
                             "CAST(substr(%c, 1, 40) || x'ffffff7f' || substr(%c, 45) AS BLOB)",
                             "CAST(substr(%c, 1, 24) || x'00000000000000f07f' || substr(%c, 33) AS BLOB)",
                             "CAST(x'000000000000f87f' || substr(%c, 9) AS BLOB)",
                             "CAST(x'a0c8eb85f3cce17f' || substr(%c, 9) AS BLOB)",
                             "CAST(substr(%c, 13) || substr(%c, 1, 12) AS BLOB)",
                             "replace(%c, '1', '9')",
                             "hex(%c)"};

constexpr std::array kSchemas{
    "ALTER TABLE @t RENAME TO old; CREATE VIEW @t AS SELECT * FROM old",
    "ALTER TABLE @t RENAME TO old; CREATE VIEW @t AS WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n) "
    "SELECT old.* FROM n, old",
    "ALTER TABLE @t ADD COLUMN more AS (hex(zeroblob(100000000)))",
    "CREATE TABLE copy AS SELECT * FROM @t; DROP TABLE @t; ALTER TABLE copy RENAME TO @t",
    "DROP TABLE @t",
    "CREATE TRIGGER g AFTER INSERT ON @t BEGIN DELETE FROM @t; END",
    "CREATE VIRTUAL TABLE v USING fts5(x)",
    "CREATE VIRTUAL TABLE v USING rtree(a, b, c)",
    "DROP VIEW tick_values",
    "DROP VIEW tick_values; CREATE VIEW tick_values AS SELECT load_extension('x')",
    "CREATE INDEX i ON @t(1)",
    "PRAGMA writable_schema = ON; UPDATE sqlite_master SET rootpage = 1 + abs(random()) % 20 WHERE name = '@t'",
    "PRAGMA writable_schema = ON; UPDATE sqlite_master SET rootpage = (SELECT rootpage FROM sqlite_master WHERE name = "
    "'ticks') WHERE name = '@t'",
    "PRAGMA writable_schema = ON; UPDATE sqlite_master SET type = 'view' WHERE name = '@t'",
    "PRAGMA writable_schema = ON; UPDATE sqlite_master SET sql = 'CREATE VIEW @t AS SELECT 1' WHERE name = '@t'",
    "PRAGMA writable_schema = ON; UPDATE sqlite_master SET sql = replace(sql, 'TEXT', 'INTEGER') WHERE name = '@t'",
    "PRAGMA writable_schema = ON; UPDATE sqlite_master SET sql = replace(sql, ' WITHOUT ROWID', '') WHERE name = '@t'",
    "PRAGMA user_version = 1",
    "PRAGMA user_version = 2",
    "PRAGMA user_version = -1",
    "PRAGMA auto_vacuum = 1; VACUUM",
    "PRAGMA page_size = 512; VACUUM",
    "PRAGMA encoding = 'UTF-16'; VACUUM",
    "ANALYZE"};

constexpr std::array kTables{"meta", "ticks", "scenes", "meshes", "structures", "events", "checks", "embedded"};

std::string replaced(std::string text, std::string_view what, std::string_view with)
{
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
        text.replace(at, what.size(), with);
    }
    return text;
}

/// Returns one change in SQL: a value in some rows, whole rows, or the schema.
std::string statement(Choices& in)
{
    const std::string table = in.of(kTables);
    const std::string column = in.of(kColumns);
    const auto dot = column.find('.');
    const std::string name = column.substr(dot + 1), of = column.substr(0, dot);
    const std::size_t modulus = 1 + in.below(4), rest = in.below(4);
    const std::string where = " WHERE (abs(random()) % 1000000 * 0 + " +
                              std::string(of == "meta" || of == "structures" ? "length(" + name + ")" : "rowid") +
                              ") % " + std::to_string(modulus) + " = " + std::to_string(rest % modulus);
    switch (in.below(8)) {
    case 0:
        return replaced(in.of(kSchemas), "@t", table);
    case 1:
        return "DELETE FROM " + of + where;
    case 2:
        return "INSERT OR IGNORE INTO " + table + " SELECT * FROM " + table;
    default:
        return "UPDATE OR IGNORE " + of + " SET " + name + " = " + replaced(in.of(kValues), "%c", name) + where;
    }
}

/// Changes bytes of pages, which hold SQLite's B-trees.
void changePages(std::string& file, Choices& in)
{
    constexpr std::size_t kPage = 4096;
    const std::size_t pages = file.size() / kPage;
    if (pages == 0) {
        return;
    }
    const std::size_t page = in.below(pages) * kPage, other = in.below(pages) * kPage;
    switch (in.below(5)) {
    case 0:
        file.replace(page, kPage, file.substr(other, kPage));
        break;
    case 1:
        file.resize(page + in.below(kPage));
        break;
    case 2: // a pointer in a page header or in the cell list
        file[page + in.below(64)] = static_cast<char>(in.number());
        break;
    case 3: { // a pointer to another page
        const std::size_t at = page + 8 + in.below(kPage - 12);
        file.replace(at, 4, std::string("\0\0\0", 3) + static_cast<char>(in.below(pages + 2)));
        break;
    }
    default:
        for (std::size_t i = 0, count = in.below(16); i < count; ++i) {
            file[page + in.below(kPage)] = static_cast<char>(in.number());
        }
    }
}

/// Builds the file for an input's choices, possibly with a journal.
void build(const InputFile& file, std::string_view bytes)
{
    static const std::array<std::string, 4> kGood{richRecording(60), richRecording(600), recording(300), recording(0)};
    Choices in(bytes);
    file.set(in.of(kGood));
    const std::size_t how = in.number();
    sqlite3* database = nullptr;
    if (sqlite3_open(file.path().c_str(), &database) == SQLITE_OK) {
        sqlite3_exec(database, "PRAGMA synchronous = OFF; PRAGMA journal_mode = MEMORY", nullptr, nullptr, nullptr);
        for (std::size_t i = 0, count = in.below(5); i < count; ++i) {
            sqlite3_exec(database, statement(in).c_str(), nullptr, nullptr, nullptr);
        }
    }
    sqlite3_close(database);
    if ((how & 1U) != 0) {
        (void)test::rehashSurfaces(file.path());
    }
    if ((how & 2U) != 0) {
        (void)test::rehash(file.path());
    }
    const std::size_t pages = (how & 4U) != 0 ? 1 + in.below(4) : 0;
    if (pages > 0) {
        std::string content = contentOf(file.path());
        for (std::size_t i = 0; i < pages; ++i) {
            changePages(content, in);
        }
        std::ofstream(file.path(), std::ios::binary) << content;
    }
    if ((how & 8U) != 0) {
        std::string journal = test::superJournal(file.path(), (how & 16U) != 0 ? "" : file.path().string() + "-victim");
        if ((how & 32U) != 0) { // a page of the earlier state
            journal.replace(8, 4, std::string("\0\0\0\1", 4));
            journal += contentOf(file.path()).substr(0, 4096);
        }
        for (std::size_t i = 0, count = in.below(4); i < count; ++i) {
            journal[in.below(journal.size())] = static_cast<char>(in.number());
        }
        std::ofstream(file.path().string() + "-journal", std::ios::binary) << journal;
    }
}

void requireFinite(const session::SessionMeasures& m)
{
    const session::ContactMeasures& c = m.sums.contact;
    require(std::isfinite(m.sums.duration_s + m.sums.pathLength_mm + m.sums.contactPath_mm + c.time_s + c.peakForce_N +
                          c.meanForce_N + c.medianForce_N + c.p95Force_N + c.peakDepth_mm + c.meanDepth_mm),
            "measures are finite");
    for (const session::SurfaceMeasures& one : m.surfaces) {
        require(std::isfinite(one.area_mm2 + one.coveredArea_mm2 + one.longestDwell_s),
                "measures of a surface are finite");
    }
}

/// Reads the whole recording in each way that a command does.
void read(const session::RecordingReader& r)
{
    std::int64_t last = -1;
    const core::Status status =
        r.forEach(0, std::numeric_limits<std::int64_t>::max(), [&](const servo::TickRecord& tick) {
            require(tick.tick > last, "ticks ascend");
            require(tick.p_WH.allFinite() && tick.felt.p_WG.allFinite() && tick.felt.f_W.allFinite(),
                    "ticks are finite");
            last = tick.tick;
            (void)r.structureName(tick);
            return true;
        });
    require(status.isOk() || status.message().find('\n') == std::string::npos, "an error is one line");
    (void)r.at(r.extent().lastTick);
    (void)r.at(r.extent().firstTick);
    (void)r.motion();
    session::MeshesByHash meshes;
    session::SurfacesByHash surfaces;
    for (const std::string& hash : r.embeddedHashes()) {
        if (auto surface = r.embedded(hash); surface.isOk()) {
            meshes[hash] = std::make_shared<const geometry::RepairedMesh>(std::move(surface).value());
            surfaces[hash] =
                std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(*meshes[hash]));
        }
    }
    session::MeasureOptions options;
    options.distance_mm = std::max(options.distance_mm, session::minDistance_mm(meshes));
    if (const auto measures = session::measureSession(r, meshes, options); measures.isOk()) {
        requireFinite(measures.value());
    }
    (void)session::resimulate(r, surfaces);
    const core::Status verified = r.verify();
    require(verified.isOk() || verified.message().find('\n') == std::string::npos, "a fault is one line");
    for (const core::Message& fault : r.faults()) {
        require(fault.english().find('\n') == std::string::npos, "a fault is one line");
    }
}

/// Choices that once exposed a bug, in hexadecimal.
constexpr std::array kFindings{
    "2a01002300026000fefc8804990445670404044466550404770488049d9904aa",
    "00000032026465766963655f73656e06cb06dc06ed06fe060f0620063106420653066406750686069706a806b9",
    "0000001e0002031e032f03400351036203730384039503a64003b703c803d903ea03fb030c031d032e033f0350036103720383039403a5",
    "000100230002fefffffb042304340445045604670404044466550404770488049904aa",
    "000100230002042304340445045604670404044466d3550404770488049904aa",
};

std::vector<std::string> seeds()
{
    std::vector<std::string> seeds{recording(300),
                                   headless(recording(300)),
                                   recording(1),
                                   headless(recording(1)),
                                   recording(0),
                                   openQuote(recording(0)),
                                   std::string("SQLite format 3\0", 16),
                                   ""};
    for (const char* finding : kFindings) {
        seeds.push_back("S" + QByteArray::fromHex(finding).toStdString());
    }
    // Choices: the recording, the checksums to restore, then statements and pages.
    for (char good = 0; good < 2; ++good) {
        for (char how = 0; how < 64; how = static_cast<char>(how + 5)) {
            std::string choices{'S', 0, good, 0, how, 0, 2};
            for (char i = 0; i < 24; ++i) {
                choices += static_cast<char>(how / 8);
                choices += static_cast<char>(17 * i + how);
            }
            seeds.push_back(choices);
        }
    }
    return seeds;
}

void tryInput(std::string_view bytes)
{
    static const InputFile file("r.palpate");
    if (bytes.starts_with('S') && !bytes.starts_with("SQLite")) {
        build(file, bytes.substr(1));
    } else {
        file.set(bytes);
    }
    const std::filesystem::path victim = file.path().string() + "-victim", journal = file.path().string() + "-journal";
    std::ofstream(victim) << "precious";
    const std::string before = contentOf(file.path()), journalBefore = contentOf(journal);
    recover(file.path());
    const auto reader = session::RecordingReader::open(file.path());
    if (reader.isOk()) {
        read(*reader.value());
    } else {
        require(reader.status().message().find('\n') == std::string::npos, "a refusal is one line");
    }
    require(contentOf(victim) == "precious", "no other file is touched");
    require(contentOf(file.path()) == before && contentOf(journal) == journalBefore, "a reader writes nothing");
}

} // namespace recording

extern const Target kRecording{"recording", 10, recording::seeds, recording::tryInput};

} // namespace palpate::fuzz
