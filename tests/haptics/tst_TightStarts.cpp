// SPDX-License-Identifier: BSD-3-Clause
// Tests a ball that is placed nearer to a surface than its radius: by the first HIP, by a structure that appears, or by
// another radius. The ball must neither be pushed nor held: it moves as the largest ball that fits there.
#include "Known.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/haptics/Palpator.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace palpate;
using namespace palpate::test;
using haptics::HapticScene;
using haptics::HapticStructure;
using haptics::Palpator;
using haptics::TickResult;
using haptics::TickStatus;

namespace {

constexpr double kSoft_N_per_mm = 0.5;

HapticStructure softOrgan(const geometry::TriangleMesh& mesh, const char* name = "organ", std::uint32_t layer = 0)
{
    HapticStructure out;
    out.name = name;
    out.surface = indexed(mesh);
    out.tissue.stiffness_N_per_mm = kSoft_N_per_mm;
    out.layer = layer;
    return out;
}

/// A palpator with its own scene.
struct TightHand
{
    HapticScene scene;
    Palpator palpator;

    TightHand(std::vector<HapticStructure> structures, double radius_mm)
        : scene(std::move(structures), radius_mm)
    {
        palpator.borrowScene(&scene);
    }
    TightHand(const geometry::TriangleMesh& mesh, double radius_mm)
        : TightHand({softOrgan(mesh)}, radius_mm)
    {
    }
    TickResult at(const Vec3& hip) { return palpator.step(hip, kTick_s); }
};

/// Appends the positions of a straight path that ends at `to`, at most `step_mm` apart.
void goTo(std::vector<Vec3>& path, const Vec3& to, double step_mm = 0.2)
{
    const Vec3 from = path.back();
    const int ticks = std::max(1, static_cast<int>(std::ceil((to - from).norm() / step_mm)));
    for (int i = 1; i <= ticks; ++i) {
        path.push_back(from + (to - from) * (double(i) / ticks));
    }
}

/// A block with its top in z = 0: the height of the HIP is its distance.
geometry::TriangleMesh flatBlock()
{
    return box(Vec3(-60, -60, -40), Vec3(60, 60, 0), 30);
}

} // namespace

