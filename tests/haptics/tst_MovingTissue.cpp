// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that move while they are touched: no wall passes through a hand, and nothing else changes.
#include "Known.h"
#include "Motions.h"
#include "Shapes.h"
#include "TestRunner.h"
#include "Trials.h"

#include <palpate/geometry/Inside.h>
#include <palpate/haptics/Palpator.h>

#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

using namespace palpate;
using namespace palpate::test;
using geometry::SurfaceMotion;
using haptics::HapticScene;
using haptics::HapticStructure;
using haptics::Palpator;
using haptics::TickResult;
using haptics::TickStatus;
using haptics::Tissue;

namespace {

constexpr double kSpring = 0.5; // N/mm

HapticStructure moving(const geometry::TriangleMesh& mesh, std::shared_ptr<const SurfaceMotion> motion,
                       const Tissue& tissue = {kSpring, 0.0}, std::uint32_t layer = 0)
{
    HapticStructure structure{"it", indexed(mesh), tissue, layer};
    structure.motion = std::move(motion);
    return structure;
}

/// A path that goes in and out of a sphere of 40 mm and around it.
Vec3 wander(double t)
{
    const double a = 2.0 * t;
    return (38.0 + 4.0 * std::sin(5.0 * t)) *
           Vec3(std::cos(a), std::sin(a) * 0.8, std::sin(0.7 * a) * 0.6).normalized();
}

Vec3 speedOfWander(double t)
{
    return (wander(t + 1e-6) - wander(t - 1e-6)) / 2e-6;
}

Tissue fullTissue()
{
    Tissue tissue;
    tissue.stiffness_N_per_mm = kSpring;
    tissue.damping_Ns_per_mm = 0.002;
    tissue.friction_static = 0.3;
    tissue.friction_dynamic = 0.2;
    tissue.friction_drag_Ns_per_mm = 0.001;
    return tissue;
}

} // namespace

