// SPDX-License-Identifier: BSD-3-Clause
#include "Motions.h"
#include "TestRunner.h"
#include "TouchScenes.h"

#include <palpate/device/DevicePresets.h>
#include <palpate/device/SimulatedHand.h>
#include <palpate/servo/ServoCore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using palpate::core::Vec3;
using palpate::device::DeviceState;
using palpate::servo::FaultKind;
using palpate::servo::GateLimits;
using palpate::servo::TickRecord;
using palpate::test::limitsOf;
using Core = palpate::servo::ServoCore;

namespace {

DeviceState hand(const Vec3& p, std::int64_t now_ns)
{
    DeviceState state;
    state.isPresent = true;
    state.p_D = p;
    state.time_ns = now_ns;
    return state;
}

std::int64_t timeOf(std::int64_t tick)
{
    return 1'000'000'000 + tick * 1'000'000;
}

} // namespace

class ServoCore : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void withoutASceneEverythingIsFreeSpace()
    {
        Core core(limitsOf("touch"), 1000.0);
        for (int i = 0; i < 10; ++i) {
            const TickRecord record = core.tick(hand(Vec3(i, 0, 0), timeOf(i)), timeOf(i));
            QCOMPARE(record.tick, std::int64_t{i});
            QVERIFY(record.time_ns == timeOf(i));
            QVERIFY(record.felt.f_W.isZero(0.0) && record.fSent_W.isZero(0.0));
            QVERIFY(record.felt.p_WG == Vec3(i, 0, 0));
            QCOMPARE(record.felt.structure, -1);
            QCOMPARE(record.scene, 0U);
            QCOMPARE(record.flags, static_cast<std::uint16_t>(i == 0 ? palpate::servo::kReset : 0));
        }
    }

    void handMovedByTissueOwesNoEnergy()
    {
        // A wall that moves by ±10 mm pushes a hand that yields like a spring and takes back what it gave.
        std::vector<palpate::haptics::HapticStructure> structures = palpate::test::sphereScene(30.0, 0.5)->structures();
        // Down first: the force is eased in before the wall arrives.
        structures[0].motion = palpate::test::oscillation(Vec3(0, 0, -10), 0.5);
        const palpate::haptics::HapticScene scene(structures);
        palpate::servo::PassivityLimits passivity;
        passivity.isOn = true;
        Core core(limitsOf("omega"), 1000.0, passivity);
        core.borrowScene(&scene, 1);
        constexpr double kHand = 0.3, kRest_mm = 33.0; // N/mm
        double z = kRest_mm, least_mJ = 0.0, most_mJ = 0.0, moved = 0.0;
        for (int i = 0; i < 6000; ++i) {
            const TickRecord tick = core.tick(hand(Vec3(0, 0, z), timeOf(i)), timeOf(i));
            QVERIFY((tick.felt.f_W - 0.5 * (tick.felt.p_WG - tick.p_WH)).norm() < 1e-9);
            least_mJ = std::min(least_mJ, tick.energy_mJ);
            most_mJ = std::max(most_mJ, tick.energy_mJ);
            moved = std::max(moved, z - kRest_mm);
            z += 0.02 * (tick.fSent_W.z() - kHand * (z - kRest_mm)) / kHand; // settles within 50 ticks
        }
        QCOMPARE(core.fault().kind, FaultKind::None);
        QVERIFY2(moved > 2.0 && most_mJ > 1.0, qPrintable(QString("%1 mm, %2 mJ").arg(moved).arg(most_mJ)));
        const double given_mJ = 0.5 * kHand * moved * moved;
        QVERIFY2(least_mJ > -1e-3 * given_mJ, qPrintable(QString("%1 of %2 mJ").arg(least_mJ).arg(given_mJ)));
    }

    void handThatIsAwaySolvesNothingAndComesBackAnew()
    {
        const auto scene = palpate::test::sphereScene(30.0, 0.5);
        Core core(limitsOf("omega"), 1000.0);
        core.borrowScene(scene.get(), 7);
        TickRecord record = core.tick({}, timeOf(0));
        QCOMPARE(record.flags, static_cast<std::uint16_t>(palpate::servo::kNoHand | palpate::servo::kSceneChanged));
        QCOMPARE(record.scene, 7U);
        QVERIFY(record.felt.f_W.isZero(0.0) && record.fSent_W.isZero(0.0));

        for (int i = 1; i < 700; ++i) { // from above to 5 mm below the surface
            record = core.tick(hand(Vec3(0, 0, 32.0 - 0.01 * i), timeOf(i)), timeOf(i));
            QCOMPARE((record.flags & palpate::servo::kReset) != 0, i == 1);
            QVERIFY((record.flags & palpate::servo::kSceneChanged) == 0);
        }
        QCOMPARE(record.felt.structure, 0);
        QVERIFY(record.felt.constraints > 0);
        // The spring between god-object and HIP, up to rounding.
        QVERIFY((record.felt.f_W - 0.5 * (record.felt.p_WG - record.p_WH)).norm() < 1e-12);
        QVERIFY(std::abs(record.fSent_W.norm() - record.felt.f_W.norm()) < 1e-12);

        record = core.tick({}, timeOf(700));
        QCOMPARE(record.flags, static_cast<std::uint16_t>(palpate::servo::kNoHand));
        QVERIFY(record.fSent_W.isZero(0.0));

        // Back inside the sphere: released without an impact.
        record = core.tick(hand(Vec3(0, 0, 20.0), timeOf(701)), timeOf(701));
        QCOMPARE(record.flags, static_cast<std::uint16_t>(palpate::servo::kReset));
        QVERIFY(record.felt.f_W.isZero(1e-9));
        QCOMPARE(record.felt.structure, -1);
    }

    void contactForceStartsInTheTickOfContact()
    {
        const auto scene = palpate::test::sphereScene(30.0, 1.0);
        Core core(limitsOf("omega"), 1000.0);
        core.borrowScene(scene.get(), 1);
        for (int i = 0; i < 600; ++i) {
            QVERIFY(core.tick(hand(Vec3(0, 0, 31.0), timeOf(i)), timeOf(i)).fSent_W.isZero(0.0));
        }
        const TickRecord record = core.tick(hand(Vec3(0, 0, 25.0), timeOf(600)), timeOf(600)); // 6 m/s
        QVERIFY(record.felt.f_W.norm() > 4.5);
        QVERIFY((record.fSent_W - record.felt.f_W).norm() < 1e-12);
        QVERIFY((record.flags & palpate::servo::kOutputGated) == 0);
    }

    void hidingAStructureUnderTheHandIsNoStep()
    {
        const auto scene = palpate::test::sphereScene(30.0, 1.0);
        const auto stiffer = palpate::test::sphereScene(30.0, 3.0);
        const GateLimits limits = limitsOf("omega");
        const double bound = limits.maxForceRate_N_per_s * 0.001 + 1e-9;
        Core core(limits, 1000.0);
        core.borrowScene(scene.get(), 1);
        Vec3 last = Vec3::Zero();
        for (int i = 0; i < 1200; ++i) {
            if (i == 800) {
                core.borrowScene(stiffer.get(), 2);
            }
            if (i == 900) {
                core.borrowScene(nullptr, 3);
            }
            if (i == 1000) {
                core.borrowScene(scene.get(), 4);
            }
            const TickRecord record =
                core.tick(hand(Vec3(0, 0, std::max(27.0, 31.0 - 0.01 * i)), timeOf(i)), timeOf(i));
            QVERIFY((record.fSent_W - last).norm() <= bound);
            last = record.fSent_W;
            if (i == 899) {
                QVERIFY(last.norm() > 8.0);
            }
            if (i > 910 && i < 1000) {
                QVERIFY(last.isZero(1e-6)); // removed
            }
        }
        QVERIFY(std::abs(last.z() - 3.0 * 0.4) < 0.1); // restored with a ramp: 200 of 500 ms
    }

    void denormalsAreFlushedWhileFeelingAndOnlyThen()
    {
        const auto scene = palpate::test::sphereScene(30.0, 1e-310); // a denormal stiffness
        palpate::haptics::Palpator palpator;
        palpator.borrowScene(scene.get());
        TickRecord tick;
        for (const double z : {31.0, 25.0}) {
            tick.p_WH = Vec3(0, 0, z);
            palpate::servo::feelTick(palpator, 0.001, tick);
        }
        QVERIFY(tick.felt.structure >= 0);
#if defined(__SSE2__) || defined(__aarch64__)
        QVERIFY(tick.felt.f_W.isZero(0.0));
#endif
        volatile double half = std::numeric_limits<double>::min();
        half = half / 2.0;
        QVERIFY(half > 0.0);
    }

    void neverWritesMoreThanTheDeviceCan()
    {
        const auto scene = palpate::test::sphereScene(30.0, 5.0);
        Core core(limitsOf("touch"), 1000.0);
        core.borrowScene(scene.get(), 1);
        TickRecord record;
        for (int i = 0; i < 1000; ++i) {
            record = core.tick(hand(Vec3(0, 0, std::max(20.0, 31.0 - 0.02 * i)), timeOf(i)), timeOf(i));
            QVERIFY(record.fSent_W.norm() <= 3.3 + 1e-12);
        }
        QVERIFY(record.felt.f_W.norm() > 40.0);
        QVERIFY((record.flags & palpate::servo::kOutputGated) != 0);
    }

    void latchesAFaultWithItsTickUntilRearmed()
    {
        Core core(limitsOf("touch"), 1000.0);
        static_cast<void>(core.tick(hand(Vec3::Zero(), timeOf(0)), timeOf(0)));
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const TickRecord record = core.tick(hand(Vec3(nan, 0, 0), timeOf(1)), timeOf(1));
        QCOMPARE(record.flags, static_cast<std::uint16_t>(palpate::servo::kInputGated));
        QVERIFY(record.p_WH.isZero(0.0));
        QVERIFY(core.fault().kind == FaultKind::NonFiniteInput);
        QCOMPARE(core.fault().tick, std::int64_t{1});
        QVERIFY(core.fault().time_ns == timeOf(1));
        static_cast<void>(core.tick(hand(Vec3::Zero(), timeOf(2)), timeOf(2)));
        QVERIFY(core.fault().kind == FaultKind::NonFiniteInput);
        core.rearm();
        QVERIFY(core.fault().kind == FaultKind::None);
        QCOMPARE(core.tick(hand(Vec3::Zero(), timeOf(3)), timeOf(3)).flags, std::uint16_t{0}); // position unchanged
    }

    /// A replay from the recorded rows and a state in the middle must give the same bits.
    void rowsAndFlagsAloneReplayBitForBit()
    {
        const std::vector<std::shared_ptr<const palpate::haptics::HapticScene>> scenes{
            nullptr, palpate::test::sphereScene(30.0, 0.5, 0.002), palpate::test::sphereScene(30.5, 0.8)};
        const auto motion = palpate::test::palpatingMotion(6000);
        std::mt19937 random(3); // NOLINT: a fixed seed
        Core core(limitsOf("omega"), 1000.0);
        std::vector<TickRecord> rows;
        constexpr std::size_t kBegin = 2345; // during contact
        palpate::haptics::PalpatorState begin;
        for (std::size_t i = 0; i < motion.size(); ++i) {
            const auto tick = static_cast<std::int64_t>(i);
            if (i % 1000 == 500) {
                const auto generation = static_cast<std::uint32_t>(1 + i / 1000 % 2);
                core.borrowScene(scenes[generation].get(), generation);
            }
            if (i == kBegin) {
                begin = core.palpatorState();
            }
            DeviceState state = hand(motion[i], timeOf(tick));
            state.isPresent = i % 777 > 20;
            if (i % 401 == 7) {
                state.p_D *= 100.0; // rejected
            }
            if (i % 1501 == 7) {
                state.time_ns -= 8'000'000; // a fault
            }
            if (i % 1500 == 300) {
                core.rearm();
            }
            rows.push_back(core.tick(state, timeOf(tick) + static_cast<std::int64_t>(random() % 300'000)));
        }

        palpate::haptics::Palpator palpator;
        std::uint32_t scene = 0;
        std::size_t contacts = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (i == kBegin) { // again, from the middle
                palpator = {};
                palpator.borrowScene(scenes[rows[i].scene].get());
                scene = rows[i].scene;
                palpator.restore(begin);
            } else if (rows[i].scene != scene) {
                scene = rows[i].scene;
                palpator.borrowScene(scenes[scene].get());
            }
            TickRecord again;
            again.p_WH = rows[i].p_WH;
            again.v_WH = rows[i].v_WH;
            again.flags = rows[i].flags;
            palpate::servo::feelTick(palpator, 0.001, again);
            QVERIFY2(palpate::test::isSameTick(again, rows[i]), qPrintable(QString("tick %1").arg(i)));
            contacts += again.felt.structure >= 0 ? 1 : 0;
        }
        QVERIFY(contacts > 1000);
    }

    /// A hand that is absent briefly, as after a lost packet, keeps its contact.
    void handThatIsBackSoonKeepsItsContact_data()
    {
        QTest::addColumn<int>("ticks");
        QTest::addColumn<double>("z");
        QTest::addColumn<bool>("isKept");
        QTest::newRow("a tick") << 1 << 27.0 << true;
        QTest::newRow("0.5 s") << 500 << 27.0 << true;
        QTest::newRow("4 mm lower") << 100 << 23.0 << true;
        QTest::newRow("0.6 s") << 600 << 27.0 << false;
        QTest::newRow("6 mm lower") << 1 << 21.0 << false;
    }
    void handThatIsBackSoonKeepsItsContact()
    {
        QFETCH(const int, ticks);
        QFETCH(const double, z);
        QFETCH(const bool, isKept);
        const auto scene = palpate::test::sphereScene(30.0, 0.5);
        Core core(limitsOf("omega"), 1000.0);
        core.borrowScene(scene.get(), 1);
        std::int64_t i = 0;
        const auto tick = [&](double at, bool isPresent) {
            DeviceState state = hand(Vec3(0, 0, at), timeOf(i));
            state.isPresent = isPresent;
            const TickRecord record = core.tick(state, timeOf(i));
            ++i;
            return record;
        };
        while (i < 1200) {
            static_cast<void>(tick(std::max(27.0, 31.0 - 0.01 * static_cast<double>(i)), true));
        }
        for (int away = 0; away < ticks; ++away) {
            QVERIFY(tick(27.0, false).fSent_W.isZero(0.0));
        }
        TickRecord record = tick(z, true);
        QCOMPARE((record.flags & palpate::servo::kReset) == 0, isKept);
        QVERIFY(record.fSent_W.norm() < 0.05); // ramped in
        for (int later = 0; later < 600; ++later) {
            record = tick(z, true);
        }
        QVERIFY(std::abs(record.fSent_W.z() - (isKept ? 0.5 * (30.0 - z) : 0.0)) < 0.02);
    }

    /// A device that appears, or is centred, where its fingertip does not fit: 2 mm off a sphere with a radius of 8 mm.
    /// The god-object must follow the hand around the sphere, before and after the clutch, instead of being held where
    /// it was placed. The facets have edges of less than 0.08 rad and a circumradius of less than 0.046 rad. At the
    /// start, the distance is therefore at most 2 mm + 30 mm (1 - cos 0.046) = 2.04 mm. Pressed to 26 mm from the
    /// centre, the ball is on a facet within an edge of the hand: the spring is at most
    /// 30 mm + 2.04 mm - 26 mm cos 0.08 long.
    void aHandThatAppearsTooNearIsNotHeld()
    {
        constexpr double kStiffness_N_per_mm = 0.5, kMost_N = kStiffness_N_per_mm * (32.04 - 26.0 * 0.9968);
        const auto scene = palpate::test::sphereScene(30.0, kStiffness_N_per_mm, 0.0, Vec3::Zero(), 8.0);
        Core core(limitsOf("omega"), 1000.0);
        core.borrowScene(scene.get(), 1);
        palpate::servo::MapSettings map;
        map.isDirect = false;
        std::int64_t i = 0;
        Vec3 p_D = Vec3::Zero(), shift = Vec3::Zero(); // of the HIP from the device
        const auto tick = [&](const Vec3& hip) {
            core.setMap(map);
            p_D = hip - shift;
            const TickRecord record = core.tick(hand(p_D, timeOf(i)), timeOf(i));
            ++i;
            return record;
        };
        for (const double latitude : {0.3, -0.2}) {
            const auto at = [latitude](double radius_mm, double longitude) {
                return Vec3(radius_mm * Vec3(std::cos(latitude) * std::cos(longitude),
                                             std::cos(latitude) * std::sin(longitude), std::sin(latitude)));
            };
            const auto isFelt = [&](const TickRecord& record) {
                return record.felt.f_W.norm() <= kMost_N && record.fSent_W.norm() <= kMost_N;
            };
            shift = map.centre_W = at(32.0, 0.0) - p_D;
            ++map.centreRequest;
            TickRecord record = tick(at(32.0, 0.0));
            QVERIFY((record.flags & palpate::servo::kReset) != 0 && record.felt.f_W.isZero(0.0));
            double longitude = 0.0;
            for (int k = 1; k <= 600; ++k) {
                record = tick(at(32.0 - 0.01 * k, 0.0));
                QVERIFY(isFelt(record));
            }
            for (int k = 0; k < 2000; ++k) {
                record = tick(at(26.0, longitude += 0.0002));
                QVERIFY2(isFelt(record), qPrintable(QString("tick %1: %2 N").arg(i).arg(record.felt.f_W.norm())));
            }
            QVERIFY(record.felt.f_W.norm() > 0.9 * kMost_N);
            map.isClutched = true;
            for (int k = 0; k < 200; ++k) {
                QVERIFY(tick(at(26.0 + 0.1 * k, longitude)).fSent_W.norm() <= kMost_N);
            }
            map.isClutched = false;
            shift = at(26.0, longitude) - p_D; // the HIP stayed
            for (int k = 0; k < 2000; ++k) {
                record = tick(at(26.0, longitude += 0.0002));
                QVERIFY2(isFelt(record), qPrintable(QString("tick %1: %2 N").arg(i).arg(record.felt.f_W.norm())));
            }
            QVERIFY(record.fSent_W.norm() > 0.9 * kMost_N); // eased in
            QCOMPARE((record.flags & palpate::servo::kReset), 0);
        }
    }

    /// While a fault is latched the contact is kept until the loop is re-armed, however long that takes.
    void aRearmedDeviceKeepsItsContact()
    {
        const auto scene = palpate::test::sphereScene(30.0, 0.5);
        Core core(limitsOf("omega"), 1000.0);
        core.borrowScene(scene.get(), 1);
        std::int64_t i = 0;
        TickRecord record;
        for (; i < 1200; ++i) {
            record =
                core.tick(hand(Vec3(0, 0, std::max(27.0, 31.0 - 0.01 * static_cast<double>(i))), timeOf(i)), timeOf(i));
        }
        for (; i < 4000; ++i) {
            DeviceState lost;
            lost.isLost = true;
            QVERIFY(core.tick(lost, timeOf(i)).fSent_W.isZero(0.0));
        }
        QVERIFY(core.fault().kind == FaultKind::DeviceLost);
        core.rearm();
        for (; i < 4600; ++i) {
            record = core.tick(hand(Vec3(0, 0, 26.5), timeOf(i)), timeOf(i));
            QVERIFY((record.flags & palpate::servo::kReset) == 0);
        }
        QVERIFY(std::abs(record.fSent_W.z() - 0.5 * 3.5) < 0.02);
    }

    /// The damping force is as smooth as the hand's motion and does not follow encoder steps.
    void countsDampEvenly()
    {
        const auto scene = palpate::test::sphereScene(30.0, 0.2, 0.005);
        for (const char* preset : {"touch", "woodenhaptics"}) {
            const auto info = palpate::device::deviceInfo(*palpate::device::findDevicePreset(preset));
            Core core(GateLimits::forDevice(info), 1000.0, palpate::servo::PassivityLimits::forDevice(info));
            core.borrowScene(scene.get(), 1);
            for (int i = 0; i < 800; ++i) {
                const double z = 31.0 - 0.01 * i;
                const double counted = info.resolution_mm * std::round(z / info.resolution_mm);
                const TickRecord record = core.tick(hand(Vec3(0, 0, counted), timeOf(i)), timeOf(i));
                if (record.felt.structure >= 0) {
                    const Vec3 damper = record.felt.f_W - 0.2 * (record.felt.p_WG - record.p_WH);
                    QVERIFY2((damper - Vec3(0, 0, 0.05)).norm() < 0.02,
                             qPrintable(QString("tick %1: %2 N").arg(i).arg(damper.z())));
                }
            }
        }
    }

    void simulatedHandRestsOnTheSphereItPresses()
    {
        using palpate::device::HandScript;
        const auto scene = palpate::test::sphereScene(30.0, 0.4);
        palpate::device::SimulatedHand device(
            HandScript::make({{0.0, Vec3(0, 0, 35)}, {1.0, Vec3(0, 0, 26)}, {3.0, Vec3(0, 0, 26)}}).value());
        QVERIFY(device.start().isOk());
        Core core(limitsOf("touch"), 1000.0);
        core.borrowScene(scene.get(), 1);
        TickRecord record;
        for (int i = 0; !device.isFinished(); ++i) {
            record = core.tick(device.read(timeOf(i)), timeOf(i));
            device.write(record.fSent_W);
        }
        // Grip and tissue are springs in series: 0.5 (p - 26) = f = 0.4 (g - p).
        QVERIFY((record.fSent_W - record.felt.f_W).norm() < 1e-12);
        QVERIFY((0.5 * (record.p_WH - Vec3(0, 0, 26)) - record.fSent_W).norm() < 1e-4);
        QVERIFY(record.fSent_W[2] > 0.5);
    }
};

PALPATE_TEST(ServoCore)
#include "tst_ServoCore.moc"
