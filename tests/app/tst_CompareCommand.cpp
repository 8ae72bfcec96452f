// SPDX-License-Identifier: BSD-3-Clause
#include "../meshio/Samples.h"
#include "Program.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <filesystem>
#include <span>

using namespace palpate;
using core::Vec3;
using test::Outcome;

/// Tests `session compare`: its numbers against `session measure`, the map's areas, and what it refuses.
class CompareCommand : public QObject
{
    Q_OBJECT

    test::Folder m_folder;

    Outcome run(const QStringList& arguments) const
    {
        return test::runProgram(QString::fromStdString(m_folder.path("").string()), arguments);
    }
    QJsonObject json(const QStringList& arguments) const
    {
        const Outcome outcome = run(arguments + QStringList{"--json", "-"});
        if (outcome.exitCode != 0) {
            qWarning("%s", outcome.error.constData());
        }
        return QJsonDocument::fromJson(outcome.out).object();
    }
    static QJsonObject measureIn(const QJsonObject& comparison, const QString& structure, const QString& measure)
    {
        for (const QJsonValue& one : comparison["measures"].toArray()) {
            if (one.toObject()["structure"] == structure && one.toObject()["measure"] == measure) {
                return one.toObject();
            }
        }
        return {};
    }
    static QJsonObject boxOf(const QJsonObject& measures)
    {
        return measures["structures"].toObject()["box"].toObject();
    }
    static QJsonObject surfaceIn(const QJsonObject& comparison)
    {
        return comparison["surfaces"].toArray().at(0).toObject();
    }
    void write(const char* name, const geometry::TriangleMesh& mesh) const
    {
        const meshio::MeshStructure one{std::filesystem::path(name).stem().string(), mesh, std::nullopt};
        QVERIFY(meshio::writeMesh(m_folder.path(name), std::span(&one, 1)).isOk());
    }
    /// Records a press on the upper face of the box that slides from one x to another. @param depth_mm  at most
    void record(const char* name, const char* scene, double from_x, double to_x, double depth_mm) const
    {
        constexpr int kTicks = 1000;
        QByteArray motion = "x,y,z\n";
        for (int i = 0; i < kTicks; ++i) {
            const double share = i / (kTicks - 1.0);
            const double depth = depth_mm * std::sin(share * 3.14159265358979);
            motion += QByteArray::number(from_x + share * (to_x - from_x)) + ",0.3," +
                      QByteArray::number(20.0 - depth, 'g', 12) + '\n';
        }
        m_folder.write("m.csv", motion.toStdString());
        const Outcome outcome = run({"replay", scene, "--motion", "m.csv", "--record", name});
        QVERIFY2(outcome.exitCode == 0, outcome.error.constData());
    }

