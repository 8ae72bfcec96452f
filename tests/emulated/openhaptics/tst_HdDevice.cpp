// SPDX-License-Identifier: BSD-3-Clause
// The released plugin for 3D Systems against emulated devices that work as they should, in virtual time.
#include "DeviceChecks.h"
#include "EmulatedHd.h"
#include "TestRunner.h"

#include <cmath>
#include <limits>

using namespace palpate;
using namespace palpate::test;
using core::Vec3;

class HdDevice : public QObject
{
    Q_OBJECT

  private:
    std::unique_ptr<EmulatedHd> m_bench;
    std::unique_ptr<device::PluginHost> m_host;

  private Q_SLOTS:
    void initTestCase()
    {
        m_bench = std::make_unique<EmulatedHd>();
        m_host = shippingPlugins();
        standin_makeTimeVirtual();
    }
    void init() { m_bench->renew(); }
    void cleanup() { QCOMPARE(m_bench->violation(), QString()); }

    void forceAcceleratesTheTipAlongItself_data()
    {
        QTest::addColumn<int>("axis");
        QTest::newRow("right") << 0;
        QTest::newRow("up") << 1;
        QTest::newRow("towards the user") << 2;
    }

    void forceAcceleratesTheTipAlongItself()
    {
        QFETCH(const int, axis);
        checkForceAcceleratesTheTip(*m_bench, *m_host, axis);
    }

    void feelsABlock() { checkBlockIsFelt(*m_bench, *m_host, 6.0); }

    void feelsABlockAt500Hz()
    {
        m_bench->with([](standin::HdBench& b) { b.rate_Hz = 500.0; }); // another rate is refused
        const auto device = m_bench->make(*m_host);
        servo::ServoLoop loop;
        loop.setScene(blockScene(0.4));
        m_bench->lift(10, 0.3);
        QVERIFY(loop.start(*device, {.askRealtime = false}).isOk());
        pass(1.0);
        m_bench->lift(-6, 0.7);
        pass(2.5);
        QVERIFY2(!loop.fault().isFaulted(), loop.fault().message.english().c_str());
        QVERIFY(m_bench->pressure_N() > 1.0);
        QVERIFY2(device->report().text.find("less than 1 kHz") != std::string::npos, device->report().text.c_str());
        loop.stop();
    }

    /// The emulated device takes a force at the end of its frame, at once.
    void roundTripIsAtMostOneTickAboveTheDevices() { checkRoundTripIsShort(*m_bench, *m_host, 0); }

    void twoDevicesAreToldApart()
    {
        m_bench->configureDevices({"Left Device", "Default Device"});
        const auto listed = m_host->find("openhaptics");
        QVERIFY(listed.isOk());
        QCOMPARE(listed.value().size(), std::size_t{2});
        QCOMPARE(listed.value()[0].name, std::string("Touch, Default Device"));
        QCOMPARE(listed.value()[0].address, std::string("110-01"));
        QCOMPARE(listed.value()[1].address, std::string("110-02"));

        m_bench->configure(R"(, "device": "Left Device")"); // by name
        const auto second = m_bench->make(*m_host);
        const auto first =
            m_bench->make(*m_host, "110-01"); // an address, here the serial number, precedes the settings
        QVERIFY(second != nullptr && first != nullptr);
        QVERIFY(second->start().isOk());
        QVERIFY(first->start().isOk());
        QCOMPARE(m_host->find("openhaptics").value().size(), std::size_t{2}); // also while both are open
        QCOMPARE(m_bench->make(*m_host, "110-02")->start().code(), core::StatusCode::NotFound); // in use
        const auto pushBoth = [&](double seconds) {
            for (int i = 0; i < static_cast<int>(seconds * 1000.0); ++i) {
                pass(0.001);
                (void)first->read(core::monotonicNow_ns());
                (void)second->read(core::monotonicNow_ns());
                first->write(Vec3(1, 0, 0));
                second->write(Vec3(0, 2, 0));
            }
        };
        const auto bothWork = [&] {
            return (m_bench->motors(0) - Vec3(1, 0, 0)).norm() < 1e-12 &&
                   (m_bench->motors(1) - Vec3(0, 2, 0)).norm() < 1e-12;
        };
        pushBoth(0.3);
        QVERIFY(bothWork());
        // One is lost: the other goes on, and the attempts to find it again interrupt it less and less often.
        m_bench->with([](standin::HdBench& b) { standin::plugHd(b.devices[0], false); });
        int working = 0;
        for (int i = 0; i < 300; ++i) {
            pushBoth(0.01);
            working += m_bench->motors(1).norm() > 1.0 ? 1 : 0;
        }
        QVERIFY2(working > 280, qPrintable(QString::number(working)));
        QCOMPARE(first->report().condition, device::DeviceCondition::Lost);
        QVERIFY(first->read(core::monotonicNow_ns()).isLost);
        QCOMPARE(second->report().condition, device::DeviceCondition::Working);
        m_bench->with([](standin::HdBench& b) { standin::plugHd(b.devices[0], true); });
        pushBoth(5.0);
        QVERIFY(bothWork());
        // Both come back in the other order: the names stay with the devices.
        m_bench->with([](standin::HdBench& b) {
            standin::plugHd(b.devices[0], false);
            standin::plugHd(b.devices[1], false);
            std::swap(b.devices[0], b.devices[1]);
        });
        pushBoth(0.5);
        QVERIFY(first->read(core::monotonicNow_ns()).isLost && second->read(core::monotonicNow_ns()).isLost);
        m_bench->with([](standin::HdBench& b) {
            standin::plugHd(b.devices[0], true);
            standin::plugHd(b.devices[1], true);
        });
        pushBoth(3.0);
        QCOMPARE(first->report().condition, device::DeviceCondition::Working);
        QVERIFY((m_bench->motors(1) - Vec3(1, 0, 0)).norm() < 1e-12);
        QVERIFY((m_bench->motors(0) - Vec3(0, 2, 0)).norm() < 1e-12);
        // The end of one leaves the other working.
        first->stop();
        QCOMPARE(m_bench->motors(1).norm(), 0.0);
        pushBoth(0.1);
        QVERIFY((m_bench->motors(0) - Vec3(0, 2, 0)).norm() < 1e-12);
        second->stop();
    }

