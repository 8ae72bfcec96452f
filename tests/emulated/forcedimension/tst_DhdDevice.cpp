// SPDX-License-Identifier: BSD-3-Clause
// The released Force Dimension plugin against emulated devices that work as they should, in virtual time.
#include "DeviceChecks.h"
#include "EmulatedDhd.h"
#include "TestRunner.h"

#include <cmath>
#include <limits>

using namespace palpate;
using namespace palpate::test;
using core::Vec3;

class DhdDevice : public QObject
{
    Q_OBJECT

  private:
    std::unique_ptr<EmulatedDhd> m_bench;
    std::unique_ptr<device::PluginHost> m_host;

  private Q_SLOTS:
    void initTestCase()
    {
        m_bench = std::make_unique<EmulatedDhd>();
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

    void feelsABlock() { checkBlockIsFelt(*m_bench, *m_host, 8.0); }

    /// The emulated device takes a force 0.1 ms after the call.
    void roundTripIsAtMostOneTickAboveTheDevices() { checkRoundTripIsShort(*m_bench, *m_host, 100'000); }

    void twoDevicesAreToldApartBySerialNumber()
    {
        m_bench->with([](standin::DhdBench& b) { b.count = 2; });
        const auto listed = m_host->find("forcedimension");
        QVERIFY(listed.isOk());
        QCOMPARE(listed.value().size(), std::size_t{2});
        QCOMPARE(listed.value()[0].address, std::string("1001"));
        QCOMPARE(listed.value()[1].address, std::string("1002"));
        const core::Status undecided = m_bench->make(*m_host)->start();
        QCOMPARE(undecided.code(), core::StatusCode::NotFound);
        QVERIFY2(undecided.message().find("2 devices") != std::string::npos, undecided.message().c_str());

        m_bench->configure(R"(, "serial": 1002)");
        const auto second = m_bench->make(*m_host);
        auto madeFirst = m_host->make("forcedimension", "1001"); // a given address goes before the settings
        QVERIFY(second != nullptr && madeFirst.isOk());
        const std::unique_ptr<device::HapticDevice> first = std::move(madeFirst).value();
        QVERIFY(second->start().isOk());
        QVERIFY(first->start().isOk());
        QCOMPARE(m_host->find("forcedimension").value().size(), std::size_t{2}); // also while both are open
        const auto pushBoth = [&](double seconds) {
            for (int i = 0; i < static_cast<int>(seconds * 1000.0); ++i) {
                pass(0.001);
                (void)first->read(core::monotonicNow_ns());
                (void)second->read(core::monotonicNow_ns());
                first->write(toDevice(*first, Vec3(1, 0, 0)));
                second->write(toDevice(*second, Vec3(0, 2, 0)));
            }
        };
        pushBoth(0.3);
        QVERIFY((m_bench->motors(0) - Vec3(1, 0, 0)).norm() < 1e-12);
        QVERIFY((m_bench->motors(1) - Vec3(0, 2, 0)).norm() < 1e-12);
        // Both come back in the other order.
        m_bench->with([](standin::DhdBench& b) {
            standin::plugDhd(b.devices[0], false);
            standin::plugDhd(b.devices[1], false);
        });
        pushBoth(0.5);
        QCOMPARE(first->report().condition, device::DeviceCondition::Lost);
        QVERIFY(first->read(core::monotonicNow_ns()).isLost);
        m_bench->with([](standin::DhdBench& b) {
            b.order = {1, 0};
            standin::plugDhd(b.devices[0], true);
            standin::plugDhd(b.devices[1], true);
        });
        pushBoth(0.5);
        QCOMPARE(first->report().condition, device::DeviceCondition::Working);
        QVERIFY((m_bench->motors(0) - Vec3(1, 0, 0)).norm() < 1e-12);
        QVERIFY((m_bench->motors(1) - Vec3(0, 2, 0)).norm() < 1e-12);
        first->stop();
        second->stop();
    }

    void limitsComeFromTheDeviceAndFromTheTable_data()
    {
        QTest::addColumn<int>("type");
        QTest::addColumn<double>("reported_N");
        QTest::addColumn<QString>("settings");
        QTest::addColumn<double>("expected_N");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("omega") << 33 << -1.0 << QString() << 12.0;
        QTest::newRow("omega, reports less") << 33 << 6.0 << QString() << 6.0;
        QTest::newRow("omega, reports more") << 33 << 600.0 << QString() << 12.0;
        QTest::newRow("omega, reports zero") << 33 << 0.0 << QString() << 12.0;
        QTest::newRow("omega, reports NaN") << 33 << nan << QString() << 12.0;
        QTest::newRow("delta") << 63 << -1.0 << QString() << 20.0;
        QTest::newRow("sigma.7") << 104 << -1.0 << QString() << 12.0;
        QTest::newRow("Falcon") << 60 << -1.0 << QString() << 8.0;
        QTest::newRow("settings lower a known limit") << 33 << -1.0 << R"(, "max_force_N": 5)" << 5.0;
        QTest::newRow("settings do not raise it") << 33 << -1.0 << R"(, "max_force_N": 40)" << 12.0;
        QTest::newRow("unknown type") << 999 << -1.0 << QString() << 3.0;
        QTest::newRow("unknown type, stated") << 999 << -1.0 << R"(, "max_force_N": 9)" << 9.0;
    }

    void limitsComeFromTheDeviceAndFromTheTable()
    {
        QFETCH(const int, type);
        QFETCH(const double, reported_N);
        QFETCH(const QString, settings);
        QFETCH(const double, expected_N);
        m_bench->with([&](standin::DhdBench& b) {
            b.devices[0].type = type;
            b.devices[0].reportedForce_N = reported_N;
            b.devices[0].hasName = type != 999;
            b.devices[0].velocityLimit_m_per_s = 1e9; // these forces throw the hand
        });
        m_bench->configure(settings.toStdString());
        const auto device = m_bench->make(*m_host);
        QVERIFY(device != nullptr);
        QCOMPARE(device->info().maxForce_N, expected_N);
        QVERIFY(device->start().isOk());
        QCOMPARE(device->info().maxForce_N, expected_N);
        QVERIFY(!device->info().name.empty());
        QCOMPARE(device->report().text.empty(), type != 999 || !settings.isEmpty());
        pushFor(*device, Vec3(300, 400, 0), 0.3);
        QVERIFY((m_bench->motors() - expected_N * Vec3(0.6, 0.8, 0)).norm() < 1e-9);
        pushFor(*device, Vec3(std::numeric_limits<double>::quiet_NaN(), 0, 0), 0.01);
        QCOMPARE(m_bench->motors().norm(), 0.0);
        device->stop();
        QCOMPARE(m_bench->violation(expected_N), QString());
        m_bench->with([](standin::DhdBench& b) { b.devices[0].largestForce_N = 0.0; });
    }

    /// An omega.7: its gripper is a button, and torque and gripper force are sent with each force.
    void reportsOrientationAndButtons()
    {
        m_bench->with([](standin::DhdBench& b) {
            b.devices[0].type = 35;
            b.devices[0].hasGripper = true;
            b.devices[0].hasWrist = true;
            b.devices[0].turn = {0.0, 0.5, 0.0}; // about the library's y axis, the user's x axis
            b.devices[0].buttons = 5;
        });
        const auto device = m_bench->make(*m_host);
        QVERIFY(device->info().sensesOrientation);
        QVERIFY(device->start().isOk());
        pushFor(*device, Vec3(0, 2, 0), 0.05);
        QVERIFY((m_bench->motors() - Vec3(0, 2, 0)).norm() < 1e-12);
        m_bench->with([](standin::DhdBench& b) { QVERIFY(b.devices[0].isGripperAButton); });
        const device::DeviceState state = device->read(core::monotonicNow_ns());
        QCOMPARE(state.buttons, 5U);
        const Eigen::AngleAxisd turn(state.q_D);
        QVERIFY(std::abs(turn.angle() - 0.5) < 1e-9);
        QVERIFY((toUser(*device, turn.axis()) - Vec3::UnitX()).norm() < 1e-9);
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
        m_bench->with([](standin::DhdBench& b) { QCOMPARE(b.devices[0].watchdogs, std::uint64_t{0}); });
        device->stop();
    }
};

PALPATE_TEST(DhdDevice)
#include "tst_DhdDevice.moc"
