// SPDX-License-Identifier: BSD-3-Clause
// Tests neighbours and clear triangles by brute force: SurfaceIndex describes the surroundings of each triangle
// correctly.
#include "Shapes.h"
#include "TestRunner.h"
#include "Trials.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace palpate;
using namespace palpate::test;
using geometry::RepairedMesh;
using geometry::SurfaceIndex;
using geometry::Triangle;

namespace {

/// Returns the distance of a point from a closed triangle. Source: Ericson, Real-Time Collision Detection (2005),
/// 5.1.5.
double distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 n = (b - a).cross(c - a).normalized();
    const auto isLeft = [&](const Vec3& u, const Vec3& v) { return n.dot((v - u).cross(p - u)) >= 0.0; };
    if (isLeft(a, b) && isLeft(b, c) && isLeft(c, a)) {
        return std::abs(n.dot(p - a));
    }
    const auto toEdge = [&p](const Vec3& u, const Vec3& v) {
        const double share = std::clamp((p - u).dot(v - u) / (v - u).squaredNorm(), 0.0, 1.0);
        return (p - (u + share * (v - u))).norm();
    };
    return std::min({toEdge(a, b), toEdge(b, c), toEdge(c, a)});
}

using Corners = std::array<Vec3, 3>;

double distance(const Vec3& p, const Corners& t)
{
    return distance(p, t[0], t[1], t[2]);
}

/// Returns an upper bound of the distance of two segments, by alternating projections.
double distanceOfEdges(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const Vec3 u = b - a, v = d - c, w = a - c;
    const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
    const double det = uu * vv - uv * uv;
    double s = det > 0.0 ? std::clamp((uv * v.dot(w) - vv * u.dot(w)) / det, 0.0, 1.0) : 0.5;
    double t = 0.0;
    for (int i = 0; i < 4; ++i) {
        t = std::clamp((w + s * u).dot(v) / vv, 0.0, 1.0);
        s = std::clamp((t * v - w).dot(u) / uu, 0.0, 1.0);
    }
    return (w + s * u - t * v).norm();
}

/// Returns the distance of two triangles without a common corner; 0 if they intersect.
double distance(const Corners& f, const Corners& g)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [one, other] : {std::pair(f, g), std::pair(g, f)}) {
        const Vec3 n = (other[1] - other[0]).cross(other[2] - other[0]);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 &p = one[i], &q = one[(i + 1) % 3];
            nearest = std::min(nearest, distance(p, other));
            const double start = n.dot(p - other[0]), end = n.dot(q - other[0]);
            if ((start < 0.0) != (end < 0.0)) {
                nearest = std::min(nearest, distance(p + start / (start - end) * (q - p), other));
            }
            for (std::size_t k = 0; k < 3; ++k) {
                nearest = std::min(nearest, distanceOfEdges(p, q, other[k], other[(k + 1) % 3]));
            }
        }
    }
    return nearest;
}

Corners cornersOf(const SurfaceIndex& index, std::uint32_t i)
{
    const Triangle t = index.triangle(i);
    return {index.vertex(t[0]), index.vertex(t[1]), index.vertex(t[2])};
}

Vec3 normalOf(const SurfaceIndex& index, std::uint32_t i)
{
    const auto [a, b, c] = cornersOf(index, i);
    return (b - a).cross(c - a).normalized();
}

std::size_t clearCount(const SurfaceIndex& index)
{
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < index.triangleCount(); ++i) {
        count += index.isClear(i) ? 1 : 0;
    }
    return count;
}

/// Returns a globe with `sides` meridians per turn, `turns` times around its poles; the last strip is `last` of a full
/// strip wide.
TriangleMesh globe(int sides, int turns, double last = 1.0)
{
    constexpr int kRows = 16;
    TriangleMesh mesh;
    const int n = sides * turns;
    mesh.vertices = {Vec3(0, 0, 10), Vec3(0, 0, -10)};
    for (int row = 1; row < kRows; ++row) {
        const double polar = std::numbers::pi * row / kRows;
        for (int i = 0; i < n; ++i) {
            const double angle = 2.0 * std::numbers::pi * (i / sides + i % sides / (sides - 1.0 + last));
            const double radius = 10.0 + 1e-5 * i / n; // so that no two vertices coincide
            mesh.vertices.push_back(
                radius * Vec3(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar)));
        }
    }
    const auto at = [n](int row, int i) {
        return static_cast<std::uint32_t>(row == 0 ? 0 : row == kRows ? 1 : 2 + (row - 1) * n + i % n);
    };
    for (int row = 0; row < kRows; ++row) {
        for (int i = 0; i < n; ++i) {
            if (row + 1 < kRows) {
                mesh.triangles.push_back({at(row, i), at(row + 1, i), at(row + 1, i + 1)});
            }
            if (row > 0) {
                mesh.triangles.push_back({at(row, i), at(row + 1, i + 1), at(row, i + 1)});
            }
        }
    }
    return mesh;
}

