// SPDX-License-Identifier: BSD-3-Clause
// Everything that the service, its messages and the devices behind it can do wrong, in virtual time: the motors never
// push more than they may, and are off within 10 ms of silence.
#include "EmulatedArm.h"
#include "EmulatedHaply.h"
#include "TestRunner.h"

#include <cmath>
#include <random>

using namespace palpate;
using namespace palpate::test;
using core::Vec3;
using device::DeviceCondition;
using standin::HaplyAnswer;

namespace {

using HaplyAct = std::function<void(standin::HaplyBench&)>;

} // namespace
Q_DECLARE_METATYPE(HaplyAct)

class HaplyFaults : public QObject
{
    Q_OBJECT

  private:
    std::unique_ptr<EmulatedHaply> m_bench;
    std::unique_ptr<device::PluginHost> m_host;
    std::unique_ptr<device::HapticDevice> m_device;
    std::unique_ptr<servo::ServoLoop> m_loop;
    bool m_isKept = false; ///< the next row continues

    /// Presses on a block, unless the last row has left the hand there.
    void press()
    {
        if (m_loop != nullptr) {
            return;
        }
        m_device = makeHaply(*m_host);
        QVERIFY(m_device != nullptr);
        m_loop = std::make_unique<servo::ServoLoop>();
        m_loop->setScene(blockScene(0.5));
        const core::Status started = m_loop->start(*m_device, {.askRealtime = false});
        QVERIFY2(started.isOk(), started.message().c_str());
        liftAndPress();
    }

    /// A contact begins outside of the block.
    void liftAndPress()
    {
        m_bench->moveHand({0, 10, 0}, 0.08);
        pass(0.12);
        m_bench->moveHand({0, -10, 0}, 0.12);
        pass(0.35);
        QVERIFY2(!m_loop->fault().isFaulted(), m_loop->fault().message.english().c_str());
        QCOMPARE(m_device->report().condition, DeviceCondition::Working);
        QVERIFY2(m_bench->motors().y() > 2.0, "the hand presses");
    }

    static standin::HaplyDevice& first(standin::HaplyBench& b) { return b.devices[0]; }

