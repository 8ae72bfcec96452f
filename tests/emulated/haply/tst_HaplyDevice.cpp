// SPDX-License-Identifier: BSD-3-Clause
// The released Haply plugin against an emulated service that works as it should, in virtual time.
#include "EmulatedArm.h"
#include "EmulatedHaply.h"
#include "TestRunner.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace palpate;
using namespace palpate::test;
using core::Vec3;

class HaplyDevice : public QObject
{
    Q_OBJECT

  private:
    std::unique_ptr<EmulatedHaply> m_bench;
    std::unique_ptr<device::PluginHost> m_host;

    static Vec3 toUser(const device::HapticDevice& device, const Vec3& v_D) { return device.info().q_UD * v_D; }

    std::unique_ptr<device::HapticDevice> started()
    {
        auto device = makeHaply(*m_host);
        const core::Status status = device == nullptr ? core::Status() : device->start();
        if (!status.isOk()) {
            qWarning("%s", status.message().c_str());
            return nullptr;
        }
        return device;
    }

    /// Lets the hand go at rest in the centre, pushes by 1 N along an axis, and compares motion and report.
    void expectMotionAlong(int axis)
    {
        const auto device = started();
        QVERIFY(device != nullptr);
        pushHaply(*device, Vec3::Zero(), 0.1);
        m_bench->with([](standin::HaplyBench& b) {
            b.devices[0].isHeld = false;
            b.devices[0].p = b.devices[0].v = {};
        });
        pushHaply(*device, Vec3::Unit(axis), 0.03);
        Vec3 p_U = Vec3::Zero(), v_U = Vec3::Zero();
        m_bench->with([&](standin::HaplyBench& b) {
            v_U = Vec3(b.devices[0].v.data());
            p_U = Vec3(b.devices[0].p.data()) * 1000.0;
        });
        // 1 N on 0.15 kg for nearly 30 ms against 1 N s/m: about 0.18 m/s, and nothing across.
        QVERIFY2(v_U[axis] > 0.1 && v_U[axis] < 0.2, qPrintable(QString::number(v_U[axis])));
        QVERIFY((v_U - v_U[axis] * Vec3::Unit(axis)).norm() < 1e-9);
        const device::DeviceState state = device->read(core::monotonicNow_ns());
        QVERIFY(state.isPresent);
        const double off_mm = (toUser(*device, state.p_D) - p_U).norm();
        QVERIFY2(off_mm < 0.3, qPrintable(QString::number(off_mm))); // of motion within a tick
        device->stop();
        QCOMPARE(m_bench->motors().norm(), 0.0);
        m_bench->with([](standin::HaplyBench& b) { b.devices[0].largestForce_N = 0.0; });
    }

