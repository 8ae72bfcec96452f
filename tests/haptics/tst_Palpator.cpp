// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/haptics/Palpator.h>

#include <cmath>
#include <cstring>
#include <limits>

using namespace palpate;
using namespace palpate::test;
using haptics::HapticScene;
using haptics::HapticStructure;
using haptics::Palpator;
using haptics::TickResult;
using haptics::TickStatus;

namespace {

Vec3 wander(int i)
{
    const double a = 4e-3 * i;
    return (i < 60 ? 46 - 0.15 * i : 37 + 3 * std::sin(0.031 * i)) *
           Vec3(std::cos(a), std::sin(a) * 0.8, std::sin(a) * 0.6);
}

bool isSameBits(const Vec3& a, const Vec3& b)
{
    return std::memcmp(a.data(), b.data(), sizeof(double) * 3) == 0;
}

} // namespace

class PalpatorTest : public QObject
{
    Q_OBJECT

    const HapticScene m_scene{{HapticStructure{"bumps", indexed(bumpySphere(40, 40.0, 0.04)), {0.5, 0.001}, 0}}};

  private slots:
    void givesTheSameBitsTwice()
    {
        Palpator one, two;
        one.setScene(&m_scene);
        two.setScene(&m_scene);
        for (int i = 0; i < 3000; ++i) {
            const TickResult a = one.step(wander(i), 1e-3), b = two.step(wander(i), 1e-3);
            QVERIFY(isSameBits(a.p_WG, b.p_WG) && isSameBits(a.f_W, b.f_W));
        }
    }

    void goesOnFromASavedStateBitForBit()
    {
        // The second one also loses its gathered facets in every tick: they must never change a result.
        Palpator whole, resumed;
        whole.setScene(&m_scene);
        resumed.setScene(&m_scene);
        int contacts = 0;
        for (int i = 0; i < 3000; ++i) {
            const haptics::PalpatorState state = whole.state();
            resumed.restore(state);
            const TickResult a = whole.step(wander(i), 1e-3), b = resumed.step(wander(i), 1e-3);
            QVERIFY2(isSameBits(a.p_WG, b.p_WG) && isSameBits(a.f_W, b.f_W), qPrintable(QString("tick %1").arg(i)));
            contacts += a.constraints > 0 ? 1 : 0;
        }
        QVERIFY(contacts > 2000);
    }

    void aHipThatIsNotFiniteChangesNothing()
    {
        Palpator palpator;
        palpator.setScene(&m_scene);
        TickResult last;
        for (int i = 0; i < 200; ++i) {
            last = palpator.step(wander(i), 1e-3);
        }
        QVERIFY(last.constraints > 0);
        for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity()}) {
            const TickResult r = palpator.step(Vec3(0, bad, 0), 1e-3);
            QCOMPARE(int(r.status), int(TickStatus::InvalidInput));
            QVERIFY(r.f_W == Vec3::Zero());
            QVERIFY(r.p_WG == last.p_WG);
        }
        const TickResult next = palpator.step(wander(199), 1e-3);
        QVERIFY(next.p_WG == last.p_WG);
    }

    void withoutASceneThereIsNoForce()
    {
        Palpator palpator;
        const TickResult r = palpator.step(Vec3(1, 2, 3), 1e-3);
        QVERIFY(r.f_W == Vec3::Zero() && r.p_WG == Vec3(1, 2, 3));
    }

    void aSceneThatGoesLetsTheGodObjectGo()
    {
        Palpator palpator;
        palpator.setScene(&m_scene);
        for (int i = 0; i < 200; ++i) {
            (void)palpator.step(wander(i), 1e-3);
        }
        const HapticScene other({HapticStructure{"far", indexed(box(Vec3(500, 0, 0), Vec3(510, 10, 10))), {}, 0}});
        palpator.setScene(&other);
        const TickResult r = palpator.step(wander(200), 1e-3);
        QVERIFY(r.p_WG == wander(200));
        QVERIFY(r.f_W == Vec3::Zero());
    }

    void aStructureWithoutTrianglesKeepsItsNumber()
    {
        const HapticScene scene({HapticStructure{"hidden", nullptr, {}, 0},
                                 HapticStructure{"box", indexed(box(Vec3(-5, -5, -5), Vec3(5, 5, 0))), {0.5, 0.0}, 3}});
        QCOMPARE(scene.layerCount(), std::size_t{1});
        Palpator palpator;
        palpator.setScene(&scene);
        (void)palpator.step(Vec3(0, 0, 1), 1e-3);
        QCOMPARE(palpator.step(Vec3(0, 0, -1), 1e-3).structure, 1);
    }

    void reportsTheTriangleOfTheMeshThatWasGiven()
    {
        const geometry::RepairedMesh r = geometry::repair(box(Vec3(-5, -5, -5), Vec3(5, 5, 0), 6));
        const HapticScene scene({HapticStructure{
            "box", std::make_shared<geometry::SurfaceIndex>(geometry::SurfaceIndex::build(r)), {}, 0}});
        Palpator palpator;
        palpator.setScene(&scene);
        (void)palpator.step(Vec3(1.1, 2.3, 1), 1e-3);
        const TickResult t = palpator.step(Vec3(1.1, 2.3, -1), 1e-3);
        core::Box touched;
        for (const std::uint32_t v : r.mesh.triangles[t.triangle]) {
            touched.extend(r.mesh.vertices[v]);
        }
        QVERIFY(touched.exteriorDistance(Vec3(1.1, 2.3, 0)) == 0.0);
    }
};

static const bool registered = palpate::test::registerTest(
    "Palpator", []() -> std::unique_ptr<QObject> { return std::make_unique<PalpatorTest>(); });
#include "tst_Palpator.moc"