    void severalDevicesWithoutADefaultAreAQuestion()
    {
        m_bench->configureDevices({"Left Device", "Right Device"});
        const core::Status undecided = m_bench->make(*m_host)->start();
        QCOMPARE(undecided.code(), core::StatusCode::NotFound);
        QVERIFY2(undecided.message().find("2 devices") != std::string::npos, undecided.message().c_str());
    }

    /// The maker's test program runs, this program fails: the name of the default device differs.
    void onlyDeviceNeedsNoName()
    {
        m_bench->with([](standin::HdBench& b) { b.devices[0].name = {"Default PHANToM"}; });
        for (const char* const name : {"Default PHANToM", "Left Device"}) {
            m_bench->configureDevices({name});
            const auto device = m_bench->make(*m_host);
            QVERIFY(device->start().isOk());
            device->stop();
        }
        m_bench->configureDevices({"Default PHANToM"});
        const core::Status unknown = m_bench->make(*m_host, "Default Device")->start();
        QCOMPARE(unknown.code(), core::StatusCode::NotFound);
        QVERIFY2(unknown.message().find("Touch_Setup") != std::string::npos, unknown.message().c_str());
    }

    void limitsComeFromTheDeviceAndFromTheTable_data()
    {
        QTest::addColumn<QByteArray>("model");
        QTest::addColumn<double>("stated_N");
        QTest::addColumn<QString>("settings");
        QTest::addColumn<double>("expected_N");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("Touch") << QByteArray("Touch") << 3.3 << QString() << 3.3;
        QTest::newRow("Touch, states less") << QByteArray("Touch") << 2.0 << QString() << 2.0;
        QTest::newRow("Touch, states more") << QByteArray("Touch") << 600.0 << QString() << 3.3;
        QTest::newRow("Touch, states zero") << QByteArray("Touch") << 0.0 << QString() << 3.3;
        QTest::newRow("Touch, states a negative force") << QByteArray("Touch") << -5.0 << QString() << 3.3;
        QTest::newRow("Touch, states NaN") << QByteArray("Touch") << nan << QString() << 3.3;
        QTest::newRow("Omni") << QByteArray("PHANTOM Omni") << 3.3 << QString() << 3.3;
        QTest::newRow("Touch X") << QByteArray("Touch X") << 7.9 << QString() << 7.9;
        QTest::newRow("Desktop") << QByteArray("PHANTOM Desktop") << 20.0 << QString() << 7.9;
        QTest::newRow("Premium 1.5") << QByteArray("PHANTOM Premium 1.5") << 20.0 << QString() << 8.5;
        QTest::newRow("Premium 3.0") << QByteArray("PHANTOM Premium 3.0") << 15.0 << QString() << 15.0;
        QTest::newRow("settings lower a limit") << QByteArray("Touch") << 3.3 << R"(, "max_force_N": 1)" << 1.0;
        QTest::newRow("settings do not raise it") << QByteArray("Touch") << 3.3 << R"(, "max_force_N": 9)" << 3.3;
        QTest::newRow("unknown, states a lot") << QByteArray("Feel-o-mat") << 600.0 << QString() << 20.0;
        QTest::newRow("unknown, states nothing") << QByteArray("Feel-o-mat") << nan << QString() << 3.0;
        QTest::newRow("unknown, stated by the user") << QByteArray("") << nan << R"(, "max_force_N": 9)" << 9.0;
    }

