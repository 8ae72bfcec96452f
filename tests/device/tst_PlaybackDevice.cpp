// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/device/PlaybackDevice.h>

#include <barrier>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

using palpate::core::StatusCode;
using palpate::device::PlaybackRow;
using palpate::device::Vec3;
using Playback = palpate::device::PlaybackDevice;

namespace {

std::vector<Vec3> line(int rows)
{
    std::vector<Vec3> positions;
    for (int i = 0; i < rows; ++i) {
        positions.emplace_back(i, 0.1 * i, -i);
    }
    return positions;
}

} // namespace

class PlaybackDevice : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void refusesAnEmptyMotion() { QVERIFY(Playback(std::vector<Vec3>{}).start().code() == StatusCode::Empty); }

    void playsOneRowATickAndThenLetsGo()
    {
        const auto rows = line(50);
        Playback device(rows);
        QVERIFY(device.start().isOk());
        for (int i = 0; i < 50; ++i) {
            const auto state = device.read(i);
            QVERIFY(state.isPresent);
            QVERIFY(state.p_D == rows[static_cast<std::size_t>(i)]);
            QCOMPARE(state.time_ns, std::int64_t{i});
            QCOMPARE(device.row(), std::int64_t{i});
            QVERIFY(!device.hasEnded());
        }
        for (int i = 0; i < 5; ++i) {
            QVERIFY(!device.read(50 + i).isPresent);
            QVERIFY(device.hasEnded());
        }
        QVERIFY(device.start().isOk());
        QVERIFY(!device.hasEnded());
        QVERIFY(device.read(0).p_D == rows[0]);
    }

    void keepsButtonsAndAbsence()
    {
        std::vector<PlaybackRow> rows(3);
        rows[0].buttons = 2;
        rows[1].isPresent = false;
        rows[2].p_W = Vec3(1, 1, 1);
        Playback device(rows);
        QVERIFY(device.start().isOk());
        QCOMPARE(device.read(0).buttons, 2U);
        QVERIFY(!device.read(1).isPresent);
        QVERIFY(device.read(2).isPresent);
    }

    void interpolatesAtOtherSpeeds_data()
    {
        QTest::addColumn<double>("speed");
        QTest::newRow("half") << 0.5;
        QTest::newRow("three tenths") << 0.3;
        QTest::newRow("two") << 2.0;
        QTest::newRow("seven halves") << 3.5;
    }
    void interpolatesAtOtherSpeeds()
    {
        QFETCH(double, speed);
        Playback device(line(50));
        device.setSpeed(speed);
        QVERIFY(device.start().isOk());
        int ticks = 0;
        for (;; ++ticks) {
            const auto state = device.read(ticks);
            if (!state.isPresent) {
                break;
            }
            QVERIFY(std::abs(state.p_D[0] - speed * ticks) < 1e-9);
        }
        QCOMPARE(ticks, static_cast<int>(std::floor(49.0 / speed + 1e-9)) + 1);
    }

    void ignoresSpeedsThatAreNone()
    {
        Playback device(line(5));
        device.setSpeed(std::numeric_limits<double>::quiet_NaN());
        QVERIFY(device.start().isOk());
        static_cast<void>(device.read(0));
        QCOMPARE(device.read(1).p_D[0], 1.0);
        device.setSpeed(-3.0);
        QCOMPARE(device.read(2).p_D[0], 2.0);
        QCOMPARE(device.read(3).p_D[0], 2.0);
    }

    void holdsWhilePaused()
    {
        Playback device(line(10));
        QVERIFY(device.start().isOk());
        static_cast<void>(device.read(0));
        device.setPaused(true);
        QVERIFY(device.isPaused());
        for (int i = 1; i < 20; ++i) {
            const auto state = device.read(i);
            QVERIFY(state.isPresent);
            QCOMPARE(state.p_D[0], 1.0);
            QCOMPARE(state.time_ns, std::int64_t{i});
        }
        device.setPaused(false);
        QCOMPARE(device.read(20).p_D[0], 1.0);
        QCOMPARE(device.read(21).p_D[0], 2.0);
    }

    void letsGoForOneTickWhereTheMotionJumps()
    {
        Playback device(line(10));
        QVERIFY(device.start().isOk());
        static_cast<void>(device.read(0));
        device.seek(7);
        QVERIFY(!device.read(1).isPresent);
        QCOMPARE(device.row(), std::int64_t{7});
        QCOMPARE(device.read(2).p_D[0], 7.0);
        device.seek(1000);
        QVERIFY(!device.read(3).isPresent);
        QCOMPARE(device.read(4).p_D[0], 9.0);
        QVERIFY(!device.read(5).isPresent);
        QVERIFY(device.hasEnded());
        device.seek(-4);
        QVERIFY(!device.read(6).isPresent);
        QVERIFY(!device.hasEnded());
        QCOMPARE(device.read(7).p_D[0], 0.0);
    }

    void startsAtTheRowSoughtBefore()
    {
        Playback device(line(10));
        device.seek(4);
        QVERIFY(device.start().isOk());
        QCOMPARE(device.read(0).p_D[0], 4.0);
    }

    void loopsWithATickOfAbsence()
    {
        Playback device(line(4));
        device.setLooping(true);
        QVERIFY(device.start().isOk());
        for (int i = 0; i < 40; ++i) {
            const auto state = device.read(i);
            QCOMPARE(state.isPresent, i % 5 != 4);
            if (state.isPresent) {
                QCOMPARE(state.p_D[0], static_cast<double>(i % 5));
            }
            QVERIFY(!device.hasEnded());
        }
    }

    void staysWithinItsRowsUnderControlFromAnotherThread()
    {
        Playback device(line(100));
        device.setLooping(true);
        QVERIFY(device.start().isOk());
        std::barrier start(2);
        std::thread control([&] {
            start.arrive_and_wait();
            for (int i = 0; i < 20'000; ++i) {
                device.seek(i * 37 % 120 - 10);
                device.setSpeed(i % 7 * 0.6);
                device.setPaused(i % 11 == 0);
                device.setLooping(i % 5 != 0);
            }
        });
        start.arrive_and_wait();
        int outside = 0;
        for (int i = 0; i < 200'000; ++i) {
            const auto state = device.read(i);
            outside += !(state.p_D[0] >= 0.0 && state.p_D[0] <= 99.0) ? 1 : 0;
        }
        control.join();
        QCOMPARE(outside, 0);
    }
};

PALPATE_TEST(PlaybackDevice)
#include "tst_PlaybackDevice.moc"
