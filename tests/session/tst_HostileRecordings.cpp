// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Shapes.h"
#include "HostileRecordings.h"
#include "Sessions.h"
#include "TestRunner.h"
#include "database/ReadOnlyVfs.h"

#include <palpate/session/MeasureSession.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/Recovery.h>
#include <palpate/session/Replay.h>

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QtEndian>

#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include <sys/stat.h>
#include <unistd.h>

using namespace palpate;
using session::RecordingReader;

namespace {

std::vector<std::string> englishOf(const std::vector<core::Message>& messages)
{
    std::vector<std::string> texts;
    for (const core::Message& message : messages) {
        texts.push_back(message.english());
    }
    return texts;
}

/// CPU time of this process, which other programs do not lengthen. [s]
double cpuTime_s()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

constexpr double kSoon_s = 5.0; // CPU time; limit for endless work in a view or generated column of the file

/// Returns name, content and modification time of all files in a folder.
QStringList stateOf(const QString& folder)
{
    QStringList out;
    for (const QFileInfo& info : QDir(folder).entryInfoList(QDir::Files, QDir::Name)) {
        QFile file(info.filePath());
        (void)file.open(QIODevice::ReadOnly);
        out << info.fileName() + ' ' +
                   QCryptographicHash::hash(file.readAll(), QCryptographicHash::Sha256).toHex().left(16) + ' ' +
                   QString::number(info.lastModified().toMSecsSinceEpoch());
    }
    return out;
}

bool isFinite(const session::ContactMeasures& m)
{
    return std::isfinite(m.peakForce_N + m.meanForce_N + m.medianForce_N + m.p95Force_N + m.peakDepth_mm +
                         m.meanDepth_mm + m.p95Depth_mm + m.time_s);
}

bool isFinite(const session::SessionMeasures& m)
{
    bool is =
        std::isfinite(m.sums.duration_s + m.sums.pathLength_mm + m.sums.contactPath_mm) && isFinite(m.sums.contact);
    for (const auto& [name, one] : m.sums.structures) {
        is = is && isFinite(one);
    }
    for (const session::SurfaceMeasures& one : m.surfaces) {
        is = is && std::isfinite(one.area_mm2 + one.coveredArea_mm2 + one.longestDwell_s);
    }
    return is;
}

session::MeshesByHash surfacesOf(const RecordingReader& reader)
{
    session::MeshesByHash meshes;
    for (const std::string& hash : reader.embeddedHashes()) {
        if (auto surface = reader.embedded(hash); surface.isOk()) {
            meshes[hash] = std::make_shared<const geometry::RepairedMesh>(std::move(surface).value());
        }
    }
    return meshes;
}

} // namespace