TriangleMesh shaken(TriangleMesh mesh, double by_mm, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (Vec3& v : mesh.vertices) {
        v += by_mm * Vec3(unit(random), unit(random), unit(random));
    }
    return mesh;
}

TriangleMesh together(TriangleMesh mesh, const TriangleMesh& other)
{
    append(mesh, other);
    return mesh;
}

} // namespace

class ClearTriangles : public QObject
{
    Q_OBJECT

    static void addShapes()
    {
        QTest::addColumn<TriangleMesh>("mesh");
        const TriangleMesh ball = sphere(4, 10.0);
        QTest::newRow("sphere") << ball;
        QTest::newRow("hills") << bumpySphere(8, 10.0, 0.1);
        QTest::newRow("box") << box(Vec3(-5, -5, -5), Vec3(5, 5, 5), 4);
        QTest::newRow("groove of 90 degrees") << groove(std::numbers::pi / 2);
        QTest::newRow("groove of 1 degree") << groove(std::numbers::pi / 180);
        QTest::newRow("open sheet") << sheet(5.0, 4);
        QTest::newRow("spheres that cross") << together(ball, moved(sphere(3, 8.0), Vec3(9, 1, 2)));
        QTest::newRow("spheres that touch in a point") << together(ball, moved(sphere(4, 10.0), Vec3(20, 0, 0)));
        QTest::newRow("sphere in a sphere, 1e-8 mm apart") << together(ball, sphere(4, 10.0 - 1e-8));
        QTest::newRow("sphere in a sphere, 1e-10 mm apart") << together(ball, sphere(4, 10.0 - 1e-10));
        QTest::newRow("sphere in a sphere, 1e-3 mm apart") << together(ball, sphere(4, 10.0 - 1e-3));
        QTest::newRow("soup") << soup(ball);
        QTest::newRow("shaken") << shaken(ball, 1.0, 1);
        QTest::newRow("shaken hard") << shaken(ball, 4.0, 2);
        QTest::newRow("shaken hard, many") << shaken(sphere(7, 10.0), 1.5, 3);
        QTest::newRow("globe") << globe(12, 1);
        QTest::newRow("globe of slivers") << globe(60, 1);
        QTest::newRow("globe with a strip of slivers") << globe(12, 1, 2e-5);
        QTest::newRow("globe twice around") << globe(12, 2);
        TriangleMesh spiked = ball;
        for (std::size_t i = 0; i < ball.triangles.size(); i += 20) {
            // A thin spike on the triangle, with its tip in a corner.
            const Triangle t = ball.triangles[i];
            const Vec3 &a = spiked.vertices[t[0]], &b = spiked.vertices[t[1]], &c = spiked.vertices[t[2]];
            const Vec3 up = 1e-7 * a.normalized();
            const auto n = static_cast<std::uint32_t>(spiked.vertices.size());
            const std::array added{Vec3(0.4 * a + 0.4 * b + 0.2 * c + up), Vec3(0.4 * a + 0.2 * b + 0.4 * c + up),
                                   Vec3(0.4 * a + 0.3 * b + 0.3 * c + 1e5 * up)};
            spiked.vertices.insert(spiked.vertices.end(), added.begin(), added.end());
            for (const Triangle& side : {Triangle{t[0], n + 1, n}, Triangle{t[0], n, n + 2},
                                         Triangle{t[0], n + 2, n + 1}, Triangle{n, n + 1, n + 2}}) {
                spiked.triangles.push_back(side);
            }
        }
        QTest::newRow("spikes") << spiked;
        QTest::newRow("far away") << moved(ball, Vec3::Constant(1e6));
        TriangleMesh finned = ball;
        finned.vertices.emplace_back(0, 0, 15);
        const Triangle t = finned.triangles[0];
        finned.triangles.push_back({t[0], t[1], static_cast<std::uint32_t>(finned.vertices.size() - 1)});
        QTest::newRow("fin") << finned;
        TriangleMesh turned = ball;
        std::swap(turned.triangles[7][1], turned.triangles[7][2]);
        QTest::newRow("one turned over") << turned;
    }

