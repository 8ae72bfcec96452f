// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"
#include "Trials.h"

#include <palpate/haptics/Palpator.h>

#include <algorithm>
#include <array>
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

/// Returns a cone with more facets at its apex than a neighbourhood holds.
geometry::TriangleMesh crowdedCone()
{
    geometry::TriangleMesh mesh;
    constexpr std::uint32_t kFacets = 300;
    mesh.vertices.push_back(Vec3::Zero());
    for (std::uint32_t i = 0; i < kFacets; ++i) {
        const double a = 2.0 * 3.14159265358979 * i / kFacets;
        mesh.vertices.push_back(Vec3(10.0 * std::cos(a), 10.0 * std::sin(a), 1.0 + std::sin(5.0 * a)));
        mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % kFacets});
    }
    return mesh;
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

  private Q_SLOTS:
    void givesTheSameBitsTwice()
    {
        Palpator one, two;
        one.borrowScene(&m_scene);
        two.borrowScene(&m_scene);
        for (int i = 0; i < 3000; ++i) {
            const TickResult a = one.step(wander(i), 1e-3), b = two.step(wander(i), 1e-3);
            QVERIFY(isSameBits(a.p_WG, b.p_WG) && isSameBits(a.f_W, b.f_W));
        }
    }

    void aHiddenLayerThatIsShownLeavesTheOthersAsTheyWere()
    {
        const auto organ = indexed(sphere(8, 30.0)), lump = indexed(sphere(8, 10.0));
        const HapticStructure outer{"organ", organ, {0.2, 0.0}, 3}, inner{"lump", lump, {0.5, 0.0}, 7};
        const HapticScene both({outer, inner}), alone({inner});
        Palpator palpator;
        palpator.borrowScene(&alone);
        const Vec3 hip(0.0, 0.0, 7.0);
        (void)palpator.step(Vec3(0.0, 0.0, 12.0), 1e-3);
        const TickResult before = palpator.step(hip, 1e-3);
        QVERIFY(before.f_W.z() > 1.0);
        palpator.borrowScene(&both);
        const TickResult shown = palpator.step(hip, 1e-3);
        QVERIFY(isSameBits(before.f_W, shown.f_W)); // the organ exerts no force on a HIP that is inside at the start
        QVERIFY(isSameBits(before.p_WG, shown.p_WG));
        palpator.borrowScene(&alone);
        QVERIFY(isSameBits(before.f_W, palpator.step(hip, 1e-3).f_W));
    }

    void aHipTooFarAwayMovesNothing()
    {
        Palpator palpator;
        palpator.borrowScene(&m_scene);
        (void)palpator.step(Vec3(46, 0, 0), 1e-3);
        const TickResult pressed = palpator.step(Vec3(36, 0, 0), 1e-3);
        QCOMPARE(pressed.constraints > 0, true);
        for (const double far_mm : {2e6, 1e9, 1e100, 1.7e308}) {
            const TickResult refused = palpator.step(Vec3(-far_mm, 0, 0), 1e-3);
            QCOMPARE(refused.status, TickStatus::InvalidInput);
            QVERIFY(refused.f_W == Vec3::Zero());
            const TickResult back = palpator.step(Vec3(36, 0, 0), 1e-3);
            QVERIFY((back.p_WG - pressed.p_WG).norm() < 1e-9);
        }
        QCOMPARE(palpator.step(Vec3(-1e5, 0, 0), 1e-3).status, TickStatus::Converged);
    }

    void noInfiniteForceLeaves()
    {
        for (const double dt_s : {5e-324, 1e-310, 1e-300}) {
            Palpator palpator;
            palpator.borrowScene(&m_scene);
            (void)palpator.step(Vec3(46, 0, 0), 1e-3);
            const TickResult pressed = palpator.step(Vec3(36, 0, 0), dt_s);
            QVERIFY(pressed.constraints > 0);
            QVERIFY(pressed.f_W.allFinite());
        }
    }

    void theWorkOfAPointsTickIsBounded()
    {
        // 60,000 facets at one vertex: no sweep along them completes, and the god-object stays in front of them.
        geometry::TriangleMesh fan;
        constexpr std::uint32_t kFacets = 60000;
        fan.vertices.push_back(Vec3(0.0, 0.0, 5.0));
        for (std::uint32_t i = 0; i < kFacets; ++i) {
            const double a = 2.0 * 3.14159265358979 * i / kFacets;
            fan.vertices.push_back(Vec3(20.0 * std::cos(a), 20.0 * std::sin(a), 0.0));
            fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % kFacets});
        }
        const HapticScene scene{{HapticStructure{"fan", indexed(fan), {0.5, 0.0}, 0}}};
        Palpator warm, cold;
        warm.borrowScene(&scene);
        cold.borrowScene(&scene);
        int bounded = 0;
        for (int i = 0; i < 60; ++i) {
            const Vec3 hip(1e-3 * i, 2e-3 * i, 6.0 - 0.1 * i);
            cold.restore(warm.state());
            const TickResult one = warm.step(hip, 1e-3), other = cold.step(hip, 1e-3);
            QVERIFY(isSameBits(one.p_WG, other.p_WG) && isSameBits(one.f_W, other.f_W));
            QVERIFY(one.status == other.status);
            QVERIFY(one.p_WG.z() > 5.0 - 0.26 * one.p_WG.head<2>().norm() - 1e-6);
            QVERIFY((one.p_WG - hip).norm() < 1e-6 || (one.constraints > 0 && one.f_W.norm() > 0.0));
            bounded += one.status == TickStatus::IterationLimit ? 1 : 0;
        }
        QVERIFY(bounded > 0);
    }

    void goesOnFromASavedStateBitForBit()
    {
        // The second palpator also drops its cached facets in every tick: caching must never change a result.
        Palpator whole, resumed;
        whole.borrowScene(&m_scene);
        resumed.borrowScene(&m_scene);
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

    void noCacheChangesAResultInAHurryOrACrowd_data()
    {
        QTest::addColumn<bool>("isCrowd");
        QTest::newRow("hills at 400 mm/s") << false;
        QTest::newRow("300 facets at a corner") << true;
    }
    void noCacheChangesAResultInAHurryOrACrowd()
    {
        QFETCH(bool, isCrowd);
        const HapticScene scene(
            {HapticStructure{"one", indexed(isCrowd ? crowdedCone() : bumpySphere(40, 40.0, 0.05)), {0.5, 0.001}, 0}});
        Palpator whole, resumed;
        whole.borrowScene(&scene);
        resumed.borrowScene(&scene);
        int contacts = 0;
        const int ticks = test::trials(20000);
        for (int i = 0; i < ticks; ++i) {
            const double a = (isCrowd ? 0.03 : 0.01) * i;
            const Vec3 hip = isCrowd ? Vec3(0.02 * std::sin(a), 0.02 * std::sin(1.7 * a), 0.5 - std::min(1.5, 1e-2 * i))
                                     : Vec3(35.0 *
                                            Vec3(std::cos(a) * std::cos(0.37 * a), std::sin(a) * std::cos(0.37 * a),
                                                 std::sin(0.37 * a)) *
                                            (i < 20 ? 1.5 - 0.025 * i : 1.0));
            if (i % 3 == 0) {
                resumed.restore(whole.state());
            }
            const TickResult x = whole.step(hip, 1e-3), y = resumed.step(hip, 1e-3);
            QVERIFY2(isSameBits(x.p_WG, y.p_WG) && x.constraints == y.constraints,
                     qPrintable(QString("tick %1").arg(i)));
            contacts += x.constraints > 0 ? 1 : 0;
        }
        QVERIFY(contacts > 3 * ticks / 4);
    }

    void noTickMakesMoreMovesThanItMay()
    {
        for (const std::uint32_t most : {1u, 2u, 5u}) {
            Palpator palpator(haptics::Fingertips::Points, {most});
            palpator.borrowScene(&m_scene);
            std::uint32_t greatest = 0;
            for (int i = 0; i < 2000; ++i) {
                const TickResult result = palpator.step(wander(i), 1e-3);
                QVERIFY(result.iterations <= most);
                greatest = std::max(greatest, result.iterations);
            }
            QCOMPARE(greatest, most); // more moves without the bound
        }
    }

    void aPointNeedsLittleRoom()
    {
        Palpator palpator(haptics::Fingertips::Points);
        QVERIFY2(palpator.byteSize() <= 65536, qPrintable(QString::number(palpator.byteSize())));
        const HapticScene ball(std::vector<HapticStructure>(m_scene.structures()), 2.0);
        palpator.borrowScene(&ball);
        const TickResult refused = palpator.step({0.0, 0.0, 0.0}, 1e-3);
        QCOMPARE(refused.status, TickStatus::InvalidInput);
        QCOMPARE(refused.f_W, Vec3(Vec3::Zero()));
    }

    /// The contact of each layer is reported, outermost first, and the forces add up to the force on the hand.
    void everyLayerThatIsTouchedIsNamed()
    {
        std::vector<HapticStructure> structures;
        structures.push_back({"inner", indexed(sphere(24, 20.0)), {1.5, 0.0}, 3});
        structures.push_back({"outer", indexed(sphere(24, 30.0)), {0.5, 0.0}, 1});
        const HapticScene scene(std::move(structures));
        Palpator palpator;
        palpator.borrowScene(&scene);
        TickResult result;
        for (double height = 35.0; height >= 14.0; height -= 0.25) {
            const Vec3 hip(1.0, 2.0, height);
            result = palpator.step(hip, 1e-3);
            Vec3 sum = Vec3::Zero();
            for (std::size_t i = 0; i < result.contactCount; ++i) {
                const haptics::Contact& contact = result.contacts[i];
                QCOMPARE(contact.layer, static_cast<std::uint32_t>(i));
                QCOMPARE(contact.structure, i == 0 ? 1u : 0u);
                QVERIFY(std::abs(contact.depth_mm - (contact.p_WG - hip).norm()) < 1e-12);
                QVERIFY((contact.f_W - (i == 0 ? 0.5 : 1.5) * contact.depth_mm * contact.n_W).norm() < 1e-12);
                sum += contact.f_W;
            }
            QVERIFY((sum - result.f_W).norm() < 1e-12);
            QCOMPARE(result.contactCount, static_cast<std::uint8_t>(height > 29.9 ? 0 : height > 19.8 ? 1 : 2));
        }
        QCOMPARE(result.p_WG, result.contacts[0].p_WG);
    }

    /// Below an edge or a vertex several facets hold the god-object equally well: the previous facet stays active.
    void aHandAtRestFeelsOneForce_data()
    {
        QTest::addColumn<double>("radius_mm");
        for (const double radius_mm : {0.0, 1.0}) {
            QTest::newRow(qPrintable(QString("%1 mm").arg(radius_mm))) << radius_mm;
        }
    }
    void aHandAtRestFeelsOneForce()
    {
        QFETCH(double, radius_mm);
        const std::array meshes{box(Vec3(-10, -10, -10), Vec3(10, 10, 0), 3), bumpySphere(8, 10.0, 0.06), groove(1.2),
                                sheet(10.0, 3)};
        int isHeld = 0;
        for (const geometry::TriangleMesh& mesh : meshes) {
            HapticStructure one{"it", indexed(mesh), {0.3, 0.0}, 0};
            auto corners = std::make_shared<std::vector<std::array<float, 3>>>(one.surface->triangleCount());
            for (std::uint32_t i = 0; i < corners->size(); ++i) {
                for (std::size_t k = 0; k < 3; ++k) {
                    const Vec3& v = one.surface->vertex(one.surface->triangle(i)[k]);
                    (*corners)[i][k] = static_cast<float>(1.5 + 0.3 * std::sin(0.5 * v.x() + 0.3 * v.y()));
                }
            }
            one.maps.stiffness.corners = std::move(corners);
            const HapticScene scene({one}, radius_mm);
            for (std::size_t i = 0; i < mesh.triangles.size(); i += mesh.triangles.size() / 12) {
                const auto& [a, b, c] = mesh.triangles[i];
                const Vec3 n =
                    (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).normalized();
                for (const Vec3& below : {mesh.vertices[a], Vec3(0.5 * (mesh.vertices[a] + mesh.vertices[b]))}) {
                    Palpator palpator;
                    palpator.borrowScene(&scene);
                    for (double height = 1.0; height > -1.4; height -= 0.1) {
                        (void)palpator.step(below + (radius_mm + height) * n, 1e-3);
                    }
                    const Vec3 hip = below + (radius_mm - 1.5) * n;
                    TickResult first;
                    for (int tick = 0; tick < 12; ++tick) {
                        const TickResult now = palpator.step(hip, 1e-3);
                        if (tick == 4) {
                            first = now;
                        }
                        if (tick > 4) {
                            QVERIFY(now.triangle == first.triangle && now.constraints == first.constraints);
                            QVERIFY(isSameBits(now.f_W, first.f_W) && isSameBits(now.p_WG, first.p_WG));
                        }
                    }
                    isHeld += first.constraints > 0 ? 1 : 0;
                }
            }
        }
        QVERIFY2(isHeld > 50, qPrintable(QString::number(isHeld)));
    }

    void aHipThatIsNotFiniteChangesNothing()
    {
        Palpator palpator;
        palpator.borrowScene(&m_scene);
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
        palpator.borrowScene(&m_scene);
        for (int i = 0; i < 200; ++i) {
            (void)palpator.step(wander(i), 1e-3);
        }
        const HapticScene other({HapticStructure{"far", indexed(box(Vec3(500, 0, 0), Vec3(510, 10, 10))), {}, 0}});
        palpator.borrowScene(&other);
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
        palpator.borrowScene(&scene);
        (void)palpator.step(Vec3(0, 0, 1), 1e-3);
        QCOMPARE(palpator.step(Vec3(0, 0, -1), 1e-3).structure, 1);
    }

    void reportsTheTriangleOfTheMeshThatWasGiven()
    {
        const geometry::RepairedMesh r = geometry::repair(box(Vec3(-5, -5, -5), Vec3(5, 5, 0), 6));
        const HapticScene scene({HapticStructure{
            "box", std::make_shared<geometry::SurfaceIndex>(geometry::SurfaceIndex::build(r)), {}, 0}});
        Palpator palpator;
        palpator.borrowScene(&scene);
        (void)palpator.step(Vec3(1.1, 2.3, 1), 1e-3);
        const TickResult t = palpator.step(Vec3(1.1, 2.3, -1), 1e-3);
        core::Box touched;
        for (const std::uint32_t v : r.mesh.triangles[t.triangle]) {
            touched.extend(r.mesh.vertices[v]);
        }
        QVERIFY(touched.exteriorDistance(Vec3(1.1, 2.3, 0)) == 0.0);
    }
};

PALPATE_TEST_NAMED("Palpator", PalpatorTest)
#include "tst_Palpator.moc"