/// Tests recordings that are malicious or damaged.
class HostileRecordings : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    std::filesystem::path path(const char* name) const { return m_folder->filePath(name).toStdString(); }

    void write(const char* name, const QByteArray& bytes) const
    {
        QFile file(m_folder->filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
    }

    QByteArray bytes(const char* name) const
    {
        QFile file(m_folder->filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    static void statements(std::initializer_list<std::pair<const char*, const char*>> rows, const char* second)
    {
        QTest::addColumn<QString>("sql");
        QTest::addColumn<QString>("said");
        for (const auto& [sql, said] : rows) {
            QTest::newRow(sql) << QString(sql) << QString(said == nullptr ? second : said);
        }
    }

  private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(test::writeRichRecording(path("a.palpate"), 1500));
    }

    /// A rollback journal may name a file to delete.
    void journalOfSeveralDatabasesIsRefused_data()
    {
        QTest::addColumn<bool>("isAbsolute");
        QTest::newRow("relative") << false;
        QTest::newRow("absolute") << true;
    }
    void journalOfSeveralDatabasesIsRefused()
    {
        QFETCH(bool, isAbsolute);
        const QString before = QDir::currentPath();
        QVERIFY(QDir::setCurrent(m_folder->path()));
        write("victim.txt", "precious");
        const std::string name = isAbsolute ? path("victim.txt").string() : "victim.txt";
        write("a.palpate-journal", QByteArray::fromStdString(test::superJournal(path("a.palpate"), name)));
        const QStringList state = stateOf(m_folder->path());
        const auto reader = RecordingReader::open(path("a.palpate"));
        QCOMPARE(reader.status().code(), core::StatusCode::BadFormat);
        QVERIFY2(reader.status().message().find("journal of several databases") != std::string::npos,
                 reader.status().message().c_str());
        const auto recovered = session::recoverRecording(path("a.palpate"), path("b.palpate"));
        QVERIFY(!recovered.isOk());
        QVERIFY2(recovered.status().message().find("journal of several databases") != std::string::npos,
                 recovered.status().message().c_str());
        QCOMPARE(stateOf(m_folder->path()), state);
        QVERIFY(QDir::setCurrent(before));
    }

    /// Even if the journal is replaced after the check, the file layer opens and deletes no other file.
    void fileLayerDeletesNothing()
    {
        write("victim.txt", "precious");
        write("a.palpate-journal",
              QByteArray::fromStdString(test::superJournal(path("a.palpate"), path("victim.txt").string())));
        const QStringList state = stateOf(m_folder->path());
        session::internal::ReadOnlyVfs layer;
        sqlite3* database = nullptr;
        QCOMPARE(sqlite3_open_v2(path("a.palpate").c_str(), &database, SQLITE_OPEN_READWRITE, layer.name()), SQLITE_OK);
        (void)sqlite3_exec(database, "SELECT count(*) FROM meta", nullptr, nullptr, nullptr);
        (void)sqlite3_exec(database, "DELETE FROM meta", nullptr, nullptr, nullptr);
        const std::string attach = "ATTACH '" + path("victim.txt").string() + "' AS v; SELECT * FROM v.sqlite_master";
        QVERIFY(sqlite3_exec(database, attach.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK);
        QVERIFY(layer.refusal().english().find("victim.txt") != std::string::npos);
        sqlite3_close(database);
        QCOMPARE(stateOf(m_folder->path()), state);
    }

    void journalThatIsNoFileIsRefused_data()
    {
        QTest::addColumn<bool>("isLink");
        QTest::newRow("pipe") << false;
        QTest::newRow("link") << true;
    }
    void journalThatIsNoFileIsRefused()
    {
        QFETCH(bool, isLink);
        const std::filesystem::path journal = path("a.palpate-journal");
        write("victim.txt", "precious");
        QCOMPARE(isLink ? ::symlink(path("victim.txt").c_str(), journal.c_str()) : ::mkfifo(journal.c_str(), 0600), 0);
        const auto reader = RecordingReader::open(path("a.palpate"));
        QVERIFY2(reader.status().message().find("found something else than a file") != std::string::npos,
                 reader.status().message().c_str());
        QCOMPARE(bytes("victim.txt"), QByteArray("precious"));
    }

    /// Rolls back after a crash as SQLite does, without changing either file.
    void rollsBackInMemory()
    {
        const QByteArray whole = bytes("a.palpate");
        sqlite3* database = nullptr;
        QCOMPARE(sqlite3_open(path("a.palpate").c_str(), &database), SQLITE_OK);
        QCOMPARE(sqlite3_exec(database,
                              "PRAGMA cache_size = 1; PRAGMA cache_spill = 1; BEGIN;"
                              "UPDATE ticks SET hip_x = 1e9, buttons = 7; INSERT INTO events SELECT id + 100, tick, "
                              "kind, hex(zeroblob(20000)) FROM events; DELETE FROM ticks WHERE tick > 700;",
                              nullptr, nullptr, nullptr),
                 SQLITE_OK);
        write("crashed.palpate", bytes("a.palpate"));
        write("crashed.palpate-journal", bytes("a.palpate-journal"));
        sqlite3_close(database);
        QVERIFY(bytes("crashed.palpate") != whole);
        QVERIFY(bytes("crashed.palpate-journal").size() > 4096);
        QVERIFY(QFile::setPermissions(m_folder->filePath("crashed.palpate"), QFileDevice::ReadOwner));
        QVERIFY(QFile::setPermissions(m_folder->filePath("crashed.palpate-journal"), QFileDevice::ReadOwner));
        QVERIFY(QFile::setPermissions(m_folder->path(), QFileDevice::ReadOwner | QFileDevice::ExeOwner));
        const QStringList state = stateOf(m_folder->path());
        {
            const auto reader = RecordingReader::open(path("crashed.palpate"));
            const auto original = RecordingReader::open(path("a.palpate"));
            QVERIFY2(reader.isOk(), reader.status().message().c_str());
            QVERIFY2(reader.value()->verify().isOk(), reader.value()->verify().message().c_str());
            QVERIFY(reader.value()->faults().empty());
            QCOMPARE(reader.value()->extent().ticks, std::int64_t{1500});
            QCOMPARE(reader.value()->events().size(), original.value()->events().size());
            std::int64_t same = 0;
            QVERIFY(reader.value()
                        ->forEach(0, 1499,
                                  [&](const servo::TickRecord& tick) {
                                      same += test::isSameTick(tick, *original.value()->at(tick.tick)) ? 1 : 0;
                                      return true;
                                  })
                        .isOk());
            QCOMPARE(same, std::int64_t{1500});
        }
        QCOMPARE(stateOf(m_folder->path()), state);
        QVERIFY(QFile::setPermissions(m_folder->path(),
                                      QFileDevice::ReadOwner | QFileDevice::ExeOwner | QFileDevice::WriteOwner));
        QVERIFY(session::recoverRecording(path("crashed.palpate"), path("copy.palpate")).isOk());
        QCOMPARE(RecordingReader::open(path("copy.palpate")).value()->extent().ticks, std::int64_t{1500});
    }

    /// Readers and the recorder never block each other: the reader succeeds while the lock is held.
    void readsWhileAnotherRecords()
    {
        sqlite3* database = nullptr;
        QCOMPARE(sqlite3_open(path("a.palpate").c_str(), &database), SQLITE_OK);
        const auto run = [database](const char* sql) {
            return sqlite3_exec(database, sql, nullptr, nullptr, nullptr) == SQLITE_OK;
        };
        QVERIFY(run("BEGIN IMMEDIATE; INSERT INTO events VALUES(1000, 5, 'note', '{}')"));
        const auto reader = RecordingReader::open(path("a.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        QCOMPARE(reader.value()->at(1499)->tick, std::int64_t{1499});
        QVERIFY2(run("COMMIT"), sqlite3_errmsg(database));
        sqlite3_close(database);
    }

    /// Views, generated columns, triggers, virtual tables: no code from the file is executed.
    void schemaOfItsOwnIsRefused_data()
    {
        statements(
            {
                {"ALTER TABLE events RENAME TO e0; CREATE VIEW events(id, tick, kind, json) AS WITH RECURSIVE n(i) AS "
                 "(SELECT 0 UNION ALL SELECT i + 1 FROM n) SELECT i, i, 'note', hex(zeroblob(1000)) FROM n",
                 nullptr},
                {"DROP VIEW tick_values; ALTER TABLE ticks RENAME TO t0; CREATE VIEW ticks AS WITH RECURSIVE n(i) AS "
                 "(SELECT 0 UNION ALL SELECT i + 1 FROM n) SELECT t0.* FROM n, t0",
                 nullptr},
                {"ALTER TABLE meta RENAME TO m0; CREATE VIEW meta AS WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL SELECT "
                 "i + 1 FROM n) SELECT i AS key, hex(zeroblob(100000)) AS value FROM n",
                 nullptr},
                {"ALTER TABLE checks RENAME TO c0; CREATE VIEW checks AS SELECT * FROM c0", nullptr},
                {"ALTER TABLE scenes RENAME TO s0; CREATE VIEW scenes AS SELECT * FROM s0", nullptr},
                {"ALTER TABLE structures RENAME TO s0; CREATE VIEW structures AS SELECT * FROM s0", nullptr},
                {"ALTER TABLE meshes RENAME TO m0; CREATE VIEW meshes AS SELECT * FROM m0", nullptr},
                {"ALTER TABLE embedded RENAME TO m0; CREATE VIEW embedded AS SELECT * FROM m0", nullptr},
                {"CREATE VIEW maps AS SELECT 1 AS id, 'a' AS sha256, zeroblob(1000000) AS corners", nullptr},
                {"CREATE VIEW more AS SELECT 1", nullptr},
                {"DROP VIEW tick_values; CREATE VIEW tick_values AS SELECT 1 AS tick", nullptr},
                {"DROP TABLE meta; CREATE TABLE meta(key TEXT PRIMARY KEY, value AS (hex(zeroblob(400000000))))",
                 "other columns in the table \"meta\""},
                {"ALTER TABLE meta ADD COLUMN more AS (hex(zeroblob(400000000)))", "other columns"},
                {"ALTER TABLE ticks ADD COLUMN more AS (hip_x * 2)", "other columns"},
                {"ALTER TABLE events ADD COLUMN more", "other columns"},
                {"CREATE TRIGGER t AFTER INSERT ON events BEGIN DELETE FROM ticks; END", nullptr},
                {"CREATE TEMP TABLE x(y); CREATE TABLE more(x)", nullptr},
                {"CREATE INDEX i ON events(hex(json))", nullptr},
                {"CREATE VIRTUAL TABLE f USING fts5(x)", nullptr},
                {"CREATE VIRTUAL TABLE f USING rtree(id, a, b)", nullptr},
                {"ANALYZE", nullptr},
                {"PRAGMA writable_schema = ON; UPDATE sqlite_master SET sql = 'CREATE VIEW events AS SELECT 1' WHERE "
                 "name = 'events'",
                 nullptr},
                {"DROP TABLE embedded", "no table \"embedded\""},
                {"DROP TABLE checks", "no table \"checks\""},
            },
            "expected only the tables of version");
    }
    void schemaOfItsOwnIsRefused()
    {
        QFETCH(QString, sql);
        QFETCH(QString, said);
        QVERIFY(test::runSql(path("a.palpate"), sql.toStdString()));
        const double begin_s = cpuTime_s();
        const auto reader = RecordingReader::open(path("a.palpate"));
        QVERIFY(!reader.isOk());
        const std::string& message = reader.status().message();
        QVERIFY2(QString::fromStdString(message).contains(said) ||
                     QString::fromStdString(message).contains("malformed database schema"),
                 message.c_str());
        QVERIFY2(message.starts_with(path("a.palpate").string()) && message.find('\n') == std::string::npos,
                 message.c_str());
        (void)session::recoverRecording(path("a.palpate"), path("b.palpate"));
        QVERIFY(cpuTime_s() - begin_s < kSoon_s);
    }

    void schemaOfAllVersionsIsItsOwn()
    {
        for (const char* name : {"version1", "version2"}) {
            const auto reader =
                RecordingReader::open(std::string(PALPATE_SOURCE_DIR "/tests/session/data/") + name + ".palpate");
            QVERIFY2(reader.isOk(), reader.status().message().c_str());
            QVERIFY(reader.value()->faults().empty());
        }
    }

    void writeAheadLogIsRefused()
    {
        QVERIFY(test::runSql(path("a.palpate"), "PRAGMA journal_mode = WAL"));
        write("a.palpate-wal", QByteArray(100, 'x'));
        const QStringList state = stateOf(m_folder->path());
        const auto reader = RecordingReader::open(path("a.palpate"));
        QVERIFY2(reader.status().message().find("write-ahead log") != std::string::npos,
                 reader.status().message().c_str());
        QCOMPARE(stateOf(m_folder->path()), state);
    }

    /// Values with a wrong checksum: damage is named and skipped, and no figure is inf or nan.
    void damagedTicksAreLeftOut_data()
    {
        statements(
            {
                {"UPDATE ticks SET hip_x = 1e300", "tick 0: found 10³⁰⁰ for hip"},
                {"UPDATE ticks SET hip_x = 1e300 WHERE tick = 700", "ticks 500 to 749: tick 700: found 10³⁰⁰ for hip"},
                {"UPDATE ticks SET hip_x = 9e999 WHERE tick = 700", "tick 700: found inf for hip"},
                {"UPDATE ticks SET hip_x = NULL WHERE tick = 3", "tick 3: found nothing for hip"},
                {"UPDATE ticks SET hip_x = 'abc', structure = 'x', triangle = 'y' WHERE tick > 1200",
                 "found text for hip"},
                {"UPDATE ticks SET structure = 'x' WHERE tick = 1300", "found text for structure"},
                {"UPDATE ticks SET structure = 5 WHERE tick BETWEEN 1 AND 1400", "ticks 0 to 249: found other bits"},
                {"UPDATE ticks SET triangle = -1 WHERE structure = 0", "found -1 for triangle"},
                {"UPDATE ticks SET constraints = 200", "found 200 for constraints"},
                {"UPDATE ticks SET flags = 65536", "found 65536 for flags"},
                {"UPDATE ticks SET time_ns = 9223372036854775807 WHERE tick = 1499", "for time_ns"},
                {"UPDATE ticks SET force_y = x'00' WHERE structure = 0", "found bytes for force"},
                {"UPDATE ticks SET force_x = 1e308, force_y = 1e308, force_z = 1e308", "found 10³⁰⁸ for force"},
                {"UPDATE ticks SET layers = zeroblob(88000) WHERE structure = 0", "no contacts of layers"},
                {"UPDATE ticks SET layers = 'text' WHERE structure = 0", "found text for layers"},
                {"UPDATE ticks SET hip_z = hip_z + 1e-9 WHERE tick = 700", "ticks 500 to 749: found other bits"},
                {"DELETE FROM ticks WHERE tick = 700", "ticks 500 to 749: found 249 rows, expected 250"},
                {"DELETE FROM checks WHERE first = 500", "a part of the recording was taken out"},
                {"DELETE FROM checks", "metadata: found without a checksum"},
                {"UPDATE checks SET rows = 100 WHERE first = 500", "ticks 500 to 749: found 101 rows, expected 100"},
                {"UPDATE events SET json = '{}'", "events "},
                {"UPDATE events SET tick = 9e18", "event "},
                {"UPDATE structures SET stiffness_N_per_mm = 1", "scene 1: found other bits"},
                {"UPDATE meta SET value = '20 N' WHERE key = 'device_name'", "metadata: found other bits"},
            },
            "");
    }
    void damagedTicksAreLeftOut()
    {
        QFETCH(QString, sql);
        QFETCH(QString, said);
        QVERIFY(test::runSql(path("a.palpate"), sql.toStdString()));
        const auto reader = RecordingReader::open(path("a.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        const auto measures = session::measureSession(*reader.value(), surfacesOf(*reader.value()));
        QVERIFY2(measures.isOk(), measures.status().message().c_str());
        QVERIFY(isFinite(measures.value()));
        QVERIFY(std::isfinite(reader.value()->extent().duration_s) && reader.value()->extent().duration_s < 2.0);
        const std::vector<std::string> faults = englishOf(reader.value()->faults());
        QCOMPARE(englishOf(measures.value().damaged), faults);
        QVERIFY2(std::any_of(faults.begin(), faults.end(),
                             [&](const std::string& line) { return QString::fromStdString(line).contains(said); }),
                 faults.empty() ? "no fault" : faults.front().c_str());
        QVERIFY(!reader.value()->verify().isOk());
        const auto read = reader.value()->motion();
        for (const core::Vec3& p : read.isOk() ? read.value().p_WH : std::vector<core::Vec3>()) {
            QVERIFY(p.allFinite() && p.norm() < 100.0);
        }
        // A seek never returns a tick of a damaged block.
        for (const std::int64_t tick : {0, 3, 700, 1300, 1499}) {
            if (const auto at = reader.value()->at(tick)) {
                QVERIFY(at->p_WH.norm() < 100.0 && at->felt.f_W.norm() < 100.0 && at->tick <= tick);
            }
        }
    }

    /// A message about a block that several measures read appears once; the other blocks are measured.
    void wholeBlocksAreMeasured()
    {
        QVERIFY(test::runSql(path("a.palpate"), "UPDATE ticks SET hip_x = 1e300 WHERE tick = 700;"
                                                "UPDATE checks SET sha256 = zeroblob(32) WHERE first = 1000"));
        const auto reader = RecordingReader::open(path("a.palpate"));
        for (int times = 0; times < 2; ++times) {
            QCOMPARE(session::measureSession(*reader.value(), {}).value().sums.ticks, std::int64_t{1000});
        }
        // A damaged hash does not invalidate the following block.
        QCOMPARE(reader.value()->faults().size(), std::size_t{2});
        QCOMPARE(reader.value()->at(700)->tick, std::int64_t{499});
        QCOMPARE(reader.value()->at(1249)->tick, std::int64_t{999});
        QCOMPARE(reader.value()->at(1250)->tick, std::int64_t{1250});
    }

    /// Values with correct checksums, as any program can write them.
    void valuesOutOfBoundsAreRefused_data()
    {
        statements(
            {
                {"UPDATE meta SET value = '1e-300' WHERE key = 'dt_s'", "\"dt_s\" is not a valid number"},
                {"UPDATE meta SET value = '0.002' WHERE key = 'dt_s'", "not one period of \"rate_Hz\""},
                {"UPDATE meta SET value = '2' WHERE key = 'dt_s'; UPDATE meta SET value = '0.5' WHERE key = 'rate_Hz'",
                 "is not a valid number"},
                {"UPDATE meta SET value = 'inf' WHERE key = 'rate_Hz'", "\"rate_Hz\" is not a valid number"},
                {"UPDATE meta SET value = 'nan' WHERE key = 'device_max_force_N'", "is not a valid number"},
                {"UPDATE meta SET value = '9223372036854775807' WHERE key = 'first_tick'", "\"first_tick\" is"},
                {"UPDATE meta SET value = '99999999999' WHERE key = 'device_buttons'", "\"device_buttons\" is"},
                {"UPDATE structures SET stiffness_N_per_mm = 1e9", "for stiffness_N_per_mm, expected 0 to 1000"},
                {"UPDATE structures SET stiffness_N_per_mm = 'firm'", "found nan for stiffness_N_per_mm"},
                {"UPDATE structures SET friction_static = 6", "for friction_static, expected 0 to 5"},
                {"UPDATE structures SET layer = 'deep'", "found the layer"},
                {"UPDATE meshes SET unit_mm = 1e300", "for unit_mm"},
                {"UPDATE meshes SET unit_mm = NULL", "found no mesh with a unit"},
                {"UPDATE structures SET mesh = 'none'", "found no mesh with a unit"},
                {"UPDATE meshes SET pose = '1 0 0 1e300 0 1 0 0 0 0 1 0'", "for pose"},
                {"UPDATE scenes SET fingertip_mm = 1e300", "for fingertip_mm"},
                {"UPDATE scenes SET generation = -5 WHERE generation = 1", "found the scene -5"},
            },
            "");
    }
    void valuesOutOfBoundsAreRefused()
    {
        QFETCH(QString, sql);
        QFETCH(QString, said);
        QVERIFY(test::runSql(path("a.palpate"), sql.toStdString()));
        QVERIFY(test::rehash(path("a.palpate")));
        const auto reader = RecordingReader::open(path("a.palpate"));
        QCOMPARE(reader.status().code(), core::StatusCode::BadFormat);
        QVERIFY2(QString::fromStdString(reader.status().message()).contains(said), reader.status().message().c_str());
    }

    /// Tick numbers at the limits of their range.
    void extremeTickNumbers_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::addColumn<int>("measured");
        QTest::addColumn<int>("recovered");
        QTest::newRow("the last one")
            << "UPDATE ticks SET tick = 9223372036854775807 WHERE tick = 1499; UPDATE checks SET last = "
               "9223372036854775807 WHERE kind = 'ticks' AND last = 1499"
            << 1250 << 1499;
        QTest::newRow("a line from the lowest")
            << "UPDATE checks SET first = -9223372036854775808 WHERE first = 500" << 1250 << 1500;
        QTest::newRow("a line to the highest")
            << "UPDATE checks SET last = 9223372036854775807 WHERE first = 500" << 1250 << 1500;
        QTest::newRow("a line of all") << "UPDATE checks SET first = 0, last = 9007199254740992 WHERE first = 500"
                                       << 1250 << 1500;
        QTest::newRow("a negative tick") << "UPDATE ticks SET tick = -5 WHERE tick = 0" << 1250 << 1250;
        QTest::newRow("rows") << "UPDATE checks SET rows = 9223372036854775807 WHERE first = 500" << 1250 << 1250;
    }
    void extremeTickNumbers()
    {
        QFETCH(QString, sql);
        QFETCH(int, measured);
        QFETCH(int, recovered);
        QVERIFY(test::runSql(path("a.palpate"), sql.toStdString()));
        const auto reader = RecordingReader::open(path("a.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        const session::RecordingExtent& extent = reader.value()->extent();
        QVERIFY(extent.firstTick >= 0 && extent.lastTick <= 1499 && extent.dropped <= 500 && extent.duration_s < 2.0);
        const auto measures = session::measureSession(*reader.value(), {});
        QCOMPARE(measures.value().sums.ticks, std::int64_t{measured});
        QVERIFY(!reader.value()->faults().empty());
        const auto copy = session::recoverRecording(path("a.palpate"), path("b.palpate"));
        QVERIFY2(copy.isOk(), copy.status().message().c_str());
        QVERIFY2(copy.value().ticks >= recovered, std::to_string(copy.value().ticks).c_str());
        QVERIFY(RecordingReader::open(path("b.palpate")).value()->verify().isOk());
    }

    /// Surfaces with correct hashes but numbers that no mesh file may contain.
    void surfacesOutOfBoundsAreRefused_data()
    {
        QTest::addColumn<QString>("sql");
        const QString vertices = "UPDATE embedded SET vertices = x'%1' || substr(vertices, 25)";
        QTest::newRow("1e308 mm") << vertices.arg(QString("a0c8eb85f3cce17f").repeated(3));
        QTest::newRow("1.1e7 mm") << vertices.arg(QString("00000000f0fb6441").repeated(3));
        QTest::newRow("nan") << vertices.arg(QString("000000000000f87f").repeated(3));
        QTest::newRow("one vertex three times")
            << "UPDATE embedded SET triangles = x'010000000100000001000000' || substr(triangles, 13)";
        QTest::newRow("an index out of range")
            << "UPDATE embedded SET triangles = x'ffffff7f0100000002000000' || substr(triangles, 13)";
        QTest::newRow("no triangle") << "UPDATE embedded SET triangles = x'', two_sided = x'', source = x''";
        QTest::newRow("fewer sides") << "UPDATE embedded SET two_sided = x'00'";
        QTest::newRow("half a number") << "UPDATE embedded SET vertices = substr(vertices, 2)";
    }
    void surfacesOutOfBoundsAreRefused()
    {
        QFETCH(QString, sql);
        QVERIFY(test::runSql(path("a.palpate"), sql.toStdString()));
        QVERIFY(test::rehashSurfaces(path("a.palpate")));
        QVERIFY(test::rehash(path("a.palpate")));
        const auto reader = RecordingReader::open(path("a.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        const std::vector<std::string> hashes = reader.value()->embeddedHashes();
        QCOMPARE(hashes.size(), std::size_t{1});
        QVERIFY(!reader.value()->embedded(hashes.front()).isOk());
    }

    /// The state before the first tick holds the triangles that the solver touches.
    void startThatTouchesNoTriangleIsRefused()
    {
        // First layer: structure 0, triangle 0x7fffffff, side 1, one constraint, placed.
        QVERIFY(test::runSql(path("a.palpate"),
                             "UPDATE meta SET value = CAST(substr(value, 1, 36) || x'ffffff7f0000000000000000010000"
                             "0101' || substr(value, 54) AS BLOB) WHERE key = 'start'"));
        QVERIFY(test::rehash(path("a.palpate")));
        const auto reader = RecordingReader::open(path("a.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        QCOMPARE(int(reader.value()->info().start.layers[0].constraints), 1);
        session::SurfacesByHash surfaces;
        for (const std::string& hash : reader.value()->embeddedHashes()) {
            surfaces[hash] = test::boxSurfaces().begin()->second;
        }
        const auto again = session::resimulate(*reader.value(), surfaces);
        QVERIFY(!again.isOk());
        QVERIFY2(again.status().message().find("triangle 2147483647") != std::string::npos,
                 again.status().message().c_str());
    }

    /// Events whose texts share pages, and pages in cycles, take bounded time.
    void pagesThatLeadInCirclesEnd()
    {
        const QByteArray good = bytes("a.palpate");
        constexpr qsizetype kPage = 4096;
        const auto be32 = [](quint32 value) {
            QByteArray out(4, 0);
            qToBigEndian(value, out.data());
            return out;
        };
        for (qsizetype page = 1; page * kPage < good.size(); ++page) {
            // An inner page whose children all refer back to this page or its neighbour.
            QByteArray inner(kPage, 0);
            inner[0] = 5;
            constexpr int kCells = 400;
            inner.replace(3, 2, be32(kCells).mid(2));
            inner.replace(5, 2, be32(kPage - 5 * kCells).mid(2));
            inner.replace(8, 4, be32(static_cast<quint32>(page + 2)));
            for (int cell = 0; cell < kCells; ++cell) {
                const int at = kPage - 5 * (cell + 1);
                inner.replace(12 + 2 * cell, 2, be32(static_cast<quint32>(at)).mid(2));
                inner.replace(at, 4, be32(static_cast<quint32>(page + 2)));
                inner[at + 4] = static_cast<char>(cell % 100);
            }
            QByteArray bad = good;
            bad.replace(page * kPage, kPage, inner);
            write("c.palpate", bad);
            const double begin_s = cpuTime_s();
            const auto reader = RecordingReader::open(path("c.palpate"));
            if (reader.isOk()) {
                (void)session::measureSession(*reader.value(), {});
                (void)reader.value()->verify();
            }
            QVERIFY2(cpuTime_s() - begin_s < 4.0 * kSoon_s, qPrintable(QString::number(page)));
        }
    }
};

PALPATE_TEST(HostileRecordings)
#include "tst_HostileRecordings.moc"
