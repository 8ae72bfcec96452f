// SPDX-License-Identifier: BSD-3-Clause
// Everything that a device, its cable and its library can do wrong, in virtual time: the motors never push more than
// they may, and are off within 10 ms of silence.
#include "DeviceChecks.h"
#include "EmulatedDhd.h"
#include "TestRunner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace palpate;
using namespace palpate::test;
using core::Vec3;
using device::DeviceCondition;

namespace {

using Act = std::function<void(standin::DhdBench&)>;

} // namespace
Q_DECLARE_METATYPE(Act)

class DhdFaults : public QObject
{
    Q_OBJECT

  private:
    std::unique_ptr<EmulatedDhd> m_bench;
    std::unique_ptr<device::PluginHost> m_host;
    std::unique_ptr<PressingHand<standin::DhdBench>> m_hand;

    static standin::DhdDevice& first(standin::DhdBench& b) { return b.devices[0]; }

  private Q_SLOTS:
    void initTestCase()
    {
        m_bench = std::make_unique<EmulatedDhd>();
        m_host = shippingPlugins();
        standin_makeTimeVirtual();
        m_hand = std::make_unique<PressingHand<standin::DhdBench>>(*m_bench, *m_host);
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
        QTest::addColumn<Act>("begin");
        QTest::newRow("every second read too early") << Act([](auto& b) { first(b).faults.isEverySecondEarly = true; });
        QTest::newRow("motors saturated") << Act([](auto& b) { first(b).faults.isSaturated = true; });
        QTest::newRow("one call in twenty fails") << Act([](auto& b) { first(b).faults.failing = 0.05; });
    }

    void doesNoHarm()
    {
        QFETCH(const Act, begin);
        m_hand->press();
        m_bench->with(begin);
        pass(0.5);
        QVERIFY2(!m_hand->loop->fault().isFaulted(), m_hand->loop->fault().message.english().c_str());
        QVERIFY(m_hand->device->report().condition == DeviceCondition::Working);
        QVERIFY(m_hand->largestForce_N() > 2.0); // a failed read is answered by zero
        m_bench->with([](standin::DhdBench& b) { first(b).faults = {}; });
        m_hand->keep();
    }

    void takesTheForceAway_data()
    {
        QTest::addColumn<Act>("begin");
        QTest::addColumn<bool>("isLost");
        const auto stall = [](double s) {
            return Act([s](auto& b) { first(b).faults.stallUntil_ns = b.sim_ns + static_cast<std::int64_t>(s * 1e9); });
        };
        const auto poison = [](double value) {
            return Act([value](auto& b) {
                first(b).faults.isPoisoned = true;
                first(b).faults.poison = value;
            });
        };
        QTest::newRow("stalls for 0.1 s") << stall(0.1) << false;
        QTest::newRow("stalls for 2 s") << stall(2.0) << false;
        QTest::newRow("answers at 20 Hz") << Act([](auto& b) { first(b).faults.blockEach_ns = 50'000'000; }) << false;
        QTest::newRow("jumps by 1 m") << Act([](auto& b) { first(b).faults.jump_m = 1.0; }) << false;
        QTest::newRow("NaN") << poison(std::numeric_limits<double>::quiet_NaN()) << false;
        QTest::newRow("infinity") << poison(std::numeric_limits<double>::infinity()) << false;
        QTest::newRow("1e308") << poison(1e308) << false;
        QTest::newRow("unplugged") << Act([](auto& b) { standin::plugDhd(first(b), false); }) << true;
        for (const int error : {1, 21}) {
            QTest::addRow("error %d in each call", error)
                << Act([error](auto& b) { first(b).faults.error = error; }) << true;
        }
    }