  private Q_SLOTS:
    void initTestCase()
    {
        write("box.stl", test::box(Vec3(-40, -20, -20), Vec3(40, 20, 20), 8));
        write("ball.stl", test::sphere(12, 20.0));
        m_folder.write("s.palpate.json", R"({"version": 1, "structures": [
            {"mesh": "box.stl", "name": "box", "stiffness_N_per_mm": 1.0}]})");
        m_folder.write("other.palpate.json", R"({"version": 1, "structures": [
            {"mesh": "ball.stl", "name": "box", "stiffness_N_per_mm": 1.0}]})");
        m_folder.write("more.palpate.json", R"({"version": 1, "structures": [
            {"mesh": "box.stl", "name": "box", "stiffness_N_per_mm": 0.5},
            {"mesh": "ball.stl", "name": "ball", "layer": 1}]})");
        m_folder.write("soft.palpate.json", R"({"version": 1, "structures": [
            {"mesh": "box.stl", "name": "box", "stiffness_N_per_mm": 0.5}]})");
        record("a.palpate", "s.palpate.json", -20.0, 5.0, 4.0);
        record("b.palpate", "s.palpate.json", -5.0, 20.0, 4.24); // 6 % more
        record("c.palpate", "s.palpate.json", -5.0, 20.0, 4.32); // 8 % more
    }

    void numbersAreThoseOfMeasure()
    {
        const QJsonObject compared = json({"session", "compare", "a.palpate", "b.palpate"});
        const QJsonObject a = json({"session", "measure", "a.palpate"}), b = json({"session", "measure", "b.palpate"});
        QCOMPARE(compared["coverage_distance_mm"], a["coverage_distance_mm"]);
        int checked = 0;
        for (const QJsonValue& value : compared["measures"].toArray()) {
            const QJsonObject one = value.toObject();
            const QString structure = one["structure"].toString(), key = one["measure"].toString();
            const auto in = [&](const QJsonObject& all) {
                return structure.isEmpty() ? all : all["structures"].toObject()[structure].toObject();
            };
            if (in(a).contains(key) && in(a)[key].isDouble()) {
                QVERIFY2(one["first"] == in(a)[key] && one["second"] == in(b)[key], qPrintable(structure + key));
                ++checked;
            }
        }
        QCOMPARE(checked, 11 + 9); // the whole session and the box
        const QJsonObject press = boxOf(a)["press"].toObject();
        QCOMPARE(measureIn(compared, "box", "press_time_s")["first"], press["time_s"]);
        QCOMPARE(measureIn(compared, "box", "presses")["first"], press["phases"]);
        QCOMPARE(measureIn(compared, "box", "coverage_percent")["second"].toDouble(),
                 100.0 * boxOf(b)["coverage"].toDouble());
    }

    /// The hands overlap from x = -5 to 5; each covered part is in one of two areas.
    void areasAddUpToTheCoverage()
    {
        const QJsonObject compared = json({"session", "compare", "a.palpate", "b.palpate"});
        const QJsonObject surface = surfaceIn(compared);
        const double both = surface["both_mm2"].toDouble(), onlyA = surface["only_first_mm2"].toDouble(),
                     onlyB = surface["only_second_mm2"].toDouble();
        QVERIFY(both > 100.0 && onlyA > 100.0 && onlyB > 100.0);
        const auto covered = [this](const char* name) {
            return boxOf(json({"session", "measure", name}))["covered_area_mm2"].toDouble();
        };
        QVERIFY(std::abs(both + onlyA - covered("a.palpate")) < 1e-6);
        QVERIFY(std::abs(both + onlyB - covered("b.palpate")) < 1e-6);
        const QJsonObject swapped = json({"session", "compare", "b.palpate", "a.palpate"});
        QCOMPARE(surfaceIn(swapped)["only_first_mm2"].toDouble(), onlyB);
    }

    void marksForcesThatAHandCanTellApart()
    {
        for (const auto& [name, isNoticeable] : {std::pair("b.palpate", false), std::pair("c.palpate", true)}) {
            const QJsonObject peak = measureIn(json({"session", "compare", "a.palpate", name}), "", "peak_force_N");
            QCOMPARE(peak["noticeable"], QJsonValue(isNoticeable));
        }
        const QJsonObject compared = json({"session", "compare", "a.palpate", "c.palpate"});
        QVERIFY(measureIn(compared, "", "peak_depth_mm")["noticeable"].isNull()); // no force
        const Outcome outcome = run({"session", "compare", "a.palpate", "c.palpate"});
        QCOMPARE(outcome.exitCode, 0);
        QVERIFY2(outcome.out.contains("Whole session\n"), outcome.out.constData());
        const QByteArray peak = outcome.out.mid(outcome.out.indexOf("  Peak force [N]")).split('\n').front();
        QCOMPARE(peak.simplified(), QByteArray("Peak force [N] 4 4.32 0.32 +8 % noticeable"));
    }

    void refusesRecordingsOfDifferentSurfaces()
    {
        record("other.palpate", "other.palpate.json", 0.0, 1.0, 3.0);
        record("more.palpate", "more.palpate.json", 0.0, 1.0, 3.0);
        const auto refused = [this](const QStringList& files, const char* why) {
            const Outcome outcome = run(QStringList{"session", "compare"} + files);
            QCOMPARE(outcome.exitCode, 2);
            QCOMPARE(outcome.error.count('\n'), 1);
            QVERIFY2(outcome.error.contains(why), outcome.error.constData());
            QVERIFY(outcome.out.isEmpty());
        };
        refused({"a.palpate", "other.palpate"}, "(the surface of box is another one)");
        refused({"a.palpate", "more.palpate"}, "(ball was palpable only in the second)");
        refused({"more.palpate", "a.palpate"}, "(ball was palpable only in the first)");
        refused({"a.palpate", "a.palpate"}, "found the same recording twice, expected two");
        refused({"a.palpate", "m.csv"}, "m.csv");
        refused({"a.palpate", "b.palpate", "--json", "b.palpate"}, "b.palpate");
        QCOMPARE(run({"session", "measure", "b.palpate"}).exitCode, 0); // not overwritten
    }

    void namesConditionsThatWereNotTheSame()
    {
        record("soft.palpate", "soft.palpate.json", -20.0, 5.0, 4.0);
        const QJsonObject compared = json({"session", "compare", "a.palpate", "soft.palpate"});
        QCOMPARE(compared["conditions"].toArray(),
                 QJsonArray{"The stiffness of box was 1 N/mm in A and 0.5 N/mm in B."});
        QVERIFY(json({"session", "compare", "a.palpate", "b.palpate"})["conditions"].toArray().isEmpty());
    }
};

PALPATE_TEST(CompareCommand)
#include "tst_CompareCommand.moc"
