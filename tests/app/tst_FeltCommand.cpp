// SPDX-License-Identifier: BSD-3-Clause
#include "../meshio/Samples.h"
#include "../support/Shapes.h"
#include "Program.h"
#include "TestRunner.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>

using namespace palpate;
using core::Vec3;
using test::Outcome;

/// Tests `palpate felt`: which lumps are palpable.
class FeltCommand : public QObject
{
    Q_OBJECT

    test::Folder m_folder;

    Outcome run(const QStringList& arguments) const
    {
        return test::runProgram(QString::fromStdString(m_folder.path("").string()), QStringList{"felt"} + arguments);
    }
    QByteArray read(const char* name) const
    {
        QFile file(QString::fromStdString(m_folder.path(name).string()));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    void write(const char* name, const geometry::TriangleMesh& mesh) const
    {
        QByteArray text;
        for (const Vec3& v : mesh.vertices) {
            text +=
                QString(
                    QStringLiteral("v %1 %2 %3\n").arg(v.x(), 0, 'g', 12).arg(v.y(), 0, 'g', 12).arg(v.z(), 0, 'g', 12))
                    .toUtf8();
        }
        for (const geometry::Triangle& t : mesh.triangles) {
            text += QString(QStringLiteral("f %1 %2 %3\n").arg(t[0] + 1).arg(t[1] + 1).arg(t[2] + 1)).toUtf8();
        }
        QFile file(QString::fromStdString(m_folder.path(name).string()));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    }
    bool writeScene(const char* name, const QByteArray& lump) const
    {
        QFile file(QString::fromStdString(m_folder.path(name).string()));
        return file.open(QIODevice::WriteOnly) &&
               file.write(R"({"version": 1, "structures": [{"mesh": "organ.obj", "stiffness_N_per_mm": 0.2},)" + lump +
                          "]}") > 0;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        write("organ.obj", test::sphere(40, 80.0));
        write("lump.obj", test::moved(test::sphere(12, 10.0), Vec3(0, 0, 62)));
        write("away.obj", test::moved(test::sphere(8, 10.0), Vec3(0, 0, 162)));
        QVERIFY(writeScene("scene.json", R"({"mesh": "lump.obj", "stiffness_N_per_mm": 0.6})"));
    }

    void aLumpIsToldWithItsVerdicts()
    {
        const Outcome outcome = run({"scene.json", "--json", "felt.json", "--vtp", "felt.vtp"});
        QCOMPARE(outcome.exitCode, 0);
        QVERIFY2(outcome.out.contains("lump (3 times as stiff, from the tissues' stiffness), 8.0 mm below at least"),
                 outcome.out.constData());
        QVERIFY(outcome.out.contains("not by hand") && outcome.out.contains("plainly"));
        QVERIFY(outcome.out.contains("estimate for research and rehearsal"));
        const QJsonObject all = QJsonDocument::fromJson(read("felt.json")).object();
        const QJsonArray presses = all["lumps"].toArray().at(0)["press"].toArray();
        QCOMPARE(presses.size(), 4);
        QCOMPARE(presses.at(0)["verdict"].toString(), QStringLiteral("not by hand"));
        const QJsonArray best = presses.at(3)["best_p_mm"].toArray();
        QVERIFY(std::hypot(best.at(0).toDouble(), best.at(1).toDouble()) < 4.0 && best.at(2).toDouble() > 79.0);
        QVERIFY(read("felt.vtp").contains("FeltRatioHigh"));
    }

    void infoNamesTheVerdictsToo()
    {
        const Outcome outcome =
            test::runProgram(QString::fromStdString(m_folder.path("").string()), {"info", "scene.json"});
        QCOMPARE(outcome.exitCode, 0);
        QVERIFY2(outcome.out.contains("  lump: lump in organ: 3 times as stiff"), outcome.out.constData());
    }

    void ratioRadiusAndPressAreTaken()
    {
        const auto ratioAt = [&](const QStringList& options) {
            const Outcome outcome = run(QStringList{"scene.json", "--json", "r.json"} + options);
            const QJsonValue lump = QJsonDocument::fromJson(read("r.json")).object()["lumps"].toArray().at(0);
            return outcome.exitCode == 0 ? lump["press"].toArray().last()["ratio"].toDouble() : -1.0;
        };
        const double usual = ratioAt({"--press", "2"});
        QVERIFY(usual > 1.1 && usual < 1.2);
        QVERIFY(ratioAt({"--press", "2", "--ratio", "lump=10"}) > usual);
        QVERIFY(ratioAt({"--press", "4"}) > usual);
        QVERIFY(ratioAt({"--press", "2", "--radius", "2"}) < usual);
    }

    void whatIsLeftOutIsNamed()
    {
        QVERIFY(writeScene("two.json", R"({"mesh": "lump.obj", "inside": "organ", "young_ratio": 4.4},
                                          {"mesh": "away.obj", "inside": "organ"})"));
        const Outcome outcome = run({"two.json"});
        QCOMPARE(outcome.exitCode, 3);
        QVERIFY2(outcome.error.contains("away: left out, it lies outside organ"), outcome.error.constData());
        QVERIFY(outcome.out.contains("lump (4.4 times as stiff, as typed)"));
    }

    void badInputIsRefusedWithItsPlace_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("says");
        QTest::newRow("no lump") << QStringList{"organ.obj"} << "found no lump";
        QTest::newRow("ratio of nothing") << QStringList{"scene.json", "--ratio", "spleen=2"} << "spleen";
        QTest::newRow("ratio without a number") << QStringList{"scene.json", "--ratio", "lump"} << "expected NAME=R";
        QTest::newRow("ratio 0") << QStringList{"scene.json", "--ratio", "lump=0"} << "--ratio lump";
        QTest::newRow("ratio too large") << QStringList{"scene.json", "--ratio", "lump=10001"} << "at most 10000";
        QTest::newRow("radius 0") << QStringList{"scene.json", "--radius", "0"} << "--radius";
        QTest::newRow("radius too large") << QStringList{"scene.json", "--radius", "31"} << "at most 30 mm";
        QTest::newRow("press descends") << QStringList{"scene.json", "--press", "4,2"} << "ascending";
        QTest::newRow("press is no number") << QStringList{"scene.json", "--press", "0,x"} << "--press";
        QTest::newRow("no such file") << QStringList{"none.json"} << "none.json";
    }
    void badInputIsRefusedWithItsPlace()
    {
        QFETCH(const QStringList, arguments);
        QFETCH(const QString, says);
        const Outcome outcome = run(arguments + QStringList{"--json", "bad.json"});
        QCOMPARE(outcome.exitCode, 2);
        QVERIFY2(outcome.error.contains(says.toUtf8()), outcome.error.constData());
        QVERIFY(!QFile::exists(QString::fromStdString(m_folder.path("bad.json").string())));
    }
};

PALPATE_TEST(FeltCommand)
#include "tst_FeltCommand.moc"
