// SPDX-License-Identifier: BSD-3-Clause
#include "../meshio/Samples.h"
#include "Program.h"
#include "TestRunner.h"

#include <palpate/meshio/SceneFile.h>
#include <palpate/session/Findings.h>
#include <palpate/session/RecordingWriter.h>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

using namespace palpate;
using core::Finding;
using core::FindingType;
using test::Outcome;

/// Tests `palpate findings`: export of the findings in a scene or recording as tables and point lists, and import of
/// point lists.
class FindingsCommand : public QObject
{
    Q_OBJECT

    test::Folder m_folder;

    Outcome run(const QStringList& arguments) const
    {
        return test::runProgram(QString::fromStdString(m_folder.path("").string()),
                                QStringList{"findings"} + arguments);
    }

    QByteArray read(const char* name) const
    {
        QFile file(QString::fromStdString(m_folder.path(name).string()));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    static std::vector<Finding> marked()
    {
        return {{.name = "=pea",
                 .p_W = {0.1, -2.0, 3.0},
                 .note = "hard, \"as a pea\"",
                 .structure = "liver",
                 .force_N = 2.5,
                 .depth_mm = 5.0,
                 .layers = {{"liver", 0.75, 5.0}, {"lump", 1.75, 2.0}},
                 .id = "a",
                 .type = FindingType::Lump,
                 .size_mm = 12.0,
                 .camera = core::ViewPose{{1, 2, 1.0 / 3.0}, {0, 0, 0}, {0, 0, 1}, 30},
                 .marked_utc = "2026-11-23T00:24:54Z"},
                {.name = "vein", .p_W = {-5, 6, 7}, .id = "b", .type = FindingType::KeepAway},
                {.name = "Note 3", .note = "cirrhotic", .id = "c", .hasPlace = false}};
    }

    static std::vector<Finding> byId(std::vector<Finding> findings)
    {
        std::sort(findings.begin(), findings.end(), [](const Finding& x, const Finding& y) { return x.id < y.id; });
        return findings;
    }

    /// Returns the header with the column names of DESK, and a row per finding.
    /// @param moment  time of the first finding, in a recording
    static QByteArray table(const QByteArray& moment, const QByteArray& others)
    {
        return "id,name,type,structure,x_mm,y_mm,z_mm,frame,size_mm,force_N,depth_mm,felt_N_per_mm,marked_s,recording,"
               "note,inside,total_force_N\r\n"
               "a,'=pea,lump,liver,0.1,-2,3,LPS,12,2.5,5,0.5," +
               moment +
               ",\"hard, \"\"as a pea\"\"\",,2.5\r\n"
               "b,vein,keep away,,-5,6,7,LPS,,,,," +
               others +
               ",,,\r\n"
               "c,Note 3,other,,,,,,,,,," +
               others + ",cirrhotic,,\r\n";
    }

  private Q_SLOTS:
    void initTestCase()
    {
        meshio::SceneFile scene;
        scene.findings = marked();
        QVERIFY(meshio::writeScene(m_folder.path("s.palpate.json"), scene).isOk());
        scene.findings = {{.name = "there before", .p_W = {9, 9, 9}, .id = "b"}};
        QVERIFY(meshio::writeScene(m_folder.path("other.palpate.json"), scene).isOk());

        session::RecordingInfo info;
        info.rate_Hz = 1000.0;
        info.firstTick = 40;
        auto writer = session::RecordingWriter::create(m_folder.path("r.palpate"), info);
        QVERIFY(writer.isOk());
        for (std::int64_t i = 0; i < 2000; ++i) {
            servo::TickRecord tick;
            tick.tick = 40 + i;
            QVERIFY(writer.value()->append(tick).isOk());
        }
        std::int64_t tick = 1540;
        for (const Finding& finding : marked()) {
            QVERIFY(writer.value()
                        ->addEvent({tick, finding.hasPlace ? "finding" : "note", session::findingJson(finding)})
                        .isOk());
            tick = 1790;
        }
        QVERIFY(writer.value()->finish().isOk());
        (void)m_folder.write("no.txt", "neither");
        (void)m_folder.write("broken.palpate.json", R"({"version": 1, "findings": [{"position": [0, 0, "x"]}]})");
        (void)m_folder.write("cut.palpate", std::string("SQLite format 3\0 and no more", 28));
    }

    void theTableHasItsColumns()
    {
        const Outcome scene = run({"s.palpate.json", "--csv", "s.csv"});
        QVERIFY2(scene.exitCode == 0, scene.error);
        QCOMPARE(read("s.csv"), table(",", ","));
        QVERIFY2(scene.out.startsWith("3 findings\n1. =pea (lump) on liver at (0.1 -2.0 3.0) mm, 12 mm across, 2.5 N "
                                      "at 5 mm: hard, \"as a pea\"\n"),
                 scene.out);
        QVERIFY2(scene.out.contains("\n3. Note 3 (note): cirrhotic\n"), scene.out);

        const Outcome recording = run({"r.palpate", "--csv", "r.csv"});
        QVERIFY2(recording.exitCode == 0, recording.error);
        QCOMPARE(read("r.csv"), table("1.5,r.palpate", "1.75,r.palpate"));
        QVERIFY2(recording.out.contains(", marked at 1.5 s: hard"), recording.out);
    }

    void aTableOnStdoutIsAlone()
    {
        const Outcome csv = run({"s.palpate.json", "--csv", "-"});
        QCOMPARE(csv.exitCode, 0);
        QCOMPARE(csv.out, table(",", ","));
        const Outcome markups = run({"s.palpate.json", "--markups", "-"});
        QCOMPARE(markups.exitCode, 0);
        // lump, keep away, and the list for notes
        QCOMPARE(QJsonDocument::fromJson(markups.out)["markups"].toArray().size(), 3);
    }

    void markupsGoOutAndComeBackEqual_data()
    {
        QTest::addColumn<QString>("file");
        QTest::newRow("scene") << "s.palpate.json";
        QTest::newRow("recording") << "r.palpate";
    }
    void markupsGoOutAndComeBackEqual()
    {
        QFETCH(QString, file);
        const Outcome out = run({file, "--csv", "m.csv", "--markups", "m.mrk.json"});
        QVERIFY2(out.exitCode == 0, out.error);
        QVERIFY(!read("m.csv").isEmpty());
        const QJsonObject document = QJsonDocument::fromJson(read("m.mrk.json")).object();
        QVERIFY(document["@schema"].toString().contains("markups-schema-v1.0.3.json"));

        meshio::SceneFile empty;
        QVERIFY(meshio::writeScene(m_folder.path("empty.palpate.json"), empty).isOk());
        const Outcome in = run({"empty.palpate.json", "--import", "m.mrk.json", "--out", "back.palpate.json"});
        QVERIFY2(in.exitCode == 0, in.error);
        QCOMPARE(in.out, QByteArray("back.palpate.json: 3 findings taken, 3 in all\n"));
        const auto back = meshio::readScene(m_folder.path("back.palpate.json"));
        QVERIFY(back.isOk());
        const std::vector<Finding> is = byId(back.value().findings), was = byId(marked());
        QCOMPARE(is.size(), was.size());
        for (std::size_t i = 0; i < is.size(); ++i) {
            QVERIFY2(is[i] == was[i], was[i].name.c_str());
        }
    }

    /// Existing findings stay, and an imported finding with a used id gets another id.
    void whatIsTakenComesBesideWhatIsThere()
    {
        QCOMPARE(run({"s.palpate.json", "--markups", "m.mrk.json"}).exitCode, 0);
        const Outcome in = run({"other.palpate.json", "--import", "m.mrk.json", "--out", "both.palpate.json"});
        QCOMPARE(in.out, QByteArray("both.palpate.json: 3 findings taken, 4 in all\n"));
        const auto both = meshio::readScene(m_folder.path("both.palpate.json"));
        QVERIFY(both.isOk());
        const std::vector<Finding>& findings = both.value().findings;
        QCOMPARE(findings.size(), std::size_t{4});
        QCOMPARE(findings[0].name, std::string("there before"));
        QCOMPARE(std::count_if(findings.begin(), findings.end(), [](const Finding& one) { return one.id == "b"; }), 1);
        const auto before = meshio::readScene(m_folder.path("other.palpate.json"));
        QCOMPARE(before.value().findings.size(), std::size_t{1});
    }

    void badPointsAreNamedAndTheRestIsTaken()
    {
        (void)m_folder.write(
            "bad.mrk.json",
            "{\"@schema\": \"markups-schema-v1.0.3.json\", \"markups\": [{\"type\": \"Fiducial\", "
            "\"coordinateSystem\": \"RAS\", \"coordinateUnits\": \"um\", \"controlPoints\": [{\"label\": \"n\", "
            "\"position\": [NaN, 0, 0]}, {\"label\": \"none\"}, {\"label\": \"good\", \"position\": [1000, -2000, "
            "3000]}]}]}");
        const Outcome in = run({"other.palpate.json", "--import", "bad.mrk.json", "--out", "some.palpate.json"});
        QCOMPARE(in.exitCode, 3);
        QCOMPARE(in.out, QByteArray("some.palpate.json: 1 finding taken, 2 in all\n"));
        QCOMPARE(in.error.count('\n'), 2);
        QVERIFY2(in.error.contains("bad.mrk.json: markups[0].controlPoints[0].position: found"), in.error);
        QVERIFY2(in.error.contains("bad.mrk.json: markups[0].controlPoints[1]: found no position"), in.error);
        const auto some = meshio::readScene(m_folder.path("some.palpate.json"));
        QCOMPARE(some.value().findings.back().p_W, core::Vec3(-1, 2, 3));
    }

    void whatCannotBeIsOneLine_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("exitCode");
        QTest::addColumn<QByteArray>("error");
        const auto row = [](const char* name, const QStringList& arguments, int exitCode, const char* error) {
            QTest::newRow(name) << arguments << exitCode << QByteArray(error);
        };
        row("neither kind", {"no.txt"}, 2, "palpate: no.txt: found neither a scene nor a recording");
        row("not there", {"gone.palpate.json"}, 2, "palpate: gone.palpate.json");
        row("broken scene", {"broken.palpate.json"}, 2,
            "palpate: broken.palpate.json: findings[0].position[2]: found \"x\"");
        row("cut recording", {"cut.palpate"}, 2, "palpate: cut.palpate");
        row("both to stdout", {"s.palpate.json", "--csv", "-", "--markups", "-"}, 2, "palpate: findings: found - for");
        row("over itself", {"s.palpate.json", "--csv", "s.palpate.json"}, 2, "palpate: ");
        row("import alone", {"s.palpate.json", "--import", "m.mrk.json"}, 2,
            "palpate: findings: found one of --import");
        row("import into a recording", {"r.palpate", "--import", "m.mrk.json", "--out", "x.palpate.json"}, 2,
            "palpate: findings --import: found r.palpate, expected a scene");
        row("import and export", {"s.palpate.json", "--import", "m.mrk.json", "--out", "x.palpate.json", "--csv", "x"},
            2, "palpate: findings --import: found --csv");
        row("no markups", {"s.palpate.json", "--import", "no.txt", "--out", "x.palpate.json"}, 2, "palpate: no.txt: ");
        row("no folder", {"s.palpate.json", "--csv", "none/x.csv"}, 2, "palpate: none/x.csv");
    }
    void whatCannotBeIsOneLine()
    {
        QFETCH(QStringList, arguments);
        QFETCH(int, exitCode);
        QFETCH(QByteArray, error);
        const QByteArray before = read("s.palpate.json");
        const Outcome outcome = run(arguments);
        QCOMPARE(outcome.exitCode, exitCode);
        QVERIFY2(outcome.error.startsWith(error), outcome.error);
        QCOMPARE(outcome.error.count('\n'), 1);
        QCOMPARE(outcome.out, QByteArray());
        QCOMPARE(read("s.palpate.json"), before);
        QVERIFY(!QFile::exists(QString::fromStdString(m_folder.path("x.palpate.json").string())));
    }
};

PALPATE_TEST(FindingsCommand)
#include "tst_FindingsCommand.moc"
