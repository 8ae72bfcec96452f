// SPDX-License-Identifier: BSD-3-Clause
// Everything that a device, its cable, its library and the library's scheduler can do wrong, in virtual time: the
// motors never push more than they may, and are off within 10 ms of silence.
#include "DeviceChecks.h"
#include "EmulatedHd.h"
#include "TestRunner.h"

#include <limits>
#include <random>

using namespace palpate;
using namespace palpate::test;
using device::DeviceCondition;

namespace {

using HdAct = std::function<void(standin::HdBench&)>;

standin::HdDevice& first(standin::HdBench& b)
{
    return b.devices[0];
}

HdAct frameError(unsigned error)
{
    return [error](auto& b) { first(b).faults.frameError = error; };
}

} // namespace
Q_DECLARE_METATYPE(HdAct)

class HdFaults : public QObject
{
    Q_OBJECT

  private:
    std::unique_ptr<EmulatedHd> m_bench;
    std::unique_ptr<device::PluginHost> m_host;
    std::unique_ptr<PressingHand<standin::HdBench>> m_hand;

  private Q_SLOTS:
    void initTestCase()
    {
        m_bench = std::make_unique<EmulatedHd>();
        m_host = shippingPlugins();
        standin_makeTimeVirtual();
        m_hand = std::make_unique<PressingHand<standin::HdBench>>(*m_bench, *m_host);
    }
    void init()
    {
        if (!m_hand->isKept()) {
            m_bench->renew();
        }
    }
    void cleanup()
    {
        m_hand->finishRow();
        QCOMPARE(m_bench->violation(), QString());
    }
    void cleanupTestCase() { m_hand.reset(); }

    void doesNoHarm_data()
    {
        QTest::addColumn<HdAct>("begin");
        QTest::newRow("one reading in twenty fails") << HdAct([](auto& b) { first(b).faults.failing = 0.05; });
        QTest::newRow("late by up to 2 ms") << HdAct([](auto& b) { b.scheduler.lateMost_ns = 2'000'000; });
        QTest::newRow("called twice each time") << HdAct([](auto& b) { b.scheduler.isDoubled = true; });
        QTest::newRow("called after it was stopped") << HdAct([](auto& b) { b.scheduler.callsAfterStop = true; });
        QTest::newRow("a frame was left open") << HdAct([](auto& b) { first(b).faults.isFrameLeftOpen = true; });
        QTest::newRow("a position stays away for 2 ms") << HdAct([](auto& b) {
            first(b).faults.frameError = 0x0402;
            first(b).faults.frameErrors = 2;
        });
    }

    void doesNoHarm()
    {
        QFETCH(const HdAct, begin);
        m_hand->press();
        m_bench->with(begin);
        pass(0.5);
        QVERIFY2(!m_hand->loop->fault().isFaulted(), m_hand->loop->fault().message.english().c_str());
        QCOMPARE(m_hand->device->report().condition, DeviceCondition::Working);
        QVERIFY(m_hand->largestForce_N() > 2.0);
    }

    void takesTheForceAway_data()
    {
        QTest::addColumn<HdAct>("begin");
        QTest::addColumn<bool>("isLost");
        const auto stall = [](double s) {
            return HdAct([s](auto& b) { b.scheduler.stallUntil_ns = b.sim_ns + static_cast<std::int64_t>(s * 1e9); });
        };
        const auto poison = [](double value) {
            return HdAct([value](auto& b) {
                first(b).faults.isPoisoned = true;
                first(b).faults.poison = value;
            });
        };
        QTest::newRow("stalls for 7 ms") << stall(0.007) << false;
        QTest::newRow("stalls for 0.1 s") << stall(0.1) << false;
        QTest::newRow("stalls for 3 s") << stall(3.0) << true;
        QTest::newRow("its thread ends") << HdAct([](auto& b) { b.scheduler.isDead = true; }) << true;
        QTest::newRow("bursts at 50 Hz") << HdAct([](auto& b) { b.scheduler.isBursting = true; }) << false;
        QTest::newRow("20 Hz") << HdAct([](auto& b) { first(b).faults.blockEach_ns = 50'000'000; }) << false;
        QTest::newRow("jumps by 1 m") << HdAct([](auto& b) { first(b).faults.jump_mm = 1000.0; }) << true;
        QTest::newRow("jumps by 70 mm") << HdAct([](auto& b) { first(b).faults.jump_mm = 70.0; }) << false;
        QTest::newRow("NaN") << poison(std::numeric_limits<double>::quiet_NaN()) << true;
        QTest::newRow("infinity") << poison(std::numeric_limits<double>::infinity()) << true;
        QTest::newRow("1e308") << poison(1e308) << true;
        QTest::newRow("unplugged") << HdAct([](auto& b) { standin::plugHd(first(b), false); }) << true;
        for (const unsigned error : {0x0103U, 0x0104U, 0x0302U, 0x0999U}) {
            QTest::addRow("error 0x%04x in each frame", error) << frameError(error) << true;
        }
        QTest::newRow("every call fails") << HdAct([](auto& b) { first(b).faults.callError = 0x0302; }) << true;
    }