class TightStarts : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    /// Over a plane the centre stays above its greatest height so far, up to the radius, and follows the hand sideways.
    /// This closed form has no memory of the start except for the height.
    void movesOverAPlaneLikeABallThatFits_data()
    {
        QTest::addColumn<double>("radius");
        QTest::addColumn<double>("height");
        QTest::addColumn<bool>("isOpen");
        for (const double radius : {2.0, 4.0, 8.0, 12.0}) {
            for (const double share : {0.0, 1e-9, 0.02, 0.25, 0.6, 0.999}) {
                for (const bool isOpen : {false, true}) {
                    QTest::addRow("%g mm, %g mm above a %s", radius, share * radius, isOpen ? "sheet" : "block")
                        << radius << share * radius << isOpen;
                }
            }
        }
    }
    void movesOverAPlaneLikeABallThatFits()
    {
        QFETCH(const double, radius);
        QFETCH(const double, height);
        QFETCH(const bool, isOpen);
        TightHand hand(isOpen ? sheet(60.0, 30) : flatBlock(), radius);
        std::vector<Vec3> path{Vec3(1.3, 2.1, height)};
        goTo(path, Vec3(1.3, 2.1, -14));
        goTo(path, Vec3(13.3, -7.9, -14));
        goTo(path, Vec3(13.2, -7.85, -14), 5e-5); // slowly
        goTo(path, Vec3(10, -5, 0.5 * (height + radius)));
        goTo(path, Vec3(-4, 3, -1), 1.0);
        goTo(path, Vec3(-4, 3, radius + 1));
        goTo(path, Vec3(2, 3, -2));
        goTo(path, Vec3(-7, 8, -2));
        double lowest = height;
        for (std::size_t i = 0; i < path.size(); ++i) {
            const TickResult r = hand.at(path[i]);
            QVERIFY2(r.status == TickStatus::Converged, qPrintable(QString("tick %1").arg(i)));
            const Vec3 expected(path[i].x(), path[i].y(), std::max(path[i].z(), lowest));
            // A step that brings the ball nearer to the HIP by less than its accuracy may be made with a later one.
            const double step = i > 0 ? (path[i] - path[i - 1]).norm() : 0.0;
            const double most = kBound_mm + (step < 1e-4 ? step : 0.0), off = (r.p_WG - expected).norm();
            QVERIFY2(off <= most, qPrintable(QString("tick %1: off by %2 mm").arg(i).arg(off)));
            QVERIFY((r.f_W - kSoft_N_per_mm * (r.p_WG - path[i])).norm() <= 1e-12 || r.constraints == 0);
            QVERIFY(i > 0 || r.f_W.isZero(0.0));
            lowest = std::min(radius, std::max(lowest, path[i].z()));
        }
        QVERIFY(lowest == radius);
    }

    /// A start with clearance d is the same as the contact of a ball with radius d, wherever that ball came from. Two
    /// solutions differ by the lateral accuracy of rest, 1.4e-4 of the distance to the HIP each (fingertip.md, "Rest").
    void pressesAndSlidesLikeABallOfItsClearance_data()
    {
        QTest::addColumn<geometry::TriangleMesh>("mesh");
        QTest::addColumn<double>("radius");
        QTest::addColumn<Vec3>("start");
        QTest::addColumn<double>("clearance");
        QTest::addColumn<Vec3>("pressed");
        QTest::addColumn<Vec3>("slid");
        const double r2 = std::sqrt(0.5);
        for (const double radius : {2.0, 5.0, 8.0, 12.0}) {
            const QByteArray name = QByteArray::number(radius);
            QTest::newRow("edge of a block, mm: " + name)
                << box(Vec3(-60, -60, -40), Vec3(0, 60, 0), 15) << radius << Vec3(Vec3(0, 1, 0) + r2 * Vec3(1, 0, 1))
                << 1.0 << Vec3(-3, 1, -2) << Vec3(-3, 16, -2);
            QTest::newRow("over the edge of a block, mm: " + name)
                << box(Vec3(-60, -60, -40), Vec3(0, 60, 0), 15) << radius << Vec3(-8, 1, 1.5) << 1.5 << Vec3(-8, 1, -6)
                << Vec3(-1, 5, -6);
            QTest::newRow("corner of a block, mm: " + name)
                << box(Vec3(-40, -40, -40), Vec3(0, 0, 0), 10) << radius << Vec3(Vec3(1, 2, 3).normalized()) << 1.0
                << Vec3(-1, -2, -3) << Vec3(-8, -3, -2);
            QTest::newRow("thin plate, mm: " + name)
                << box(Vec3(-60, -60, -0.4), Vec3(60, 60, 0), 30) << radius << Vec3(3.1, 2.2, 0.8) << 0.8
                << Vec3(3.1, 2.2, -13) << Vec3(-9, 8, -13);
            // Both walls are one clearance away.
            const double half = std::numbers::pi / 6.0;
            QTest::newRow("groove of 60 degrees, mm: " + name)
                << groove(2.0 * half, 30.0, 40.0) << radius << Vec3(0, 1, 1.2 / std::sin(half)) << 1.2
                << Vec3(0.1, 1, -5) << Vec3(-0.2, 14, -4);
            QTest::newRow("rim of a groove, mm: " + name) << groove(2.0 * half, 30.0, 40.0) << radius << Vec3(0, 1, 8)
                                                          << 8.0 * std::sin(half) << Vec3(3, 1, 1) << Vec3(-3, 9, 1);
        }
    }
    void pressesAndSlidesLikeABallOfItsClearance()
    {
        QFETCH(const geometry::TriangleMesh, mesh);
        QFETCH(const double, radius);
        QFETCH(const Vec3, start);
        QFETCH(const double, clearance);
        QFETCH(const Vec3, pressed);
        QFETCH(const Vec3, slid);
        TightHand placed(mesh, radius), small(mesh, std::min(radius, clearance));
        // The small ball comes from above to the same place.
        std::vector<Vec3> path{start + 60.0 * (start - pressed).normalized()};
        goTo(path, start);
        for (const Vec3& hip : path) {
            (void)small.at(hip);
        }
        const bool isPlaced = clearance < radius;
        if (!isPlaced) {
            for (const Vec3& hip : path) {
                (void)placed.at(hip);
            }
        }
        path.assign(1, start);
        goTo(path, pressed);
        goTo(path, slid);
        goTo(path, pressed);
        double farthest = 0.0;
        for (std::size_t i = 0; i < path.size(); ++i) {
            const TickResult a = placed.at(path[i]), b = small.at(path[i]);
            const double most = kBound_mm + 2.0 * std::sqrt(2e-8) * (b.p_WG - path[i]).norm();
            const double apart = (a.p_WG - b.p_WG).norm();
            QVERIFY2(a.status == TickStatus::Converged && apart <= most,
                     qPrintable(QString("tick %1: %2 mm apart, expected %3").arg(i).arg(apart).arg(most)));
            farthest = std::max(farthest, (a.p_WG - start).norm());
        }
        QVERIFY2(farthest > 0.3 * (slid - pressed).norm(), "the god-object did not follow the hand");
    }

    /// Once the whole ball has fitted, every bit is that of a motion that began outside.
    void afterTheWholeBallHasFittedTheStartIsForgotten_data()
    {
        QTest::addColumn<geometry::TriangleMesh>("mesh");
        QTest::addColumn<double>("friction");
        QTest::newRow("hills") << bumpySphere(40, 30.0, 0.03) << 0.0;
        QTest::newRow("hills with friction") << bumpySphere(40, 30.0, 0.03) << 0.3;
        QTest::newRow("block") << box(Vec3(-60, -60, -60), Vec3(60, 60, 30), 20) << 0.0;
    }
    void afterTheWholeBallHasFittedTheStartIsForgotten()
    {
        QFETCH(const geometry::TriangleMesh, mesh);
        QFETCH(const double, friction);
        for (const double radius : {2.0, 5.0, 8.0, 12.0}) {
            for (const double height : {1.001, 0.4 * radius, -0.4 * radius, -1.5 * radius}) {
                HapticStructure structure = softOrgan(mesh);
                structure.tissue.friction_static = structure.tissue.friction_dynamic = friction;
                TightHand placed({structure}, radius), outside({structure}, radius);
                const Vec3 start(0.7, 1.1, 30.0 + height), away(0.7, 1.1, 31.0 + 1.2 * radius);
                for (int i = 0; i < 10; ++i) {
                    (void)outside.at(Vec3(0.7, 1.1, 80 - 1 * i));
                }
                std::vector<Vec3> path{start};
                if (height > 0.0) {
                    goTo(path, Vec3(0.7, 1.1, 30));
                    goTo(path, Vec3(5, -4, 28));
                }
                goTo(path, away);
                for (const Vec3& hip : path) {
                    (void)placed.at(hip);
                }
                path.assign(1, away);
                goTo(path, Vec3(3, 2, 26), 0.1);
                goTo(path, Vec3(-9, 7, 26), 0.1);
                goTo(path, away, 0.3);
                int contacts = 0;
                for (std::size_t i = 0; i < path.size(); ++i) {
                    const TickResult a = placed.at(path[i]), b = outside.at(path[i]);
                    QVERIFY2(a.p_WG == b.p_WG && a.f_W == b.f_W && a.iterations == b.iterations &&
                                 a.triangle == b.triangle,
                             qPrintable(QString("radius %1, %2 mm above, tick %3").arg(radius).arg(height).arg(i)));
                    contacts += a.constraints > 0 ? 1 : 0;
                }
                QVERIFY(contacts > 100);
            }
        }
    }

    /// Out of the tissue through its surface, and then sideways at 1 mm, where the whole ball does not fit.
    void leavesTissueFreelyAndSlidesOutside()
    {
        for (const double radius : {2.0, 8.0, 12.0}) {
            for (const double depth : {1e-9, 0.5, 3.0, 19.0}) {
                TightHand hand(flatBlock(), radius);
                std::vector<Vec3> path{Vec3(1.3, 2.1, -depth)};
                goTo(path, Vec3(3, 4, 1));
                goTo(path, Vec3(25, -9, 1));
                const double skin = hand.scene.layer(0).skin_mm;
                for (const Vec3& hip : path) {
                    const TickResult r = hand.at(hip);
                    QVERIFY2((r.p_WG - hip).norm() <= 4.0 * skin,
                             qPrintable(QString("%1 mm behind").arg((r.p_WG - hip).norm())));
                }
                QVERIFY_AT(hand.at(Vec3(25, -9, -4)), Vec3(25, -9, 1));
                path.assign(1, Vec3(25, -9, -4));
                goTo(path, Vec3(25, -9, radius + 1));
                goTo(path, Vec3(20, -5, -4));
                for (const Vec3& hip : path) {
                    (void)hand.at(hip);
                }
                QVERIFY_AT(hand.at(Vec3(20, -5, -4)), Vec3(20, -5, radius));
            }
        }
    }

    /// Any motion away from the surface is free from the first tick on.
    void leavesWithoutForce()
    {
        const geometry::TriangleMesh mesh = sphere(16, 30.0);
        std::mt19937_64 random(5);
        std::normal_distribution<double> normal;
        for (int i = 0; i < 50; ++i) {
            TightHand hand(mesh, 8.0);
            const Vec3 out = Vec3(normal(random), normal(random), normal(random)).normalized();
            const double height = 0.15 * i;
            for (int k = 0; k < 60; ++k) {
                const Vec3 hip = (30.0 + height + 0.2 * k) * out;
                const TickResult r = hand.at(hip);
                QVERIFY(r.p_WG == hip && r.f_W.isZero(0.0));
            }
        }
    }

    /// Each layer has its own ball and its own room: 2 mm above an organ, 7 mm above the lump inside.
    void layersHaveTheirOwnRoom()
    {
        const double radius = 8.0;
        TightHand hand(
            {softOrgan(flatBlock(), "liver", 0), softOrgan(box(Vec3(-20, -20, -30), Vec3(20, 20, -5), 10), "lump", 1)},
            radius);
        std::vector<Vec3> path{Vec3(1, 2, 2)};
        goTo(path, Vec3(1, 2, -12));
        goTo(path, Vec3(9, -5, -12));
        TickResult r;
        for (const Vec3& hip : path) {
            r = hand.at(hip);
        }
        QCOMPARE(r.contactCount, std::uint8_t(2));
        QVERIFY((r.contacts[0].p_WG - Vec3(9, -5, 2)).norm() <= kBound_mm);
        QVERIFY((r.contacts[1].p_WG - Vec3(9, -5, 2)).norm() <= kBound_mm);
        path.assign(1, Vec3(9, -5, -12));
        goTo(path, Vec3(9, -5, 4)); // the lump has its whole room again, the liver not
        goTo(path, Vec3(2, -5, -12));
        for (const Vec3& hip : path) {
            r = hand.at(hip);
        }
        QVERIFY((r.contacts[0].p_WG - Vec3(2, -5, 4)).norm() <= kBound_mm);
        QVERIFY((r.contacts[1].p_WG - Vec3(2, -5, 3)).norm() <= kBound_mm);
    }

    /// Several structures of one layer: the ball keeps the distance that it has from one, and its radius from the
    /// other.
    void keepsOffSeveralStructures()
    {
        TightHand hand(
            {softOrgan(flatBlock(), "organ"), softOrgan(box(Vec3(10, -30, -5), Vec3(20, 30, 20), 8), "vessel")}, 8.0);
        std::vector<Vec3> path{Vec3(1, 2, 2)}; // 2 mm from one, 9 mm from the other
        goTo(path, Vec3(1, 2, -3));
        goTo(path, Vec3(12, 6, -3));
        for (const Vec3& hip : path) {
            (void)hand.at(hip);
        }
        QVERIFY_AT(hand.at(Vec3(12, 6, -3)), Vec3(2, 6, 2)); // the whole radius from the vessel
        QCOMPARE(hand.at(Vec3(12, 6, -3)).constraints, std::uint8_t(2));
    }

    /// A structure that appears near a hand, or around it, is a start as well.
    void aStructureThatAppearsIsAStart()
    {
        const double radius = 8.0;
        HapticStructure hidden = softOrgan(flatBlock(), "block");
        const HapticStructure other = softOrgan(box(Vec3(200, 0, 0), Vec3(210, 10, 10)), "other");
        const HapticScene shown({hidden, other}, radius);
        hidden.surface = nullptr;
        const HapticScene without({hidden, other}, radius);
        for (const double height : {2.0, -3.0, -20.0}) {
            Palpator palpator;
            palpator.borrowScene(&without);
            (void)palpator.step(Vec3(1, 2, height - 1), kTick_s);
            (void)palpator.step(Vec3(1, 2, height), kTick_s);
            palpator.borrowScene(&shown);
            const double level = std::max(1.0, height);
            std::vector<Vec3> path{Vec3(1, 2, height)};
            goTo(path, Vec3(1, 2, level));
            const double skin = shown.layer(0).skin_mm;
            for (const Vec3& hip : path) {
                QVERIFY((palpator.step(hip, kTick_s).p_WG - hip).norm() <= 4.0 * skin);
            }
            path.assign(1, Vec3(1, 2, level));
            goTo(path, Vec3(1, 2, -9));
            goTo(path, Vec3(12, -3, -9));
            for (const Vec3& hip : path) {
                (void)palpator.step(hip, kTick_s);
            }
            QVERIFY_AT(palpator.step(Vec3(12, -3, -9), kTick_s), Vec3(12, -3, level));
        }
    }

    /// A contact that is restored, or carried to a replaced surface, keeps the distance that it had.
    void keepsItsDistanceAcrossChangesOfTheScene()
    {
        const double radius = 8.0;
        const HapticStructure block1 = softOrgan(flatBlock(), "block"),
                              block2 = softOrgan(moved(flatBlock(), Vec3(0, 0, 0.3)), "block"),
                              other = softOrgan(box(Vec3(200, 0, 0), Vec3(210, 10, 10)), "other");
        HapticStructure hidden = block1;
        hidden.surface = nullptr;
        const HapticScene first({block1, other}, radius), higher({block2, other}, radius),
            without({hidden, other}, radius);
        Palpator palpator;
        palpator.borrowScene(&first);
        std::vector<Vec3> path{Vec3(1, 2, 2)};
        goTo(path, Vec3(1, 2, -3));
        for (const Vec3& hip : path) {
            (void)palpator.step(hip, kTick_s);
        }
        palpator.borrowScene(&higher);
        QVERIFY_AT(palpator.step(Vec3(1, 2, -3), kTick_s), Vec3(1, 2, 2.3));
        palpator.borrowScene(&without);
        QVERIFY_AT(palpator.step(Vec3(1, 2, -3), kTick_s), Vec3(1, 2, -3));
        QVERIFY(palpator.borrowScene(&higher)); // restored
        QVERIFY_AT(palpator.step(Vec3(1, 2, -3), kTick_s), Vec3(1, 2, 2.3));
        QVERIFY_AT(palpator.step(Vec3(4, -2, -3), kTick_s), Vec3(4, -2, 2.3));
    }

    /// Another radius under a pressing hand gives no push: it counts once the ball has left.
    void anotherRadiusGivesNoPush()
    {
        const HapticStructure structure = softOrgan(flatBlock());
        const HapticScene point({structure}, 0.0), small({structure}, 2.0), large({structure}, 8.0);
        for (const HapticScene* before : {&point, &small}) {
            Palpator palpator;
            palpator.borrowScene(before);
            const double held = before->fingertip_mm();
            std::vector<Vec3> path{Vec3(1, 2, 12)};
            goTo(path, Vec3(1, 2, -3));
            for (const Vec3& hip : path) {
                (void)palpator.step(hip, kTick_s);
            }
            palpator.borrowScene(&large);
            QVERIFY_AT(palpator.step(Vec3(1, 2, -3), kTick_s), Vec3(1, 2, held));
            QVERIFY_AT(palpator.step(Vec3(4, -2, -3), kTick_s), Vec3(4, -2, held));
            path.assign(1, Vec3(4, -2, -3));
            goTo(path, Vec3(4, -2, 9));
            goTo(path, Vec3(6, 1, -3));
            for (const Vec3& hip : path) {
                (void)palpator.step(hip, kTick_s);
            }
            QVERIFY_AT(palpator.step(Vec3(6, 1, -3), kTick_s), Vec3(6, 1, 8));
        }
    }

    /// The state between ticks and the HIP determine each tick, also while the ball lacks room.
    void whatIsKeptBetweenTicksChangesNothing()
    {
        const geometry::TriangleMesh mesh = bumpySphere(30, 30.0, 0.05);
        TightHand kept(mesh, 8.0), thrownAway(mesh, 8.0);
        int tight = 0;
        for (int i = 0; i < 3000; ++i) {
            const Vec3 out = Vec3(std::sin(0.02 * i), std::cos(0.023 * i), std::sin(0.011 * i)).normalized();
            const Vec3 hip = (i < 2000 ? 32.0 - 3.0 * std::sin(0.01 * i) : 32.0 + 0.02 * (i - 2000)) * out;
            thrownAway.palpator.restore(kept.palpator.state());
            const TickResult a = kept.at(hip), b = thrownAway.at(hip);
            QVERIFY2(a.p_WG == b.p_WG && a.f_W == b.f_W && a.iterations == b.iterations && a.status == b.status,
                     qPrintable(QString("tick %1").arg(i)));
            tight += kept.palpator.state().layers[0].placed == haptics::GodObjectState::kTight ? 1 : 0;
        }
        QVERIFY2(tight > 1000 && tight < 2999, qPrintable(QString::number(tight)));
    }

    /// A start that has its whole room is no different: the search is not charged to the tick.
    void aStartWithRoomCostsNoWork()
    {
        const geometry::TriangleMesh mesh = bumpySphere(30, 30.0, 0.05);
        for (const std::uint32_t work : {60U, 120U, 400U}) {
            const HapticScene scene({softOrgan(mesh)}, 4.0), same({softOrgan(mesh)}, 4.0);
            Palpator a(haptics::Fingertips::Any, {.ballWork = work}), b(haptics::Fingertips::Any, {.ballWork = work});
            a.borrowScene(&scene);
            b.borrowScene(&scene);
            for (int i = 0; i < 200; ++i) {
                if (i % 7 == 0) {
                    a.borrowScene(i % 2 == 0 ? &same : &scene, haptics::Continuity::Places);
                }
                const double arc = 0.01 * i;
                const Vec3 hip = (42.0 - std::min(8.0, 0.1 * i)) * Vec3(std::cos(arc), std::sin(arc), 0.0);
                const TickResult p = a.step(hip, kTick_s), q = b.step(hip, kTick_s);
                if (q.constraints > 0) {
                    break; // a change of scene discards contacts
                }
                QVERIFY(p.p_WG == q.p_WG && p.status == q.status && p.iterations == q.iterations);
            }
        }
    }
};

PALPATE_TEST(TightStarts)
#include "tst_TightStarts.moc"
