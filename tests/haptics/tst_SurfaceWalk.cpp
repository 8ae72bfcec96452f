// SPDX-License-Identifier: BSD-3-Clause
// Walking over clear facets needs no queries: the result must equal that of queries, and the walk must stop where
// another structure is near.
#include "Shapes.h"
#include "TestRunner.h"
#include "solver/Walk.h"

#include <palpate/haptics/Palpator.h>

#include <cmath>

using namespace palpate;
using namespace palpate::test;
using haptics::HapticScene;
using haptics::HapticStructure;
using haptics::Palpator;
using haptics::TickResult;
using haptics::TickStatus;

class SurfaceWalkTest : public QObject
{
    Q_OBJECT

    static HapticScene sceneOf(const std::vector<TriangleMesh>& meshes)
    {
        std::vector<HapticStructure> structures;
        for (const TriangleMesh& mesh : meshes) {
            structures.push_back({"it", indexed(mesh), {0.5, 0.0}, 0});
        }
        return HapticScene(std::move(structures));
    }

    static TriangleMesh scaled(const TriangleMesh& mesh, double by)
    {
        return transformed(mesh, [by](const Vec3& v) { return Vec3(by * v); });
    }

    static TriangleMesh moved(const TriangleMesh& mesh, const Vec3& by)
    {
        return transformed(mesh, [&by](const Vec3& v) { return Vec3(v + by); });
    }

    /// Returns a winding path around the origin, from outside to `depth_mm` below a sphere of 50 mm and on.
    static Vec3 hipAt(int tick, double depth_mm, double mmATick)
    {
        const double arc = mmATick * tick / 50.0;
        const Vec3 direction(std::cos(arc) * std::cos(0.37 * arc), std::sin(arc) * std::cos(0.37 * arc),
                             std::sin(0.37 * arc));
        return direction * (55.0 - (5.0 + depth_mm) * std::min(1.0, tick / 500.0));
    }