    void takesTheForceAway()
    {
        QFETCH(const Act, begin);
        QFETCH(const bool, isLost);
        m_hand->press();
        double stall_s = 0.0;
        m_bench->with([&](standin::DhdBench& b) {
            begin(b);
            stall_s = std::max(0.0, static_cast<double>(first(b).faults.stallUntil_ns - b.sim_ns) * 1e-9);
        });
        const std::uint64_t overruns = m_hand->loop->timing().overruns;
        pass(0.020); // the watchdog of 9 ms, or the gate at 5 ms and its ramp of 8 ms
        QCOMPARE(m_bench->motors().norm(), 0.0);
        QVERIFY(m_hand->loop->fault().isFaulted() || isLost);
        pass(0.15); // without an answer for 0.1 s, the device is lost
        QCOMPARE(m_bench->motors().norm(), 0.0);
        QVERIFY(m_hand->loop->fault().isFaulted());
        if (isLost) {
            QCOMPARE(m_hand->device->report().condition, DeviceCondition::Lost);
            QVERIFY(!m_hand->device->report().text.empty());
        }
        m_bench->with([](standin::DhdBench& b) {
            first(b).faults = {};
            if (!first(b).isPlugged) {
                standin::plugDhd(first(b), true);
            }
        });
        pass(stall_s + 0.4);
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
        QTest::addColumn<Act>("begin");
        QTest::addColumn<Act>("end");
        QTest::addColumn<QString>("word");
        QTest::newRow("power off") << Act([](auto& b) { first(b).hasPower = false; })
                                   << Act([](auto& b) { first(b).hasPower = true; }) << "power supply";
        QTest::newRow("not calibrated") << Act([](auto& b) { first(b).isReset = true; })
                                        << Act([](auto& b) { first(b).isReset = false; }) << "calibration pit";
        QTest::newRow("force button") << Act([](auto& b) { standin::pressForceButton(first(b)); })
                                      << Act([](auto& b) { standin::pressForceButton(first(b)); })
                                      << "Press the device's button";
        QTest::newRow("too fast") << Act([](auto& b) {
            first(b).v = {0.7, 0, 0};
        }) << Act([](auto& b) { standin::pressForceButton(first(b)); })
                                  << "too fast";
    }

    void tellsWhatToDo()
    {
        QFETCH(const Act, begin);
        QFETCH(const Act, end);
        QFETCH(const QString, word);
        m_hand->press();
        std::uint64_t enablings = 0;
        m_bench->with([&](standin::DhdBench& b) {
            begin(b);
            enablings = first(b).enablings;
        });
        pass(0.15);
        const device::DeviceReport report = m_hand->device->report();
        QCOMPARE(report.condition, DeviceCondition::NeedsCalibration);
        QVERIFY2(report.text.find(word.toStdString()) != std::string::npos, report.text.c_str());
        QVERIFY(!m_hand->device->read(core::monotonicNow_ns()).isPresent);
        QCOMPARE(m_bench->motors().norm(), 0.0);
        m_bench->with([&](standin::DhdBench& b) {
            QCOMPARE(first(b).enablings, enablings); // the device is not fought
            first(b).largestForce_N = 0.0;
            end(b);
        });
        pass(0.1);
        QVERIFY2(m_bench->motors().norm() < 1.0, "eased in");
        m_hand->liftAndPress();
        m_hand->keep();
    }

    void deviceWithoutWatchdogWorksWithAWarning()
    {
        m_bench->with([](standin::DhdBench& b) { first(b).faults.hasNoWatchdog = true; });
        m_hand->press(0.6); // attempts to set it
        QVERIFY2(m_hand->device->report().text.find("watchdog could not be set") != std::string::npos,
                 m_hand->device->report().text.c_str());
    }

    void frozenPoseHoldsAtMostItsForce()
    {
        m_hand->press();
        const double before_N = m_bench->motors().norm();
        m_bench->with([](standin::DhdBench& b) { first(b).faults.isFrozen = true; });
        pass(0.5); // cannot be told from a hand at rest: the force stays, bounded
        QVERIFY(m_bench->motors().norm() < before_N + 0.1);
    }

    void refusesWithTheReason_data()
    {
        QTest::addColumn<int>("error");
        QTest::addColumn<QString>("word");
        QTest::newRow("busy") << 3 << "close other programs";
        QTest::newRow("in use") << 20 << "close other programs";
        QTest::newRow("no driver") << 4 << "udev rule";
        QTest::newRow("firmware") << 8 << "error of the stand-in";
    }