class MovingTissue : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void thinPlateDoesNotPassAStillHand_data()
    {
        QTest::addColumn<double>("speed_mm_s");
        QTest::addColumn<double>("radius_mm");
        for (const double radius_mm : {0.0, 4.0}) {
            for (const double speed : {20.0, 2000.0, 50000.0}) {
                QTest::addRow("%g mm/s, radius %g mm", speed, radius_mm) << speed << radius_mm;
            }
        }
    }
    void thinPlateDoesNotPassAStillHand()
    {
        QFETCH(double, speed_mm_s);
        QFETCH(double, radius_mm);
        const double duration_s = 100.0 / speed_mm_s, from_mm = -20.0;
        const Vec3 hip(0.3, 0.2, 0.0);
        const auto motion = glide(Vec3(0, 0, speed_mm_s), duration_s, Vec3(0, 0, from_mm));
        const HapticScene scene({moving(sheet(50.0, 5), motion)}, radius_mm);
        Palpator palpator;
        palpator.borrowScene(&scene);
        double before_mW = 0.0, work_mJ = 0.0, depth = 0.0;
        const int ticks = static_cast<int>(duration_s / kTick_s);
        for (int i = 0; i < ticks; ++i) {
            const TickResult tick = palpator.step(hip, kTick_s, nullptr, i * kTick_s);
            depth = from_mm + i * kTick_s * speed_mm_s + radius_mm;
            if (depth < -1e-3) {
                QCOMPARE(tick.contactCount, 0);
                QVERIFY(tick.p_WG == hip);
            } else if (depth > 1e-3) {
                QCOMPARE(tick.contactCount, 1);
                QVERIFY((tick.p_WG - hip - Vec3(0, 0, depth)).norm() < 1e-5);
                QVERIFY((tick.f_W - Vec3(0, 0, kSpring * depth)).norm() < 1e-5);
                QVERIFY((tick.n_W - Vec3::UnitZ()).norm() < 1e-9);
            }
            const double power_mW = palpator.tissuePower_mW();
            work_mJ += 0.5 * kTick_s * (before_mW + power_mW);
            before_mW = power_mW;
        }
        QVERIFY(depth > 20.0);
        if (ticks >= 50) { // the wall has put the spring's energy in, to the rounding of the trapezium rule
            const double stored_mJ = 0.5 * kSpring * depth * depth;
            QVERIFY2(std::abs(work_mJ - stored_mJ) < 0.01 * stored_mJ,
                     qPrintable(QString("%1 mJ of %2").arg(work_mJ).arg(stored_mJ)));
        }
    }

    void oscillatingSphereDoesNotPassAHand_data()
    {
        QTest::addColumn<double>("frequency_Hz");
        QTest::addColumn<double>("radius_mm");
        for (const double radius_mm : {0.0, 3.0}) {
            QTest::addRow("0.25 Hz, radius %g mm", radius_mm) << 0.25 << radius_mm;
            QTest::addRow("50 Hz, radius %g mm", radius_mm) << 50.0 << radius_mm;
        }
    }
    void oscillatingSphereDoesNotPassAHand()
    {
        QFETCH(double, frequency_Hz);
        QFETCH(double, radius_mm);
        const Vec3 amplitude(0, 0, 20.0), hip(1, 2, 35.0);
        const auto mesh = sphere(8, 30.0);
        const auto motion = oscillation(amplitude, frequency_Hz);
        const HapticScene scene({moving(mesh, motion)}, radius_mm);
        const auto index = indexed(mesh);
        Palpator palpator;
        palpator.borrowScene(&scene);
        int touched = 0;
        for (int i = 0; i < 20000; ++i) {
            const double t = i * kTick_s;
            const TickResult tick = palpator.step(hip, kTick_s, nullptr, t);
            QVERIFY(tick.status == TickStatus::Converged);
            const auto moment = motion->at(t);
            const Vec3 centre = motion->toWorld(moment, Vec3::Zero());
            const Vec3 g_R = tick.p_WG - centre;
            QVERIFY2(g_R.norm() >= 29.5 + radius_mm, "the god-object is inside");
            QVERIFY2(g_R.z() > 0.0, "the god-object has passed the sphere");
            QVERIFY((tick.f_W - kSpring * (tick.p_WG - hip)).norm() < 1e-9);
            touched += tick.contactCount;
        }
        QVERIFY(touched > 8000 && touched < 15000);
    }

    void translationEqualsTheStaticRun_data()
    {
        QTest::addColumn<double>("radius_mm");
        QTest::addColumn<bool>("isFull");
        QTest::newRow("point") << 0.0 << false;
        QTest::newRow("point, friction and damping") << 0.0 << true;
        QTest::newRow("ball") << 2.0 << false;
        QTest::newRow("ball, friction and damping") << 2.0 << true;
    }
    void translationEqualsTheStaticRun()
    {
        QFETCH(double, radius_mm);
        QFETCH(bool, isFull);
        const auto mesh = bumpySphere(20, 40.0, 0.03);
        const Tissue tissue = isFull ? fullTissue() : Tissue{kSpring, 0.0};
        const auto motion = oscillation(Vec3(5, -8, 20), 1.7);
        HapticStructure still = moving(mesh, nullptr, tissue);
        const HapticScene rests({still}, radius_mm), moves({moving(mesh, motion, tissue)}, radius_mm);
        Palpator a, b;
        a.borrowScene(&rests);
        b.borrowScene(&moves);
        for (int i = 0; i < 20000; ++i) {
            const double t = i * kTick_s;
            const auto moment = motion->at(t);
            const Vec3 shift = motion->toWorld(moment, Vec3::Zero()), p = wander(t) + shift;
            const Vec3 X = p - shift, v_R = speedOfWander(t), v = v_R + motion->velocity(moment, X);
            const TickResult was = a.step(X, kTick_s, &v_R, t), is = b.step(p, kTick_s, &v, t);
            QCOMPARE(is.contactCount, was.contactCount);
            QCOMPARE(is.triangle, was.triangle);
            QVERIFY2((is.p_WG - shift - was.p_WG).norm() <= 1e-10,
                     qPrintable(QString("tick %1: %2 mm").arg(i).arg((is.p_WG - shift - was.p_WG).norm())));
            QVERIFY((is.f_W - was.f_W).norm() <= 1e-10);
            QVERIFY(is.friction() == was.friction());
        }
    }

    void turningStructureTurnsTheForce()
    {
        std::vector<geometry::PoseKey> keys;
        for (int i = 0; i <= 32; ++i) {
            core::Transform pose = core::Transform::Identity();
            pose.linear() = Eigen::AngleAxisd(2.0 * std::numbers::pi * i / 32.0, Vec3(1, 2, 3).normalized()).matrix();
            keys.push_back({i / 32.0, pose});
        }
        const auto motion = SurfaceMotion::poses(keys, true).value();
        const HapticScene scene({moving(bumpySphere(20, 40.0, 0.03), motion)});
        Palpator palpator;
        palpator.borrowScene(&scene);
        Vec3 f_R = Vec3::Zero();
        for (int i = 0; i < 3000; ++i) {
            const auto moment = motion->at(i * kTick_s);
            const Vec3 X(20, 25, 18);
            const TickResult tick =
                palpator.step(motion->toWorld(moment, i == 0 ? Vec3(50, 62, 45) : X), kTick_s, nullptr, i * kTick_s);
            if (i == 1) {
                f_R = moment.turn.transpose() * tick.f_W;
                QVERIFY(f_R.norm() > 0.5);
            } else if (i > 1) {
                QVERIFY((moment.turn.transpose() * tick.f_W - f_R).norm() < 1e-9);
            }
        }
    }

    void tissuePowerClosesTheEnergy()
    {
        // The stored energy changes by the work of the hand and by that of the tissue, and by nothing else.
        geometry::Breath breath;
        breath.amplitude_mm = Vec3(0, 4, 15);
        breath.period_s = 1.0;
        breath.still_W = Vec3(0, 0, -50);
        breath.full_W = Vec3(0, 0, 50);
        const auto motion = SurfaceMotion::breath(breath, core::Box(Vec3::Constant(-70), Vec3::Constant(70))).value();
        const HapticScene scene({moving(sheet(200.0), motion)}); // flat: facets store energy in steps
        Palpator palpator;
        palpator.borrowScene(&scene);
        const auto path = [](double t) {
            return Vec3(20 * std::sin(3 * t), 15 * std::cos(2 * t), 4 + 6 * std::cos(7 * t));
        };
        const double dt = 1e-4; // the trapezium rule's error falls with its square
        double work = 0.0, most = 0.0, worst = 0.0, powerBefore = 0.0, tissue = 0.0;
        Vec3 before = path(0.0), f = Vec3::Zero();
        for (int i = 0; i < 40000; ++i) {
            const Vec3 p = path(i * dt);
            const TickResult tick = palpator.step(p, dt, nullptr, i * dt);
            const double power = palpator.tissuePower_mW();
            const auto moment = motion->at(i * dt); // the spring is one of the rest shape
            const double depth =
                (motion->toRest(moment, tick.p_WG, tick.p_WG).X - motion->toRest(moment, p, p).X).norm();
            QVERIFY(tick.contactCount == 0 || std::abs(tick.contacts[0].depth_mm - (tick.p_WG - p).norm()) < 1e-12);
            work += -0.5 * (f + tick.f_W).dot(p - before) + 0.5 * dt * (power + powerBefore);
            tissue += 0.5 * dt * std::abs(power + powerBefore);
            worst = std::max(worst, std::abs(work - 0.5 * kSpring * depth * depth));
            most = std::max(most, 0.5 * kSpring * depth * depth);
            f = tick.f_W;
            powerBefore = power;
            before = p;
        }
        QVERIFY2(most > 3.0 && tissue > most, qPrintable(QString("%1 mJ, tissue %2").arg(most).arg(tissue)));
        QVERIFY2(worst < 1e-3 * most, qPrintable(QString("%1 of %2 mJ").arg(worst).arg(most)));
    }

    void pulseScalesTheForceAndIsCounted()
    {
        const auto motion = SurfaceMotion::pulse(0.8, 0.5).value();
        const HapticScene scene({moving(sphere(20, 40.0), motion)});
        const HapticScene rests({moving(sphere(20, 40.0), nullptr)});
        Palpator palpator, still;
        palpator.borrowScene(&scene);
        still.borrowScene(&rests);
        double energy = 0.0, before = 0.0, least = 1e9, most = 0.0, stored = 0.0;
        for (int i = 0; i < 2000; ++i) {
            const Vec3 hip = i == 0 ? Vec3(0, 0, 45) : Vec3(0, 0, 36);
            const TickResult tick = palpator.step(hip, kTick_s, nullptr, i * kTick_s);
            const TickResult one = still.step(hip, kTick_s);
            const double s = 1.0 + 0.5 * std::pow(std::sin(std::numbers::pi * i * kTick_s / 0.8), 2);
            QVERIFY((tick.f_W - s * one.f_W).norm() < 1e-6);
            if (i == 1) {
                stored = 0.5 * kSpring * std::pow(one.contacts[0].depth_mm, 2);
            }
            if (i > 1) {
                energy += 0.5 * kTick_s * (before + palpator.tissuePower_mW());
                least = std::min(least, energy);
                most = std::max(most, energy);
            }
            before = palpator.tissuePower_mW();
        }
        QVERIFY(std::abs(most - 0.5 * stored) < 1e-4 && least > -1e-4);
    }

    void heldGodObjectKeepsItsMaterialPoint()
    {
        Tissue tissue{kSpring, 0.0};
        tissue.friction_static = tissue.friction_dynamic = 1.0;
        const auto motion = randomMotion(core::Box(Vec3::Constant(-70), Vec3::Constant(70)), 20.0, 4, 6);
        const HapticScene scene({moving(sphere(20, 40.0), motion, tissue)});
        Palpator palpator;
        palpator.borrowScene(&scene);
        const Vec3 X(0.5, 0.3, 36.0);
        Vec3 material = Vec3::Zero();
        for (int i = 0; i < trials(100000); ++i) {
            const auto moment = motion->at(i * kTick_s);
            const Vec3 wobble = 0.3 * Vec3(std::sin(0.01 * i), std::cos(0.013 * i), std::sin(0.02 * i));
            const Vec3 p =
                motion->toWorld(moment, i == 0 ? Vec3(0.5, 0.3, 45) : Vec3(X + (i < 3 ? Vec3::Zero() : wobble)));
            const TickResult tick = palpator.step(p, kTick_s, nullptr, i * kTick_s);
            if (i == 2) {
                material = palpator.state().layers[0].p_WG;
            } else if (i > 2) {
                QVERIFY(tick.friction() == haptics::Friction::Holds);
                QVERIFY((palpator.state().layers[0].p_WG - material).norm() <= 1e-9);
                QVERIFY((tick.p_WG - motion->toWorld(moment, material)).norm() <= 1e-9);
            }
        }
    }

    void handDoesNotPassRandomTissue_data()
    {
        QTest::addColumn<double>("radius_mm");
        QTest::newRow("point") << 0.0;
        QTest::newRow("ball") << 2.0;
    }
    /// PALPATE_MOVING_TICKS in the environment sets the number of ticks.
    void handDoesNotPassRandomTissue()
    {
        QFETCH(double, radius_mm);
        const int asked = qEnvironmentVariableIntValue("PALPATE_MOVING_TICKS");
        const int motions = 10, ticks = (asked > 0 ? asked : trials(100000)) / motions;
        std::mt19937 random(42);
        std::uniform_real_distribution<double> of(-1.0, 1.0);
        const auto mesh = bumpySphere(12, 40.0, 0.05);
        const auto index = indexed(mesh);
        int touched = 0;
        for (int trial = 0; trial < motions; ++trial) {
            const auto motion = randomMotion(core::Box(Vec3::Constant(-60), Vec3::Constant(60)), 10.0, 4,
                                             static_cast<unsigned>(200 + trial));
            const HapticScene scene({moving(mesh, motion)}, radius_mm);
            Palpator palpator;
            palpator.borrowScene(&scene);
            Vec3 p(0, 0, 55), aim(0, 0, 20);
            for (int i = 0; i < ticks; ++i) {
                if (i % 200 == 199) {
                    aim = 50.0 * Vec3(of(random), of(random), of(random));
                }
                const double speed = i / 400 % 2 == 0 ? 0.3 : 3.0; // mm a tick
                p += std::min(1.0, speed / std::max(1e-9, (aim - p).norm())) * (aim - p);
                const double t = i * kTick_s;
                const TickResult tick = palpator.step(p, kTick_s, nullptr, t);
                const Vec3 g_R = palpator.state().layers[0].p_WG;
                QVERIFY((tick.p_WG - motion->toWorld(motion->at(t), g_R)).norm() < 1e-9);
                QVERIFY(tick.p_WG.allFinite() && tick.f_W.allFinite());
                touched += tick.contactCount;
                if (i % 7 == 0 || tick.contactCount == 0) {
                    QVERIFY2(!isInside(*index, g_R), qPrintable(QString("trial %1, tick %2").arg(trial).arg(i)));
                }
            }
        }
        QVERIFY2(touched > motions * ticks / 4, qPrintable(QString::number(touched)));
    }

    void otherMotionsAreOtherLayers()
    {
        const auto slow = oscillation(Vec3(0, 0, 1), 1.0), fast = oscillation(Vec3(0, 0, 1), 2.0);
        const auto at = [](double x) { return moved(sphere(4, 10.0), Vec3(x, 0, 0)); };
        const auto again = oscillation(Vec3(0, 0, 1), 1.0); // equal, another object
        const HapticScene scene(
            {moving(at(0), slow), moving(at(30), fast), moving(at(60), nullptr), moving(at(90), again)});
        QCOMPARE(scene.layerCount(), std::size_t{3});
        QVERIFY(scene.layer(0).motion == nullptr);
        QVERIFY(scene.layer(1).motion == slow.get() && scene.layer(1).structures.size() == 2);
        QVERIFY(scene.layer(2).motion == fast.get());
        std::vector<HapticStructure> many;
        for (int i = 0; i < 5; ++i) {
            many.push_back(moving(at(30 * i), oscillation(Vec3(0, 0, 1 + i), 1.0)));
        }
        const auto refused = HapticScene::make(many);
        QVERIFY(!refused.isOk() && QString::fromStdString(refused.status().message()).contains("found 5 layers"));
        many.pop_back();
        QVERIFY(HapticScene::make(many).isOk());
    }

    void layersKeepTheirGodObjectsWhenTheClockIsHeld()
    {
        const auto slow = oscillation(Vec3(0, 0, 5), 1.0), fast = oscillation(Vec3(0, 0, 5), 2.0);
        const auto at = [](double x) { return moved(sphere(8, 20.0), Vec3(x, 0, 0)); };
        const HapticScene scene({moving(at(0), slow), moving(at(90), fast)});
        const HapticScene held(
            {moving(at(0), slow->withClock(0.1, 0.1, 0.0)), moving(at(90), fast->withClock(0.1, 0.1, 0.0))});
        Palpator palpator;
        palpator.borrowScene(&scene);
        TickResult tick;
        for (int i = 0; i <= 100; ++i) {
            tick = palpator.step(Vec3(90, 0, i == 0 ? 40.0 : 16.0), kTick_s, nullptr, i * kTick_s);
        }
        QCOMPARE(tick.structure, 1);
        palpator.borrowScene(&held);
        for (int i = 101; i < 400; ++i) {
            const TickResult now = palpator.step(Vec3(90, 0, 16.0), kTick_s, nullptr, i * kTick_s);
            QCOMPARE(now.structure, 1);
            QVERIFY((now.p_WG - tick.p_WG).norm() < 1e-9 && (now.f_W - tick.f_W).norm() < 1e-9);
        }
    }

    void layersOfOneShapeKeepTheirGodObjects()
    {
        // Two structures breathe alike, one of them later: the shape of their motions is the same.
        const auto first = oscillation(Vec3(0, 0, 5), 1.0), second = first->withClock(0.0, 0.3, 1.0);
        const auto at = [](double x) { return moved(sphere(8, 20.0), Vec3(x, 0, 0)); };
        const auto scene = [&] { return HapticScene({moving(at(0), first), moving(at(90), second)}); };
        const HapticScene before = scene(), after = scene();
        for (const double x : {0.0, 90.0}) {
            Palpator palpator;
            palpator.borrowScene(&before);
            for (int i = 0; i <= 100; ++i) {
                (void)palpator.step(Vec3(x, 0, i == 0 ? 40.0 : 10.0), kTick_s, nullptr, i * kTick_s);
            }
            const haptics::PalpatorState was = palpator.state();
            palpator.borrowScene(&after);
            const haptics::PalpatorState is = palpator.state();
            for (std::size_t layer = 0; layer < 2; ++layer) {
                QVERIFY(is.layers[layer].p_WG == was.layers[layer].p_WG && is.p_RH[layer] == was.p_RH[layer]);
            }
            palpator.borrowScene(&after);
            QVERIFY(palpator.state().layers[0].p_WG == was.layers[0].p_WG);
            QCOMPARE(palpator.step(Vec3(x, 0, 10.0), kTick_s, nullptr, 0.101).structure, x == 0.0 ? 0 : 1);
        }
    }

    void hiddenStructureResumesTheContactWhereTheTissueIs_data()
    {
        QTest::addColumn<int>("ticks"); // hidden; the tissue rises by 0.04 mm in each
        QTest::addColumn<bool>("isTakenAlong");
        QTest::addColumn<double>("force_N"); // 0: not resumed
        QTest::newRow("the hand goes with the tissue") << 200 << true << 1.5;
        QTest::newRow("the tissue goes 8 mm past the hand") << 200 << false << 0.0;
        QTest::newRow("the tissue goes 2 mm past the hand") << 50 << false << 2.5;
        QTest::newRow("the hand goes with the tissue for too long") << 600 << true << 0.0;
    }
    void hiddenStructureResumesTheContactWhereTheTissueIs()
    {
        QFETCH(int, ticks);
        QFETCH(bool, isTakenAlong);
        QFETCH(double, force_N);
        const Vec3 v(0, 0, 40.0);
        HapticStructure resting{"other", indexed(moved(sphere(4, 5.0), Vec3(200, 0, 0))), {kSpring, 0.0}, 1};
        const auto shown =
            HapticScene::make({moving(box(Vec3(-40, -40, -40), Vec3(40, 40, 0), 4), glide(v, 2.0)), resting}).value();
        for (const bool isOtherShown : {true, false}) {
            auto hidden = shown->without(0).value();
            hidden = isOtherShown ? hidden : hidden->without(1).value();
            Palpator palpator, resumed;
            palpator.borrowScene(shown.get());
            double t = 0.0, depth = -1.0; // below the top at z = 0 at rest
            const auto felt = [&](Palpator& hand, bool isAlong) {
                const Vec3 hip = Vec3(1, 2, -depth) + (isAlong ? t : 100.0 * kTick_s) * v;
                return hand.step(hip, kTick_s, nullptr, t).f_W.norm();
            };
            for (int i = 0; i <= 100; ++i) {
                t = i * kTick_s;
                depth = -1.0 + 0.04 * i;
                (void)felt(palpator, true);
            }
            QVERIFY(std::abs(felt(palpator, true) - 1.5) < 1e-6);
            QVERIFY(!palpator.borrowScene(hidden.get()));
            for (int i = 1; i <= ticks; ++i) {
                t = (100 + i) * kTick_s;
                QCOMPARE(felt(palpator, isTakenAlong), 0.0);
            }
            palpator.borrowScene(shown.get());
            resumed.borrowScene(shown.get());
            resumed.restore(palpator.state()); // a recording may start in between
            const double force = felt(palpator, isTakenAlong);
            QVERIFY2(std::abs(force - force_N) < 1e-6, qPrintable(QString::number(force)));
            QVERIFY(felt(resumed, isTakenAlong) == force);
            QVERIFY(felt(palpator, isTakenAlong) == force); // and stays so
        }
    }

    void restoredStateGivesTheSameBits()
    {
        const auto motion = randomMotion(core::Box(Vec3::Constant(-60), Vec3::Constant(60)), 10.0, 4, 9);
        const HapticScene scene({moving(bumpySphere(20, 40.0, 0.03), motion, fullTissue())});
        Palpator one, two;
        one.borrowScene(&scene);
        two.borrowScene(&scene);
        for (int i = 0; i < 6000; ++i) {
            const double t = i * kTick_s;
            if (i % 50 == 0) {
                two.reset();
                two.restore(one.state());
            }
            const TickResult a = one.step(wander(t), kTick_s, nullptr, t), b = two.step(wander(t), kTick_s, nullptr, t);
            QVERIFY(std::memcmp(a.p_WG.data(), b.p_WG.data(), sizeof a.p_WG) == 0);
            QVERIFY(std::memcmp(a.f_W.data(), b.f_W.data(), sizeof a.f_W) == 0);
        }
    }

    void handBeyondTheMotionIsRefusedWithoutATrace()
    {
        const HapticScene scene({moving(sphere(8, 20.0), glide(Vec3(1e9, 0, 0), 1.0))});
        Palpator palpator;
        palpator.borrowScene(&scene);
        (void)palpator.step(Vec3(0, 0, 30), kTick_s, nullptr, 0.0);
        const haptics::PalpatorState before = palpator.state();
        const TickResult tick = palpator.step(Vec3(0, 0, 19), kTick_s, nullptr, 0.9);
        QVERIFY(tick.status == TickStatus::InvalidInput && tick.f_W.isZero(0.0));
        QVERIFY(palpator.state().p_WH == before.p_WH && palpator.state().p_RH == before.p_RH);
        QCOMPARE(palpator.tissuePower_mW(), 0.0);
    }
};

PALPATE_TEST(MovingTissue)
#include "tst_MovingTissue.moc"