  private Q_SLOTS:
    void findsWhatAskingFinds_data()
    {
        QTest::addColumn<TriangleMesh>("mesh");
        QTest::addColumn<double>("mmATick");
        QTest::addColumn<bool>("hasHollows");
        QTest::newRow("large facets") << sphere(8, 50.0) << 0.1 << false;
        QTest::newRow("small facets") << sphere(96, 50.0) << 0.1 << false;
        QTest::newRow("several facets a tick") << sphere(96, 50.0) << 1.0 << false;
        QTest::newRow("hills") << bumpySphere(48, 50.0, 0.02) << 0.1 << false;
        QTest::newRow("hills and hollows") << bumpySphere(48, 50.0, 0.05) << 0.1 << true;
        QTest::newRow("hollows, fast") << bumpySphere(96, 50.0, 0.05) << 0.4 << true;
        TriangleMesh bowl = bumpySphere(48, 50.0, 0.02);
        std::erase_if(bowl.triangles, [&bowl](const geometry::Triangle& t) { return bowl.vertices[t[0]].z() < -20.0; });
        QTest::newRow("without an inside") << bowl << 0.1 << false;
        QTest::newRow("box") << box(Vec3(-40, -40, -40), Vec3(40, 40, 40), 40) << 0.2 << false;
    }
    void findsWhatAskingFinds()
    {
        QFETCH(TriangleMesh, mesh);
        QFETCH(double, mmATick);
        QFETCH(bool, hasHollows);
        // With the same surface slightly further in as another structure, which is never reached, no walk is possible
        // and all facets are queried.
        const HapticScene alone = sceneOf({mesh}), beside = sceneOf({mesh, scaled(mesh, 0.999)});
        Palpator one, other;
        one.borrowScene(&alone);
        other.borrowScene(&beside);
        int contacts = 0, creases = 0;
        for (int tick = 0; tick < 20'000; ++tick) {
            const Vec3 hip = hipAt(tick, 4.0, mmATick);
            const TickResult a = one.step(hip, 1e-3), b = other.step(hip, 1e-3);
            QVERIFY2(a.p_WG == b.p_WG, qPrintable(QString("tick %1").arg(tick)));
            QCOMPARE(a.iterations, b.iterations);
            QCOMPARE(a.constraints, b.constraints);
            QCOMPARE(a.triangle, b.triangle);
            contacts += a.constraints > 0 ? 1 : 0;
            creases += a.constraints == 2 ? 1 : 0;
        }
        QVERIFY2(contacts > 4'000, qPrintable(QString::number(contacts)));
        QVERIFY2(creases > 2'000 || !hasHollows, qPrintable(QString::number(creases)));
    }

    void fliesAsFarAsAskingFlies()
    {
        // The cached free space of the second palpator is dropped before each tick.
        const HapticScene scene = sceneOf({bumpySphere(24, 50.0, 0.05), moved(sphere(6, 5.0), Vec3(54, 6, 0))});
        Palpator one, other;
        one.borrowScene(&scene);
        other.borrowScene(&scene);
        int contacts = 0, free = 0;
        for (int tick = 0; tick < 20'000; ++tick) {
            const Vec3 hip = hipAt(tick, 1.0 - 3.0 * std::sin(0.01 * tick), 0.1);
            other.restore(other.state());
            const TickResult a = one.step(hip, 1e-3), b = other.step(hip, 1e-3);
            QVERIFY2(a.p_WG == b.p_WG, qPrintable(QString("tick %1").arg(tick)));
            QCOMPARE(a.constraints, b.constraints);
            QCOMPARE(a.iterations, b.iterations);
            ++(a.constraints > 0 ? contacts : free);
        }
        QVERIFY2(contacts > 4'000 && free > 4'000, qPrintable(QString("%1 %2").arg(contacts).arg(free)));
    }

    void asksWhereNothingIsPromised_data()
    {
        QTest::addColumn<double>("alongA"); // weights of the corners
        QTest::addColumn<double>("alongB");
        QTest::addColumn<double>("skins"); // above the facet
        QTest::addColumn<bool>("isClear");
        QTest::newRow("in the middle") << 0.3 << 0.3 << 1.0 << true;
        QTest::newRow("too high") << 0.3 << 0.3 << 2.5 << false;
        QTest::newRow("too low") << 0.3 << 0.3 << 0.5 << false;
        QTest::newRow("beside it") << -0.1 << 0.6 << 1.0 << false;
        QTest::newRow("at a corner") << 1e-6 << 1e-6 << 1.0 << false;
        QTest::newRow("off a corner") << 1e-4 << 1e-4 << 1.0 << true;
    }
    void asksWhereNothingIsPromised()
    {
        QFETCH(double, alongA);
        QFETCH(double, alongB);
        QFETCH(double, skins);
        QFETCH(bool, isClear);
        using namespace haptics::internal;
        const HapticScene scene = sceneOf({sphere(24, 50.0)});
        Facet facet = Facet::of(*scene.structures()[0].surface, 0, 100);
        const double along = 1.0 - alongA - alongB;
        Vec3 god = along * facet.c + alongA * facet.a + alongB * facet.b + skins * facet.skin_mm * facet.n;
        const Vec3 hip = (facet.a + facet.b + facet.c) / 3.0 - facet.n;
        NearPoint near;
        Facet beyond;
        Walk walk(hip, scene.layer(0), near, nullptr, {god, facet, beyond, 1});
        (void)walk.run(Walk::Start::OnFacet, 64);
        QCOMPARE(walk.isClear(), isClear);
    }

    void onlyACreaseHoldsBetweenTwoFacets_data()
    {
        QTest::addColumn<double>("radius"); // negative: from inside
        QTest::addColumn<double>("aside");  // from the edge's middle, in facets
        QTest::addColumn<bool>("isHeld");
        QTest::addColumn<bool>("isClear");
        QTest::newRow("a crease") << -50.0 << 0.0 << true << true;
        QTest::newRow("a ridge") << 50.0 << 0.0 << false << true;
        QTest::newRow("one not touched") << -50.0 << 0.1 << true << false;
    }
    void onlyACreaseHoldsBetweenTwoFacets()
    {
        QFETCH(double, radius);
        QFETCH(double, aside);
        QFETCH(bool, isHeld);
        QFETCH(bool, isClear);
        using namespace haptics::internal;
        TriangleMesh mesh = sphere(24, std::abs(radius));
        if (radius < 0.0) {
            for (geometry::Triangle& t : mesh.triangles) {
                std::swap(t[0], t[1]);
            }
        }
        const HapticScene scene = sceneOf({mesh});
        const geometry::SurfaceIndex& surface = *scene.structures()[0].surface;
        Facet facet = Facet::of(surface, 0, 100);
        Facet second = Facet::of(surface, 0, surface.neighbour(100, 0).triangle);
        const Vec3 outwards = (facet.n + second.n).normalized(), middle = 0.5 * (facet.a + facet.b);
        Vec3 god = middle + aside * (facet.c - middle) + facet.skin_mm / outwards.dot(facet.n) * outwards;
        const Vec3 hip = middle - outwards;
        NearPoint near;
        Walk walk(hip, scene.layer(0), near, nullptr, {god, facet, second, 1});
        QCOMPARE(Walk::hasArrived(walk.run(Walk::Start::InCrease, 64)), isHeld);
        QCOMPARE(walk.isClear(), isClear);
    }

    void leavesACreaseOverTheFacetThatHolds()
    {
        using namespace haptics::internal;
        TriangleMesh mesh = sphere(24, 50.0);
        for (geometry::Triangle& t : mesh.triangles) {
            std::swap(t[0], t[1]);
        }
        const HapticScene scene = sceneOf({mesh});
        const geometry::SurfaceIndex& surface = *scene.structures()[0].surface;
        const std::array pair{Facet::of(surface, 0, 100), Facet::of(surface, 0, surface.neighbour(100, 0).triangle)};
        for (const std::size_t holds : {0u, 1u}) {
            Facet facet = pair[0];
            const Vec3 outwards = (pair[0].n + pair[1].n).normalized(), middle = 0.5 * (facet.a + facet.b);
            Vec3 god = middle + facet.skin_mm / outwards.dot(facet.n) * outwards;
            const Facet& to = pair[holds];
            const Vec3 hip = (to.a + to.b + to.c) / 3.0 - 0.01 * to.n;
            NearPoint near;
            Facet second = pair[1];
            Walk walk(hip, scene.layer(0), near, nullptr, {god, facet, second, 1});
            QCOMPARE(walk.run(Walk::Start::InCrease, 64), Walk::Ended::OnFacet);
            QVERIFY(walk.isClear());
            QCOMPARE(facet.triangle, to.triangle);
            QVERIFY((god - hip - (0.01 + to.skin_mm) * to.n).norm() < 1e-9);
        }
    }

    void stopsAtAnotherStructure()
    {
        const Vec3 centre = hipAt(2000, 0.0, 0.1).normalized() * 51.0;
        const double radius = 4.0;
        const TriangleMesh obstacle = moved(sphere(12, radius), centre);
        const HapticScene scene = sceneOf({sphere(96, 50.0), obstacle});
        Palpator palpator;
        palpator.borrowScene(&scene);
        double nearest = 1e9;
        int ofObstacle = 0;
        for (int tick = 0; tick < 2100; ++tick) {
            const TickResult result = palpator.step(hipAt(tick, 2.0, 0.1), 1e-3);
            QCOMPARE(result.status, TickStatus::Converged);
            nearest = std::min(nearest, (result.p_WG - centre).norm());
            ofObstacle += result.structure == 1 ? 1 : 0;
        }
        // Facets of the obstacle are at most a few hundredths of a millimetre below its sphere.
        QVERIFY2(nearest > radius - 0.05, qPrintable(QString::number(nearest)));
        QVERIFY(ofObstacle > 50);
    }
};

PALPATE_TEST_NAMED("SurfaceWalk", SurfaceWalkTest)
#include "tst_SurfaceWalk.moc"