    void limitsComeFromTheDeviceAndFromTheTable()
    {
        QFETCH(const QByteArray, model);
        QFETCH(const double, stated_N);
        QFETCH(const QString, settings);
        QFETCH(const double, expected_N);
        m_bench->with([&](standin::HdBench& b) {
            b.devices[0].model = {};
            std::copy(model.begin(), model.end(), b.devices[0].model.begin());
            b.devices[0].maxForce_N = stated_N;
        });
        m_bench->configure(settings.toStdString());
        const auto device = m_bench->make(*m_host);
        QVERIFY(device != nullptr);
        QCOMPARE(device->info().maxForce_N, expected_N);
        QVERIFY(device->start().isOk());
        QVERIFY(!device->info().name.empty());
        m_bench->with([](standin::HdBench& b) { b.devices[0].maxForce_N = 1e9; }); // the library does not help
        pushFor(*device, Vec3(300, 400, 0), 0.3);
        QVERIFY((m_bench->motors() - expected_N * Vec3(0.6, 0.8, 0)).norm() < 1e-9);
        pushFor(*device, Vec3(std::numeric_limits<double>::quiet_NaN(), 0, 0), 0.01);
        QCOMPARE(m_bench->motors().norm(), 0.0);
        device->stop();
        QCOMPARE(m_bench->violation(expected_N), QString());
        m_bench->with([](standin::HdBench& b) { b.devices[0].largestForce_N = 0.0; });
    }

    void otherLimitsComeFromTheDevice()
    {
        const auto limits = [&](const std::function<void(standin::HdDevice&)>& change) {
            m_bench->renew();
            m_bench->with([&](standin::HdBench& b) { change(b.devices[0]); });
            return m_bench->make(*m_host)->info();
        };
        const device::DeviceInfo stated = limits([](standin::HdDevice& d) { d.maxStiffness_N_per_mm = 0.3; });
        QCOMPARE(stated.maxStiffness_N_per_mm, 0.3);
        QCOMPARE(stated.maxDamping_Ns_per_mm, 0.004); // the published one is lower
        QCOMPARE(stated.workspaceRadius_mm, (80.0 + 60.0 + 35.0) / 3.0);
        const device::DeviceInfo unstated = limits([](standin::HdDevice& d) { d.statesLimits = false; });
        QCOMPARE(unstated.maxForce_N, 3.3);
        QCOMPARE(unstated.maxStiffness_N_per_mm, 0.4);
        QCOMPARE(unstated.workspaceRadius_mm, 75.0);
        const device::DeviceInfo lying = limits([](standin::HdDevice& d) {
            d.maxStiffness_N_per_mm = -1.0;
            d.workspace_mm = {1, 1, 1, 0, 0, 0};
        });
        QCOMPARE(lying.maxStiffness_N_per_mm, 0.4);
        QCOMPARE(lying.workspaceRadius_mm, 75.0);
    }

    /// The origin is the middle of the usable workspace.
    void reportsPositionOrientationAndButtons()
    {
        m_bench->with([](standin::HdBench& b) {
            b.devices[0].workspace_mm = {-80, 0, -35, 80, 120, 35};
            b.devices[0].p = b.devices[0].to = {0.010, 0.080, 0.0};
            b.devices[0].turn = {0.5, 0.0, 0.0};
            b.devices[0].buttons = 0x7fffff03; // the library may set other bits
        });
        const auto device = m_bench->make(*m_host);
        QVERIFY(device->info().sensesOrientation);
        QVERIFY(device->start().isOk());
        pass(0.02);
        const device::DeviceState state = device->read(core::monotonicNow_ns());
        QVERIFY((state.p_D - Vec3(10, 20, 0)).norm() < 1e-9);
        QCOMPARE(state.buttons, 3U);
        const Eigen::AngleAxisd turn(state.q_D);
        QVERIFY(std::abs(state.q_D.norm() - 1.0) < 1e-12);
        QVERIFY(std::abs(turn.angle() - 0.5) < 1e-3);
        QVERIFY((turn.axis() - Vec3::UnitX()).norm() < 1e-3);
        device->stop();
    }

    void forceExpiresWithTheServoThread()
    {
        const auto device = m_bench->make(*m_host);
        QVERIFY(device->start().isOk());
        pushFor(*device, Vec3(0, 3, 0), 0.2);
        QCOMPARE(m_bench->motors().norm(), 3.0);
        pass(0.010);
        QCOMPARE(m_bench->motors().norm(), 0.0);
        m_bench->with([](standin::HdBench& b) { QCOMPARE(b.devices[0].watchdogs, std::uint64_t{0}); });
        device->stop();
    }

    void forcesOfAnotherDriverAreSwitchedOnAgain()
    {
        const auto device = m_bench->make(*m_host);
        QVERIFY(device->start().isOk());
        pushFor(*device, Vec3(0, 1, 0), 0.1);
        m_bench->with([](standin::HdBench& b) { b.devices[0].isForceOn = false; });
        pushFor(*device, Vec3(0, 1, 0), 0.05);
        QVERIFY(!device->read(core::monotonicNow_ns()).isPresent); // so that the gate eases the force in
        pushFor(*device, Vec3(0, 1, 0), 1.0);
        QCOMPARE(m_bench->motors().norm(), 1.0);
        device->stop();
    }
};

PALPATE_TEST(HdDevice)
#include "tst_HdDevice.moc"