    void refusesWithTheReason()
    {
        QFETCH(const int, error);
        QFETCH(const QString, word);
        m_bench->with([&](standin::DhdBench& b) { first(b).faults.openError = error; });
        const auto device = m_bench->make(*m_host);
        QVERIFY(device != nullptr);
        const core::Status status = device->start();
        QCOMPARE(status.code(), core::StatusCode::NotFound);
        QVERIFY2(status.message().find(word.toStdString()) != std::string::npos, status.message().c_str());
        const auto found = m_host->find("forcedimension");
        QVERIFY(found.isOk() && found.value().size() == 1);
        QVERIFY(found.value()[0].problem.find(word.toStdString()) != std::string::npos);
        // The third attempt works, as users report of firmware that is loaded meanwhile.
        m_bench->with([&](standin::DhdBench& b) { first(b).faults.openError = 0; });
        QVERIFY(device->start().isOk());
        device->stop();
        m_bench->with([](standin::DhdBench& b) { b.count = 0; });
        QVERIFY2(device->start().message().find("plug it in") != std::string::npos, "nothing connected");
        QVERIFY(m_host->find("forcedimension").value().empty());
    }

    void startsAfterTheDeviceWasPluggedInAgain()
    {
        const auto device = m_bench->make(*m_host); // has it open
        QVERIFY(device != nullptr);
        m_bench->with([](standin::DhdBench& b) { standin::plugDhd(first(b), false); });
        QCOMPARE(device->start().code(), core::StatusCode::NotFound);
        m_bench->with([](standin::DhdBench& b) { standin::plugDhd(first(b), true); });
        QVERIFY(device->start().isOk());
        device->stop();
        m_bench->with([](standin::DhdBench& b) { first(b).faults.error = 7; });
        QCOMPARE(device->start().code(), core::StatusCode::DeviceLost);
    }

    void everythingAtRandom()
    {
        m_hand->press();
        std::mt19937 random{11};
        const auto chance = [&random](double p) { return std::uniform_real_distribution<double>(0, 1)(random) < p; };
        int faults = 0, forces = 0;
        for (int round = 0; round < 48; ++round) {
            m_bench->with([&](standin::DhdBench& b) {
                standin::DhdFaults& f = first(b).faults;
                f = {};
                if (round % 4 != 3) { // one in four is good
                    f.failing = chance(0.3) ? 0.3 : 0.0;
                    f.isEverySecondEarly = chance(0.3);
                    f.isSaturated = chance(0.2);
                    f.blockEach_ns = chance(0.2) ? 7'000'000 : 0;
                    f.stallUntil_ns = chance(0.2) ? b.sim_ns + 300'000'000 : 0;
                    f.error = chance(0.1) ? 7 : 0;
                    f.isPoisoned = chance(0.1);
                    f.poison = 1e308;
                    first(b).v[0] += chance(0.1) ? 0.7 : 0.0;
                    first(b).isReset = chance(0.1);
                }
                if (!first(b).isPlugged || chance(0.1)) {
                    standin::plugDhd(first(b), !first(b).isPlugged);
                }
            });
            if (m_hand->loop->fault().isFaulted()) {
                ++faults;
                m_hand->loop->rearm();
            }
            if (m_hand->device->report().text.find("button") != std::string::npos) {
                m_bench->with([](standin::DhdBench& b) { standin::pressForceButton(first(b)); });
            }
            m_bench->moveHand({0, 10, 0}, 0.12);
            pass(0.2);
            m_bench->moveHand({0, -10, 0}, 0.12);
            pass(0.4);
            forces += m_bench->motors().norm() > 1.0 ? 1 : 0;
            QCOMPARE(m_bench->violation(), QString());
            QVERIFY(m_hand->loop->isRunning());
        }
        qInfo("%d faults, force in %d of 48 rounds, lost %llu times", faults, forces,
              static_cast<unsigned long long>(m_hand->device->report().losses));
        QVERIFY(faults > 10 && forces > 10 && m_hand->device->report().losses > 3);
    }
};

PALPATE_TEST(DhdFaults)
#include "tst_DhdFaults.moc"
