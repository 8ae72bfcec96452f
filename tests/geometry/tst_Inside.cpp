// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/geometry/Inside.h>

#include <cmath>
#include <limits>
#include <random>

using namespace palpate;
using core::Vec3;
using geometry::isInside;

class Inside : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void tellsInsideFromOutside()
    {
        // A shell: a ball of 30 mm with a hollow of 10 mm.
        geometry::TriangleMesh shell = test::sphere(16, 30.0);
        geometry::TriangleMesh hollow = test::sphere(8, 10.0);
        geometry::flip(hollow);
        test::append(shell, hollow);
        const auto surface = test::indexed(shell);
        std::mt19937 random(3);
        std::uniform_real_distribution<double> anywhere(-35.0, 35.0);
        for (int i = 0; i < 2000; ++i) {
            const Vec3 p(anywhere(random), anywhere(random), anywhere(random));
            const double r = p.norm();
            if (std::abs(r - 30.0) > 0.5 && std::abs(r - 10.0) > 0.5) { // the balls are faceted
                QCOMPARE(isInside(*surface, p), r < 30.0 && r > 10.0);
            }
        }
    }

    /// A ray through or along an edge or corner must be rejected: aimed at every corner and edge midpoint of a box,
    /// from either side, for any direction of the rays.
    void raysThroughEdgesAndCornersCountRight()
    {
        const geometry::TriangleMesh box = test::box({-10, -10, -10}, {10, 10, 10}, 4);
        const auto surface = test::indexed(box);
        const Vec3 directions[]{Vec3(0.31, 0.53, 0.79).normalized(), Vec3(-0.67, 0.23, -0.71).normalized(),
                                Vec3(0.19, -0.89, 0.43).normalized(), Vec3::UnitX(), Vec3(1, 1, 0).normalized()};
        for (const geometry::Triangle& t : box.triangles) {
            for (int edge = 0; edge < 3; ++edge) {
                const Vec3& a = box.vertices[t[static_cast<std::size_t>(edge)]];
                const Vec3& b = box.vertices[t[static_cast<std::size_t>((edge + 1) % 3)]];
                for (const Vec3& target : {a, Vec3(0.5 * (a + b))}) {
                    for (const Vec3& d : directions) {
                        for (const double back : {0.5, 7.0, 30.0}) {
                            const Vec3 p = target - back * d;
                            const double out = p.cwiseAbs().maxCoeff() - 10.0;
                            if (std::abs(out) > 1e-6) {
                                QCOMPARE(isInside(*surface, p), out < 0.0);
                            }
                        }
                    }
                }
            }
        }
    }

    /// One ray leaves through a hole and meets no wall: the other two decide.
    void oneWrongRayIsOutvoted()
    {
        geometry::TriangleMesh ball = test::sphere(12, 20.0);
        const Vec3 ray = Vec3(0.31, 0.53, 0.79).normalized(); // the first ray direction
        std::erase_if(ball.triangles, [&](const geometry::Triangle& t) {
            const Vec3 middle = (ball.vertices[t[0]] + ball.vertices[t[1]] + ball.vertices[t[2]]) / 3.0;
            return middle.normalized().dot(ray) > 0.97;
        });
        QVERIFY(ball.triangles.size() < 20 * 144);
        QVERIFY(isInside(*test::indexed(ball), Vec3(0.1, 0.2, 0.3)));
    }

    void farAwayAndTinyAreTheSame()
    {
        for (const double scale : {1e-3, 1.0, 1e3}) {
            const Vec3 at(4e5 * scale, -7e5 * scale, 1e5 * scale);
            const auto surface = test::indexed(test::moved(test::sphere(6, 10.0 * scale), at));
            QVERIFY(isInside(*surface, at));
            QVERIFY(isInside(*surface, at + Vec3(0, 9.0 * scale, 0)));
            QVERIFY(!isInside(*surface, at + Vec3(0, 10.5 * scale, 0)));
            QVERIFY(!isInside(*surface, at + Vec3::Constant(9.0 * scale))); // in the corner of the box
        }
    }

    void nothingIsInsideOfNothing()
    {
        const auto surface = test::indexed(test::sphere(4, 10.0));
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!isInside(geometry::SurfaceIndex::build({}), Vec3::Zero()));
        QVERIFY(!isInside(*surface, Vec3(nan, 0, 0)));
        QVERIFY(!isInside(*surface, Vec3(std::numeric_limits<double>::infinity(), 0, 0)));
    }
};

PALPATE_TEST(Inside)
#include "tst_Inside.moc"
