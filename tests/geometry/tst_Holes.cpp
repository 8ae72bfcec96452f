// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/geometry/Holes.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace palpate;
using namespace palpate::test;

/// Tests finding and closing the holes of a surface.
class Holes : public QObject
{
    Q_OBJECT

    static constexpr double kRadius_mm = 40.0;

    /// Returns a sphere with welded vertices, without the triangles above and below two heights.
    static geometry::TriangleMesh cutSphere(double top_mm, double bottom_mm, int fineness = 24)
    {
        geometry::TriangleMesh mesh = geometry::repair(sphere(fineness, kRadius_mm)).mesh;
        std::erase_if(mesh.triangles, [&](const geometry::Triangle& t) {
            return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) {
                return mesh.vertices[v].z() > top_mm || mesh.vertices[v].z() < bottom_mm;
            });
        });
        return mesh;
    }
    /// Returns a box without its top, whose rim has many vertices on straight lines.
    static geometry::TriangleMesh openBox(int fineness)
    {
        geometry::TriangleMesh mesh = geometry::repair(box(Vec3::Zero(), Vec3(30, 20, 10), fineness)).mesh;
        std::erase_if(mesh.triangles, [&](const geometry::Triangle& t) {
            return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return mesh.vertices[v].z() == 10.0; });
        });
        return mesh;
    }
    static double diameterAt_mm(double height_mm)
    {
        return 2.0 * std::sqrt(kRadius_mm * kRadius_mm - height_mm * height_mm);
    }

  private Q_SLOTS:
    void closedSurfaceHasNone()
    {
        QVERIFY(geometry::holesOf(geometry::repair(sphere(12, kRadius_mm)).mesh).empty());
        QVERIFY(geometry::holesOf({}).empty());
        QVERIFY(!geometry::withHolesClosed(geometry::repair(sphere(12, kRadius_mm)), 1000.0));
    }

    void borderOfASheetIsOne()
    {
        const auto holes = geometry::holesOf(geometry::repair(sheet(10.0, 4)).mesh);
        QCOMPARE(holes.size(), std::size_t{1});
        QCOMPARE(holes[0].vertices.size(), std::size_t{16});
        QVERIFY(std::abs(holes[0].across_mm - 20.0 * std::sqrt(2.0)) < 1e-9);
    }

    /// Two caps are cut off a sphere; the border of each is a ring around the axis.
    void holesComeBySize()
    {
        const auto holes = geometry::holesOf(cutSphere(35.0, -20.0));
        QCOMPARE(holes.size(), std::size_t{2});
        const auto diagonal_mm = [](double height_mm) { return std::sqrt(2.0) * diameterAt_mm(height_mm); };
        constexpr double kEdge_mm = 8.0; // the ring follows edges
        QVERIFY2(std::abs(holes[0].across_mm - diagonal_mm(20.0)) < kEdge_mm,
                 qPrintable(QString::number(holes[0].across_mm)));
        QVERIFY2(std::abs(holes[1].across_mm - diagonal_mm(35.0)) < kEdge_mm,
                 qPrintable(QString::number(holes[1].across_mm)));
    }

    /// Two missing triangles that share a corner are two holes.
    void holesThatMeetAtAVertexAreSeparate()
    {
        geometry::TriangleMesh mesh = geometry::repair(sphere(6, kRadius_mm)).mesh;
        const geometry::Triangle first = mesh.triangles.front();
        const auto opposite =
            std::find_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const geometry::Triangle& t) {
                return std::count_if(t.begin(), t.end(), [&](std::uint32_t v) {
                           return std::find(first.begin(), first.end(), v) != first.end();
                       }) == 1;
            });
        mesh.triangles.erase(opposite);
        mesh.triangles.erase(mesh.triangles.begin());
        const auto holes = geometry::holesOf(mesh);
        QCOMPARE(holes.size(), std::size_t{2});
        QCOMPARE(holes[0].vertices.size(), std::size_t{3});
        const auto closed = geometry::withHolesClosed(geometry::repair(mesh), 1000.0);
        QVERIFY(closed && closed->surface.report.isClosed());
        const double whole_mm3 = geometry::repair(sphere(6, kRadius_mm)).report.volume_mm3;
        QVERIFY(std::abs(closed->surface.report.volume_mm3 - whole_mm3) < 1e-9 * whole_mm3);
    }

    /// The volume of a sphere between two planes is that of the sphere without two caps.
    void closedSphereHasTheVolumeBetweenItsCuts()
    {
        const geometry::RepairedMesh open = geometry::repair(cutSphere(30.0, -20.0, 60));
        QVERIFY(!open.report.isClosed());
        const auto closed = geometry::withHolesClosed(open, 1000.0);
        QVERIFY(closed);
        QCOMPARE(closed->closed, std::size_t{2});
        const geometry::MeshReport& report = closed->surface.report;
        QVERIFY(report.isClosed());
        QCOMPARE(report.nonManifoldEdges, std::size_t{0});
        QCOMPARE(report.insideOutComponents, std::size_t{0});
        QCOMPARE(report.vertices, open.report.vertices);
        const auto cap_mm3 = [](double height_mm) {
            const double h = kRadius_mm - height_mm;
            return std::numbers::pi * h * h * (3.0 * kRadius_mm - h) / 3.0;
        };
        const double ball_mm3 = 4.0 / 3.0 * std::numbers::pi * std::pow(kRadius_mm, 3);
        const double expected_mm3 = ball_mm3 - cap_mm3(30.0) - cap_mm3(20.0);
        // The cuts follow edges of 1.2 mm on discs of 53 and 69 mm.
        QVERIFY2(std::abs(report.volume_mm3 / expected_mm3 - 1.0) < 0.03,
                 qPrintable(QString::number(report.volume_mm3)));
        // The cap of a nearly flat ring has about the area of its disc.
        const double discs_mm2 =
            std::numbers::pi / 4.0 * (std::pow(diameterAt_mm(30.0), 2) + std::pow(diameterAt_mm(20.0), 2));
        QVERIFY2(std::abs(closed->addedArea_mm2 / discs_mm2 - 1.0) < 0.1,
                 qPrintable(QString::number(closed->addedArea_mm2)));
    }

    void onlySmallHolesAreClosed()
    {
        const geometry::RepairedMesh open = geometry::repair(cutSphere(35.0, -20.0));
        const auto holes = geometry::holesOf(open.mesh);
        const auto closed = geometry::withHolesClosed(open, holes[1].across_mm);
        QVERIFY(closed && closed->closed == 1 && !closed->surface.report.isClosed());
        QCOMPARE(closed->largest_mm, holes[1].across_mm);
        QCOMPARE(geometry::holesOf(closed->surface.mesh).size(), std::size_t{1});
        QVERIFY(!geometry::withHolesClosed(open, 0.5 * holes[1].across_mm));
    }

    /// Three neighbouring vertices of the rim are on a line: a triangle of these would have no area and be removed. The
    /// rim of the last row has more edges than are spanned at once.
    void flatRimIsClosedExactly_data()
    {
        QTest::addColumn<int>("fineness");
        QTest::newRow("coarse") << 1;
        QTest::newRow("fine") << 8;
        QTest::newRow("very fine") << 110;
    }
    void flatRimIsClosedExactly()
    {
        QFETCH(int, fineness);
        const auto closed = geometry::withHolesClosed(geometry::repair(openBox(fineness)), 1000.0);
        QVERIFY(closed);
        QVERIFY(closed->surface.report.isClosed());
        QVERIFY(std::abs(closed->surface.report.volume_mm3 - 6000.0) < 1e-6);
        QVERIFY(std::abs(closed->addedArea_mm2 - 600.0) < 1e-6); // without overlap
    }

    /// A new triangle continues the values at the border.
    void valuesContinueOnTheCap()
    {
        geometry::TriangleMesh mesh = cutSphere(30.0, -100.0);
        geometry::MeshArray array{"Map", true, {}};
        for (const geometry::Triangle& t : mesh.triangles) {
            array.values.push_back(mesh.vertices[t[0]].z() > 20.0 ? 2.0F : 1.0F);
        }
        mesh.arrays.push_back(array);
        const geometry::RepairedMesh open = geometry::repair(mesh);
        const auto closed = geometry::withHolesClosed(open, 1000.0);
        QVERIFY(closed);
        const std::vector<float>& values = closed->surface.mesh.arrays[0].values;
        QCOMPARE(values.size(), closed->surface.mesh.triangles.size());
        for (std::size_t i = open.mesh.triangles.size(); i < values.size(); ++i) {
            QCOMPARE(values[i], 2.0F);
            QVERIFY(closed->surface.source[i] < mesh.triangles.size());
        }
    }
};

PALPATE_TEST(Holes)
#include "tst_Holes.moc"