  private Q_SLOTS:
    void neighboursAreThoseOfTheEdges_data() { addShapes(); }
    void neighboursAreThoseOfTheEdges()
    {
        QFETCH(TriangleMesh, mesh);
        const auto index = indexed(mesh);
        for (std::uint32_t i = 0; i < index->triangleCount(); ++i) {
            const Triangle t = index->triangle(i);
            for (std::uint32_t e = 0; e < 3; ++e) {
                const std::uint32_t p = t[e], q = t[(e + 1) % 3];
                int there = 0;
                SurfaceIndex::Neighbour expected{SurfaceIndex::kNoNeighbour, 0};
                for (std::uint32_t j = 0; j < index->triangleCount(); ++j) {
                    const Triangle u = index->triangle(j);
                    for (std::uint32_t k = 0; k < 3; ++k) {
                        const std::uint32_t v = u[k], w = u[(k + 1) % 3];
                        there += (v == p && w == q) || (v == q && w == p) ? 1 : 0;
                        if (v == q && w == p) {
                            expected = {j, k};
                        }
                    }
                }
                if (there != 2) {
                    expected = {SurfaceIndex::kNoNeighbour, 0};
                }
                const SurfaceIndex::Neighbour found = index->neighbour(i, e);
                QCOMPARE(found.triangle, expected.triangle);
                if (found.triangle != SurfaceIndex::kNoNeighbour) {
                    QCOMPARE(found.edge, expected.edge);
                }
            }
        }
    }

    void nothingIsNearWhatIsClear_data() { addShapes(); }
    void nothingIsNearWhatIsClear()
    {
        QFETCH(TriangleMesh, mesh);
        const auto index = indexed(mesh);
        const double skin = index->skin_mm();
        struct Ball
        {
            Vec3 centre;
            double radius;
        };
        std::vector<Ball> balls; // bounding balls around the triangles, which exclude most pairs
        for (std::uint32_t i = 0; i < index->triangleCount(); ++i) {
            const auto [a, b, c] = cornersOf(*index, i);
            const Vec3 centre = (a + b + c) / 3.0;
            balls.push_back({centre, std::sqrt(std::max({(a - centre).squaredNorm(), (b - centre).squaredNorm(),
                                                         (c - centre).squaredNorm()}))});
        }
        std::mt19937 random(7);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        constexpr std::uint32_t kStep = kIsSanitized ? 8 : 1;
        for (std::uint32_t i = 0; i < index->triangleCount(); i += kStep) {
            bool isClearAround = true;
            for (std::uint32_t e = 0; e < 3; ++e) {
                const std::uint32_t n = index->neighbour(i, e).triangle;
                isClearAround = isClearAround && n != SurfaceIndex::kNoNeighbour && index->isClear(n);
            }
            QCOMPARE(index->isClearAround(i), isClearAround);
            if (!index->isClear(i)) {
                continue;
            }
            const auto corners = cornersOf(*index, i);
            const Vec3 n = normalOf(*index, i);
            std::vector<Vec3> places;
            for (std::size_t e = 0; e < 3; ++e) {
                const std::uint32_t beyond = index->neighbour(i, static_cast<std::uint32_t>(e)).triangle;
                QVERIFY(beyond != SurfaceIndex::kNoNeighbour);
                QVERIFY(n.dot(normalOf(*index, beyond)) > 0.6 - 1e-6);
                // As near to a corner as possible, along both edges and in between.
                const Vec3 &p = corners[e], u = (corners[(e + 1) % 3] - p).normalized(),
                           v = (corners[(e + 2) % 3] - p).normalized();
                for (const Vec3& along : {u, v, Vec3((u + v).normalized())}) {
                    places.emplace_back(p + SurfaceIndex::kClearOfCorners * skin * along);
                }
                places.emplace_back(p + 0.5 * (corners[(e + 1) % 3] - p));
            }
            for (int k = 0; k < 20; ++k) {
                const double s = unit(random), t = unit(random) * (1.0 - s);
                places.emplace_back(corners[0] + s * (corners[1] - corners[0]) + t * (corners[2] - corners[0]));
            }
            double nearest = std::numeric_limits<double>::infinity();
            for (const Vec3& place : places) {
                for (const double height : {0.5, 1.0, SurfaceIndex::kClearHeight, -0.5, -SurfaceIndex::kClearHeight}) {
                    const Vec3 at = place + height * skin * n;
                    if (height < 0.0 && !index->isTwoSided(i)) {
                        break;
                    }
                    for (std::uint32_t j = 0; j < index->triangleCount(); ++j) {
                        const auto isNeighbour = [&](std::uint32_t e) { return index->neighbour(i, e).triangle == j; };
                        if ((at - balls[j].centre).norm() > balls[j].radius + nearest || j == i || isNeighbour(0) ||
                            isNeighbour(1) || isNeighbour(2)) {
                            continue;
                        }
                        const auto [a, b, c] = cornersOf(*index, j);
                        nearest = std::min(nearest, distance(at, a, b, c));
                    }
                }
            }
            const Triangle t = index->triangle(i);
            for (std::uint32_t j = 0; j < index->triangleCount(); ++j) {
                const Triangle u = index->triangle(j);
                const bool isApart =
                    (balls[i].centre - balls[j].centre).norm() > balls[i].radius + balls[j].radius + nearest;
                if (!isApart && std::find_first_of(t.begin(), t.end(), u.begin(), u.end()) == t.end()) {
                    nearest = std::min(nearest, distance(corners, cornersOf(*index, j)));
                }
            }
            QVERIFY2(nearest > 2.0 * skin, qPrintable(QString("%1 skins").arg(nearest / skin)));
        }
    }

