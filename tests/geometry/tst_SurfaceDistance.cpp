// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"
#include "Trials.h"

#include <palpate/geometry/SurfaceDistance.h>
#include <palpate/geometry/SurfaceMargin.h>

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <vector>

using namespace palpate;
using namespace palpate::test;
using geometry::nearestPoint;
using geometry::Relation;
using geometry::SurfaceIndex;
using geometry::surfaceMargin;

namespace {

using Real = long double;
using RealVector = Eigen::Matrix<Real, 3, 1>;
using RealTriangle = std::array<RealVector, 3>;

/// Corners of the faces of a triangle: three corners, three edges, the triangle.
const std::array<std::vector<int>, 7> kFaces{{{0}, {1}, {2}, {0, 1}, {1, 2}, {2, 0}, {0, 1, 2}}};

/// Distance of two triangles in long double, independent of the method under test: the least distance of the affine
/// hulls of each pair of faces whose solution lies in both faces.
Real oracle(const RealTriangle& a, const RealTriangle& b)
{
    Real least = std::numeric_limits<Real>::infinity();
    for (const auto& f : kFaces) {
        for (const auto& g : kFaces) {
            const auto n = static_cast<int>(f.size()) - 1, m = static_cast<int>(g.size()) - 1;
            const RealVector between = b[g[0]] - a[f[0]];
            Eigen::Matrix<Real, 3, Eigen::Dynamic> directions(3, n + m);
            for (int i = 0; i < n; ++i) {
                directions.col(i) = a[f[i + 1]] - a[f[0]];
            }
            for (int i = 0; i < m; ++i) {
                directions.col(n + i) = -(b[g[i + 1]] - b[g[0]]);
            }
            Eigen::Matrix<Real, Eigen::Dynamic, 1> x(n + m);
            if (n + m > 0) {
                const Eigen::ColPivHouseholderQR<Eigen::Matrix<Real, 3, Eigen::Dynamic>> solver(directions);
                if (solver.rank() < std::min(3, n + m)) {
                    continue; // parallel or without area: smaller faces have the same distance
                }
                x = solver.solve(between);
            }
            const auto isIn = [](const auto& part) { return (part.array() >= 0).all() && part.sum() <= 1; };
            if (isIn(x.head(n)) && isIn(x.tail(m))) {
                least = std::min(least, (directions * x - between).norm());
            }
        }
    }
    return least;
}

std::vector<RealTriangle> trianglesOf(const SurfaceIndex& surface)
{
    std::vector<RealTriangle> all;
    for (std::uint32_t i = 0; i < surface.triangleCount(); ++i) {
        const geometry::Triangle t = surface.triangle(i);
        all.push_back(
            {surface.vertex(t[0]).cast<Real>(), surface.vertex(t[1]).cast<Real>(), surface.vertex(t[2]).cast<Real>()});
    }
    return all;
}

Real bruteForce(const SurfaceIndex& a, const SurfaceIndex& b)
{
    Real least = std::numeric_limits<Real>::infinity();
    const auto others = trianglesOf(b);
    for (const RealTriangle& one : trianglesOf(a)) {
        for (const RealTriangle& other : others) {
            least = std::min(least, oracle(one, other));
        }
    }
    return least;
}

/// Separate triangles at random places in a ball, each stretched by the given factors along random axes.
TriangleMesh scattered(std::mt19937& random, int count, double radius_mm, const Vec3& centre, double width)
{
    std::normal_distribution<double> normal;
    const auto point = [&] { return Vec3(normal(random), normal(random), normal(random)); };
    TriangleMesh mesh;
    for (int i = 0; i < count; ++i) {
        const Vec3 place = centre + radius_mm * point().normalized();
        const Vec3 along = 2.0 * point(), across = width * point();
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {place, place + along, place + 0.3 * along + across});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

geometry::SurfaceDistance between(const TriangleMesh& a, const TriangleMesh& b)
{
    return geometry::surfaceDistance(*indexed(a), *indexed(b)).value();
}

} // namespace

/// Tests surfaceDistance, nearestPoint and surfaceMargin.
class SurfaceDistance : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void equalsBruteForce_data()
    {
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("apart_mm");
        for (const double width : {2.0, 1e-2, 1e-4}) {
            for (const double apart_mm : {0.0, 8.0, 30.0, 500.0}) {
                QTest::addRow("width %g, %g mm apart", width, apart_mm) << width << apart_mm;
            }
        }
    }
    /// Random separate triangles, from compact ones to needles.
    void equalsBruteForce()
    {
        QFETCH(double, width);
        QFETCH(double, apart_mm);
        std::mt19937 random(17);
        for (int trial = 0; trial < trials(4); ++trial) {
            const auto a = indexed(scattered(random, 40, 10.0, Vec3(3, -200, 90), width));
            const auto b = indexed(scattered(random, 25, 10.0, Vec3(3 + apart_mm, -200, 90), width));
            const auto found = geometry::surfaceDistance(*a, *b);
            QVERIFY(found.has_value());
            const auto expected = static_cast<double>(bruteForce(*a, *b));
            QVERIFY2(std::abs(found->surface_mm - expected) < 1e-9,
                     qPrintable(QString("found %1, expected %2").arg(found->surface_mm, 0, 'g', 17).arg(expected)));
            QVERIFY(std::abs((found->onFirst - found->onSecond).norm() - expected) < 1e-9);
            QVERIFY(std::abs(nearestPoint(*a, found->onFirst)->distance_mm) < 1e-9);
            QVERIFY(std::abs(nearestPoint(*b, found->onSecond)->distance_mm) < 1e-9);
        }
    }

