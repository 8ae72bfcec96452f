// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/geometry/Holes.h>

#include <algorithm>
#include <cmath>

using namespace palpate;
using namespace palpate::test;

/// Tests the search for holes in a surface.
class Holes : public QObject
{
    Q_OBJECT

    /// Returns a sphere of 40 mm radius without the triangles above a height.
    static geometry::TriangleMesh cutSphere(double top_mm, double bottom_mm)
    {
        geometry::TriangleMesh mesh = sphere(24, 40.0);
        std::erase_if(mesh.triangles, [&](const geometry::Triangle& t) {
            return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
                return mesh.vertices[v].z() > top_mm || mesh.vertices[v].z() < bottom_mm;
            });
        });
        return mesh;
    }

  private Q_SLOTS:
    void aClosedSurfaceHasNone()
    {
        QVERIFY(geometry::holesOf(sphere(12, 40.0)).empty());
        QVERIFY(geometry::holesOf({}).empty());
    }

    void theBorderOfASheetIsOne()
    {
        const auto holes = geometry::holesOf(sheet(10.0, 4));
        QCOMPARE(holes.size(), std::size_t{1});
        QCOMPARE(holes[0].edges, std::size_t{16});
        QVERIFY(std::abs(holes[0].across_mm - 20.0 * std::sqrt(2.0)) < 1e-9);
    }

    /// Two caps are cut off a sphere; the border of each is a ring around the axis.
    void twoHolesComeBySize()
    {
        const auto holes = geometry::holesOf(cutSphere(35.0, -20.0));
        QCOMPARE(holes.size(), std::size_t{2});
        const auto ring_mm = [](double height_mm) { return 2.0 * std::sqrt(2.0 * (1600.0 - height_mm * height_mm)); };
        constexpr double kEdge_mm = 8.0; // the ring follows edges
        QVERIFY2(std::abs(holes[0].across_mm - ring_mm(20.0)) < kEdge_mm,
                 qPrintable(QString::number(holes[0].across_mm)));
        QVERIFY2(std::abs(holes[1].across_mm - ring_mm(35.0)) < kEdge_mm,
                 qPrintable(QString::number(holes[1].across_mm)));
        QVERIFY(holes[0].edges > holes[1].edges);
    }
};

PALPATE_TEST(Holes)
#include "tst_Holes.moc"
