// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"
#include "TouchScenes.h"

#include <palpate/device/DevicePresets.h>
#include <palpate/servo/ServoCore.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

using palpate::core::Quaternion;
using palpate::device::DeviceState;
using palpate::servo::GatedInput;
using palpate::servo::GateLimits;
using palpate::servo::MappedInput;
using palpate::servo::MapSettings;
using palpate::servo::TickRecord;
using palpate::servo::Vec3;
using Map = palpate::servo::WorkspaceMap;

namespace {

MapSettings mapped(double scale = 1.0, const Quaternion& q_WD = Quaternion::Identity())
{
    MapSettings settings;
    settings.isDirect = false;
    settings.scale = scale;
    settings.q_WD = q_WD;
    settings.centre_W = Vec3(100, -50, 20);
    return settings;
}

GatedInput at(const Vec3& p_D, bool isFirst = false)
{
    GatedInput input;
    input.p_D = p_D;
    input.isPresent = true;
    input.isFirst = isFirst;
    return input;
}

Quaternion someTurn()
{
    return Quaternion(Eigen::AngleAxisd(1.1, Vec3(1, 2, -0.5).normalized()));
}

GateLimits omegaLimits()
{
    palpate::device::DeviceInfo info = palpate::device::deviceInfo(*palpate::device::findDevicePreset("omega"));
    return GateLimits::forDevice(info);
}

/// Runs a core on a moving device, tick by tick.
struct Hand
{
    TickRecord tick(const Vec3& p_D, std::uint32_t buttons = 0)
    {
        DeviceState state;
        state.isPresent = true;
        state.p_D = p_D;
        state.buttons = buttons;
        now_ns += 1'000'000;
        state.time_ns = now_ns;
        return core.tick(state, now_ns);
    }
    palpate::servo::ServoCore core{omegaLimits(), 1000.0};
    std::int64_t now_ns = 1'000'000'000;
};

} // namespace

