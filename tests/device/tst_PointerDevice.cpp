// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/device/DevicePresets.h>
#include <palpate/device/PointerDevice.h>

#include <atomic>
#include <barrier>
#include <thread>

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

    void findsEveryPresetByItsId()
    {
        QCOMPARE(palpate::device::devicePresets().size(), std::size_t{7});
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
