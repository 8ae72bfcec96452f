// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/geometry/Repair.h>
#include <palpate/geometry/SurfaceSection.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace palpate;
using namespace palpate::test;
using geometry::SectionContour;
using geometry::SectionPlane;

namespace {

std::vector<SectionContour> cut(const TriangleMesh& mesh, const SectionPlane& plane)
{
    const geometry::RepairedMesh surface = geometry::repair(mesh);
    return geometry::sectionOf(surface.mesh.vertices, surface.mesh.triangles, surface.twoSided, plane);
}

double areaOf(const std::vector<SectionContour>& contours)
{
    return geometry::areaOf(geometry::filled(contours));
}

/// Area by the shoelace formula, positive for contours with the inside on the left.
double shoelace(const std::vector<SectionContour>& contours)
{
    double sum = 0.0;
    for (const SectionContour& one : contours) {
        for (std::size_t i = 0; i < one.points.size(); ++i) {
            const Eigen::Vector2d &a = one.points[i], &b = one.points[(i + 1) % one.points.size()];
            sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
        }
    }
    return sum;
}

bool areClosed(const std::vector<SectionContour>& contours)
{
    return std::all_of(contours.begin(), contours.end(), [](const SectionContour& one) { return one.isClosed; });
}

SectionPlane level(double z)
{
    return SectionPlane::through(Vec3(0, 0, z), Vec3::UnitZ());
}

} // namespace