    void mostOfASmoothSurfaceIsClear()
    {
        const auto ball = indexed(sphere(16, 50.0));
        QCOMPARE(clearCount(*ball), std::size_t{ball->triangleCount()});
        const auto hills = indexed(bumpySphere(32, 50.0, 0.05));
        QVERIFY2(double(clearCount(*hills)) > 0.99 * hills->triangleCount(),
                 qPrintable(QString::number(clearCount(*hills))));
        const auto wide = indexed(together(sphere(16, 50.0), sphere(16, 49.0)));
        QCOMPARE(clearCount(*wide), std::size_t{wide->triangleCount()});
    }

    void whatIsInTheWayIsNotClear()
    {
        // All triangles have a corner at the open edge.
        QCOMPARE(clearCount(*indexed(sheet(5.0, 2))), std::size_t{0});
        QCOMPARE(clearCount(*indexed(together(sphere(4, 10.0), sphere(4, 10.0 - 1e-11)))), std::size_t{0});
    }

    void whatLiesAllOverEachOtherEndsSoon()
    {
        // 30,000 triangles as large as the scene: 450 million pairs of touching boxes.
        std::mt19937 random(11);
        std::uniform_real_distribution<double> unit(-100.0, 100.0);
        TriangleMesh mesh;
        for (std::uint32_t i = 0; i < 90'000; ++i) {
            mesh.vertices.emplace_back(unit(random), unit(random), unit(random));
        }
        for (std::uint32_t i = 0; i < 30'000; ++i) {
            mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        }
        append(mesh, moved(sphere(8, 10.0), Vec3(1000, 0, 0)));
        const RepairedMesh repaired = geometry::repair(mesh);
        for (const unsigned threads : {1u, 2u, 8u}) {
            // Then not even the triangles of a distant sphere are classified as clear.
            QCOMPARE(clearCount(SurfaceIndex::build(repaired, threads)), std::size_t{0});
        }
    }

    void threadsMakeNoDifference()
    {
        const RepairedMesh mesh =
            geometry::repair(together(shaken(sphere(40, 50.0), 0.2, 5), moved(sphere(20, 30.0), Vec3(25, 3, 8))));
        QVERIFY(mesh.mesh.triangles.size() > 20'000);
        const SurfaceIndex one = SurfaceIndex::build(mesh, 1);
        const std::size_t count = clearCount(one);
        QVERIFY(count > 0 && count < one.triangleCount());
        for (const unsigned threads : {2u, 3u, 8u}) {
            const SurfaceIndex several = SurfaceIndex::build(mesh, threads);
            QCOMPARE(one.vertexCount(), several.vertexCount());
            for (std::uint32_t v = 0; v < one.vertexCount(); ++v) {
                QVERIFY(one.vertex(v) == several.vertex(v));
            }
            for (std::uint32_t i = 0; i < one.triangleCount(); ++i) {
                QVERIFY(one.triangle(i) == several.triangle(i));
                QCOMPARE(one.sourceTriangle(i), several.sourceTriangle(i));
                QCOMPARE(one.isClear(i), several.isClear(i));
                QCOMPARE(one.isClearAround(i), several.isClearAround(i));
                for (std::uint32_t e = 0; e < 3; ++e) {
                    QCOMPARE(one.neighbour(i, e).triangle, several.neighbour(i, e).triangle);
                    QCOMPARE(one.neighbour(i, e).edge, several.neighbour(i, e).edge);
                }
            }
            QVERIFY(one.skin_mm() == several.skin_mm() && one.facetSize_mm() == several.facetSize_mm());
            QCOMPARE(one.byteSize(), several.byteSize());
        }
    }
};

PALPATE_TEST(ClearTriangles)
#include "tst_ClearTriangles.moc"