    void takesTheForceAway()
    {
        QFETCH(const HdAct, begin);
        QFETCH(const bool, isLost);
        m_hand->press();
        m_bench->with(begin);
        const std::uint64_t overruns = m_hand->loop->timing().overruns;
        pass(0.020); // the watchdog of 9 ms, or the gate at 5 ms and its ramp of 8 ms
        QCOMPARE(m_bench->motors().norm(), 0.0);
        pass(0.15); // without an answer for 0.1 s, the device is lost
        QCOMPARE(m_bench->motors().norm(), 0.0);
        QVERIFY(m_hand->loop->fault().isFaulted());
        if (isLost) {
            QCOMPARE(m_hand->device->report().condition, DeviceCondition::Lost);
            QVERIFY(!m_hand->device->report().text.empty());
        }
        m_bench->with([](standin::HdBench& b) {
            first(b).faults = {};
            b.scheduler.isDead = b.scheduler.isBursting = false;
            if (!first(b).isPlugged) {
                standin::plugHd(first(b), true);
            }
        });
        const auto works = [this] { return m_hand->device->report().condition == DeviceCondition::Working; };
        for (int i = 0; i < 100 && !works(); ++i) {
            pass(0.05);
        }
        pass(0.2);
        QCOMPARE(m_hand->loop->timing().overruns, overruns); // no call of the library delays a tick
        QVERIFY(m_hand->loop->fault().isFaulted());          // latched, though all is well again
        QCOMPARE(m_bench->motors().norm(), 0.0);
        QCOMPARE(m_hand->device->report().condition, DeviceCondition::Working);
        m_hand->loop->rearm();
        m_hand->liftAndPress();
        m_hand->keep();
    }

    /// The state of the device reaches the user in words, and the force returns with easing.
    void tellsWhatToDo_data()
    {
        QTest::addColumn<HdAct>("begin");
        QTest::addColumn<QString>("word");
        QTest::newRow("too fast") << frameError(0x0203) << "too fast";
        QTest::newRow("force impulse") << frameError(0x0202) << "refused a force";
        QTest::newRow("force error") << frameError(0x0204) << "refused a force";
        QTest::newRow("too fast, and switches forces off") << HdAct([](auto& b) {
            first(b).faults.frameError = 0x0203;
            first(b).faults.disablesForces = true;
        }) << "too fast";
        QTest::newRow("licence") << frameError(0x0600) << "licence of OpenHaptics";
        QTest::newRow("needs its inkwell") << HdAct([](auto& b) { first(b).calibration = 0x5002; }) << "inkwell";
        QTest::newRow("needs its reset pose") << HdAct([](auto& b) {
            first(b).calibration = 0x5002;
            first(b).styles = 1;
        }) << "Device > Calibrate";
    }

    void tellsWhatToDo()
    {
        QFETCH(const HdAct, begin);
        QFETCH(const QString, word);
        // The style of calibration is asked for when the device is opened.
        m_bench->with([&](standin::HdBench& b) {
            begin(b);
            const int styles = first(b).styles;
            first(b).faults = {};
            first(b).calibration = 0x5000;
            first(b).styles = styles;
        });
        m_hand->press();
        m_bench->with(begin);
        pass(0.02);
        QCOMPARE(m_bench->motors().norm(), 0.0);
        pass(0.15);
        const device::DeviceReport report = m_hand->device->report();
        QCOMPARE(report.condition, DeviceCondition::NeedsCalibration);
        QVERIFY2(report.text.find(word.toStdString()) != std::string::npos, report.text.c_str());
        QVERIFY(!m_hand->device->read(core::monotonicNow_ns()).isPresent);
        QCOMPARE(m_bench->motors().norm(), 0.0);
        QVERIFY(!m_hand->loop->fault().isFaulted()); // the hand is away
        m_bench->with([](standin::HdBench& b) {
            first(b).faults = {};
            first(b).calibration = 0x5000;
        });
        double before_N = 0.0;
        for (int i = 0; i < 1000; ++i) { // no step when the force returns
            pass(0.001);
            const double force_N = m_bench->motors().norm();
            QVERIFY2(force_N - before_N < 0.1, qPrintable(QString::number(force_N - before_N)));
            before_N = force_N;
        }
        m_hand->liftAndPress();
    }

