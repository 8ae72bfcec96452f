// SPDX-License-Identifier: BSD-3-Clause
#include "English.h"
#include "Masks.h"
#include "Samples.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/meshio/ShapeSurface.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

using namespace palpate;
using core::Vec3;
using meshio::SurfaceKind;

namespace {

std::shared_ptr<const geometry::RepairedMesh> repaired(const geometry::TriangleMesh& mesh)
{
    return std::make_shared<const geometry::RepairedMesh>(geometry::repair(mesh, geometry::Facing::AsGiven));
}

meshio::SceneStructure smoothed(double smoothing = meshio::kDefaultSmoothing)
{
    meshio::SceneStructure description;
    description.surface = SurfaceKind::Smoothed;
    description.smoothing = smoothing;
    return description;
}

} // namespace

class ShapeSurface : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void facetsStayAsTheyAre()
    {
        const auto asRead = repaired(test::maskSurface(test::ballMask(8.0, Vec3(1, 1, 3))));
        const meshio::ShapedSurface shaped = meshio::shapeSurface(asRead, {});
        QCOMPARE(shaped.surface.get(), asRead.get());
        QVERIFY(shaped.staircase.has_value());
        QVERIFY(!shaped.smoothing.has_value());
    }

    void noVertexMovesFartherThanHalfAVoxel()
    {
        const Vec3 voxel_mm(1, 1, 3);
        const auto asRead = repaired(test::maskSurface(test::ballMask(15.0, voxel_mm)));
        for (const double smoothing : {0.0, 0.5, 0.7, 1.0}) {
            const meshio::ShapedSurface shaped = meshio::shapeSurface(asRead, smoothed(smoothing));
            QCOMPARE(shaped.surface->mesh.vertices.size(), asRead->mesh.vertices.size());
            double most_mm = 0.0;
            for (std::size_t i = 0; i < asRead->mesh.vertices.size(); ++i) {
                const Vec3 move_mm = shaped.surface->mesh.vertices[i] - asRead->mesh.vertices[i];
                QVERIFY((move_mm.cwiseAbs().array() <= 0.5 * voxel_mm.array() + 1e-9).all());
                most_mm = std::max(most_mm, move_mm.norm());
            }
            QVERIFY(shaped.smoothing.has_value());
            QVERIFY(std::abs(shaped.smoothing->most_mm - most_mm) < 1e-9);
            QVERIFY(std::abs(shaped.smoothing->volumeAfter_mm3 - shaped.surface->report.volume_mm3) < 1e-9);
            QVERIFY(most_mm > 0.0);
        }
    }

    /// Far from the origin and in another unit the result is the same, although VTK's filter uses floats.
    void isTheSameEverywhere()
    {
        const auto mesh = test::maskSurface(test::ballMask(10.0, Vec3(1, 1, 3)));
        geometry::TriangleMesh far = mesh;
        const Vec3 by(1024.0 * 900, -512.0 * 1200, 2048.0 * 300);
        for (Vec3& p : far.vertices) {
            p += by;
        }
        const auto here = meshio::shapeSurface(repaired(mesh), smoothed());
        const auto there = meshio::shapeSurface(repaired(far), smoothed());
        QCOMPARE(here.surface->mesh.vertices.size(), there.surface->mesh.vertices.size());
        for (std::size_t i = 0; i < here.surface->mesh.vertices.size(); ++i) {
            QVERIFY((here.surface->mesh.vertices[i] + by - there.surface->mesh.vertices[i]).norm() < 1e-4);
        }
    }

    void withoutAStaircaseTheLimitIsHalfAnEdge()
    {
        const auto asRead = repaired(test::tetrahedron("t").mesh);
        const meshio::ShapedSurface shaped = meshio::shapeSurface(asRead, smoothed());
        QVERIFY(!shaped.staircase.has_value());
        QVERIFY(shaped.smoothing.has_value());
        QVERIFY(shaped.smoothing->limit_mm < 0.5 * 24.0 * std::sqrt(2.0));
        QVERIFY(shaped.smoothing->most_mm <= std::sqrt(3.0) * shaped.smoothing->limit_mm + 1e-9);
    }

    void sceneFieldsAreKept()
    {
        const test::Folder folder;
        const std::vector<meshio::MeshStructure> ball{
            {"ball", test::maskSurface(test::ballMask(8.0, Vec3(1, 1, 3))), std::nullopt}};
        QVERIFY(meshio::writeMesh(folder.path("ball.stl"), ball).isOk());
        const auto file = folder.write("s.palpate.json", R"({"version": 1, "structures": [{"mesh": "ball.stl",
            "surface": "smoothed", "smoothing": 0.4, "outwards": true, "close_holes_mm": 25}]})");
        const auto scene = meshio::readScene(file);
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        const meshio::SceneStructure& one = scene.value().structures.front();
        QVERIFY(one.surface == SurfaceKind::Smoothed && one.smoothing == 0.4 && one.outwards && one.extra.empty());
        QCOMPARE(one.closeHoles_mm, 25.0);
        QVERIFY(meshio::writeScene(folder.path("t.palpate.json"), scene.value()).isOk());
        const auto again = meshio::readScene(folder.path("t.palpate.json"));
        QVERIFY(again.isOk());
        const meshio::SceneStructure& same = again.value().structures.front();
        QVERIFY(same.surface == SurfaceKind::Smoothed && same.smoothing == 0.4 && same.outwards);
        QCOMPARE(same.closeHoles_mm, 25.0);

        const auto loaded = meshio::loadScene(file);
        QVERIFY2(loaded.isOk(), loaded.status().message().c_str());
        QVERIFY(loaded.value().structures.front().smoothing.has_value());
        QVERIFY(test::mentions(loaded.value().warnings, "staircase of about 1 × 1 × 3 mm voxels"));
        QVERIFY(test::mentions(loaded.value().warnings, "smoothed: vertices moved by at most "));
    }

    void whatIsNotSaidIsNotWritten()
    {
        const test::Folder folder;
        meshio::SceneFile scene;
        scene.structures.emplace_back();
        scene.structures.back().mesh = folder.path("a.stl");
        QVERIFY(meshio::writeScene(folder.path("s.palpate.json"), scene).isOk());
        const std::string text = test::fileBytes(folder.path("s.palpate.json"));
        for (const char* field : {"surface", "smoothing", "crease_deg", "outwards", "close_holes_mm"}) {
            QVERIFY2(text.find(field) == std::string::npos, field);
        }
    }

    void wrongFieldsAreNamed_data()
    {
        QTest::addColumn<std::string>("field");
        QTest::addColumn<std::string>("complaint");
        QTest::newRow("surface") << std::string(R"("surface": "waxed")")
                                 << std::string("structures[0].surface: found \"waxed\", expected one of facets, "
                                                "smooth, smoothed, smoothed and smooth");
        QTest::newRow("smoothing") << std::string(R"("smoothing": 1.5)")
                                   << std::string("structures[0].smoothing: found 1.5");
        QTest::newRow("outwards") << std::string(R"("outwards": 1)") << std::string("structures[0].outwards");
        QTest::newRow("holes") << std::string(R"("close_holes_mm": -1)")
                               << std::string("structures[0].close_holes_mm: found -1");
    }
    void wrongFieldsAreNamed()
    {
        QFETCH(std::string, field);
        QFETCH(std::string, complaint);
        const test::Folder folder;
        const auto file =
            folder.write("s.palpate.json", R"({"version": 1, "structures": [{"mesh": "a.stl", )" + field + "}]}");
        const auto scene = meshio::readScene(file);
        QVERIFY(!scene.isOk());
        QVERIFY2(scene.status().message().find(complaint) != std::string::npos, scene.status().message().c_str());
    }

    void curvesFacetsOnRequest()
    {
        const test::Folder folder;
        const std::vector<meshio::MeshStructure> ball{{"ball", test::sphere(4, 20.0), std::nullopt}};
        QVERIFY(meshio::writeMesh(folder.path("ball.vtp"), ball).isOk());
        const auto load = [&folder](const std::string& fields) {
            const auto file = folder.write("s.palpate.json",
                                           R"({"version": 1, "structures": [{"mesh": "ball.vtp", )" + fields + "}]}");
            const auto loaded = meshio::loadScene(file);
            return loaded.isOk() ? loaded.value() : meshio::LoadedScene();
        };
        const meshio::LoadedScene facets = load(R"("surface": "facets")"), curved = load(R"("surface": "smooth")"),
                                  sharp = load(R"("surface": "smooth", "crease_deg": 5)"),
                                  both = load(R"("surface": "smoothed and smooth", "smoothing": 0)");
        QVERIFY(!facets.structures.front().curving);
        QCOMPARE(curved.structures.front().curving->before, std::size_t{320});
        QCOMPARE(curved.structures.front().curving->triangles,
                 curved.structures.front().surface->mesh.triangles.size());
        QVERIFY(test::mentions(curved.warnings, "curved facets: "));
        const double truth = 4.0 / 3.0 * std::numbers::pi * 8000.0;
        const auto error = [truth](const meshio::LoadedScene& scene) {
            return std::abs(scene.structures.front().surface->report.volume_mm3 / truth - 1.0);
        };
        QVERIFY2(error(facets) > 0.02 && error(curved) < 1e-3, qPrintable(QString::number(error(curved))));
        QVERIFY(test::mentions(sharp.warnings, "no facet is curved"));
        QCOMPARE(sharp.structures.front().surface->mesh.triangles.size(), std::size_t{320});
        QVERIFY(both.structures.front().smoothing && both.structures.front().curving);
        QCOMPARE(curved.scene.structures.front().crease_deg, 40.0);
        QCOMPARE(sharp.scene.structures.front().crease_deg, 5.0);
        QVERIFY(meshio::writeScene(folder.path("t.palpate.json"), sharp.scene).isOk());
        const auto again = meshio::readScene(folder.path("t.palpate.json"));
        QVERIFY(again.isOk() && again.value().structures.front().crease_deg == 5.0);
        QVERIFY(again.value().structures.front().surface == SurfaceKind::Smooth);
    }

    void optionsTurnAndSmoothWhatIsRead()
    {
        const test::Folder folder;
        std::vector<meshio::MeshStructure> both{
            {"ball", test::maskSurface(test::ballMask(8.0, Vec3(1, 1, 1))), std::nullopt},
            test::tetrahedron("t", Vec3(100, 0, 0))};
        for (meshio::MeshStructure& one : both) {
            geometry::flip(one.mesh);
        }
        QVERIFY(meshio::writeMesh(folder.path("two.vtp"), both).isOk());
        meshio::ReadOptions options;
        const auto asItIs = meshio::loadScene(folder.path("two.vtp"), options);
        options.turnsOutwards = true;
        options.isSmoothed = true;
        const auto changed = meshio::loadScene(folder.path("two.vtp"), options);
        QVERIFY(asItIs.isOk() && changed.isOk());
        for (std::size_t i = 0; i < 2; ++i) {
            const meshio::LoadedStructure &before = asItIs.value().structures[i],
                                          &after = changed.value().structures[i];
            QVERIFY(before.surface->report.volume_mm3 < 0.0 && after.surface->report.volume_mm3 > 0.0);
            QCOMPARE(after.surface->report.insideOutComponents, std::size_t{0});
            QVERIFY(!before.smoothing && after.smoothing);
            QVERIFY(after.description.outwards && after.description.surface == SurfaceKind::Smoothed);
            QVERIFY(after.asRead->report.volume_mm3 < 0.0); // the original surface is kept
        }
    }

    /// A tetrahedron without one of its faces, inside out, becomes the whole one.
    void closesHolesOnRequest()
    {
        const test::Folder folder;
        std::vector<meshio::MeshStructure> one{test::tetrahedron("t", Vec3(100, 0, 0))};
        const double whole_mm3 = geometry::repair(one.front().mesh).report.volume_mm3;
        geometry::flip(one.front().mesh);
        one.front().mesh.triangles.pop_back();
        QVERIFY(meshio::writeMesh(folder.path("t.vtp"), one).isOk());
        meshio::ReadOptions options;
        options.turnsOutwards = true;
        options.closeHoles_mm = 10.0;
        const auto open = meshio::loadScene(folder.path("t.vtp"), options);
        QVERIFY(open.isOk());
        QVERIFY(!open.value().structures[0].closing && !open.value().structures[0].surface->report.isClosed());
        options.closeHoles_mm = 50.0;
        const auto closed = meshio::loadScene(folder.path("t.vtp"), options);
        QVERIFY(closed.isOk());
        const meshio::LoadedStructure& after = closed.value().structures[0];
        QVERIFY(after.surface->report.isClosed());
        QVERIFY(std::abs(after.surface->report.volume_mm3 - whole_mm3) < 1e-6 * whole_mm3);
        QVERIFY(after.closing && after.closing->holes == 1);
        QVERIFY(!after.asRead->report.isClosed()); // the original surface is kept
        QVERIFY(test::mentions(closed.value().warnings, "t: 1 hole of "));
    }
};

PALPATE_TEST(ShapeSurface)
#include "tst_ShapeSurface.moc"
