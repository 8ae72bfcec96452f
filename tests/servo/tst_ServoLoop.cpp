// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"
#include "TouchScenes.h"

#include <palpate/core/Clock.h>
#include <palpate/device/DevicePresets.h>
#include <palpate/device/PlaybackDevice.h>
#include <palpate/device/PointerDevice.h>
#include <palpate/servo/SafetyGate.h>
#include <palpate/servo/ServoCore.h>
#include <palpate/servo/ServoLoop.h>

#include <algorithm>
#include <atomic>
#include <barrier>
#include <chrono>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

using palpate::core::Status;
using palpate::core::StatusCode;
using palpate::core::Vec3;
using palpate::device::DeviceInfo;
using palpate::device::DeviceState;
using palpate::haptics::HapticScene;
using palpate::servo::FaultKind;
using palpate::servo::RecordingStart;
using palpate::servo::ServoOptions;
using palpate::servo::TickRecord;
using Loop = palpate::servo::ServoLoop;

namespace {

/// A device with motors that follows a scripted motion and keeps the commanded force.
class TestDevice final : public palpate::device::HapticDevice
{
  public:
    DeviceInfo info() const override
    {
        DeviceInfo info = palpate::device::deviceInfo(*palpate::device::findDevicePreset("omega"));
        info.workspaceRadius_mm = 0.0;
        return info;
    }
    Status start() override
    {
        if (throwsAtStart) {
            throw std::runtime_error("no such port");
        }
        starts.fetch_add(1);
        return startStatus;
    }
    void stop() noexcept override { stops.fetch_add(1); }
    DeviceState read(std::int64_t now_ns) noexcept override
    {
        const auto tick = reads.fetch_add(1);
        if (tick == slowTick.load()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(25));
        }
        DeviceState state;
        state.isPresent = !isAway.load();
        state.isLost = isLost.load();
        state.time_ns = isStale.load() ? now_ns - 100'000'000 : now_ns;
        state.p_D = motion.empty() ? Vec3(0, 0, isNoNumber.load() ? std::numeric_limits<double>::quiet_NaN() : z.load())
                                   : motion[static_cast<std::size_t>(tick) % motion.size()];
        return state;
    }
    void write(const Vec3& f) noexcept override
    {
        const std::int64_t now_ns = palpate::core::monotonicNow_ns();
        if (!f.isZero(0.0)) {
            lastForce_ns.store(now_ns);
        }
        force.store(f.norm());
        largestForce.store(std::max(largestForce.load(), f.norm()));
        writes.fetch_add(1);
    }

    std::vector<Vec3> motion; // set before the start
    Status startStatus;
    bool throwsAtStart = false;
    std::atomic<double> z{40.0};
    std::atomic<bool> isAway{false};
    std::atomic<bool> isLost{false};
    std::atomic<bool> isStale{false};
    std::atomic<bool> isNoNumber{false};
    std::atomic<std::int64_t> slowTick{-1};
    std::atomic<std::int64_t> reads{0};
    std::atomic<std::int64_t> writes{0};
    std::atomic<std::int64_t> lastForce_ns{0};
    std::atomic<int> starts{0};
    std::atomic<int> stops{0};
    std::atomic<double> force{-1.0};
    std::atomic<double> largestForce{0.0};
};