    /// The motors get warm: the continuous force at most, without a step.
    void warmMotorsReduceTheForce()
    {
        m_hand->press();
        m_bench->with([](standin::HdBench& b) {
            first(b).faults.frameError = 0x0200;
            first(b).faults.frameErrors = 1000;
        });
        double before_N = m_bench->motors().norm();
        for (int i = 0; i < 1000; ++i) {
            pass(0.001);
            const double force_N = m_bench->motors().norm();
            QVERIFY2(std::abs(force_N - before_N) < 0.1, qPrintable(QString::number(force_N - before_N)));
            before_N = force_N;
        }
        QVERIFY2(std::abs(m_bench->motors().norm() - 0.88) < 1e-6,
                 qPrintable(QString::number(m_bench->motors().norm())));
        QVERIFY(m_hand->device->report().text.find("warm") != std::string::npos);
        QVERIFY(!m_hand->loop->fault().isFaulted());
        pass(11.0);
        QCOMPARE(m_hand->device->report().text, std::string());
        m_hand->liftAndPress();
    }

    /// A device that needs an update is calibrated by the driver: its positions jump, and no force is driven meanwhile.
    void calibratesByItself()
    {
        m_hand->press();
        m_bench->with([](standin::HdBench& b) {
            first(b).calibration = 0x5001;
            first(b).offset_mm = 30.0;
            first(b).largestForce_N = 0.0;
        });
        pass(0.1);
        m_bench->with([](standin::HdBench& b) {
            QCOMPARE(first(b).calibrations, std::uint64_t{1});
            QCOMPARE(first(b).calibrationStyle, 4U);
            QCOMPARE(first(b).calibration, 0x5000U);
        });
        m_hand->loop->rearm(); // of the jump
        m_hand->liftAndPress();
    }

    void calibratesOnRequestInTheResetPose()
    {
        m_bench->with([](standin::HdBench& b) {
            first(b).calibration = 0x5002;
            first(b).styles = 1;
        });
        const auto device = m_bench->make(*m_host);
        QVERIFY(device->start().isOk());
        pass(0.6); // longer than the driver waits between calibrations
        QCOMPARE(device->report().condition, DeviceCondition::NeedsCalibration);
        m_bench->with([](standin::HdBench& b) { QCOMPARE(first(b).calibrations, std::uint64_t{0}); });
        QVERIFY(device->calibrate().isOk());
        pass(0.1);
        QCOMPARE(device->report().condition, DeviceCondition::Working);
        m_bench->with([](standin::HdBench& b) { QCOMPARE(first(b).calibrationStyle, 1U); });
        device->stop();
    }

    void refusesToCalibrateAnInkwellDevice()
    {
        const auto device = m_bench->make(*m_host);
        QCOMPARE(device->calibrate().code(), core::StatusCode::Unsupported);
    }

    void frozenPoseHoldsAtMostItsForce()
    {
        m_hand->press();
        const double before_N = m_bench->motors().norm();
        m_bench->with([](standin::HdBench& b) { first(b).faults.isFrozen = true; });
        pass(0.5); // cannot be told from a hand at rest: the force stays, bounded
        QVERIFY(m_bench->motors().norm() < before_N + 0.1);
    }

    void refusesWithTheReason_data()
    {
        QTest::addColumn<unsigned>("error");
        QTest::addColumn<QString>("word");
        QTest::newRow("no communication") << 0x0302U << "cable";
        QTest::newRow("licence") << 0x0600U << "licence";
        QTest::newRow("in use") << 0x0301U << "close other programs";
        QTest::newRow("configuration") << 0x0303U << "/touch/config";
        QTest::newRow("fault") << 0x0300U << "power supply";
        QTest::newRow("another") << 0x0777U << "1911 of libHD (error of the stand-in)";
    }

    void refusesWithTheReason()
    {
        QFETCH(const unsigned, error);
        QFETCH(const QString, word);
        m_bench->with([&](standin::HdBench& b) { first(b).faults.initError = error; });
        const auto device = m_bench->make(*m_host);
        QVERIFY(device != nullptr);
        const core::Status status = device->start();
        QCOMPARE(status.code(), core::StatusCode::NotFound);
        QVERIFY2(status.message().find(word.toStdString()) != std::string::npos, status.message().c_str());
        const auto found = m_host->find("openhaptics");
        QVERIFY(found.isOk() && found.value().size() == 1);
        QVERIFY(found.value()[0].problem.find(word.toStdString()) != std::string::npos);
        // A later attempt works, as users report of firmware that is loaded meanwhile.
        m_bench->with([&](standin::HdBench& b) { first(b).faults.initError = 0; });
        QVERIFY(device->start().isOk());
        device->stop();
    }

