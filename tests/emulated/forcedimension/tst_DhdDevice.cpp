// SPDX-License-Identifier: BSD-3-Clause
// The released Force Dimension plugin against emulated devices that work as they should, in virtual time.
#include "EmulatedArm.h"
#include "EmulatedDhd.h"
#include "TestRunner.h"

#include <palpate/servo/ServoLoop.h>

#include <algorithm>
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

    /// Writes a force in the user frame for some time, tick by tick.
    static void pushFor(device::HapticDevice& device, const Vec3& f_U, double seconds)
    {
        for (int i = 0; i < static_cast<int>(seconds * 1000.0); ++i) {
            pass(0.001);
            (void)device.read(core::monotonicNow_ns());
            device.write(toDevice(device, f_U));
        }
    }

    /// The first force call of `device` that carries a sampled position as its force (1 N for 1 mm): its delay since
    /// the sample, for each sample.
    std::vector<std::int64_t> delays()
    {
        std::vector<std::int64_t> found;
        m_bench->with([&](standin::DhdBench& b) {
            const standin::DhdDevice& d = b.devices[0];
            const std::uint64_t size = d.forces.size();
            Vec3 before = Vec3::Zero();
            for (std::uint64_t i = d.forceCount > size ? d.forceCount - size : 0; i < d.forceCount; ++i) {
                const standin::DhdForce& force = d.forces[i % size];
                const Vec3 f(force.f.data());
                if (f.isApprox(before) || f.norm() < 0.5) {
                    continue;
                }
                before = f;
                for (std::uint64_t j = d.sampleCount > size ? d.sampleCount - size : 0; j < d.sampleCount; ++j) {
                    const standin::DhdSample& sample = d.samples[j % size];
                    if ((Vec3(sample.p.data()) * 1000.0 - f).norm() < 1e-9) {
                        found.push_back(force.time_ns - sample.time_ns);
                        break;
                    }
                }
            }
        });
        return found;
    }

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
        const auto device = makeDhd(*m_host);
        QVERIFY(device != nullptr);
        const core::Status started = device->start();
        QVERIFY2(started.isOk(), started.message().c_str());
        pushFor(*device, Vec3::Zero(), 0.2);
        m_bench->with([](standin::DhdBench& b) {
            standin::DhdDevice& d = b.devices[0];
            d.isHeld = false;
            d.p = d.v = {};
        });
        const Vec3 f_U = Vec3::Unit(axis);
        pushFor(*device, f_U, 0.03);
        Vec3 p_U = Vec3::Zero(), v_U = Vec3::Zero();
        m_bench->with([&](standin::DhdBench& b) {
            v_U = Vec3(b.devices[0].v.data());
            p_U = Vec3(b.devices[0].p.data()) * 1000.0;
        });
        // 1 N on 0.15 kg for nearly 30 ms against 1 N s/m: about 0.18 m/s, and nothing across.
        QVERIFY2(v_U[axis] > 0.1 && v_U[axis] < 0.2, qPrintable(QString::number(v_U[axis])));
        QVERIFY((v_U - v_U[axis] * f_U).norm() < 1e-9);
        const device::DeviceState state = device->read(core::monotonicNow_ns());
        QVERIFY(state.isPresent);
        QVERIFY2((toUser(*device, state.p_D) - p_U).norm() < 0.3, // of motion within a tick
                 qPrintable(QString::number((toUser(*device, state.p_D) - p_U).norm())));
        device->stop();
        QCOMPARE(m_bench->motors().norm(), 0.0);
    }

    void feelsABlock()
    {
        const auto device = makeDhd(*m_host);
        QVERIFY(device != nullptr);
        servo::ServoLoop loop;
        loop.setScene(blockScene(1.0));
        m_bench->moveHand({0, 10, 0}, 0.3);
        const core::Status started = loop.start(*device, {.askRealtime = false});
        QVERIFY2(started.isOk(), started.message().c_str());
        pass(1.0);
        m_bench->moveHand({0, -8, 0}, 0.7);
        pass(2.5);
        QVERIFY2(!loop.fault().isFaulted(), loop.fault().message.english().c_str());
        double depth_mm = 0.0;
        m_bench->with([&](standin::DhdBench& b) { depth_mm = -b.devices[0].p[1] * 1000.0; });
        const Vec3 f_U = m_bench->motors();
        qInfo("%.3f mm deep, %.3f N", depth_mm, f_U.y());
        // Spring of 1 N/mm against the hand of 0.5 N/mm, 8 mm below the surface.
        QVERIFY(depth_mm > 2.0);
        QVERIFY(std::abs(f_U.y() - depth_mm) < 0.02);
        QVERIFY(std::hypot(f_U.x(), f_U.z()) < 0.01);
        const device::DeviceReport report = device->report();
        QCOMPARE(report.condition, device::DeviceCondition::Working);
        QCOMPARE(report.text, std::string());
        QVERIFY(report.latency.count > 1000);
        loop.stop();
        QCOMPARE(m_bench->motors().norm(), 0.0);
        m_bench->with([](standin::DhdBench& b) { QCOMPARE(b.devices[0].owner, 0); }); // closed
    }

    void roundTripIsAtMostOneTickAboveTheDevices()
    {
        const auto device = makeDhd(*m_host);
        QVERIFY(device != nullptr);
        QVERIFY(device->start().isOk());
        pushFor(*device, Vec3::Zero(), 0.2);
        m_bench->with([](standin::DhdBench& b) { b.devices[0].mass_kg = 1000.0; }); // not moved by the forces
        m_bench->with([](standin::DhdBench& b) { b.devices[0].v = {0.004, 0.003, 0.002}; });
        m_bench->with([](standin::DhdBench& b) { b.devices[0].isHeld = false; });
        for (int i = 0; i < 1000; ++i) {
            pass(0.001);
            const device::DeviceState state = device->read(core::monotonicNow_ns());
            device->write(state.p_D);
        }
        std::vector<std::int64_t> found = delays();
        device->stop();
        QVERIFY2(found.size() > 300, qPrintable(QString::number(found.size())));
        std::sort(found.begin(), found.end());
        qInfo("%zu round trips: median %.3f ms, longest %.3f ms", found.size(),
              static_cast<double>(found[found.size() / 2]) * 1e-6, static_cast<double>(found.back()) * 1e-6);
        constexpr std::int64_t kOwn_ns = 100'000; // the emulated device takes a force 0.1 ms after the call
        QVERIFY(found.back() <= kOwn_ns + 1'000'000);
    }

    void twoDevicesAreToldApartBySerialNumber()
    {
        m_bench->with([](standin::DhdBench& b) { b.count = 2; });
        const auto listed = m_host->find("forcedimension");
        QVERIFY(listed.isOk());
        QCOMPARE(listed.value().size(), std::size_t{2});
        QCOMPARE(listed.value()[0].address, std::string("1001"));
        QCOMPARE(listed.value()[1].address, std::string("1002"));
        const core::Status undecided = makeDhd(*m_host)->start();
        QCOMPARE(undecided.code(), core::StatusCode::NotFound);
        QVERIFY2(undecided.message().find("2 devices") != std::string::npos, undecided.message().c_str());

        m_bench->configure(R"(, "serial": 1002)");
        const auto second = makeDhd(*m_host);
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
        const auto device = makeDhd(*m_host);
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
        const auto device = makeDhd(*m_host);
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
        const auto device = makeDhd(*m_host);
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
