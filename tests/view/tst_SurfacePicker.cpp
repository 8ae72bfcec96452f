// SPDX-License-Identifier: BSD-3-Clause
#include "Balls.h"
#include "TestRunner.h"

#include <palpate/view/SurfacePicker.h>

#include <QElapsedTimer>

#include <random>

using namespace palpate;
using core::Vec3;

namespace {

/// Finds the nearest hit by testing every triangle with a different formula (barycentric areas).
double bruteForce(const geometry::TriangleMesh& mesh, const view::Ray& ray)
{
    double best = std::numeric_limits<double>::infinity();
    for (const auto& t : mesh.triangles) {
        const Vec3& a = mesh.vertices[t[0]];
        const Vec3& b = mesh.vertices[t[1]];
        const Vec3& c = mesh.vertices[t[2]];
        const Vec3 n = (b - a).cross(c - a);
        const double along = n.dot(ray.d_W);
        if (along == 0.0) {
            continue;
        }
        const double s = n.dot(a - ray.p_W) / along;
        const Vec3 p = ray.p_W + s * ray.d_W;
        const bool isInside =
            (b - a).cross(p - a).dot(n) >= 0 && (c - b).cross(p - b).dot(n) >= 0 && (a - c).cross(p - c).dot(n) >= 0;
        if (s > 0.0 && isInside) {
            best = std::min(best, s);
        }
    }
    return best;
}

} // namespace

class SurfacePicker : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void findsTheNearSideOfASphere()
    {
        const auto ball = geometry::SurfaceIndex::build(geometry::repair(test::ball(20.0, 5)));
        const auto hit = view::firstHit(ball, {Vec3(1.0, 2.0, 100.0), -Vec3::UnitZ()});
        QVERIFY(hit.has_value());
        QVERIFY(hit->p_W.z() > 0.0);
        QVERIFY(std::abs(hit->p_W.norm() - 20.0) < 0.02); // sagitta of the facets
        QVERIFY(hit->n_W.z() > 0.9);
        QVERIFY(std::abs(hit->distance_mm - (100.0 - hit->p_W.z())) < 1e-9);
    }
    void findsTheInnerSideFromWithin()
    {
        const auto ball = geometry::SurfaceIndex::build(geometry::repair(test::ball(20.0, 4)));
        const auto hit = view::firstHit(ball, {Vec3::Zero(), Vec3::UnitX()});
        QVERIFY(hit.has_value());
        QVERIFY(hit->n_W.x() < -0.9); // towards the viewer
    }
    void missesWhatIsBesideOrBehind()
    {
        const auto ball = geometry::SurfaceIndex::build(geometry::repair(test::ball(20.0, 4)));
        QVERIFY(!view::firstHit(ball, {Vec3(21.0, 0.0, 100.0), -Vec3::UnitZ()}).has_value());
        QVERIFY(!view::firstHit(ball, {Vec3(0.0, 0.0, 100.0), Vec3::UnitZ()}).has_value());
    }
    void agreesWithTryingEveryTriangle()
    {
        const auto repaired = geometry::repair(test::ball(20.0, 3, Vec3(500.0, -300.0, 40.0)));
        const auto index = geometry::SurfaceIndex::build(repaired);
        std::mt19937 random(7);
        std::uniform_real_distribution<double> spread(-24.0, 24.0);
        int hits = 0;
        for (int i = 0; i < 2000; ++i) {
            const Vec3 centre(500.0, -300.0, 40.0);
            const Vec3 from = centre + Vec3(spread(random), spread(random), spread(random)).normalized() * 200.0;
            const Vec3 to = centre + Vec3(spread(random), spread(random), spread(random));
            const view::Ray ray{from, (to - from).normalized()};
            const double expected = bruteForce(repaired.mesh, ray);
            const auto hit = view::firstHit(index, ray);
            QCOMPARE(hit.has_value(), std::isfinite(expected));
            if (hit) {
                ++hits;
                QVERIFY(std::abs(hit->distance_mm - expected) < 1e-9);
            }
        }
        QVERIFY(hits > 500 && hits < 2000);
    }
    void isFastOnAMillionTriangles()
    {
        const auto index = geometry::SurfaceIndex::build(geometry::repair(test::ball(300.0, 8)));
        QVERIFY(index.triangleCount() > 1'000'000);
        QElapsedTimer timer;
        timer.start();
        constexpr int kPicks = 200;
        for (int i = 0; i < kPicks; ++i) {
            QVERIFY(view::firstHit(index, {Vec3(i - 100.0, 0.7 * i - 70.0, 1000.0), -Vec3::UnitZ()}).has_value());
        }
        // A pick must not delay a frame noticeably; it takes microseconds, so the bound holds on a busy machine too.
        QVERIFY2(static_cast<double>(timer.nsecsElapsed()) * 1e-6 / kPicks < 10.0,
                 qPrintable(QString::number(timer.elapsed())));
    }

    void aMeshWithoutAHierarchyIsHitAlike()
    {
        const auto mesh = geometry::repair(test::ball(20.0, 3));
        const auto index = geometry::SurfaceIndex::build(mesh);
        for (int i = 0; i < 200; ++i) {
            view::Ray ray{core::Vec3(0.2 * i - 20.0, 0.07 * i - 7.0, 60.0), -core::Vec3::UnitZ()};
            ray.d_W = (ray.d_W + core::Vec3(0.001 * i, 0.0, 0.0)).normalized();
            const auto one = view::firstHit(mesh.mesh, mesh.report.bounds, ray);
            const auto other = view::firstHit(index, ray);
            QCOMPARE(one.has_value(), other.has_value());
            if (one) {
                QVERIFY(std::abs(one->distance_mm - other->distance_mm) < 1e-9);
                QVERIFY((one->n_W - other->n_W).norm() < 1e-9 ||
                        one->triangle != index.sourceTriangle(other->triangle));
            }
        }
        QVERIFY(!view::firstHit(mesh.mesh, mesh.report.bounds, {core::Vec3(0, 0, 60), core::Vec3::UnitX()}));
    }
};

PALPATE_TEST(SurfacePicker)
#include "tst_SurfacePicker.moc"