    /// Grids with parallel edges, faces and shared planes: every pair of facets is degenerate.
    void equalsBruteForceOnParallelFaces()
    {
        const auto one = indexed(box(Vec3(0, 0, 0), Vec3(4, 4, 4), 3));
        for (const Vec3& by : {Vec3(6, 0, 0), Vec3(4.5, 4.5, 0), Vec3(5, 5, 5), Vec3(4.25, 1, 1), Vec3(0, 0, -7)}) {
            const auto other = indexed(box(by, by + Vec3(4, 4, 4), 2));
            const auto found = geometry::surfaceDistance(*one, *other);
            QVERIFY(std::abs(found->distance_mm - static_cast<double>(bruteForce(*one, *other))) < 1e-9);
            QCOMPARE(found->relation, Relation::Apart);
        }
    }

    /// Nearly parallel edges that pass each other: their closest points must not be guessed.
    void keepsTheAccuracyOfNearlyParallelEdges()
    {
        for (const double turn : {1e-3, 1e-6, 1e-8}) {
            const TriangleMesh a{{Vec3(-50, 0, 0), Vec3(50, 0, 0), Vec3(0, -1, -9)}, {{0, 1, 2}}};
            const TriangleMesh b{{Vec3(-40, -40 * turn, 1e-3), Vec3(45, 45 * turn, 1e-3), Vec3(0, 1, 9)}, {{0, 1, 2}}};
            const auto ia = indexed(a), ib = indexed(b);
            const auto found = geometry::surfaceDistance(*ia, *ib);
            QVERIFY(std::abs(found->distance_mm - static_cast<double>(bruteForce(*ia, *ib))) < 1e-9);
        }
    }

    /// Two spheres with vertices that face each other on the line of the centres.
    void measuresTwoSpheres()
    {
        const TriangleMesh sphere40 = sphere(20, 40.0), sphere10 = sphere(12, 10.0);
        const Vec3 tip = sphere40.vertices[0].normalized();
        const auto found =
            between(sphere40, moved(transformed(sphere10, [](const Vec3& p) { return Vec3(-p); }), 53.5 * tip));
        QCOMPARE(found.relation, Relation::Apart);
        QVERIFY(std::abs(found.distance_mm - 3.5) < 1e-9);
        QVERIFY((found.onFirst - 40.0 * tip).norm() < 1e-9);
        QVERIFY((found.onSecond - 43.5 * tip).norm() < 1e-9);
    }

    void swappingTheSurfacesSwapsThePoints()
    {
        const TriangleMesh a = bumpySphere(12, 20.0, 0.1), b = moved(bumpySphere(20, 15.0, 0.05), Vec3(41, 7, -3));
        const auto ab = between(a, b), ba = between(b, a);
        QCOMPARE(ab.distance_mm, ba.distance_mm);
        QVERIFY((ab.onFirst - ba.onSecond).norm() < 1e-9 && (ab.onSecond - ba.onFirst).norm() < 1e-9);
    }

    void crossingIsZeroAtAPlaceOnBoth()
    {
        const auto organ = indexed(sphere(20, 40.0)), lump = indexed(moved(sphere(8, 10.0), Vec3(38, 3, 2)));
        const auto found = geometry::surfaceDistance(*organ, *lump);
        QCOMPARE(found->relation, Relation::Crossing);
        QCOMPARE(found->distance_mm, 0.0);
        QCOMPARE(found->surface_mm, 0.0);
        QVERIFY(nearestPoint(*organ, found->onFirst)->distance_mm < 1e-9);
        QVERIFY(nearestPoint(*lump, found->onFirst)->distance_mm < 1e-9);
        QCOMPARE(between(box(Vec3(0, 0, 0), Vec3(1, 1, 1)), box(Vec3(1, 0, 0), Vec3(2, 1, 1), 3)).relation,
                 Relation::Crossing); // a common face
        QCOMPARE(between(sphere(8, 10.0), sphere(8, 10.0)).relation, Relation::Crossing);
    }