class SurfaceSection : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void areaOfASphereIsThatOfADiscWithinTheFacets_data()
    {
        QTest::addColumn<double>("distance_mm");
        QTest::addColumn<Vec3>("n");
        for (const double distance_mm : {0.0, 3.7, 18.0}) {
            QTest::addRow("axial %g", distance_mm) << distance_mm << Vec3(0, 0, 1);
            QTest::addRow("oblique %g", distance_mm) << distance_mm << Vec3(0.3, -0.8, 0.5);
        }
    }
    void areaOfASphereIsThatOfADiscWithinTheFacets()
    {
        QFETCH(double, distance_mm);
        QFETCH(Vec3, n);
        constexpr double kRadius_mm = 20.0;
        const TriangleMesh mesh = sphere(24, kRadius_mm);
        // The facets lie between the sphere and the largest sphere inside all of them.
        double inner_mm = kRadius_mm;
        for (const geometry::Triangle& t : mesh.triangles) {
            const Vec3 normal = (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                                    .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]])
                                    .normalized();
            inner_mm = std::min(inner_mm, std::abs(normal.dot(mesh.vertices[t[0]])));
        }
        QVERIFY(inner_mm > 0.98 * kRadius_mm);
        const auto contours = cut(mesh, SectionPlane::through(distance_mm * n.normalized(), n));
        QCOMPARE(contours.size(), std::size_t{1});
        QVERIFY(contours[0].isClosed);
        const double area_mm2 = areaOf(contours);
        const double most_mm2 = std::numbers::pi * (kRadius_mm * kRadius_mm - distance_mm * distance_mm);
        const double least_mm2 = std::numbers::pi * (inner_mm * inner_mm - distance_mm * distance_mm);
        QVERIFY2(area_mm2 < most_mm2 && area_mm2 > least_mm2, qPrintable(QString::number(area_mm2)));
        QVERIFY(std::abs(shoelace(contours) - area_mm2) < 1e-9 * area_mm2);
    }

    /// Planes through faces, edges and corners of a box of 10 x 10 x 10 mm, divided into 3 x 3 squares a side.
    void exactlyThroughVerticesStaysClosed()
    {
        const TriangleMesh mesh = box(Vec3::Zero(), Vec3(9, 9, 9), 3);
        for (const double z : {3.0, 6.0}) {
            const auto contours = cut(mesh, level(z));
            QCOMPARE(contours.size(), std::size_t{1});
            QVERIFY(areClosed(contours));
            QVERIFY(std::abs(areaOf(contours) - 81.0) < 1e-12);
        }
        // Through four edges of the box.
        const auto diagonal = cut(mesh, SectionPlane::through(Vec3(0, 0, 0), Vec3(1, -1, 0)));
        QVERIFY(areClosed(diagonal));
        QVERIFY(std::abs(areaOf(diagonal) - 81.0 * std::numbers::sqrt2) < 1e-9);
        // In the plane of two faces: the vertices count as above, so the box begins above the lower face and the plane
        // of the upper face cuts just below it.
        QVERIFY(cut(mesh, level(0.0)).empty());
        QVERIFY(std::abs(areaOf(cut(mesh, level(9.0))) - 81.0) < 1e-12);
        // Through one corner only.
        QVERIFY(areaOf(cut(mesh, SectionPlane::through(Vec3(0, 0, 0), Vec3(1, 1, 1)))) < 1e-12);
    }

    void outsideOfEverythingIsEmpty()
    {
        QVERIFY(cut(sphere(8, 5.0), level(5.1)).empty());
        QVERIFY(cut(TriangleMesh(), level(0.0)).empty());
        QVERIFY(geometry::filled({}).empty());
        QVERIFY(level(5.0).crosses({Vec3(-1, -1, 4), Vec3(1, 1, 5)}));
        QVERIFY(!level(5.1).crosses({Vec3(-1, -1, 4), Vec3(1, 1, 5)}));
        QVERIFY(!level(0.0).crosses(core::Box()));
    }

    void cavitiesStayEmptyAndInvertedSurfacesAreFilled()
    {
        TriangleMesh inner = box(Vec3(2, 2, 2), Vec3(7, 7, 7));
        const TriangleMesh outer = box(Vec3::Zero(), Vec3(9, 9, 9), 3);
        TriangleMesh organ = outer;
        append(organ, inner); // the same orientation: filled once
        QVERIFY(std::abs(areaOf(cut(organ, level(4.1))) - 81.0) < 1e-9);
        geometry::flip(inner);
        organ = outer;
        append(organ, inner);
        QVERIFY(std::abs(areaOf(cut(organ, level(4.1))) - (81.0 - 25.0)) < 1e-9);
        geometry::flip(organ);
        const auto inverted = cut(organ, level(4.1));
        QVERIFY(shoelace(inverted) < 0.0);
        QVERIFY(std::abs(areaOf(inverted) - (81.0 - 25.0)) < 1e-9);
    }

    void overlappingPartsAreFilledOnce()
    {
        TriangleMesh both = box(Vec3::Zero(), Vec3(9, 9, 9), 3);
        append(both, box(Vec3(5, 5, -1), Vec3(12, 12, 8)));
        const auto strips = geometry::filled(cut(both, level(4.1)));
        QVERIFY(std::abs(geometry::areaOf(strips) - (81.0 + 49.0 - 16.0)) < 1e-9);
        const SectionPlane plane = level(4.1);
        const auto contains = [&](double x, double y) {
            return std::any_of(strips.begin(), strips.end(),
                               [&](const auto& one) { return one.contains(plane.inPlane(Vec3(x, y, 4.1))); });
        };
        QVERIFY(contains(1, 1) && contains(7, 7) && contains(11, 11) && !contains(1, 11) && !contains(-1, 1));
    }

    void openSurfacesAreOutlinesOnly()
    {
        const auto line = cut(sheet(10.0, 4), SectionPlane::through(Vec3(0.1, 0, 0), Vec3::UnitX()));
        QCOMPARE(line.size(), std::size_t{1});
        QVERIFY(!line[0].isClosed);
        const double length_mm = (line[0].points.back() - line[0].points.front()).norm();
        QVERIFY(std::abs(length_mm - 20.0) < 1e-9);
        QVERIFY(geometry::filled(line).empty());
        // A tube: the line returns to its start, but the surface is open. A closed part beside it is filled.
        TriangleMesh tube = box(Vec3::Zero(), Vec3(9, 9, 9));
        std::erase_if(tube.triangles, [&](const geometry::Triangle& t) {
            return std::all_of(t.begin(), t.end(), [&](auto v) { return tube.vertices[v].z() == 0.0; });
        });
        append(tube, box(Vec3(20, 0, 0), Vec3(22, 2, 9)));
        const auto rings = cut(tube, level(4.1));
        QCOMPARE(rings.size(), std::size_t{2});
        const SectionContour& open = rings[0].isClosed ? rings[1] : rings[0];
        QVERIFY(!open.isClosed && open.points.front() == open.points.back());
        QVERIFY(std::abs(areaOf(rings) - 4.0) < 1e-9);
    }

    void cutsVerticesThatHaveMoved()
    {
        const geometry::RepairedMesh surface = geometry::repair(box(Vec3::Zero(), Vec3(9, 9, 9)));
        std::vector<Vec3> vertices = surface.mesh.vertices;
        for (Vec3& p : vertices) {
            p.x() *= 2.0;
        }
        const auto contours = geometry::sectionOf(vertices, surface.mesh.triangles, surface.twoSided, level(4.1));
        QVERIFY(std::abs(areaOf(contours) - 162.0) < 1e-9);
    }

    void coordinatesReturnToTheWorld()
    {
        const SectionPlane plane = SectionPlane::through(Vec3(100, -40, 7), Vec3(1, 2, -3));
        QVERIFY((plane.u_W.cross(plane.v_W) - plane.n_W).norm() < 1e-14);
        const Vec3 p = plane.inWorld({3.0, -4.0});
        QVERIFY(std::abs(plane.distance_mm(p)) < 1e-12);
        QVERIFY((plane.inPlane(p) - Eigen::Vector2d(3.0, -4.0)).norm() < 1e-12);
    }
};

PALPATE_TEST(SurfaceSection)
#include "tst_SurfaceSection.moc"
