// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Shapes.h"
#include "Sessions.h"
#include "TestRunner.h"

#include <palpate/geometry/Repair.h>
#include <palpate/session/GeometryHash.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/RecordingWriter.h>
#include <palpate/session/Recovery.h>
#include <palpate/session/SharedCopy.h>

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

using namespace palpate;
using session::RecordingReader;

/// Paths in recordings: those of a new recording, and those of a copy that is given to others.
class SharedCopy : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    std::filesystem::path path(const char* name) const { return m_folder.filePath(name).toStdString(); }
    QByteArray bytes(const char* name) const
    {
        QFile file(m_folder.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    static std::vector<servo::TickRecord> ticksOf(const RecordingReader& reader)
    {
        std::vector<servo::TickRecord> all;
        (void)reader.forEach(0, std::numeric_limits<std::int64_t>::max(), [&](const servo::TickRecord& tick) {
            all.push_back(tick);
            return true;
        });
        return all;
    }

    /// Records in the folder `recordings`. @param mesh  of the structure, absolute
    void record(const char* name, const std::filesystem::path& scene, const std::filesystem::path& mesh) const
    {
        QVERIFY(QDir(m_folder.path()).mkpath("recordings"));
        session::RecordingInfo info;
        info.scene = scene.string();
        info.firstGeneration = 1;
        std::filesystem::remove(path(name));
        auto writer = session::RecordingWriter::create(path(name), info, session::RecordingWriter::Sync::AtEnd);
        QVERIFY2(writer.isOk(), writer.status().message().c_str());
        for (session::SceneRecord one : test::palpationScenes()) {
            one.structures[0].source.mesh = mesh.string();
            QVERIFY(writer.value()->addScene(one).isOk());
        }
        for (const servo::TickRecord& tick : test::palpationTicks(1000)) {
            QVERIFY(writer.value()->append(tick).isOk());
        }
        QVERIFY(writer.value()->finish().isOk());
    }

  private Q_SLOTS:

    void newRecordingsHaveNoAbsolutePath_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("stored");
        QTest::newRow("beside") << "recordings/box.stl"
                                << "box.stl";
        QTest::newRow("below") << "recordings/deep/box.stl"
                               << "deep/box.stl";
        QTest::newRow("elsewhere") << "cases/anna/box.stl"
                                   << "../cases/anna/box.stl";
        QTest::newRow("not normal") << "recordings/../cases/./box.stl"
                                    << "../cases/box.stl";
    }
    void newRecordingsHaveNoAbsolutePath()
    {
        QFETCH(const QString, file);
        QFETCH(const QString, stored);
        const std::filesystem::path whole = path(qPrintable(file));
        record("recordings/r.palpate", whole, whole);
        const auto reader = RecordingReader::open(path("recordings/r.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        QCOMPARE(QString::fromStdString(reader.value()->info().scene), stored);
        QCOMPARE(QString::fromStdString(reader.value()->scenes()[1].structures[0].source.mesh), stored);
        QVERIFY(!bytes("recordings/r.palpate").contains(m_folder.path().toUtf8()));
        QVERIFY2(reader.value()->verify().isOk(), reader.value()->verify().message().c_str());
    }

    /// `..` leads to the parent of a link's target.
    void aFolderIsResolvedBeforeAPathIsStored()
    {
        QVERIFY(QDir(m_folder.path()).mkpath("disk/inner"));
        QVERIFY(QDir(m_folder.path()).mkpath("recordings"));
        (void)QFile::link(m_folder.filePath("disk/inner"), m_folder.filePath("recordings/link"));
        record("recordings/link/r.palpate", path("cases/box.stl"), path("cases/box.stl"));
        const auto reader = RecordingReader::open(path("recordings/link/r.palpate"));
        QCOMPARE(reader.value()->info().scene, std::string("../../cases/box.stl"));
    }

    void aRecoveredCopyElsewhereLeadsToTheSameFiles()
    {
        QVERIFY(QDir(m_folder.path()).mkpath("cases"));
        QVERIFY(QDir(m_folder.path()).mkpath("copies/deep"));
        QVERIFY(QFile(m_folder.filePath("cases/box.stl")).open(QIODevice::WriteOnly));
        record("recordings/r.palpate", path("cases/box.stl"), path("cases/missing.stl"));
        QVERIFY(session::recoverRecording(path("recordings/r.palpate"), path("copies/deep/c.palpate")).isOk());
        const auto reader = RecordingReader::open(path("copies/deep/c.palpate"));
        QCOMPARE(reader.value()->info().scene, std::string("../../cases/box.stl"));
        // A path that leads nowhere is kept.
        QCOMPARE(reader.value()->scenes()[0].structures[0].source.mesh, std::string("../cases/missing.stl"));
    }

    void copiesHaveNoFolder()
    {
        QVERIFY(QDir(m_folder.path()).mkpath("recordings"));
        // As older recordings, with absolute paths, and with texts that contain them.
        record("recordings/r.palpate", path("cases/anna/s.palpate.json"), path("cases/anna/box.stl"));
        QVERIFY(test::runSql(path("recordings/r.palpate"),
                             "INSERT INTO meta VALUES('unknown', '" + path("cases/anna").string() + "');"));
        QVERIFY(!session::shareRecording(path("recordings/r.palpate"), path("c.palpate")).isOk()); // changed
        record("recordings/r.palpate", path("cases/anna/s.palpate.json"), path("cases/anna/box.stl"));
        const std::string note = R"({"text": "harder, 2 N/mm, 5/10 mm"})";
        const geometry::RepairedMesh box =
            geometry::repair(test::box(core::Vec3(-20, -20, -20), core::Vec3(20, 20, 20)));
        {
            session::RecordingInfo info;
            info.scene = "../cases/anna/s.palpate.json";
            info.sceneBeside = "anna/s.palpate.json";
            info.firstGeneration = 1;
            info.device.name = "a device";
            std::filesystem::remove(path("recordings/r.palpate"));
            auto writer = session::RecordingWriter::create(path("recordings/r.palpate"), info);
            for (session::SceneRecord one : test::palpationScenes()) {
                session::StructureSource& source = one.structures[0].source;
                source.mesh = "../cases/anna/box.stl";
                source.sha256 = session::geometryHash(box.mesh);
                source.embed = std::make_shared<const geometry::RepairedMesh>(box);
                QVERIFY(writer.value()->addScene(one).isOk());
            }
            QVERIFY(writer.value()->addEvent({0, "note", note}).isOk());
            QVERIFY(writer.value()
                        ->addEvent({2, "fault",
                                    R"({"what": "/home/anna/My cases/log.txt: cannot be read",)"
                                    R"( "n": [0.1, "/home/anna/n.txt"], "in": {"file": "/home/anna/f.stl"}})"})
                        .isOk());
            for (const servo::TickRecord& tick : test::palpationTicks(1000)) {
                QVERIFY(writer.value()->append(tick).isOk());
            }
            QVERIFY(writer.value()->finish().isOk());
        }
        const QByteArray before = bytes("recordings/r.palpate");
        QVERIFY(before.contains("anna"));
        const auto shared = session::shareRecording(path("recordings/r.palpate"), path("c.palpate"));
        QVERIFY2(shared.isOk(), shared.status().message().c_str());
        QCOMPARE(shared.value(), std::int64_t{1000});
        QCOMPARE(bytes("recordings/r.palpate"), before);
        const QByteArray after = bytes("c.palpate");
        for (const char* part : {"anna", "cases", "/box.stl", "/s.palpate.json", "/home"}) {
            QVERIFY2(!after.contains(part), part);
        }
        QVERIFY(after.contains("box.stl"));
        QCOMPARE(QDir(m_folder.path()).entryList({"c.palpate*", ".palpate-*"}, QDir::Files | QDir::Hidden).size(), 1);

        const auto a = RecordingReader::open(path("recordings/r.palpate")),
                   b = RecordingReader::open(path("c.palpate"));
        QVERIFY2(b.isOk(), b.status().message().c_str());
        QVERIFY2(b.value()->verify().isOk(), b.value()->verify().message().c_str());
        QVERIFY(b.value()->extent().isComplete);
        QCOMPARE(b.value()->info().scene, std::string("s.palpate.json"));
        QVERIFY(b.value()->info().sceneBeside.empty());
        QCOMPARE(b.value()->info().startedUtc, a.value()->info().startedUtc);
        QCOMPARE(b.value()->info().device.name, std::string("a device"));
        const auto ticks = ticksOf(*a.value()), copied = ticksOf(*b.value());
        QCOMPARE(copied.size(), ticks.size());
        for (std::size_t i = 0; i < ticks.size(); ++i) {
            QVERIFY2(test::isSameTick(ticks[i], copied[i]), std::to_string(i).c_str());
        }
        const auto& events = b.value()->events();
        QCOMPARE(events.size(), a.value()->events().size() + 1);
        QCOMPARE(events.back().kind, std::string("shared"));
        QVERIFY(events.back().json.find("from_sha256") != std::string::npos);
        QCOMPARE(events.front().json, note); // without a path, byte for byte
        const auto fault =
            std::find_if(events.begin(), events.end(), [](const auto& event) { return event.kind == "fault"; });
        QCOMPARE(fault->json,
                 std::string(R"({"in":{"file":"f.stl"},"n":[0.1,"n.txt"],"what":"log.txt: cannot be read"})"));
        QCOMPARE(b.value()->embeddedHashes(), std::vector<std::string>{session::geometryHash(box.mesh)});
        QVERIFY(b.value()->embedded(session::geometryHash(box.mesh)).isOk());
        const auto original = QCryptographicHash::hash(before, QCryptographicHash::Sha256).toHex();
        QVERIFY2(events.back().json.find(original.toStdString()) != std::string::npos, events.back().json.c_str());
    }

    void aCutOffRecordingStaysCutOff()
    {
        QVERIFY(test::writeRecording(path("cut.palpate"), test::palpationTicks(300), false));
        QVERIFY(session::shareRecording(path("cut.palpate"), path("shared.palpate")).isOk());
        const auto reader = RecordingReader::open(path("shared.palpate"));
        QVERIFY(reader.isOk() && reader.value()->verify().isOk());
        QVERIFY(!reader.value()->extent().isComplete);
        QCOMPARE(reader.value()->scenes().size(), std::size_t{2});
        QVERIFY(QDir(m_folder.path()).mkpath("folder"));
        QVERIFY(session::shareRecording(path("cut.palpate"), path("folder")).status().message().find("not a file") !=
                std::string::npos);
    }

    void aDamagedRecordingIsRefused()
    {
        record("recordings/r.palpate", path("s.palpate.json"), path("box.stl"));
        QVERIFY(test::runSql(path("recordings/r.palpate"), "UPDATE ticks SET hip_x = hip_x + 1 WHERE tick = 300"));
        std::filesystem::remove(path("c.palpate"));
        const auto shared = session::shareRecording(path("recordings/r.palpate"), path("c.palpate"));
        QVERIFY(shared.status().message().find("session recover") != std::string::npos);
        QVERIFY(!std::filesystem::exists(path("c.palpate")));
        const auto itself = session::shareRecording(path("recordings/r.palpate"), path("recordings/r.palpate"));
        QCOMPARE(itself.status().code(), core::StatusCode::BadCommandLine);
    }

    /// Older versions are copied as recovery does: ticks under the rules of their version.
    void olderVersionsAreCopied()
    {
        for (const char* name : {"version1.palpate", "version2.palpate"}) {
            const auto from = std::filesystem::path(PALPATE_SOURCE_DIR) / "tests/session/data" / name;
            const auto shared = session::shareRecording(from, path("old.palpate"));
            QVERIFY2(shared.isOk(), shared.status().message().c_str());
            const auto a = RecordingReader::open(from), b = RecordingReader::open(path("old.palpate"));
            QVERIFY(b.isOk() && b.value()->verify().isOk());
            QCOMPARE(b.value()->info().tickVersion, a.value()->info().tickVersion);
            QCOMPARE(b.value()->extent().ticks, a.value()->extent().ticks);
        }
    }
};

PALPATE_TEST(SharedCopy)
#include "tst_SharedCopy.moc"
