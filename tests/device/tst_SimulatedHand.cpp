// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/device/SimulatedHand.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

using palpate::core::StatusCode;
using palpate::device::SimulatedHandOptions;
using palpate::device::Vec3;
using Hand = palpate::device::SimulatedHand;

namespace {

palpate::device::HandScript pressAndLift()
{
    return palpate::device::HandScript::make(
               {{0.0, Vec3(0, 0, 10)}, {0.4, Vec3(0, 0, -5)}, {0.8, Vec3(3, 0, -5)}, {1.2, Vec3(3, 0, 10)}})
        .value();
}

palpate::device::HandScript still()
{
    return palpate::device::HandScript::make({{0.0, Vec3(1, 2, 3)}}).value();
}

} // namespace

class SimulatedHand : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void saysTheLimitsOfItsPreset()
    {
        SimulatedHandOptions options;
        options.preset = *palpate::device::findDevicePreset("falcon");
        options.rate_Hz = 2000.0;
        const auto info = Hand(still(), options).info();
        QCOMPARE(info.id, std::string("simulated-hand"));
        QCOMPARE(info.maxForce_N, 8.0);
        QCOMPARE(info.actuatedAxes, 3);
        QCOMPARE(info.rate_Hz, 2000.0);
        QCOMPARE(info.workspaceRadius_mm, 0.0);
    }

    void refusesBadOptions()
    {
        SimulatedHandOptions options;
        options.mass_kg = 0.0;
        QVERIFY(Hand(still(), options).start().code() == StatusCode::OutOfRange);
        options = {};
        options.rate_Hz = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(Hand(still(), options).start().code() == StatusCode::OutOfRange);
        options = {};
        options.subSteps = 0;
        QVERIFY(Hand(still(), options).start().code() == StatusCode::OutOfRange);
    }

    void followsTheScriptExactlyWhenRigid()
    {
        SimulatedHandOptions options;
        options.isRigid = true;
        Hand hand(pressAndLift(), options);
        QVERIFY(hand.start().isOk());
        for (int tick = 0; tick < 1300; ++tick) {
            const auto state = hand.read(tick);
            QVERIFY(state.p_D == hand.script().at(tick / 1000.0).p_W);
            QVERIFY(state.isPresent && state.time_ns == tick);
            QCOMPARE(hand.isFinished(), tick >= 1200);
            hand.write(Vec3(0, 0, 3));
        }
    }

    void giveWayToAForceByItsGrip()
    {
        // At rest the grip's spring carries the force: f = k (p - target).
        Hand hand(still());
        QVERIFY(hand.start().isOk());
        const Vec3 f(0.0, -1.0, 0.5);
        Vec3 p = Vec3::Zero();
        for (int tick = 0; tick < 3000; ++tick) {
            p = hand.read(tick).p_D;
            hand.write(f);
        }
        QVERIFY((p - (Vec3(1, 2, 3) + f / 0.5)).norm() < 1e-9);
    }

    void firstTicksObeyNewton()
    {
        // From rest, a constant force moves the hand by f t^2 / 2 m while spring and damper have hardly stretched.
        SimulatedHandOptions options;
        options.gripStiffness_N_per_mm = 0.0;
        options.gripDamping_Ns_per_mm = 0.0;
        options.deviceDamping_Ns_per_mm = 0.0;
        options.subSteps = 1000;
        Hand hand(still(), options);
        QVERIFY(hand.start().isOk());
        Vec3 p = Vec3::Zero();
        for (int tick = 0; tick <= 10; ++tick) {
            p = hand.read(tick).p_D;
            hand.write(Vec3(2.0, 0.0, 0.0));
        }
        // 2 N on 0.1 kg for 10 ms: 20 m/s^2, 1 mm; semi-implicit Euler is ahead by a fraction of 1 / steps.
        QVERIFY(std::abs(p[0] - 1.0 - 1.0) < 1.1e-4);
    }

    void saturatesAtTheDevicesForce()
    {
        Hand bounded(still());
        Hand pushed(still());
        QVERIFY(bounded.start().isOk() && pushed.start().isOk());
        for (int tick = 0; tick < 500; ++tick) {
            QVERIFY((bounded.read(tick).p_D - pushed.read(tick).p_D).norm() < 1e-12);
            bounded.write(Vec3(0, 0, 3.3));
            pushed.write(Vec3(0, 0, 1e6));
        }
    }

    void staysFiniteWhateverIsWritten()
    {
        Hand hand(still());
        QVERIFY(hand.start().isOk());
        const double inf = std::numeric_limits<double>::infinity();
        const double nan = std::numeric_limits<double>::quiet_NaN();
        for (int tick = 0; tick < 300; ++tick) {
            QVERIFY(hand.read(tick).p_D.allFinite());
            hand.write(tick % 3 == 0 ? Vec3(nan, 0, 0) : tick % 3 == 1 ? Vec3(0, inf, 0) : Vec3(1e308, 1e308, 1e308));
        }
    }

    void givesTheSameBitsForTheSameForcesWhateverTheClock()
    {
        std::vector<Vec3> first;
        for (int run = 0; run < 2; ++run) {
            Hand hand(pressAndLift());
            QVERIFY(hand.start().isOk());
            for (int tick = 0; tick < 1500; ++tick) {
                const Vec3 p = hand.read(run == 0 ? tick : 1'000'000LL * tick * tick).p_D;
                if (run == 0) {
                    first.push_back(p);
                } else {
                    QVERIFY(std::memcmp(p.data(), first[static_cast<std::size_t>(tick)].data(), 3 * sizeof(double)) ==
                            0);
                }
                hand.write(p[2] < 0.0 ? Vec3(0, 0, -0.4 * p[2]) : Vec3(Vec3::Zero()));
            }
        }
    }

    void beginsAnewAtStart()
    {
        Hand hand(pressAndLift());
        QVERIFY(hand.start().isOk());
        for (int tick = 0; tick < 1300; ++tick) {
            static_cast<void>(hand.read(tick));
        }
        QVERIFY(hand.isFinished());
        hand.stop();
        QVERIFY(hand.start().isOk());
        QVERIFY(!hand.isFinished());
        QVERIFY(hand.read(0).p_D == Vec3(0, 0, 10));
    }

    void readsInStepsOfItsResolution()
    {
        SimulatedHandOptions options;
        options.resolution_mm = 0.055;
        Hand hand(pressAndLift(), options);
        QVERIFY(hand.start().isOk());
        for (int tick = 0; tick < 1200; ++tick) {
            const double steps = hand.read(tick).p_D[2] / 0.055;
            QVERIFY(std::abs(steps - std::round(steps)) < 1e-9);
        }
    }
};

PALPATE_TEST(SimulatedHand)
#include "tst_SimulatedHand.moc"