  private Q_SLOTS:
    void initTestCase()
    {
        standin_makeTimeVirtual();
        standin_makePollsVirtual();
        m_bench = std::make_unique<EmulatedHaply>();
        m_host = shippingPlugins();
    }
    void init() { m_bench->renew(); }
    void cleanup() { QCOMPARE(m_bench->violation(), QString()); }
    void cleanupTestCase() { m_bench.reset(); }

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
        expectMotionAlong(axis);
    }

    void axesThatTheHubHasLeftAreReset_data()
    {
        QTest::addColumn<QString>("basis");
        QTest::addColumn<double>("scale");
        QTest::addColumn<QString>("type");
        QTest::newRow("other basis") << "XZY" << 1.0 << "inverse3";
        QTest::newRow("scaled mount") << "XYZ" << 2.0 << "inverse3";
        QTest::newRow("Minverse, centred by the service") << "XYZ" << 1.0 << "minverse";
    }

    void axesThatTheHubHasLeftAreReset()
    {
        QFETCH(const QString, basis);
        QFETCH(const double, scale);
        QFETCH(const QString, type);
        m_bench->with([&](standin::HaplyBench& b) {
            b.devices[0].basis = basis.toStdString();
            b.devices[0].mountScale = scale;
            b.devices[0].mount_m = {0.1 * (scale - 1.0), 0.0, 0.0};
            b.devices[0].type = type.toStdString();
        });
        expectMotionAlong(1);
    }

    void axesThatCannotBeResetAreReported_data()
    {
        QTest::addColumn<QString>("basis");
        QTest::addColumn<double>("scale");
        QTest::addColumn<double>("workspace");
        QTest::newRow("basis") << "XZY" << 1.0 << 1.0;
        QTest::newRow("mount") << "XYZ" << 2.0 << 1.0;
        QTest::newRow("workspace") << "XYZ" << 1.0 << 2.0;
    }

    void axesThatCannotBeResetAreReported()
    {
        QFETCH(const QString, basis);
        QFETCH(const double, scale);
        QFETCH(const double, workspace);
        m_bench->with([&](standin::HaplyBench& b) {
            b.devices[0].basis = basis.toStdString();
            b.devices[0].mountScale = scale;
            b.devices[0].workspaceScale = workspace;
            b.devices[0].ignoresConfiguration = true;
        });
        const auto device = started();
        QVERIFY(device != nullptr);
        pushHaply(*device, Vec3(0, 2, 0), 0.1);
        QCOMPARE(m_bench->motors().norm(), 0.0);
        QVERIFY(!device->read(core::monotonicNow_ns()).isPresent);
        QCOMPARE(device->report().condition, device::DeviceCondition::NeedsCalibration);
        QVERIFY2(device->report().text.find("Haply Hub") != std::string::npos, device->report().text.c_str());
        m_bench->with([](standin::HaplyBench& b) { // the user follows the advice
            b.devices[0].ignoresConfiguration = false;
            b.devices[0].workspaceScale = 1.0;
        });
        m_bench->crash(); // as the Hub does when it applies settings
        pushHaply(*device, Vec3(0, 2, 0), 2.0);
        QVERIFY((m_bench->motors() - Vec3(0, 2, 0)).norm() < 1e-9);
        device->stop();
    }

    void feelsABlock()
    {
        const auto device = makeHaply(*m_host);
        QVERIFY(device != nullptr);
        servo::ServoLoop loop;
        loop.setScene(blockScene(1.0));
        m_bench->moveHand({0, 10, 0}, 0.2);
        const core::Status started = loop.start(*device, {.askRealtime = false});
        QVERIFY2(started.isOk(), started.message().c_str());
        pass(0.8);
        m_bench->moveHand({0, -8, 0}, 0.5);
        pass(1.5);
        QVERIFY2(!loop.fault().isFaulted(), loop.fault().message.english().c_str());
        double depth_mm = 0.0;
        m_bench->with([&](standin::HaplyBench& b) { depth_mm = -b.devices[0].p[1] * 1000.0; });
        const Vec3 f_U = m_bench->motors();
        qInfo("%.3f mm deep, %.3f N", depth_mm, f_U.y());
        // Spring of 1 N/mm against the hand of 0.5 N/mm, 8 mm below the surface.
        QVERIFY(depth_mm > 2.0);
        QVERIFY(std::abs(f_U.y() - depth_mm) < 0.02);
        QVERIFY(std::hypot(f_U.x(), f_U.z()) < 0.01);
        const device::DeviceReport report = device->report();
        QCOMPARE(report.condition, device::DeviceCondition::Working);
        QCOMPARE(report.text, std::string());
        QVERIFY(report.latency.count > 500);
        loop.stop();
        QCOMPARE(m_bench->motors().norm(), 0.0);
        m_bench->with([](standin::HaplyBench& b) {
            QCOMPARE(b.devices[0].forces.back().f, (standin::HaplyV3{})); // sent, and not only forgotten
        });
        pass(0.01);
        m_bench->with([](standin::HaplyBench& b) { QCOMPARE(b.openSessions, 0); });
    }

    /// From the answer that carries a position to the message with the force computed from it.
    void roundTripIsAtMostOneTickAboveTheServices()
    {
        const auto device = started();
        QVERIFY(device != nullptr);
        pushHaply(*device, Vec3::Zero(), 0.1);
        m_bench->with([](standin::HaplyBench& b) {
            b.devices[0].mass_kg = 1000.0; // not moved by the forces
            b.devices[0].v = {0.004, 0.003, 0.002};
            b.devices[0].isHeld = false;
            b.devices[0].samples.clear();
            b.devices[0].forces.clear();
        });
        for (int i = 0; i < 500; ++i) {
            pass(0.001);
            const device::DeviceState state = device->read(core::monotonicNow_ns());
            device->write(state.p_D); // 1 N for 1 mm
        }
        device->stop();
        std::vector<std::int64_t> found;
        m_bench->with([&](standin::HaplyBench& b) {
            const standin::HaplyDevice& d = b.devices[0];
            Vec3 before = Vec3::Zero();
            for (const standin::HaplyForce& force : d.forces) {
                const Vec3 f(force.f.data());
                if (f.norm() < 0.1 || (f - before).norm() < 1e-7) {
                    continue;
                }
                before = f;
                for (const standin::HaplySample& sample : d.samples) {
                    if ((Vec3(sample.p.data()) * 1000.0 - f).norm() < 1e-9) {
                        found.push_back(force.time_ns - sample.time_ns);
                        break;
                    }
                }
            }
        });
        QVERIFY2(found.size() > 300, qPrintable(QString::number(found.size())));
        std::sort(found.begin(), found.end());
        qInfo("%zu round trips: median %.3f ms, longest %.3f ms", found.size(),
              static_cast<double>(found[found.size() / 2]) * 1e-6, static_cast<double>(found.back()) * 1e-6);
        constexpr std::int64_t kOwn_ns = 200'000; // both directions of the emulated link
        QVERIFY(found.back() <= kOwn_ns + 1'000'000);
    }

    void nameOfTheForceFollowsTheVersion_data()
    {
        QTest::addColumn<QString>("version");
        QTest::addColumn<bool>("isNew");
        QTest::addColumn<bool>("isVector");
        QTest::newRow("3.1") << "3.1.1" << false << false;
        QTest::newRow("3.4") << "3.4.0" << true << false;
        QTest::newRow("3.5") << "3.5.0" << true << true;
        QTest::newRow("3.12") << "3.12.2-rc1" << true << true;
        QTest::newRow("no version, old fields") << "" << false << false;
        QTest::newRow("no version, new fields") << "" << true << true;
        QTest::newRow("3.5 that takes the old name only") << "3.5.0" << true << false; // found by what it drives
        QTest::newRow("3.4 that takes the new name only") << "3.4.0" << true << true;
    }

    void nameOfTheForceFollowsTheVersion()
    {
        QFETCH(const QString, version);
        QFETCH(const bool, isNew);
        QFETCH(const bool, isVector);
        m_bench->with([&](standin::HaplyBench& b) {
            b.version = version.toStdString();
            b.isNew = isNew;
            b.hasVector = isVector;
            b.hasValues = !isVector;
        });
        const auto device = started();
        QVERIFY(device != nullptr);
        pushHaply(*device, Vec3(0, 2, 0), 0.3);
        QVERIFY((m_bench->motors() - Vec3(0, 2, 0)).norm() < 1e-9);
        QCOMPARE(device->report().text, std::string());
        device->stop();
    }

    void deviceThatNeverFollowsIsReported()
    {
        m_bench->with([](standin::HaplyBench& b) { b.hasVector = b.hasValues = false; });
        const auto device = started();
        QVERIFY(device != nullptr);
        pushHaply(*device, Vec3(0, 2, 0), 0.5);
        QVERIFY2(device->report().text.find("does not drive the force") != std::string::npos,
                 device->report().text.c_str());
        m_bench->with([](standin::HaplyBench& b) { b.hasVector = b.hasValues = true; });
        pushHaply(*device, Vec3(0, 2, 0), 0.05);
        QCOMPARE(device->report().text, std::string());
        device->stop();
    }

    void twoDevicesAreToldApartById()
    {
        m_bench->with([](standin::HaplyBench& b) {
            b.devices.emplace_back();
            b.devices[1].id = "04A1";
        });
        const auto listed = m_host->find("haply");
        QVERIFY(listed.isOk());
        QCOMPARE(listed.value().size(), std::size_t{2});
        QCOMPARE(listed.value()[0].address, std::string("049D"));
        QCOMPARE(listed.value()[1].name, std::string("Haply Inverse3 04A1"));
        const core::Status undecided = makeHaply(*m_host)->start();
        QCOMPARE(undecided.code(), core::StatusCode::NotFound);
        QVERIFY2(undecided.message().find("2 devices") != std::string::npos, undecided.message().c_str());

        m_bench->configure(R"(, "device_id": "04A1")");
        const auto second = makeHaply(*m_host);
        const auto first = makeHaply(*m_host, "049D"); // a given address goes before the settings
        QVERIFY(second != nullptr && first != nullptr);
        QVERIFY(second->start().isOk());
        QVERIFY(first->start().isOk());
        const core::Status twice = makeHaply(*m_host, "049D")->start();
        QVERIFY2(twice.message().find("already in use") != std::string::npos, twice.message().c_str());
        const auto pushBoth = [&](double seconds) {
            const Vec3 right = first->info().q_UD.conjugate() * Vec3(1, 0, 0);
            const Vec3 up = second->info().q_UD.conjugate() * Vec3(0, 2, 0);
            for (int i = 0; i < static_cast<int>(seconds * 1000.0); ++i) {
                pass(0.001);
                (void)first->read(core::monotonicNow_ns());
                (void)second->read(core::monotonicNow_ns());
                first->write(right);
                second->write(up);
            }
        };
        const auto areBothRight = [&](std::size_t i, std::size_t j) {
            return (m_bench->motors(i) - Vec3(1, 0, 0)).norm() < 1e-9 &&
                   (m_bench->motors(j) - Vec3(0, 2, 0)).norm() < 1e-9;
        };
        pushBoth(0.2);
        QVERIFY(areBothRight(0, 1));
        // Both come back in the other order.
        m_bench->with([](standin::HaplyBench& b) { b.devices[0].isPlugged = b.devices[1].isPlugged = false; });
        pushBoth(0.3);
        QCOMPARE(first->report().condition, device::DeviceCondition::Lost);
        QVERIFY(first->read(core::monotonicNow_ns()).isLost);
        m_bench->with([](standin::HaplyBench& b) {
            std::swap(b.devices[0], b.devices[1]);
            b.devices[0].isPlugged = b.devices[1].isPlugged = true;
        });
        pushBoth(0.6);
        QCOMPARE(first->report().condition, device::DeviceCondition::Working);
        QVERIFY(areBothRight(1, 0));
        first->stop();
        second->stop();
    }

    void limitsComeFromTheTable_data()
    {
        QTest::addColumn<QString>("type");
        QTest::addColumn<QString>("settings");
        QTest::addColumn<double>("expected_N");
        QTest::newRow("Inverse3") << "inverse3" << QString() << 10.0;
        QTest::newRow("Inverse3x") << "inverse3x" << QString() << 10.0;
        QTest::newRow("settings lower a known limit") << "inverse3"
                                                      << R"(, "max_force_N": 5)" << 5.0;
        QTest::newRow("settings do not raise it") << "inverse3"
                                                  << R"(, "max_force_N": 40)" << 10.0;
        QTest::newRow("Minverse") << "minverse" << QString() << 3.0;
        QTest::newRow("Minverse, stated") << "minverse"
                                          << R"(, "max_force_N": 4)" << 4.0;
        QTest::newRow("unknown") << "inverse9" << QString() << 3.0;
    }

    void limitsComeFromTheTable()
    {
        QFETCH(const QString, type);
        QFETCH(const QString, settings);
        QFETCH(const double, expected_N);
        m_bench->with([&](standin::HaplyBench& b) {
            b.devices[0].type = type.toStdString();
            b.devices[0].mass_kg = 1e6; // these forces throw the hand
        });
        m_bench->configure(settings.toStdString());
        const auto device = makeHaply(*m_host);
        QVERIFY(device != nullptr);
        QCOMPARE(device->info().maxForce_N, expected_N);
        QVERIFY(device->start().isOk());
        QCOMPARE(device->info().maxForce_N, expected_N);
        QCOMPARE(device->report().text.empty(), expected_N != 3.0);
        pushHaply(*device, Vec3(300, 400, 0), 0.1);
        QVERIFY((m_bench->motors() - expected_N * Vec3(0.6, 0.8, 0)).norm() < 1e-9);
        pushHaply(*device, Vec3(std::numeric_limits<double>::quiet_NaN(), 0, 0), 0.01);
        QCOMPARE(m_bench->motors().norm(), 0.0);
        device->stop();
        QCOMPARE(m_bench->violation(expected_N), QString());
    }

    void reportsOrientationAndButtonsOfTheGrip_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<quint32>("buttons");
        QTest::newRow("wired") << "verse_grip" << 1U;
        QTest::newRow("wireless") << "wireless_verse_grip" << 5U;
        QTest::newRow("custom") << "custom_verse_grip" << 5U;
    }

    void reportsOrientationAndButtonsOfTheGrip()
    {
        QFETCH(const QString, kind);
        QFETCH(const quint32, buttons);
        m_bench->with([&](standin::HaplyBench& b) {
            standin::HaplyGrip grip;
            grip.kind = kind.toStdString();
            grip.q = {std::cos(0.25), std::sin(0.25), 0.0, 0.0}; // about the service's x axis, the user's
            grip.isA = grip.isC = true;
            b.grips.push_back(grip);
        });
        const auto device = started();
        QVERIFY(device != nullptr);
        QVERIFY(device->info().sensesOrientation);
        pushHaply(*device, Vec3::Zero(), 0.05);
        const device::DeviceState state = device->read(core::monotonicNow_ns());
        QCOMPARE(state.buttons, buttons);
        const Eigen::AngleAxisd turn(state.q_D);
        QVERIFY(std::abs(turn.angle() - 0.5) < 1e-9);
        QVERIFY((toUser(*device, turn.axis()) - Vec3::UnitX()).norm() < 1e-9);
        device->stop();
    }

    void gripIsChosenBySettings()
    {
        m_bench->with([](standin::HaplyBench& b) {
            b.grips.resize(2);
            b.grips[1].id = "8002";
            b.grips[1].isB = true;
        });
        auto device = started();
        QVERIFY(device != nullptr && !device->info().sensesOrientation);
        pushHaply(*device, Vec3::Zero(), 0.05);
        QVERIFY2(device->report().text.find("grip_id") != std::string::npos, device->report().text.c_str());
        device->stop();
        m_bench->configure(R"(, "grip_id": "8002")");
        device = started();
        QVERIFY(device != nullptr && device->info().sensesOrientation);
        pushHaply(*device, Vec3::Zero(), 0.05);
        QCOMPARE(device->read(core::monotonicNow_ns()).buttons, 2U);
        QCOMPARE(device->report().text, std::string());
        device->stop();
    }

    void forceExpiresWithTheServoThread()
    {
        const auto device = started();
        QVERIFY(device != nullptr);
        pushHaply(*device, Vec3(0, 3, 0), 0.1);
        QVERIFY(std::abs(m_bench->motors().norm() - 3.0) < 1e-9);
        pass(0.010);
        QCOMPARE(m_bench->motors().norm(), 0.0);
        m_bench->with([](standin::HaplyBench& b) { QCOMPARE(b.devices[0].watchdogs, std::uint64_t{0}); });
        device->stop();
    }

    void warnsOfAnotherProgram()
    {
        m_bench->with([](standin::HaplyBench& b) { b.devices[0].isInUse = true; });
        const auto device = started();
        QVERIFY(device != nullptr);
        pushHaply(*device, Vec3::Zero(), 0.05);
        QVERIFY2(device->report().text.find("Another program") != std::string::npos, device->report().text.c_str());
        device->stop();
    }
};

PALPATE_TEST(HaplyDevice)
#include "tst_HaplyDevice.moc"