    void startsAfterTheDeviceWasPluggedInAgain()
    {
        const auto device = m_bench->make(*m_host); // has it open
        m_bench->with([](standin::HdBench& b) { standin::plugHd(first(b), false); });
        QCOMPARE(device->start().code(), core::StatusCode::NotFound);
        m_bench->with([](standin::HdBench& b) { standin::plugHd(first(b), true); });
        QVERIFY(device->start().isOk());
        device->stop();
        m_bench->with([](standin::HdBench& b) { b.scheduler.isDead = true; });
        QCOMPARE(device->start().code(), core::StatusCode::DeviceLost);
    }

    /// Another device under the same name has other limits.
    void anotherDeviceIsNotTakenForTheLostOne()
    {
        m_hand->press();
        m_bench->with([](standin::HdBench& b) { standin::plugHd(first(b), false); });
        pass(1.0);
        m_bench->with([](standin::HdBench& b) {
            standin::plugHd(first(b), true);
            first(b).serial = {"999-99"};
        });
        pass(2.0);
        QCOMPARE(m_hand->device->report().condition, DeviceCondition::Lost);
        m_bench->with([](standin::HdBench& b) { first(b).serial = {"110-01"}; });
        pass(2.0);
        QCOMPARE(m_hand->device->report().condition, DeviceCondition::Working);
    }

    /// While the library hangs in a call, nothing else of the program waits for long.
    void stopsWhileTheLibraryHangs()
    {
        m_hand->press();
        m_bench->with([](standin::HdBench& b) { first(b).faults.blockEach_ns = 8'000'000'000; });
        pass(0.1);
        const std::int64_t begin_ns = core::monotonicNow_ns();
        m_hand->loop->stop();
        QVERIFY(core::monotonicNow_ns() - begin_ns < 3'000'000'000);
        QCOMPARE(m_bench->motors().norm(), 0.0);
        m_bench->with([](standin::HdBench& b) {
            first(b).faults.blockEach_ns = 0;
            first(b).largestForce_N = 0.0;
        });
        pass(10.0);
        m_bench->with([](standin::HdBench& b) { QCOMPARE(first(b).largestForce_N, 0.0); });
        const auto device = m_bench->make(*m_host); // the device is closed at last
        QVERIFY(device->start().isOk());
        device->stop();
    }

    void everythingAtRandom()
    {
        m_hand->press();
        std::mt19937 random{11};
        const auto chance = [&random](double p) { return std::uniform_real_distribution<double>(0, 1)(random) < p; };
        int faults = 0, forces = 0;
        for (int round = 0; round < 20; ++round) {
            m_bench->with([&](standin::HdBench& b) {
                standin::HdFaults& f = first(b).faults;
                f = {};
                b.scheduler = {};
                if (round % 4 != 3) { // one in four is good
                    constexpr unsigned kErrors[] = {0x0103, 0x0200, 0x0201, 0x0203, 0x0204, 0x0302, 0x0402, 0x0600};
                    f.failing = chance(0.3) ? 0.3 : 0.0;
                    f.frameError = chance(0.3) ? kErrors[random() % std::size(kErrors)] : 0;
                    f.frameErrors = chance(0.5) ? 1 + random() % 300 : 0;
                    f.disablesForces = chance(0.3);
                    f.blockEach_ns = chance(0.1) ? 7'000'000 : 0;
                    f.isPoisoned = chance(0.1);
                    f.poison = 1e308;
                    f.isFrameLeftOpen = chance(0.2);
                    b.scheduler.isDead = chance(0.1);
                    b.scheduler.isDoubled = chance(0.2);
                    b.scheduler.callsAfterStop = chance(0.2);
                    b.scheduler.lateMost_ns = chance(0.2) ? 3'000'000 : 0;
                    b.scheduler.stallUntil_ns = chance(0.2) ? b.sim_ns + 300'000'000 : 0;
                    first(b).calibration = chance(0.2) ? 0x5001 : 0x5000;
                }
                if (!first(b).isPlugged || chance(0.1)) {
                    standin::plugHd(first(b), !first(b).isPlugged);
                }
            });
            if (m_hand->loop->fault().isFaulted()) {
                ++faults;
                m_hand->loop->rearm();
            }
            m_bench->lift(10, 0.2);
            pass(0.4);
            m_bench->lift(-10, 0.2);
            pass(0.6); // longer than a refused force stays away
            forces += m_bench->motors().norm() > 1.0 ? 1 : 0;
            QCOMPARE(m_bench->violation(), QString());
            QVERIFY(m_hand->loop->isRunning());
        }
        qInfo("%d faults, force in %d of 20 rounds, lost %llu times", faults, forces,
              static_cast<unsigned long long>(m_hand->device->report().losses));
        QVERIFY(faults > 4 && forces > 2 && m_hand->device->report().losses > 1);
        m_bench->with([](standin::HdBench& b) {
            first(b).faults = {};
            b.scheduler = {};
        });
    }
};

PALPATE_TEST(HdFaults)
#include "tst_HdFaults.moc"
