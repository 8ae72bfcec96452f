// SPDX-License-Identifier: BSD-3-Clause
#include "../meshio/Samples.h"
#include "Program.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/geometry/Repair.h>
#include <palpate/session/Findings.h>
#include <palpate/session/GeometryHash.h>
#include <palpate/session/RecordingWriter.h>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

using namespace palpate;
using core::Vec3;
using test::Outcome;

/// Tests `palpate session exercise` on a recording of 0.2 s with 6 N on a sheet of 40 mm, and with one finding.
class ExerciseCommand : public QObject
{
    Q_OBJECT

    test::Folder m_folder;

    Outcome run(const QStringList& arguments) const
    {
        return test::runProgram(QString::fromStdString(m_folder.path("").string()),
                                QStringList{"session", "exercise"} + arguments);
    }
    std::filesystem::path scene(const char* name, const char* exercise)
    {
        const std::string text = R"({"version": 1, "structures": [{"mesh": "a.stl", "name": "skin"},
            {"mesh": "b.stl", "name": "lump"}, {"mesh": "c.stl", "name": "gone"}])" +
                                 std::string(exercise) + "}";
        return m_folder.write(name, text.c_str());
    }

  private Q_SLOTS:
    void initTestCase()
    {
        session::RecordingInfo info;
        info.scene = scene("s.palpate.json", R"(, "exercise": {"targets": ["lump"], "time_s": 0.1, "force_ceiling_N": 5,
                                         "coverage_goal": 0.5})")
                         .string();
        session::SceneRecord record;
        record.generation = 1;
        for (const auto& [name, mesh] : {std::pair("skin", test::sheet(20.0, 40)),
                                         std::pair("lump", test::moved(test::sphere(6, 5.0), Vec3(0, 0, -8)))}) {
            const auto surface = std::make_shared<const geometry::RepairedMesh>(geometry::repair(mesh));
            session::StructureRecord& one = record.structures.emplace_back();
            one.name = name;
            one.source.sha256 = session::geometryHash(surface->mesh);
            one.source.embed = surface;
        }
        auto writer = session::RecordingWriter::create(m_folder.path("r.palpate"), info);
        QVERIFY(writer.isOk() && writer.value()->addScene(record).isOk());
        for (int i = 0; i < 200; ++i) {
            servo::TickRecord tick;
            tick.tick = i;
            tick.scene = 1;
            tick.p_WH = Vec3(0, 0, -2);
            tick.felt.n_W = Vec3(0, 0, 1);
            tick.felt.f_W = Vec3(0, 0, 6);
            tick.felt.structure = 0;
            tick.felt.constraints = 1;
            tick.felt.contactCount = 1;
            tick.felt.contacts[0] = {Vec3(0, 0, 0), tick.felt.n_W, tick.felt.f_W, 2.0, 1.0, 0, 0, 0, {}};
            QVERIFY(writer.value()->append(tick).isOk());
        }
        const core::Finding finding{.name = "pea", .id = "a"}; // 3 mm above the lump
        QVERIFY(writer.value()->addEvent({80, "finding", session::findingJson(finding)}).isOk());
        QVERIFY(writer.value()->finish().isOk());
    }

    void printsAndWritesTheScore()
    {
        const Outcome outcome = run({"r.palpate", "--json", "e.json"});
        QCOMPARE(outcome.error, QByteArray());
        QCOMPARE(outcome.exitCode, 0);
        QVERIFY2(outcome.out.startsWith("1 of 1 target found within 10 mm, 0 missed; 0 false alarms\n"
                                        "  lump: found after 0.1 s, 3 mm from the ball around it\n"
                                        "time 0.100 s of a limit of 0.1 s\n"),
                 outcome.out.constData());
        QVERIFY2(outcome.out.contains("goal 50 %: not reached"), outcome.out.constData());
        QVERIFY2(outcome.out.contains("force: peak 6 N; above the ceiling of 5 N for 0.100 s, impulse above it 0.1 "
                                      "N s\n"),
                 outcome.out.constData());
        QFile file(QString::fromStdString(m_folder.path("e.json").string()));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const Outcome piped = run({"r.palpate", "--json", "-"});
        QCOMPARE(piped.out, file.readAll());
        QCOMPARE(QJsonDocument::fromJson(piped.out).object()["targets"][0]["name"].toString(), QString("lump"));
        const Outcome strict = run({"r.palpate", "--within", "2"});
        QVERIFY2(strict.out.startsWith("0 of 1 target found within 2 mm, 1 missed; 1 false alarm\n  lump: missed\n"
                                       "  pea at 0.1 s: false alarm\n"),
                 strict.out.constData());
    }

    void refusesWhatItCannotScore_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("message");
        scene("none.palpate.json", "");
        scene("other.palpate.json", R"(, "exercise": {"targets": ["gone"]})");
        scene("bad.palpate.json", R"(, "exercise": {"targets": []})");
        (void)m_folder.write("a.txt", "no scene");
        QTest::newRow("no exercise") << QStringList{"r.palpate", "--scene", "none.palpate.json"}
                                     << QByteArray("none.palpate.json: exercise: found nothing, expected");
        QTest::newRow("no scene") << QStringList{"r.palpate", "--scene", "a.txt"}
                                  << QByteArray("found no scene file with an exercise");
        QTest::newRow("no targets") << QStringList{"r.palpate", "--scene", "bad.palpate.json"}
                                    << QByteArray("bad.palpate.json: exercise.targets: found nothing, expected");
        QTest::newRow("no distance") << QStringList{"r.palpate", "--within", "0"} << QByteArray("--within: found ");
        QTest::newRow("a distance in words")
            << QStringList{"r.palpate", "--within", "far"} << QByteArray("--within: found ");
        QTest::newRow("no number") << QStringList{"r.palpate", "--distance", "nan"} << QByteArray("--distance: found ");
    }
    void refusesWhatItCannotScore()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, message);
        const Outcome outcome = run(arguments);
        QCOMPARE(outcome.exitCode, 2);
        QCOMPARE(outcome.out, QByteArray());
        QVERIFY2(outcome.error.contains(message), outcome.error.constData());
    }
};

PALPATE_TEST(ExerciseCommand)
#include "tst_ExerciseCommand.moc"
