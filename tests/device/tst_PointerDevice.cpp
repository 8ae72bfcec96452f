// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/device/DevicePresets.h>
#include <palpate/device/PointerDevice.h>

#include <atomic>
#include <barrier>
#include <cmath>
#include <random>
#include <thread>
#include <vector>

using palpate::device::DeviceState;
using palpate::device::Vec3;

class PointerDevice : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void saysThatNothingPushesBack()
    {
        const auto info = palpate::device::PointerDevice().info();
        QCOMPARE(info.id, std::string("mouse"));
        QCOMPARE(info.actuatedAxes, 0);
        QVERIFY(info.maxForce_N > 0.0);
    }

    void isAbsentUntilThePointerComes()
    {
        palpate::device::PointerDevice device;
        QVERIFY(device.start().isOk());
        QVERIFY(!device.read(1).isPresent);
    }

    void givesTheNewestStateAndNeverAges()
    {
        palpate::device::PointerDevice device;
        DeviceState state;
        state.isPresent = true;
        state.buttons = 1;
        state.p_D = Vec3(1.0, 2.0, 3.0);
        device.setState(state);
        state.p_D = Vec3(4.0, 5.0, 6.0);
        device.setState(state);
        for (const std::int64_t now : {10LL, 1'000'000'000LL, 60'000'000'000LL}) {
            const DeviceState read = device.read(now);
            QVERIFY(read.isPresent);
            QCOMPARE(read.buttons, 1U);
            QVERIFY(read.p_D == Vec3(4.0, 5.0, 6.0));
            QVERIFY(read.time_ns == now);
        }
        state.isPresent = false;
        device.setState(state);
        QVERIFY(!device.read(11).isPresent);
    }

    void keepsTheNewestForceToBeShown()
    {
        palpate::device::PointerDevice device;
        QVERIFY(device.newestForce().isZero(0.0));
        device.write(Vec3(0.0, 0.0, 1.0));
        device.write(Vec3(0.0, 0.0, 2.0));
        QVERIFY(device.newestForce() == Vec3(0.0, 0.0, 2.0));
        QVERIFY(device.newestForce() == Vec3(0.0, 0.0, 2.0));
    }

    void tearsNothingBetweenWindowAndServo()
    {
        palpate::device::PointerDevice device;
        constexpr int kStates = 100'000;
        std::barrier start(2);
        std::thread window([&] {
            start.arrive_and_wait();
            for (int i = 1; i <= kStates; ++i) {
                DeviceState state;
                state.isPresent = true;
                state.p_D.setConstant(i);
                state.buttons = static_cast<std::uint32_t>(i);
                device.setState(state);
                const Vec3 f = device.newestForce();
                if (f[0] != f[1] || f[1] != f[2]) {
                    qFatal("a torn force");
                }
            }
        });
        start.arrive_and_wait();
        int torn = 0;
        double last = 0.0;
        while (last < kStates) {
            const DeviceState state = device.read(1);
            torn += state.p_D[0] != state.p_D[2] || state.p_D[0] != static_cast<double>(state.buttons) ? 1 : 0;
            torn += state.p_D[0] < last ? 1 : 0;
            last = state.p_D[0];
            device.write(state.p_D);
        }
        window.join();
        QCOMPARE(torn, 0);
    }

    /// For any targets and times of change: no jump, no faster than the steepest cubic, no overshoot.
    void easesWithoutJumpOrOvershoot()
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> anywhere(-20.0, 20.0);
        palpate::device::Ease ease;
        ease.rest(0.0);
        double at = 0.0;
        for (std::int64_t tick = 0; tick < 20'000; ++tick) {
            const std::int64_t now_ns = tick * 1'000'000;
            if (tick % 97 == 0 || tick % 61 == 0) {
                ease.aim(anywhere(random), 0.15, now_ns);
                QCOMPARE(ease.at(now_ns), at);
            }
            const double next = ease.at(now_ns + 1'000'000);
            QVERIFY((next - at) * (ease.target() - next) >= -1e-12);   // towards the target without overshoot
            QVERIFY(std::abs(next - at) <= 3.0 * 40.0 * 0.001 / 0.15); // mm per tick
            at = next;
        }
        ease.aim(7.0, 0.15, 20'000'000'000);
        QVERIFY(!ease.isThere(20'149'000'000));
        QVERIFY(ease.isThere(20'150'000'000));
        QVERIFY(ease.at(20'150'000'000) == 7.0);
    }

    void thePressOfTheSameTicksHasTheSameBits()
    {
        const auto press = [] {
            palpate::device::PointerDevice device;
            palpate::device::PointerState state;
            state.isPresent = true;
            state.buttons = 1;
            state.p_D = Vec3(1.0, 2.0, 3.0);
            state.d_D = Vec3(0.6, 0.0, -0.8);
            state.depth_mm = 4.0;
            state.hover_mm = 2.0;
            state.pressTime_s = 0.15;
            device.setState(state);
            std::vector<Vec3> path;
            for (std::int64_t tick = 0; tick < 200; ++tick) {
                path.push_back(device.read(tick * 1'000'037).p_D);
            }
            return path;
        };
        const std::vector<Vec3> path = press();
        QVERIFY(path == press());
        QVERIFY((path.front() - Vec3(1.0, 2.0, 3.0) + 2.0 * Vec3(0.6, 0.0, -0.8)).norm() < 1e-12);
        QVERIFY((path.back() - Vec3(1.0, 2.0, 3.0) - 4.0 * Vec3(0.6, 0.0, -0.8)).norm() < 1e-12);
    }

    void findsEveryPresetByItsId()
    {
        QCOMPARE(palpate::device::devicePresets().size(), std::size_t{8});
        for (const auto& preset : palpate::device::devicePresets()) {
            QVERIFY(palpate::device::findDevicePreset(preset.id) == &preset);
            QVERIFY(preset.maxForce_N > 0.0 && preset.maxForce_N <= palpate::device::kShownForceLimit_N);
            QCOMPARE(palpate::device::deviceInfo(preset).actuatedAxes, 3);
        }
        QVERIFY(palpate::device::findDevicePreset("spoon") == nullptr);
    }
};

PALPATE_TEST(PointerDevice)
#include "tst_PointerDevice.moc"