    void insideIsZeroWithItsCover()
    {
        const TriangleMesh organ = box(Vec3(-20, -20, -20), Vec3(20, 20, 20), 4);
        const TriangleMesh lump = box(Vec3(-2, -2, 12), Vec3(2, 2, 16), 2);
        const auto found = between(lump, organ);
        QCOMPARE(found.relation, Relation::Inside);
        QCOMPARE(found.distance_mm, 0.0);
        QVERIFY(std::abs(found.surface_mm - 4.0) < 1e-9);
        QVERIFY(std::abs(found.onSecond.z() - 20.0) < 1e-9);
        QCOMPARE(between(organ, lump).relation, Relation::Around);
        TriangleMesh two = lump; // only the second part is inside
        for (Vec3& p : two.vertices) {
            p.x() += 60.0;
        }
        append(two, lump);
        QCOMPARE(between(two, organ).relation, Relation::Inside);
        TriangleMesh open = organ;
        open.triangles.pop_back();
        QCOMPARE(between(lump, open).relation, Relation::Apart);
        QVERIFY(std::abs(between(lump, open).distance_mm - 4.0) < 1e-9);
        TriangleMesh shell = box(Vec3(-30, -30, -30), Vec3(30, 30, 30), 2); // an organ around another one and a cavity
        TriangleMesh cavity = box(Vec3(-10, -10, -10), Vec3(10, 10, 10), 2);
        geometry::flip(cavity);
        append(shell, cavity);
        QCOMPARE(between(box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), shell).relation, Relation::Apart);
    }

    void nothingIsMeasuredWithoutTriangles()
    {
        const auto one = indexed(sphere(4, 10.0)), empty = indexed(TriangleMesh());
        QVERIFY(!geometry::surfaceDistance(*one, *empty) && !geometry::surfaceDistance(*empty, *one));
        QVERIFY(!nearestPoint(*empty, Vec3::Zero()));
        QCOMPARE(surfaceMargin(*one, *empty, std::vector<double>{5.0}).shares, (std::vector<double>{0.0, 0.0}));
    }

    void nearestPointEqualsBruteForce()
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> place(-30.0, 30.0);
        const auto surface = indexed(bumpySphere(10, 20.0, 0.2));
        const auto triangles = trianglesOf(*surface);
        for (int i = 0; i < trials(48); ++i) {
            const Vec3 p(place(random), place(random), place(random));
            const RealVector q = p.cast<Real>();
            Real least = std::numeric_limits<Real>::infinity();
            for (const RealTriangle& t : triangles) {
                least = std::min(least, oracle(t, {q, q, q}));
            }
            const auto expected = static_cast<double>(least);
            const auto found = nearestPoint(*surface, p);
            QVERIFY(std::abs(found->distance_mm - expected) < 1e-9);
            QVERIFY(std::abs((found->at - p).norm() - expected) < 1e-9);
            QVERIFY(std::abs(nearestPoint(*surface, p, expected + 0.01)->distance_mm - expected) < 1e-9);
            QVERIFY(!nearestPoint(*surface, p, 0.9 * expected));
        }
    }

    /// A box above a plane: the shares follow from the heights.
    void marginHasTheSharesOfABox()
    {
        const auto plane = indexed(sheet(500.0, 3));
        const auto lump = indexed(box(Vec3(-3, -3, 2), Vec3(3, 3, 12), 1)); // sides 10 mm high: 240 of 312 mm2
        const std::vector<double> limits{5.0, 10.0};
        const geometry::SurfaceMargin margin = surfaceMargin(*lump, *plane, limits);
        QCOMPARE(margin.shares.size(), std::size_t{3});
        const double error = 0.6 * geometry::marginResolution_mm(*lump) * 24.0 / 312.0; // on the sides' perimeter
        QVERIFY(std::abs(margin.shares[0] - (36.0 + 24.0 * 3.0) / 312.0) < error);
        QVERIFY(std::abs(margin.shares[1] - 24.0 * 5.0 / 312.0) < 2.0 * error);
        QVERIFY(std::abs(margin.shares[2] - (36.0 + 24.0 * 2.0) / 312.0) < error);
        QVERIFY(std::abs(std::accumulate(margin.shares.begin(), margin.shares.end(), 0.0) - 1.0) < 1e-12);
        QCOMPARE(margin.insideShare, 0.0);
        for (const unsigned threads : {1U, 3U}) {
            QCOMPARE(surfaceMargin(*lump, *plane, limits, threads).shares, margin.shares);
        }
    }

    /// Without a border of a band on the lump nothing is split, and the shares are exact.
    void marginOfOneBandIsExact()
    {
        const auto plane = indexed(sheet(500.0, 3)), lump = indexed(moved(sphere(6, 2.0), Vec3(0, 0, 7.5)));
        QCOMPARE(surfaceMargin(*lump, *plane, std::vector<double>{5.0, 10.0}).shares,
                 (std::vector<double>{0.0, 1.0, 0.0}));
    }

    void marginCountsWhatIsInside()
    {
        const auto organ = indexed(box(Vec3(-50, -50, -50), Vec3(50, 50, 0), 3));
        const auto lump = indexed(box(Vec3(-5, -5, -6), Vec3(5, 5, 4), 2));
        const geometry::SurfaceMargin margin = surfaceMargin(*lump, *organ, std::vector<double>{5.0});
        QVERIFY(std::abs(margin.insideShare - (100.0 + 40.0 * 6.0) / 600.0) < 0.6 * 0.1 * 40.0 / 600.0);
    }
};

PALPATE_TEST(SurfaceDistance)
#include "tst_SurfaceDistance.moc"