/// Waits for a condition set by another thread; the long timeout only stops a broken test from hanging.
bool waitFor(const std::function<bool()>& isTrue)
{
    for (int i = 0; i < 30'000; ++i) {
        if (isTrue()) {
            return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

ServoOptions plain(double rate_Hz = 1000.0)
{
    ServoOptions options;
    options.rate_Hz = rate_Hz;
    options.askRealtime = false; // tests run in parallel
    return options;
}

/// Presses the device into the sphere until a force is sent.
bool press(TestDevice& device, Loop& loop)
{
    device.z.store(31.0);
    if (!waitFor([&] { return device.reads.load() > 20; })) {
        return false;
    }
    for (double z = 31.0; z >= 25.0; z -= 0.25) {
        device.z.store(z);
        const auto reads = device.reads.load();
        if (!waitFor([&] { return device.reads.load() > reads + 1; })) {
            return false;
        }
    }
    return waitFor([&] { return device.force.load() > 1.0; }) && !loop.fault().isFaulted();
}

} // namespace

class ServoLoop : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void refusesOptionsOutOfRange_data()
    {
        QTest::addColumn<double>("rate");
        QTest::addColumn<quint64>("ring");
        QTest::newRow("no rate") << 0.0 << quint64{1024};
        QTest::newRow("negative") << -1.0 << quint64{1024};
        QTest::newRow("too fast") << 20'000.0 << quint64{1024};
        QTest::newRow("no number") << std::numeric_limits<double>::quiet_NaN() << quint64{1024};
        QTest::newRow("no ring") << 1000.0 << quint64{0};
        QTest::newRow("huge ring") << 1000.0 << (quint64{1} << 40);
    }
    void refusesOptionsOutOfRange()
    {
        QFETCH(double, rate);
        QFETCH(quint64, ring);
        TestDevice device;
        Loop loop;
        ServoOptions options = plain(rate);
        options.ringCapacity = ring;
        const Status status = loop.start(device, options);
        QVERIFY(status.code() == StatusCode::BadCommandLine);
        QVERIFY(!status.message().empty());
        QVERIFY(!loop.isRunning());
        QCOMPARE(device.starts.load(), 0);
    }

    void saysWhyADeviceDoesNotStart()
    {
        TestDevice device;
        device.startStatus = Status(StatusCode::DeviceLost, PALPATE_TEXT("no device on this port"));
        Loop loop;
        QVERIFY(loop.start(device, plain()).code() == StatusCode::DeviceLost);
        device.throwsAtStart = true;
        const Status status = loop.start(device, plain());
        QVERIFY(status.code() == StatusCode::Internal);
        QVERIFY(status.message().find("no such port") != std::string::npos);
        QVERIFY(!loop.isRunning());
    }

    void startsTicksAndStops()
    {
        TestDevice device;
        Loop loop;
        QVERIFY(!loop.isRunning());
        loop.stop(); // nothing to stop
        QVERIFY(loop.start(device, plain()).isOk());
        QVERIFY(loop.isRunning());
        QVERIFY(loop.start(device, plain()).code() == StatusCode::Internal);
        QVERIFY(waitFor([&] { return device.reads.load() > 50; }));
        loop.stop();
        QVERIFY(!loop.isRunning());
        QCOMPARE(device.stops.load(), 1);
        QVERIFY(device.writes.load() >= device.reads.load());
        QCOMPARE(device.force.load(), 0.0);
        const auto reads = device.reads.load();
        const auto timing = loop.timing();
        QCOMPARE(timing.ticks, static_cast<std::uint64_t>(reads));
        QCOMPARE(timing.period.count, timing.ticks - 1);
        QCOMPARE(timing.lateness.count, timing.ticks);
        QCOMPARE(timing.solve.count, timing.ticks);
        QCOMPARE(timing.latency.count, timing.ticks);
        QVERIFY(timing.period.p50_ns > 0 && timing.period.max_ns >= timing.period.p99_ns);
        QVERIFY(!loop.realtime().items.empty());

        QVERIFY(loop.start(device, plain(2000.0)).isOk()); // restart
        QCOMPARE(loop.rate_Hz(), 2000.0);
        QVERIFY(waitFor([&] { return device.reads.load() > reads + 50; }));
        loop.stop();
        QVERIFY(loop.timing().ticks < static_cast<std::uint64_t>(device.reads.load()));
        QCOMPARE(device.stops.load(), 2);
    }

    /// Reopening an arm with incremental encoders would require another calibration.
    void restartsAtAnotherRateWithTheDeviceOpen()
    {
        TestDevice device;
        Loop loop;
        QCOMPARE(loop.restart({}).code(), StatusCode::Internal); // not running
        loop.setScene(palpate::test::sphereScene(30.0, 1.0));
        ServoOptions options = plain();
        QVERIFY(loop.start(device, options).isOk());
        QVERIFY(press(device, loop));
        options.rate_Hz = 2000.0;
        options.cpu = 100'000;
        QCOMPARE(loop.restart(options).code(), StatusCode::BadCommandLine);
        QCOMPARE(loop.rate_Hz(), 1000.0);
        QVERIFY(loop.isRunning());
        options.cpu = -1;
        const auto reads = device.reads.load();
        QVERIFY(loop.restart(options).isOk());
        QVERIFY(waitFor([&] { return device.reads.load() > reads + 50; }));
        QCOMPARE(loop.rate_Hz(), 2000.0);
        QVERIFY(waitFor([&] { return device.force.load() > 0.1; })); // the hand stayed in contact
        QCOMPARE(device.starts.load(), 1);
        QCOMPARE(device.stops.load(), 0);
        loop.stop();
        QCOMPARE(device.force.load(), 0.0);
        QCOMPARE(device.stops.load(), 1);
    }

    void stopsAtOnceAtTheLowestRate()
    {
        TestDevice device;
        Loop loop;
        QVERIFY(loop.start(device, plain(1.0)).isOk());
        loop.stop();
        QVERIFY(device.reads.load() <= 1); // did not wait for the deadline, a second away
        QCOMPARE(device.force.load(), 0.0);
    }

    void destructorStopsARunningLoop()
    {
        TestDevice device;
        {
            Loop loop;
            loop.setScene(palpate::test::sphereScene(30.0, 1.0));
            QVERIFY(loop.start(device, plain()).isOk());
            QVERIFY(press(device, loop));
        }
        QCOMPARE(device.force.load(), 0.0);
        QCOMPARE(device.stops.load(), 1);
    }

    void takesTheForceAwayBeforeItStops()
    {
        TestDevice device;
        Loop loop;
        loop.setScene(palpate::test::sphereScene(30.0, 1.0));
        QVERIFY(loop.start(device, plain()).isOk());
        QVERIFY(press(device, loop));
        loop.startRecording();
        QVERIFY(waitFor([&] { return loop.timing().ticks > 900; }));
        loop.stop();
        QCOMPARE(device.force.load(), 0.0);
        // The last ticks ramp down monotonically. The ramp follows the clock, and a tick soon after a late tick counts
        // as a whole period: the output depends only on the tick times, however late they were.
        std::vector<TickRecord> ticks;
        TickRecord record;
        while (loop.popTick(record)) {
            ticks.push_back(record);
        }
        QVERIFY(ticks.size() > 9);
        const auto force = [&ticks](std::size_t i) { return ticks[i].fSent_W.norm(); };
        const std::size_t last = ticks.size() - 1;
        std::size_t full = last;
        while (full > 0 && force(full) < force(full - 1)) {
            --full;
        }
        QCOMPARE(force(last), 0.0);
        QVERIFY(force(full) > 1.0);
        const double period_s = 1.0 / loop.rate_Hz();
        const double ramp_s = palpate::servo::GateLimits{}.rampDown_s;
        double left_s = ramp_s;
        for (std::size_t i = full + 1; i <= last; ++i) {
            QVERIFY(left_s > 0.0);
            const double since_s = static_cast<double>(ticks[i].time_ns - ticks[i - 1].time_ns) * 1e-9;
            left_s = std::max(0.0, left_s - std::max(period_s, since_s));
            left_s = left_s < 1e-9 * ramp_s ? 0.0 : left_s;
            const double error_N = force(i) - force(full) * left_s / ramp_s;
            QVERIFY2(std::abs(error_N) <= 1e-9 * force(full), qPrintable(QString::number(error_N)));
        }
    }

    void takesTheForceAwayOnAFaultUntilRearmed_data()
    {
        QTest::addColumn<int>("fault");
        QTest::newRow("stale input") << static_cast<int>(FaultKind::StaleInput);
        QTest::newRow("no number") << static_cast<int>(FaultKind::NonFiniteInput);
        QTest::newRow("device lost") << static_cast<int>(FaultKind::DeviceLost);
        QTest::newRow("jump") << static_cast<int>(FaultKind::InputJump);
    }
    void takesTheForceAwayOnAFaultUntilRearmed()
    {
        QFETCH(int, fault);
        const auto kind = static_cast<FaultKind>(fault);
        TestDevice device;
        Loop loop;
        loop.setScene(palpate::test::sphereScene(30.0, 1.0));
        QVERIFY(loop.start(device, plain()).isOk());
        QVERIFY(press(device, loop));
        QVERIFY(loop.ticksBeforeFault().empty());
        device.isStale.store(kind == FaultKind::StaleInput);
        device.isNoNumber.store(kind == FaultKind::NonFiniteInput);
        device.isLost.store(kind == FaultKind::DeviceLost);
        if (kind == FaultKind::InputJump) {
            device.z.store(5000.0);
        }
        QVERIFY(waitFor([&] { return loop.fault().isFaulted(); }));
        QVERIFY(loop.fault().fault.kind == kind);
        QVERIFY(loop.fault().message.english().size() > 10);
        QVERIFY(waitFor([&] { return device.force.load() == 0.0; }));
        const auto before = loop.ticksBeforeFault();
        QVERIFY(!before.empty() && before.size() <= 100);
        QCOMPARE(before.back().tick, loop.fault().fault.tick);
        for (std::size_t i = 1; i < before.size(); ++i) {
            QCOMPARE(before[i].tick, before[i - 1].tick + 1);
        }

        device.isStale.store(false);
        device.isNoNumber.store(false);
        device.isLost.store(false);
        device.z.store(25.0);
        const auto reads = device.reads.load();
        QVERIFY(waitFor([&] { return device.reads.load() > reads + 50; }));
        QCOMPARE(device.force.load(), 0.0);
        QVERIFY(loop.fault().isFaulted());
        loop.rearm();
        QVERIFY(waitFor([&] { return !loop.fault().isFaulted(); }));
        QVERIFY(press(device, loop)); // left and entered again: restarted inside
        loop.stop();
        QCOMPARE(device.force.load(), 0.0);
    }

    void lateTickIsCountedAndNotMadeUpFor()
    {
        TestDevice device;
        device.slowTick.store(100); // takes 25 periods
        Loop loop;
        QVERIFY(loop.start(device, plain()).isOk());
        loop.startRecording();
        QVERIFY(waitFor([&] { return device.reads.load() > 200; }));
        loop.stop();
        const auto timing = loop.timing();
        QVERIFY(timing.overruns >= 1);
        QVERIFY(timing.skipped >= 24);
        bool isFlagged = false;
        TickRecord record;
        while (loop.popTick(record)) {
            isFlagged = isFlagged || (record.tick == 100 && (record.flags & palpate::servo::kOverrun) != 0);
        }
        QVERIFY(isFlagged);
    }

    void givesTheNewestTickToTheWindow()
    {
        TestDevice device;
        Loop loop;
        TickRecord record;
        QVERIFY(!loop.fetchSnapshot(record));
        QVERIFY(loop.start(device, plain()).isOk());
        std::int64_t last = -1;
        for (int i = 0; i < 50; ++i) {
            QVERIFY(waitFor([&] { return loop.fetchSnapshot(record); }));
            QVERIFY(record.tick > last);
            QVERIFY(record.p_WH == Vec3(0, 0, 40.0));
            last = record.tick;
        }
        loop.stop();
    }

    void handsScenesOverAndFreesThemOutside()
    {
        TestDevice device;
        std::vector<std::weak_ptr<const HapticScene>> given;
        {
            Loop loop;
            const auto give = [&](double stiffness) {
                const auto scene = palpate::test::sphereScene(30.0, stiffness);
                given.push_back(scene);
                return loop.setScene(scene);
            };
            QCOMPARE(give(0.1), 1U);
            QCOMPARE(give(0.2), 2U); // never consumed: no thread yet
            QVERIFY(given[0].expired());
            QVERIFY(loop.start(device, plain()).isOk());
            TickRecord record;
            for (std::uint32_t i = 3; i < 30; ++i) {
                QCOMPARE(give(0.1 * i), i);
                if (i % 3 != 0) { // otherwise overtaken by the next one
                    QVERIFY(waitFor([&] { return loop.fetchSnapshot(record) && record.scene == i; }));
                    QVERIFY(waitFor([&] {
                        loop.collect();
                        return std::count_if(given.begin(), given.end(), [](const auto& g) { return !g.expired(); }) ==
                               1;
                    }));
                    QVERIFY(!given.back().expired());
                }
            }
            QCOMPARE(loop.setScene(nullptr), 30U);
            QVERIFY(waitFor([&] { return loop.fetchSnapshot(record) && record.scene == 30; }));
            give(1.0);
            give(2.0);
        }
        for (const auto& scene : given) {
            QVERIFY(scene.expired());
        }
    }

    void flagsTheFirstTickOnAnotherScene()
    {
        TestDevice device;
        Loop loop;
        QVERIFY(loop.start(device, plain()).isOk());
        loop.startRecording();
        for (int i = 0; i < 5; ++i) {
            const auto generation = loop.setScene(i % 2 == 0 ? palpate::test::sphereScene(30.0, 1.0) : nullptr);
            TickRecord record;
            QVERIFY(waitFor([&] { return loop.fetchSnapshot(record) && record.scene == generation; }));
        }
        loop.stop();
        TickRecord record;
        std::uint32_t scene = 0;
        int changes = 0;
        while (loop.popTick(record)) {
            QCOMPARE((record.flags & palpate::servo::kSceneChanged) != 0, record.scene != scene);
            changes += record.scene != scene ? 1 : 0;
            scene = record.scene;
        }
        QCOMPARE(changes, 5);
    }

    void recordsNothingUnlessAsked()
    {
        TestDevice device;
        Loop loop;
        QVERIFY(loop.start(device, plain()).isOk());
        QVERIFY(waitFor([&] { return device.reads.load() > 30; }));
        loop.stop();
        TickRecord record;
        RecordingStart start;
        QVERIFY(!loop.popTick(record));
        QVERIFY(!loop.fetchRecordingStart(start));
    }

    void countsAndFlagsWhatAFullRingLoses()
    {
        TestDevice device;
        Loop loop;
        ServoOptions options = plain(2000.0);
        options.ringCapacity = 64;
        QVERIFY(loop.start(device, options).isOk());
        loop.startRecording();
        QVERIFY(waitFor([&] { return loop.droppedTicks() > 100; }));
        TickRecord record;
        for (int i = 0; i < 32; ++i) {
            QVERIFY(loop.popTick(record));
            QVERIFY((record.flags & palpate::servo::kDroppedBefore) == 0);
        }
        QVERIFY(waitFor([&] { // continues in the freed room
            const auto dropped = loop.droppedTicks();
            std::this_thread::sleep_for(std::chrono::milliseconds(40));
            return loop.droppedTicks() > dropped;
        }));
        loop.stop();
        std::int64_t next = record.tick + 1;
        std::uint64_t missing = 0;
        int gaps = 0;
        while (loop.popTick(record)) {
            const bool isGap = record.tick != next;
            QCOMPARE((record.flags & palpate::servo::kDroppedBefore) != 0, isGap);
            missing += static_cast<std::uint64_t>(record.tick - next);
            gaps += isGap ? 1 : 0;
            next = record.tick + 1;
        }
        QVERIFY(gaps >= 1);
        QVERIFY(missing >= 100 && missing <= loop.droppedTicks());
    }

    void recordingsBegunInMidTouchReplayBitForBit()
    {
        TestDevice device;
        device.motion = palpate::test::palpatingMotion(4000);
        Loop loop;
        std::map<std::uint32_t, std::shared_ptr<const HapticScene>> scenes;
        const auto give = [&](double stiffness) {
            const auto scene = palpate::test::sphereScene(30.0, stiffness, 0.001);
            scenes[loop.setScene(scene)] = scene;
        };
        give(0.5);
        QVERIFY(loop.start(device, plain(2000.0)).isOk());
        QVERIFY(waitFor([&] { return device.reads.load() > 1000; }));

        std::atomic<bool> isDone{false};
        std::vector<TickRecord> rows;
        std::vector<RecordingStart> starts;
        std::thread recorder([&] {
            for (bool last = false; !last;) {
                last = isDone.load();
                TickRecord record;
                while (loop.popTick(record)) {
                    rows.push_back(record);
                }
                RecordingStart start;
                while (loop.fetchRecordingStart(start)) {
                    starts.push_back(start);
                }
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
            }
        });
        for (int recording = 0; recording < 3; ++recording) {
            loop.startRecording();
            for (int i = 0; i < 4; ++i) {
                const auto reads = device.reads.load();
                device.isAway.store(i == 2);
                QVERIFY(waitFor([&] { return device.reads.load() > reads + 200; }));
                give(0.3 + 0.1 * i);
            }
            loop.stopRecording();
            const auto reads = device.reads.load();
            QVERIFY(waitFor([&] { return device.reads.load() > reads + 50; }));
        }
        loop.stop();
        isDone.store(true);
        recorder.join();
        QCOMPARE(loop.droppedTicks(), std::uint64_t{0});

        QCOMPARE(starts.size(), std::size_t{3});
        palpate::haptics::Palpator palpator;
        std::uint32_t scene = 0;
        std::size_t next = 0;
        std::size_t contacts = 0;
        for (const TickRecord& row : rows) {
            if (next < starts.size() && starts[next].tick == row.tick) {
                QCOMPARE(starts[next].scene, row.scene);
                scene = row.scene;
                palpator.borrowScene(scenes.at(scene).get());
                palpator.restore(starts[next].state);
                ++next;
            } else if (row.scene != scene) {
                scene = row.scene;
                palpator.borrowScene(scenes.at(scene).get());
            }
            TickRecord again;
            again.p_WH = row.p_WH;
            again.v_WH = row.v_WH; // for the damper
            again.flags = row.flags;
            palpate::servo::feelTick(palpator, 1.0 / 2000.0, again);
            QVERIFY2(palpate::test::isSameTick(again, row), qPrintable(QString("tick %1").arg(row.tick)));
            contacts += again.felt.structure >= 0 ? 1 : 0;
        }
        QCOMPARE(next, starts.size());
        QVERIFY(contacts > 100);
    }

    void playsAMotionThroughToItsEnd()
    {
        const auto motion = palpate::test::palpatingMotion(400);
        palpate::device::PlaybackDevice device(motion);
        Loop loop;
        loop.setScene(palpate::test::sphereScene(30.0, 0.5));
        loop.startRecording();
        QVERIFY(loop.start(device, plain()).isOk());
        QVERIFY(waitFor([&] { return device.hasEnded(); }));
        loop.stop();
        std::size_t rows = 0;
        TickRecord record;
        while (loop.popTick(record)) {
            if ((record.flags & palpate::servo::kNoHand) == 0) {
                QVERIFY(rows < motion.size());
                QVERIFY(record.p_WH == motion[rows++]);
            }
        }
        QCOMPARE(rows, motion.size());
    }

    void survivesEverythingAtOnce()
    {
        palpate::device::PointerDevice device;
        Loop loop;
        std::vector<std::shared_ptr<const HapticScene>> scenes;
        for (int i = 0; i < 4; ++i) {
            scenes.push_back(palpate::test::sphereScene(28.0 + i, 0.5));
        }
        std::atomic<bool> isDone{false};
        const auto motion = palpate::test::palpatingMotion(2000);
        QVERIFY(loop.start(device, plain(4000.0)).isOk());
        std::barrier start(2);
        std::uint64_t popped = 0;
        std::thread recorder([&] {
            start.arrive_and_wait();
            for (bool last = false; !last;) {
                last = isDone.load();
                TickRecord record;
                RecordingStart begin;
                while (loop.popTick(record)) {
                    ++popped;
                }
                while (loop.fetchRecordingStart(begin)) {
                }
                static_cast<void>(loop.droppedTicks());
                std::this_thread::yield();
            }
        });
        start.arrive_and_wait();
        for (std::size_t i = 0; i < 3000; ++i) {
            DeviceState state;
            state.isPresent = i % 500 != 0;
            state.p_D = motion[i % motion.size()];
            device.setState(state);
            if (i % 3 == 0) {
                loop.setScene(i % 21 == 0 ? nullptr : scenes[i % scenes.size()]);
            }
            if (i % 50 == 0) {
                loop.startRecording();
            }
            if (i % 50 == 30) {
                loop.stopRecording();
            }
            TickRecord record;
            static_cast<void>(loop.fetchSnapshot(record));
            static_cast<void>(device.newestForce());
            static_cast<void>(loop.fault());
            if (i % 100 == 0) {
                static_cast<void>(loop.timing());
                loop.rearm();
            }
            if (i % 10 == 0) {
                std::this_thread::sleep_for(std::chrono::microseconds(300));
            }
        }
        loop.stop();
        isDone.store(true);
        recorder.join();
        QVERIFY(popped > 0);
        QVERIFY(device.newestForce().isZero(0.0));
    }
};

PALPATE_TEST(ServoLoop)
#include "tst_ServoLoop.moc"
