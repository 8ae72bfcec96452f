// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/geometry/SurfaceExamination.h>

#include <cmath>

using namespace palpate;
using geometry::examine;

class SurfaceExamination : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void cleanSurfaceCrossesNowhere();
    void crossingSheetsAreCountedByHand();
    void overlappingBallsCrossWhereBruteForceSays();
    void gridsThatMeetEdgeOnEdgeCross();
    void boundIsKeptAndSaid();
    void wallOfABoxIsItsHeight();
    void wallOfAShellIsItsThickness();
    void openSurfaceHasNoWall();
    void farFromTheOriginIsTheSame();
};

void SurfaceExamination::cleanSurfaceCrossesNowhere()
{
    for (const auto& mesh :
         {test::sphere(8, 50.0), test::bumpySphere(12, 40.0, 0.1), test::box({0, 0, 0}, {1, 2, 3}, 4)}) {
        const auto found = examine(*test::indexed(mesh));
        QCOMPARE(found.crossingPairs, std::size_t{0});
        QCOMPARE(found.examinedTriangles, mesh.triangles.size());
        QVERIFY(!found.isPairLimitReached);
    }
}

void SurfaceExamination::crossingSheetsAreCountedByHand()
{
    // Two crossing triangles; a separate third, and a fourth that only touches the first with a corner.
    geometry::TriangleMesh mesh;
    mesh.vertices = {{-2, -1, 0}, {2, -1, 0}, {0, 2, 0}, {0, 0, -1},   {0, 0, 1},    {0, 5, 0.5},
                     {9, 9, 9},   {8, 9, 9},  {9, 8, 9}, {0, -0.5, 0}, {1, -0.5, 3}, {-1, -0.5, 3}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}};
    const auto found = examine(*test::indexed(mesh));
    QCOMPARE(found.crossingPairs, std::size_t{1});
}

void SurfaceExamination::overlappingBallsCrossWhereBruteForceSays()
{
    geometry::TriangleMesh mesh = test::sphere(5, 10.0);
    test::append(mesh, test::moved(test::sphere(4, 8.0), {7.123, 1.37, 0.731}));
    const auto surface = test::indexed(mesh);
    const auto inside = [&](const core::Vec3& p, const core::Vec3& q, const geometry::Triangle& t) {
        // Solves for the intersection point, a different method from the product's volumes.
        const core::Vec3 a = surface->vertex(t[0]), b = surface->vertex(t[1]), c = surface->vertex(t[2]);
        Eigen::Matrix3d m;
        m << b - a, c - a, p - q;
        const core::Vec3 x = m.inverse() * (p - a);
        return x[0] > 0.0 && x[1] > 0.0 && x[0] + x[1] < 1.0 && x[2] > 0.0 && x[2] < 1.0;
    };
    std::size_t expected = 0;
    for (std::uint32_t i = 0; i < surface->triangleCount(); ++i) {
        for (std::uint32_t j = i + 1; j < surface->triangleCount(); ++j) {
            const geometry::Triangle s = surface->triangle(i), t = surface->triangle(j);
            bool isShared = false, isCrossing = false;
            for (std::size_t k = 0; k < 3; ++k) {
                isShared = isShared || std::find(t.begin(), t.end(), s[k]) != t.end();
                isCrossing = isCrossing || inside(surface->vertex(s[k]), surface->vertex(s[(k + 1) % 3]), t) ||
                             inside(surface->vertex(t[k]), surface->vertex(t[(k + 1) % 3]), s);
            }
            expected += isCrossing && !isShared ? 1 : 0;
        }
    }
    QVERIFY(expected > 20);
    QCOMPARE(examine(*surface).crossingPairs, expected);
}

void SurfaceExamination::gridsThatMeetEdgeOnEdgeCross()
{
    geometry::TriangleMesh mesh = test::box({0, 0, 0}, {24, 24, 24}, 4);
    test::append(mesh, test::moved(mesh, {10, 10, 10})); // squares of 6 mm
    const auto found = examine(*test::indexed(mesh));
    QVERIFY(found.crossingPairs > 0);
    QVERIFY(std::abs(*found.thinnestWall_mm - 14.0) < 1e-9); // in the overlap
}

void SurfaceExamination::boundIsKeptAndSaid()
{
    geometry::TriangleMesh mesh = test::sphere(6, 10.0);
    test::append(mesh, test::moved(test::sphere(6, 10.0), {3.1, 0.7, 0.3}));
    geometry::ExaminationLimits bounds;
    bounds.pairs = 100;
    const auto found = examine(*test::indexed(mesh), bounds);
    QVERIFY(found.isPairLimitReached);
    QVERIFY(found.examinedTriangles < mesh.triangles.size());
}

void SurfaceExamination::wallOfABoxIsItsHeight()
{
    const auto found = examine(*test::indexed(test::box({-10, -20, 5}, {10, 20, 8}, 6)));
    QVERIFY(found.thinnestWall_mm.has_value());
    QVERIFY(std::abs(*found.thinnestWall_mm - 3.0) < 1e-9);
    QVERIFY(found.thinnestAt.z() == 5.0 || found.thinnestAt.z() == 8.0);
    QVERIFY(found.wallSamples > 100);
}

void SurfaceExamination::wallOfAShellIsItsThickness()
{
    geometry::TriangleMesh shell = test::sphere(24, 20.0);
    geometry::TriangleMesh cavity = test::sphere(24, 18.5);
    geometry::flip(cavity);
    test::append(shell, cavity);
    const auto found = examine(*test::indexed(shell));
    QVERIFY(found.thinnestWall_mm.has_value());
    // Facets of a ball are at most r (1 - cos(half an edge)) inside the ball: 0.02 mm here.
    QVERIFY2(std::abs(*found.thinnestWall_mm - 1.5) < 0.03, std::to_string(*found.thinnestWall_mm).c_str());
}

void SurfaceExamination::openSurfaceHasNoWall()
{
    QVERIFY(!examine(*test::indexed(test::sheet(10.0, 5))).thinnestWall_mm.has_value());
}

void SurfaceExamination::farFromTheOriginIsTheSame()
{
    const auto found = examine(*test::indexed(test::moved(test::box({0, 0, 0}, {30, 30, 2}, 5), {1e6, -1e6, 1e6})));
    QCOMPARE(found.crossingPairs, std::size_t{0});
    QVERIFY(std::abs(*found.thinnestWall_mm - 2.0) < 1e-8);
}

PALPATE_TEST(SurfaceExamination)
#include "tst_SurfaceExamination.moc"
