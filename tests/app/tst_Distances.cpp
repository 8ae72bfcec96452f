// SPDX-License-Identifier: BSD-3-Clause
#include "../meshio/Samples.h"
#include "Program.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/meshio/SceneFile.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <span>

using namespace palpate;
using core::Vec3;
using test::Outcome;

/// Tests `info --distances`.
class Distances : public QObject
{
    Q_OBJECT

    test::Folder m_folder;

    Outcome run(const QStringList& arguments) const
    {
        return test::runProgram(QString::fromStdString(m_folder.path("").string()), arguments);
    }
    void write(const char* name, const geometry::TriangleMesh& mesh) const
    {
        const meshio::MeshStructure one{std::filesystem::path(name).stem().string(), mesh, std::nullopt};
        QVERIFY(meshio::writeMesh(m_folder.path(name), std::span(&one, 1)).isOk());
    }
    QJsonObject distances(const QStringList& files, int file = 0) const
    {
        const Outcome outcome = run(QStringList{"info", "--distances", "--json"} + files);
        return QJsonDocument::fromJson(outcome.out).array().at(file).toObject()["distances"].toObject();
    }
    static QJsonObject entry(const QJsonObject& table, const char* list, const char* key, const QString& name)
    {
        for (const auto& one : table[list].toArray()) {
            if (one.toObject()[key].toString() == name) {
                return one.toObject();
            }
        }
        return {};
    }

  private Q_SLOTS:
    void initTestCase()
    {
        write("liver.stl", test::box(Vec3(-50, -50, -50), Vec3(50, 50, 50), 4));
        write("tumour.stl", test::box(Vec3(-5, -5, 30), Vec3(5, 5, 40), 2));
        write("vessel.stl", test::box(Vec3(-20, -2, 23), Vec3(20, 2, 27), 2));
        write("spleen.stl", test::box(Vec3(80, 0, 0), Vec3(90, 10, 10), 1));
        geometry::TriangleMesh open = test::box(Vec3(100, 0, 0), Vec3(110, 10, 10), 1);
        open.triangles.pop_back();
        write("kidney.stl", open);
    }

    void tellsWhereALumpIs()
    {
        const Outcome outcome = run({"info", "--distances", "liver.stl", "tumour.stl", "vessel.stl"});
        QCOMPARE(outcome.exitCode, 0);
        QVERIFY2(outcome.out.contains("size: tumour: volume 1 ml (a ball of 12.41 mm), area 6 cm²"),
                 outcome.out.constData());
        QVERIFY(outcome.out.contains("distance: tumour to vessel: 3 mm, from ("));
        QVERIFY(outcome.out.contains("distance: tumour to liver: 0 mm, tumour lies inside, 10 mm from the surface"));
        QVERIFY(outcome.out.contains("margin: tumour to vessel: < 5 mm: "));
        QVERIFY(!outcome.out.contains("distance: liver to vessel"));
        QVERIFY(!run({"info", "liver.stl", "tumour.stl"}).out.contains("distance:"));
    }

    void jsonHasTheNumbers()
    {
        const QJsonObject table = distances({"liver.stl", "tumour.stl", "vessel.stl"}, 1);
        const QJsonObject size = entry(table, "sizes", "name", "tumour");
        QCOMPARE(size["volume_mm3"].toDouble(), 1000.0);
        QCOMPARE(size["area_mm2"].toDouble(), 600.0);
        QVERIFY(size["volume_note"].isNull());
        QVERIFY(std::abs(size["ball_diameter_mm"].toDouble() - std::cbrt(6000.0 / M_PI)) < 1e-9);
        const QJsonObject vessel = entry(table, "nearest", "second", "vessel");
        QCOMPARE(vessel["first"].toString(), QString("tumour"));
        QCOMPARE(vessel["relation"].toString(), QString("apart"));
        QVERIFY(std::abs(vessel["distance_mm"].toDouble() - 3.0) < 1e-6);
        QVERIFY(std::abs(vessel["first_mm"].toArray().at(2).toDouble() - 30.0) < 1e-6);
        QVERIFY(std::abs(vessel["second_mm"].toArray().at(2).toDouble() - 27.0) < 1e-6);
        const QJsonObject liver = entry(table, "nearest", "second", "liver");
        QCOMPARE(liver["relation"].toString(), QString("inside"));
        QCOMPARE(liver["distance_mm"].toDouble(), 0.0);
        QVERIFY(std::abs(liver["surface_mm"].toDouble() - 10.0) < 1e-6);
        const QJsonObject margin = entry(table, "margins", "structure", "liver");
        QCOMPARE(margin["inside_share"].toDouble(), 1.0);
        QCOMPARE(margin["area_shares"].toArray().size(), 3);
        QCOMPARE(table["margins"].toArray().size(), 2);
    }

    void tapesOfASceneAreListed()
    {
        meshio::SceneFile scene;
        scene.structures.resize(1);
        scene.structures[0].mesh = m_folder.path("tumour.stl");
        scene.structures[0].name = "tumour";
        scene.tapes = {{"Tape 1", Vec3(0, 0, 0), Vec3(3, 4, 0), "tumour", {}, {}}};
        QVERIFY(meshio::writeScene(m_folder.path("case.palpate.json"), scene).isOk());
        const Outcome outcome = run({"info", "--distances", "case.palpate.json"});
        QVERIFY2(outcome.out.contains("  tape: Tape 1: 5 mm, from tumour at (0, 0, 0) to (3, 4, 0)\n"),
                 outcome.out.constData());
        const QJsonObject table = distances({"case.palpate.json"});
        QCOMPARE(table["tapes"].toArray().at(0).toObject()["length_mm"].toDouble(), 5.0);
    }

    void withoutLumpsEachTwoAreMeasured()
    {
        const QJsonObject table = distances({"liver.stl", "spleen.stl", "kidney.stl"});
        QCOMPARE(table["nearest"].toArray().size(), 3);
        QVERIFY(table["margins"].toArray().isEmpty());
        QVERIFY(std::abs(entry(table, "nearest", "second", "spleen")["distance_mm"].toDouble() - 30.0) < 1e-6);
        const QJsonObject open = entry(table, "sizes", "name", "kidney");
        QVERIFY(open["volume_mm3"].isNull());
        QVERIFY(open["volume_note"].toString().contains("open edges: 3"));
        QVERIFY(run({"info", "--distances", "kidney.stl"}).out.contains("no volume: no part is closed"));
    }

    void bandsAreEdited()
    {
        const Outcome outcome = run({"info", "--distances", "--bands", "2.5,4,8", "tumour.stl", "vessel.stl"});
        QCOMPARE(outcome.exitCode, 0);
        QVERIFY2(outcome.out.contains("< 2.5 mm: 0 %, 2.5 to 4 mm: "), outcome.out.constData());
        for (const char* wrong : {"5,5", "10,5", "0,5", "a", "5,", ""}) {
            const Outcome bad = run({"info", "--distances", "--bands", wrong, "tumour.stl"});
            QVERIFY2(bad.exitCode == 2, wrong);
            QVERIFY2(bad.error.contains("--bands"), bad.error.constData());
        }
        QVERIFY(run({"info", "--bands", "5", "tumour.stl"}).exitCode != 0);
    }
};

PALPATE_TEST(Distances)
#include "tst_Distances.moc"
