// SPDX-License-Identifier: BSD-3-Clause
#include "Samples.h"
#include "TestRunner.h"

#include <algorithm>
#include <chrono>

using namespace palpate;

/// Compares the real meshes with the table in their README.
class Anatomy : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void everyMeshHasItsTriangles_data();
    void everyMeshHasItsTriangles();
    void facesOfTwoCornersAreLeftOut();
    void bodyIsReadAndRepairedSoon();
    void heartIsTurnedFromRas();
};

void Anatomy::everyMeshHasItsTriangles_data()
{
    QTest::addColumn<std::size_t>("structures");
    QTest::addColumn<std::size_t>("triangles");
    const auto row = [](const char* name, std::size_t structures, std::size_t triangles) {
        QTest::newRow(name) << structures << triangles;
    };
    row("liver-smooth.obj", 1, 4384);
    row("vh_f_liver_scene", 25, 61946);
    row("vh_f_knee_R", 28, 38644);
    row("vh_f_kidney_L.obj", 15, 72788);
    row("vh_f_body_large.vtp", 378, 1185119);
    row("arm-right.scapula.stl", 1, 28106);
    row("hat_spine.vtp", 1, 10738);
    row("carotids.stl", 1, 2289);
    row("aneurysm3d_surface.obj", 1, 6404);
    row("HeartOrientationMarker.vtp", 1, 28890);
    row("spl_left_superior_frontal_gyrus.vtp", 1, 40958);
}

void Anatomy::everyMeshHasItsTriangles()
{
    QFETCH(std::size_t, structures);
    QFETCH(std::size_t, triangles);
    PALPATE_SHARED_OR_SKIP(folder, "anatomy");
    const auto scene = meshio::loadScene(folder / QTest::currentDataTag());
    QVERIFY2(scene.isOk(), scene.status().message().c_str());
    QCOMPARE(scene.value().structures.size(), structures);
    QVERIFY(scene.value().losses.empty());
    std::size_t read = 0;
    for (const meshio::LoadedStructure& s : scene.value().structures) {
        const geometry::MeshReport& report = s.surface->report;
        read += report.inputTriangles;
        QCOMPARE(report.triangles, s.surface->mesh.triangles.size());
        QCOMPARE(report.inputTriangles, report.triangles + report.zeroAreaTriangles + report.duplicateTriangles);
    }
    QCOMPARE(read, triangles);
}

void Anatomy::facesOfTwoCornersAreLeftOut()
{
    PALPATE_SHARED_OR_SKIP(folder, "anatomy");
    const auto file = meshio::readMesh(folder / "CavaVeinAndHeart.obj");
    QVERIFY2(file.isOk(), file.status().message().c_str());
    QVERIFY(std::ranges::any_of(file.value().notes, [](const core::Message& note) {
        return note.english() == "1 face of fewer than 3 corners left out";
    }));
}

void Anatomy::bodyIsReadAndRepairedSoon()
{
    PALPATE_SHARED_OR_SKIP(folder, "anatomy");
    const auto start = std::chrono::steady_clock::now();
    const auto scene = meshio::loadScene(folder / "vh_f_body_large.vtp", {1000.0, {}});
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    QVERIFY2(scene.isOk(), scene.status().message().c_str());
    qInfo("1.19 M triangles in 378 structures: read and repaired in %.2f s", took.count());
    geometry::Box box;
    for (const meshio::LoadedStructure& s : scene.value().structures) {
        box.extend(s.surface->report.bounds);
    }
    QVERIFY((box.sizes() - core::Vec3(967, 1667, 329.1)).cwiseAbs().maxCoeff() < 1.0);
}

void Anatomy::heartIsTurnedFromRas()
{
    PALPATE_SHARED_OR_SKIP(folder, "anatomy");
    const auto file = meshio::readMesh(folder / "HeartOrientationMarker.vtp");
    QVERIFY2(file.isOk(), file.status().message().c_str());
    QCOMPARE(file.value().frame, meshio::FileFrame::Ras);
    // The bounding box in the file is −45.2 … 36.8, −55.3 … 55.8, −52.2 … 54.8.
    const core::Box box = file.value().structures[0].mesh.bounds();
    QVERIFY((box.min() - core::Vec3(-36.829, -55.813, -52.15)).cwiseAbs().maxCoeff() < 0.01);
}

PALPATE_TEST(Anatomy)
#include "tst_Anatomy.moc"