class WorkspaceMap : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void directIsTheSameBits()
    {
        Map map;
        std::mt19937_64 random(5); // NOLINT: a fixed seed
        for (int i = 0; i < 100; ++i) {
            const Vec3 p = Vec3(1e3, 1e-7, 1.0) * (static_cast<double>(random() % 1000) / 7.0);
            const MappedInput out = map.map(at(p, i == 0), 0xff);
            QVERIFY(std::memcmp(out.p_W.data(), p.data(), sizeof p) == 0);
            QVERIFY(!out.isClutched && out.isMoved == (i == 0));
            QVERIFY(map.toDevice(p) == p && map.toScene(p) == p);
        }
    }

    void theCentreScaleAndOrientationAreAsAsked()
    {
        Map map;
        map.set(mapped(2.5, someTurn()));
        QVERIFY((map.map(at(Vec3::Zero(), true), 0).p_W - Vec3(100, -50, 20)).norm() < 1e-12);
        const Vec3 p_D(3, -4, 5);
        const Vec3 expected = Vec3(100, -50, 20) + 2.5 * (someTurn() * p_D);
        QVERIFY((map.map(at(p_D), 0).p_W - expected).norm() < 1e-12);
    }

    /// Virtual work: the work of a force on the hand equals that in the scene, except for the scale of lengths.
    void forcesTurnWithTheHand()
    {
        Map map;
        map.set(mapped(0.4, someTurn()));
        static_cast<void>(map.map(at(Vec3::Zero(), true), 0));
        const Vec3 f_W(1, 2, 3);
        const Vec3 dx_D(0.1, -0.2, 0.3);
        const Vec3 before = map.map(at(Vec3::Zero()), 0).p_W;
        const Vec3 dx_W = map.map(at(dx_D), 0).p_W - before;
        QVERIFY(std::abs(map.toDevice(f_W).dot(dx_D) - f_W.dot(dx_W) / 0.4) < 1e-12);
        QVERIFY((map.toScene(map.toDevice(f_W)) - f_W).norm() < 1e-12);
    }

    void noChangeMovesTheHip()
    {
        Map map;
        map.set(mapped());
        std::mt19937_64 random(7); // NOLINT: a fixed seed
        Vec3 p_D(10, 0, 0);
        Vec3 last = map.map(at(p_D, true), 0).p_W;
        for (int i = 0; i < 500; ++i) {
            MapSettings settings = mapped(0.1 + 0.01 * static_cast<double>(random() % 500),
                                          Quaternion(Eigen::AngleAxisd(0.01 * i, Vec3::UnitZ())));
            settings.isClutched = random() % 4 == 0;
            settings.centre_W = Vec3(i, i, i); // ignored without a request to centre
            map.set(settings);
            const MappedInput out = map.map(at(p_D), 0); // the device is at rest
            QVERIFY((out.p_W - last).norm() < 1e-9);
            QVERIFY(!out.isMoved);
            last = out.p_W;
            if (settings.isClutched) {
                p_D = Vec3(static_cast<double>(random() % 100), static_cast<double>(random() % 100), 3);
                QVERIFY(map.map(at(p_D), 0).p_W == last);
            }
        }
    }

    void clutchByKeyByButtonAndAtTheEdge()
    {
        Map map;
        MapSettings settings = mapped();
        settings.clutchButtons = 2;
        settings.edge_mm = 60.0;
        map.set(settings);
        QVERIFY(!map.map(at(Vec3::Zero(), true), 1).isClutched);
        QVERIFY(map.map(at(Vec3(1, 0, 0)), 2).isClutched);
        const MappedInput released = map.map(at(Vec3(20, 0, 0)), 0);
        QVERIFY(released.isReleased && !released.isClutched);
        QVERIFY((released.p_W - Vec3(101, -50, 20)).norm() < 1e-12);
        settings.isClutched = true;
        map.set(settings);
        QVERIFY(map.map(at(Vec3(20, 0, 0)), 0).isClutched);
        settings.isClutched = false;
        map.set(settings);
        QVERIFY(map.map(at(Vec3(30, 0, 0)), 0).isReleased);
        const MappedInput edge = map.map(at(Vec3(61, 0, 0)), 0);
        QVERIFY(edge.isClutched && edge.isAtEdge);
        QVERIFY(map.map(at(Vec3(31, 0, 0)), 0).isAtEdge); // not before half way back
        const MappedInput back = map.map(at(Vec3(29, 0, 0)), 0);
        QVERIFY(back.isReleased && !back.isClutched);
        QVERIFY(back.p_W == edge.p_W);
    }

    void whoComesFromBeyondTheEdgeIsNotClutched()
    {
        Map map;
        MapSettings settings = mapped();
        settings.edge_mm = 60.0;
        map.set(settings);
        QVERIFY(!map.map(at(Vec3(100, 0, 0), true), 0).isClutched); // an arm whose rest pose is far out
        QVERIFY((map.map(at(Vec3(50, 0, 0)), 0).p_W - Vec3(150, -50, 20)).norm() < 1e-12);
        QVERIFY(map.map(at(Vec3(61, 0, 0)), 0).isAtEdge);
    }

    void centringBeginsAnew()
    {
        Map map;
        MapSettings settings = mapped();
        map.set(settings);
        static_cast<void>(map.map(at(Vec3(5, 0, 0), true), 0));
        settings.centre_W = Vec3(0, 0, 0);
        settings.centreRequest = 1;
        map.set(settings);
        const MappedInput out = map.map(at(Vec3(5, 0, 0)), 0);
        QVERIFY(out.isMoved && out.p_W == Vec3(5, 0, 0));
        QVERIFY(!map.map(at(Vec3(5, 0, 0)), 0).isMoved);
    }

    void refusesWhatIsNoMap()
    {
        Map map;
        map.set(mapped(2.0));
        static_cast<void>(map.map(at(Vec3::Zero(), true), 0));
        const double nan = std::numeric_limits<double>::quiet_NaN();
        for (const double scale : {0.0, -1.0, nan, 1e9}) {
            map.set(mapped(scale));
        }
        map.set(mapped(1.0, Quaternion(2, 0, 0, 0)));
        QCOMPARE(map.map(at(Vec3(1, 0, 0)), 0).p_W[0], 102.0);
    }

    void fillsTheWorkspace()
    {
        palpate::device::DeviceInfo info = palpate::device::deviceInfo(*palpate::device::findDevicePreset("touch"));
        const double edge = palpate::servo::edgeOf(info);
        QCOMPARE(edge, 67.5);
        QVERIFY(std::abs(2.0 * edge * palpate::servo::scaleToFill(10.0, edge) - 10.0) < 1e-12);
        QVERIFY(std::abs(2.0 * edge * palpate::servo::scaleToFill(250.0, edge) - 250.0) < 1e-12);
        QCOMPARE(palpate::servo::scaleToFill(10.0, 0.0), 1.0);
    }

    /// Random scaling, rotation and clutching while the hand presses a sphere: the god-object never enters, and no
    /// force step per tick exceeds the bound.
    void changesNeitherPullTheGodObjectThroughNorStepTheForce()
    {
        const auto scene = palpate::test::sphereScene(30.0, 2.0);
        const double bound = omegaLimits().maxForceRate_N_per_s * 0.001 + 1e-9;
        Hand hand;
        MapSettings settings = mapped();
        settings.centre_W = Vec3::Zero();
        settings.edge_mm = 60.0;
        hand.core.setMap(settings);
        hand.core.borrowScene(scene.get(), 1);
        std::mt19937_64 random(11); // NOLINT: a fixed seed
        Vec3 last = Vec3::Zero();
        double most = 0.0;
        int clutched = 0;
        for (int i = 0; i < 20'000; ++i) {
            // Above during the ramp-in, then slowly down to 3 mm deep and around.
            const double z = i < 700 ? 31.5 : std::max(27.0, 31.5 - 0.005 * (i - 700));
            const Vec3 p_D(4.0 * std::sin(0.002 * i), 4.0 * std::cos(0.003 * i), z);
            if (i > 2500 && random() % 97 == 0) {
                settings.scale = std::pow(2.0, static_cast<double>(random() % 100) / 50.0 - 1.0);
                settings.q_WD = Quaternion(Eigen::AngleAxisd(0.2 * std::sin(i), Vec3(1, 1, 0).normalized()));
                settings.isClutched = random() % 8 == 0;
                hand.core.setMap(settings);
            }
            const TickRecord tick = hand.tick(p_D);
            QVERIFY((tick.fSent_W - hand.core.map().toScene(hand.core.forceForDevice())).norm() < 1e-12);
            QVERIFY((hand.core.forceForDevice() - last).norm() <= bound || last.norm() <= bound);
            last = hand.core.forceForDevice();
            most = std::max(most, last.norm());
            clutched += (tick.flags & palpate::servo::kClutched) != 0 ? 1 : 0;
            if (tick.felt.structure >= 0) {
                QVERIFY2(tick.felt.p_WG.norm() > 29.8, qPrintable(QString("tick %1").arg(i)));
            }
        }
        QVERIFY(most > 2.0);
        QVERIFY(clutched > 100);
    }

    void aClutchTakesTheForceAwayAndEasesItInAgain()
    {
        const auto scene = palpate::test::sphereScene(30.0, 2.0);
        Hand hand;
        MapSettings settings = mapped();
        settings.centre_W = Vec3::Zero();
        settings.clutchButtons = 1;
        hand.core.setMap(settings);
        hand.core.borrowScene(scene.get(), 1);
        TickRecord tick;
        for (int i = 0; i < 1500; ++i) {
            tick = hand.tick(Vec3(0, 0, std::max(27.0, 32.0 - 0.005 * i)));
        }
        const double pressed = tick.fSent_W.norm();
        QVERIFY(pressed > 5.0);
        for (int i = 0; i < 10; ++i) {
            tick = hand.tick(Vec3(0, 0, 27), 1);
        }
        QVERIFY(tick.fSent_W.isZero(0.0));
        const Vec3 held = tick.p_WH;
        for (int i = 0; i < 200; ++i) {
            tick = hand.tick(Vec3(0.05 * i, 0, 27), 1);
            QVERIFY(tick.p_WH == held && tick.fSent_W.isZero(0.0));
        }
        tick = hand.tick(Vec3(10, 0, 27));
        QVERIFY((tick.p_WH - held).norm() < 1e-9);
        QVERIFY(tick.fSent_W.norm() < 0.05 && (tick.flags & palpate::servo::kReset) == 0);
        for (int i = 0; i < 250; ++i) {
            tick = hand.tick(Vec3(10, 0, 27));
        }
        QVERIFY(std::abs(tick.fSent_W.norm() - pressed * 0.5) < 0.05 * pressed);
        for (int i = 0; i < 300; ++i) {
            tick = hand.tick(Vec3(10, 0, 27));
        }
        QVERIFY(std::abs(tick.fSent_W.norm() - pressed) < 1e-6);
    }

    void centringInsideTissueIsReleased()
    {
        const auto scene = palpate::test::sphereScene(30.0, 2.0);
        Hand hand;
        MapSettings settings = mapped();
        settings.centre_W = Vec3(0, 0, 100);
        hand.core.setMap(settings);
        hand.core.borrowScene(scene.get(), 1);
        TickRecord tick;
        for (int i = 0; i < 600; ++i) {
            tick = hand.tick(Vec3::Zero());
        }
        settings.centre_W = Vec3::Zero();
        settings.centreRequest = 7;
        hand.core.setMap(settings);
        tick = hand.tick(Vec3::Zero());
        QVERIFY((tick.flags & palpate::servo::kReset) != 0);
        QVERIFY(tick.fSent_W.isZero(0.0) && tick.felt.structure == -1);
    }
};

PALPATE_TEST(WorkspaceMap)
#include "tst_WorkspaceMap.moc"