  private Q_SLOTS:
    void initTestCase()
    {
        standin_makeTimeVirtual();
        standin_makePollsVirtual();
        m_bench = std::make_unique<EmulatedHaply>();
        m_host = shippingPlugins();
    }
    void init()
    {
        if (m_loop == nullptr) {
            m_bench->renew();
            m_bench->with([](standin::HaplyBench& b) { b.takes_ns = 700'000; }); // fewer messages a second
        }
    }
    void cleanup()
    {
        QCOMPARE(m_bench->violation(), QString());
        if (m_isKept && !QTest::currentTestFailed()) {
            m_isKept = false;
            return;
        }
        if (m_loop != nullptr) {
            m_loop->stop();
        }
        m_loop.reset();
        m_device.reset();
        pass(0.03); // the service's own time-out, where it did not take the last message
        QCOMPARE(m_bench->motors().norm(), 0.0);
        QCOMPARE(m_bench->violation(), QString());
    }
    void cleanupTestCase() { m_bench.reset(); }

    void doesNoHarm_data()
    {
        QTest::addColumn<HaplyAct>("begin");
        QTest::newRow("fragments") << HaplyAct([](auto& b) { b.style.fragment = 7; });
        QTest::newRow("numbers with exponents") << HaplyAct([](auto& b) { b.style.hasExponents = true; });
        QTest::newRow("pings") << HaplyAct([](auto& b) { b.style.hasPings = true; });
        QTest::newRow("a second state, unasked") << HaplyAct([](auto& b) { b.style.answersTwice = true; });
        QTest::newRow("unknown fields") << HaplyAct([](auto& b) { b.style.hasStrangers = true; });
        for (const auto& [name, answer] :
             {std::pair("malformed", HaplyAnswer::Malformed), std::pair("binary", HaplyAnswer::Binary),
              std::pair("NaN", HaplyAnswer::NumberNaN)}) {
            QTest::addRow("one answer in twenty is %s", name) << HaplyAct([answer = answer](auto& b) {
                b.faults.answer = answer;
                b.faults.share = 0.05;
            });
        }
    }

    void doesNoHarm()
    {
        QFETCH(const HaplyAct, begin);
        m_bench->with(begin);
        press();
        pass(0.2);
        QVERIFY2(!m_loop->fault().isFaulted(), m_loop->fault().message.english().c_str());
        QVERIFY(m_bench->motors().y() > 2.0);
        m_bench->with([](standin::HaplyBench& b) {
            QVERIFY(!b.style.hasPings || b.pongs > 100);
            QCOMPARE(b.sessions, std::uint64_t{2}); // one of them for the limits
        });
    }

    void takesTheForceAway_data()
    {
        QTest::addColumn<HaplyAct>("begin");
        QTest::addColumn<bool>("isLost");
        const auto stall = [](std::int64_t ms) {
            return HaplyAct([ms](auto& b) { b.faults.stallUntil_ns = b.sim_ns + ms * 1'000'000; });
        };
        const auto answer = [](HaplyAnswer a) { return HaplyAct([a](auto& b) { b.faults.answer = a; }); };
        QTest::newRow("reads nothing for 30 ms") << stall(30) << false;
        QTest::newRow("reads nothing for 0.1 s") << stall(100) << false;
        QTest::newRow("reads nothing for 0.6 s") << stall(600) << true;
        QTest::newRow("answers at 20 Hz") << HaplyAct([](auto& b) { b.faults.delayAnswer_ns = 50'000'000; }) << false;
        QTest::newRow("answers 1 s late") << HaplyAct([](auto& b) { b.faults.delayAnswer_ns = 1'000'000'000; }) << true;
        QTest::newRow("jumps by 0.3 m") << HaplyAct([](auto& b) { b.faults.jump_m = 0.3; }) << false;
        QTest::newRow("jumps by 1 m") << HaplyAct([](auto& b) { b.faults.jump_m = 1.0; }) << true;
        QTest::newRow("unplugged") << HaplyAct([](auto& b) { first(b).isPlugged = false; }) << true;
        QTest::newRow("NaN") << answer(HaplyAnswer::NumberNaN) << true;
        QTest::newRow("1e999") << answer(HaplyAnswer::Number1e999) << true;
        QTest::newRow("1e308") << answer(HaplyAnswer::Number1e308) << true;
        QTest::newRow("malformed") << answer(HaplyAnswer::Malformed) << true;
        QTest::newRow("deep nesting") << answer(HaplyAnswer::Deep) << true;
        QTest::newRow("64 MiB") << answer(HaplyAnswer::Huge) << true;
        QTest::newRow("endless fragments") << answer(HaplyAnswer::EndlessPieces) << true;
        QTest::newRow("binary") << answer(HaplyAnswer::Binary) << true;
        QTest::newRow("invalid UTF-8") << answer(HaplyAnswer::InvalidUtf8) << true;
        QTest::newRow("null fields") << answer(HaplyAnswer::NullFields) << true;
        QTest::newRow("missing fields") << answer(HaplyAnswer::MissingFields) << true;
        QTest::newRow("numbers in quotes") << answer(HaplyAnswer::TextFields) << true;
        QTest::newRow("vectors as arrays") << answer(HaplyAnswer::ArrayFields) << true;
        QTest::newRow("empty messages") << answer(HaplyAnswer::Empty) << true;
        QTest::newRow("another device's state") << answer(HaplyAnswer::WrongId) << true;
        QTest::newRow("no devices") << answer(HaplyAnswer::NoDevices) << true;
        QTest::newRow("masked frames") << answer(HaplyAnswer::Masked) << true;
        QTest::newRow("reserved bits") << answer(HaplyAnswer::ReservedBits) << true;
        QTest::newRow("half a frame") << answer(HaplyAnswer::HalfFrame) << true;
        QTest::newRow("closes silently") << answer(HaplyAnswer::CloseSilently) << true;
        QTest::newRow("floods with pings") << answer(HaplyAnswer::PingFlood) << true;
        QTest::newRow("half-open") << answer(HaplyAnswer::None) << true;
    }

    void takesTheForceAway()
    {
        QFETCH(const HaplyAct, begin);
        QFETCH(const bool, isLost);
        press();
        bool isStalled = false, isJump = false;
        m_bench->with([&](standin::HaplyBench& b) {
            begin(b);
            isStalled = b.faults.stallUntil_ns != 0;
            isJump = b.faults.jump_m > 0.0;
        });
        const std::uint64_t overruns = m_loop->timing().overruns;
        // A service that reads nothing removes the force by itself, 20 ms after the last message. A jump is no silence:
        // the gate refuses five positions, and ramps down within 8 ms.
        pass(isStalled ? 0.022 : isJump ? 0.020 : 0.010);
        QCOMPARE(m_bench->motors().norm(), 0.0);
        pass(0.15);
        QCOMPARE(m_bench->motors().norm(), 0.0);
        QVERIFY(m_loop->fault().isFaulted());
        if (isLost) {
            QCOMPARE(m_device->report().condition, DeviceCondition::Lost);
            QVERIFY(!m_device->report().text.empty());
        }
        if (isStalled) {
            pass(0.5);
        }
        m_bench->with([](standin::HaplyBench& b) {
            b.faults = {};
            first(b).isPlugged = true;
        });
        pass(0.5);
        QCOMPARE(m_loop->timing().overruns, overruns); // nothing on the network delays a tick
        QVERIFY(m_loop->fault().isFaulted());          // latched, though all is well again
        QCOMPARE(m_bench->motors().norm(), 0.0);
        QCOMPARE(m_device->report().condition, DeviceCondition::Working);
        m_loop->rearm();
        liftAndPress();
        m_bench->with([](standin::HaplyBench& b) { QCOMPARE(b.openSessions, 1); });
        m_isKept = QLatin1String(QTest::currentDataTag()) != QLatin1String("half-open"); // the last row
    }

    /// A few late answers in a row are within the gate's patience; the force is eased or held, and bounded.
    void jitterIsBounded()
    {
        press();
        m_bench->with([](standin::HaplyBench& b) { b.faults.jitter = 0.3; });
        pass(0.5);
        QVERIFY(m_bench->motors().norm() < 5.0);
        QCOMPARE(m_device->report().condition, DeviceCondition::Working);
    }

    void serviceThatDiesIsFoundAgain()
    {
        press();
        m_bench->with([](standin::HaplyBench& b) { b.hasOpenDoor = false; });
        m_bench->crash();
        pass(0.010);
        QCOMPARE(m_bench->motors().norm(), 0.0);
        pass(0.5);
        QCOMPARE(m_device->report().condition, DeviceCondition::Lost);
        QVERIFY2(m_device->report().text.find("service") != std::string::npos, m_device->report().text.c_str());
        m_bench->with([](standin::HaplyBench& b) {
            QCOMPARE(b.openSessions, 0);
            b.hasOpenDoor = true;
        });
        pass(0.6);
        QCOMPARE(m_device->report().condition, DeviceCondition::Working);
        m_loop->rearm();
        liftAndPress();
    }

    /// The state of the device reaches the user in words, and the force returns with easing.
    void tellsWhatToDo_data()
    {
        QTest::addColumn<HaplyAct>("begin");
        QTest::addColumn<HaplyAct>("end");
        QTest::addColumn<QString>("word");
        QTest::newRow("power off") << HaplyAct([](auto& b) { first(b).hasPower = false; })
                                   << HaplyAct([](auto& b) { first(b).hasPower = true; }) << "power supply";
        QTest::newRow("not calibrated") << HaplyAct([](auto& b) { first(b).isCalibrated = false; })
                                        << HaplyAct([](auto& b) { first(b).isCalibrated = true; }) << "Haply Hub";
        QTest::newRow("not ready") << HaplyAct([](auto& b) { first(b).isReady = false; })
                                   << HaplyAct([](auto& b) { first(b).isReady = true; }) << "light is steady";
    }

    void tellsWhatToDo()
    {
        QFETCH(const HaplyAct, begin);
        QFETCH(const HaplyAct, end);
        QFETCH(const QString, word);
        press();
        m_bench->with(begin);
        pass(0.2);
        const device::DeviceReport report = m_device->report();
        QCOMPARE(report.condition, DeviceCondition::NeedsCalibration);
        QVERIFY2(report.text.find(word.toStdString()) != std::string::npos, report.text.c_str());
        QVERIFY(!m_device->read(core::monotonicNow_ns()).isPresent);
        QCOMPARE(m_bench->motors().norm(), 0.0);
        m_bench->with([&](standin::HaplyBench& b) {
            first(b).largestForce_N = 0.0;
            end(b);
        });
        pass(0.05);
        QVERIFY2(m_bench->motors().norm() < 1.0, "eased in");
        liftAndPress();
    }

    void frozenPoseHoldsAtMostItsForce()
    {
        press();
        pass(0.4); // until the force is eased in
        const double before_N = m_bench->motors().norm();
        m_bench->with([](standin::HaplyBench& b) { b.faults.isFrozen = true; });
        pass(0.5); // cannot be told from a hand at rest: the force stays, bounded
        QVERIFY(m_bench->motors().norm() < before_N + 0.1);
    }

    void refusesWithTheReason_data()
    {
        QTest::addColumn<HaplyAct>("begin");
        QTest::addColumn<QString>("word");
        QTest::addColumn<bool>("isListed"); // the problem is listed, else there is nothing to list
        QTest::newRow("no service") << HaplyAct([](auto& b) { b.hasOpenDoor = false; }) << "systemctl start" << true;
        QTest::newRow("404 instead of 101") << HaplyAct([](auto& b) { b.refusesUpgrade = true; }) << "404" << true;
        QTest::newRow("no answer to the upgrade")
            << HaplyAct([](auto& b) { b.ignoresUpgrade = true; }) << "\"port\"" << true;
        QTest::newRow("no inventory") << HaplyAct([](auto& b) { b.hasNoInventory = true; }) << "list of devices"
                                      << true;
        QTest::newRow("version 3.0") << HaplyAct([](auto& b) { b.version = "3.0.8"; }) << "3.0" << true;
        QTest::newRow("version 2.1") << HaplyAct([](auto& b) { b.version = "2.1.0"; }) << "expected 3.1" << true;
        QTest::newRow("version 4.0") << HaplyAct([](auto& b) { b.version = "4.0.0"; }) << "4.0" << true;
        QTest::newRow("no device") << HaplyAct([](auto& b) { b.devices.clear(); }) << "power supply" << false;
        QTest::newRow("another device") << HaplyAct([](auto& b) { first(b).id = "0001"; }) << "049D, but 0001" << false;
    }

    void refusesWithTheReason()
    {
        QFETCH(const HaplyAct, begin);
        QFETCH(const QString, word);
        QFETCH(const bool, isListed);
        m_bench->configure(R"(, "device_id": "049D")");
        m_bench->with(begin);
        pass(0.005);
        m_bench->crash();
        pass(0.005);
        const std::int64_t begin_ns = core::monotonicNow_ns();
        const auto device = makeHaply(*m_host);
        QVERIFY(device != nullptr);
        const core::Status status = device->start();
        QVERIFY(!status.isOk());
        QVERIFY2(status.message().find(word.toStdString()) != std::string::npos, status.message().c_str());
        const auto found = m_host->find("haply");
        QVERIFY(found.isOk());
        if (isListed) {
            QCOMPARE(found.value().size(), std::size_t{1});
            QVERIFY(found.value()[0].problem.find(word.toStdString()) != std::string::npos);
        }
        QVERIFY(core::monotonicNow_ns() - begin_ns < 3'000'000'000);
        m_bench->renew(); // it is there after all
        pass(0.01);
        QVERIFY2(device->start().isOk(), device->start().message().c_str());
        device->stop();
    }

    void everythingAtRandom()
    {
        press();
        std::mt19937 random{11};
        const auto chance = [&random](double p) { return std::uniform_real_distribution<double>(0, 1)(random) < p; };
        int faults = 0, forces = 0;
        for (int round = 0; round < 15; ++round) {
            m_bench->with([&](standin::HaplyBench& b) {
                b.faults = {};
                b.style = {};
                if (round % 3 != 2) { // one round in three is good
                    b.faults.answer = static_cast<HaplyAnswer>(random() % 25);
                    b.faults.share = chance(0.5) ? 0.05 : 1.0;
                    b.faults.delayAnswer_ns = chance(0.2) ? 7'000'000 : 0;
                    b.faults.jitter = chance(0.3) ? 0.2 : 0.0;
                    b.style.fragment = chance(0.3) ? 11 : 0;
                    b.style.hasPings = chance(0.3);
                    b.style.answersTwice = chance(0.3);
                    first(b).isCalibrated = chance(0.9);
                    first(b).isPlugged = chance(0.8);
                } else {
                    first(b).isCalibrated = first(b).isPlugged = true;
                }
            });
            if (chance(0.2)) {
                m_bench->crash();
            }
            if (m_loop->fault().isFaulted()) {
                ++faults;
                m_loop->rearm();
            }
            m_bench->moveHand({0, 10, 0}, 0.1);
            pass(0.25);
            if (m_loop->fault().isFaulted()) {
                m_loop->rearm();
            }
            m_bench->moveHand({0, -10, 0}, 0.1);
            pass(0.35);
            forces += m_bench->motors().norm() > 1.0 ? 1 : 0;
            QCOMPARE(m_bench->violation(), QString());
            QVERIFY(m_loop->isRunning());
        }
        qInfo("%d faults, force in %d of 15 rounds, lost %llu times", faults, forces,
              static_cast<unsigned long long>(m_device->report().losses));
        QVERIFY(faults > 3 && forces > 3 && m_device->report().losses > 3);
    }
};

PALPATE_TEST(HaplyFaults)
#include "tst_HaplyFaults.moc"
