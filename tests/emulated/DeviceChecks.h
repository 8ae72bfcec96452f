// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "EmulatedArm.h"
#include "SharedDevices.h"

#include <palpate/servo/ServoLoop.h>

#include <QCoreApplication>
#include <QProcess>
#include <QtTest>

#include <algorithm>
#include <cmath>

/// Requirements on every driver of a maker's library, with healthy devices and with faults.
namespace palpate::test {

/// Writes a force in the user frame for some time, tick by tick.
inline void pushFor(device::HapticDevice& device, const core::Vec3& f_U, double seconds)
{
    for (int i = 0; i < static_cast<int>(seconds * 1000.0); ++i) {
        pass(0.001);
        (void)device.read(core::monotonicNow_ns());
        device.write(toDevice(device, f_U));
    }
}

/// A force of 1 N along an axis of the user accelerates the tip along it, and the position is in the user's axes.
template<class Bench>
void checkForceAcceleratesTheTip(SharedDevices<Bench>& bench, device::PluginHost& host, int axis)
{
    const auto device = bench.make(host);
    QVERIFY(device != nullptr);
    const core::Status started = device->start();
    QVERIFY2(started.isOk(), started.message().c_str());
    pushFor(*device, core::Vec3::Zero(), 0.2);
    bench.with([](Bench& b) {
        b.devices[0].isHeld = false;
        b.devices[0].p = b.devices[0].v = {};
    });
    const core::Vec3 f_U = core::Vec3::Unit(axis);
    pushFor(*device, f_U, 0.03);
    core::Vec3 p_U = core::Vec3::Zero(), v_U = core::Vec3::Zero();
    bench.with([&](Bench& b) {
        v_U = core::Vec3(b.devices[0].v.data());
        p_U = core::Vec3(b.devices[0].p.data()) * 1000.0;
    });
    // 1 N on 0.15 kg for nearly 30 ms against 1 N s/m: about 0.18 m/s, and nothing across.
    QVERIFY2(v_U[axis] > 0.1 && v_U[axis] < 0.2, qPrintable(QString::number(v_U[axis])));
    QVERIFY((v_U - v_U[axis] * f_U).norm() < 1e-9);
    const device::DeviceState state = device->read(core::monotonicNow_ns());
    QVERIFY(state.isPresent);
    QVERIFY2((toUser(*device, state.p_D) - p_U).norm() < 0.3, // of motion within a tick
             qPrintable(QString::number((toUser(*device, state.p_D) - p_U).norm())));
    device->stop();
    QCOMPARE(bench.motors().norm(), 0.0);
}

/// A hand 8 mm below the surface of a block of 1 N/mm is pressed back with the force of the spring law.
template<class Bench>
void checkBlockIsFelt(SharedDevices<Bench>& bench, device::PluginHost& host, double depth_mm)
{
    const auto device = bench.make(host);
    QVERIFY(device != nullptr);
    servo::ServoLoop loop;
    loop.setScene(blockScene(1.0));
    bench.lift(10, 0.3);
    const core::Status started = loop.start(*device, {.askRealtime = false});
    QVERIFY2(started.isOk(), started.message().c_str());
    pass(1.0);
    bench.lift(-depth_mm, 0.7);
    pass(2.5);
    QVERIFY2(!loop.fault().isFaulted(), loop.fault().message.english().c_str());
    double found_mm = 0.0;
    bench.with([&](Bench& b) { found_mm = -1000.0 * core::Vec3(b.devices[0].p.data()).dot(bench.out_U()); });
    const double force_N = bench.pressure_N();
    qInfo("%.3f mm deep, %.3f N", found_mm, force_N);
    QVERIFY(found_mm > 0.25 * depth_mm); // a spring of 1 N/mm against the hand of 0.5 N/mm
    QVERIFY(std::abs(force_N - found_mm) < 0.02);
    QVERIFY((bench.motors() - force_N * bench.out_U()).norm() < 0.01);
    const device::DeviceReport report = device->report();
    QCOMPARE(report.condition, device::DeviceCondition::Working);
    QCOMPARE(report.text, std::string());
    QVERIFY(report.latency.count > 1000);
    loop.stop();
    QCOMPARE(bench.motors().norm(), 0.0);
    bench.with([](Bench& b) { QCOMPARE(b.devices[0].owner, 0); }); // closed
}

/// @param own_ns  of the emulated device, from the call with a force to the force
template<class Bench>
void checkRoundTripIsShort(SharedDevices<Bench>& bench, device::PluginHost& host, std::int64_t own_ns)
{
    const auto device = bench.make(host);
    QVERIFY(device != nullptr);
    QVERIFY(device->start().isOk());
    pushFor(*device, core::Vec3::Zero(), 0.2);
    bench.with([](Bench& b) { b.devices[0].mass_kg = 1000.0; }); // not moved by the forces
    bench.with([](Bench& b) { b.devices[0].v = {0.002, 0.0015, 0.001}; });
    bench.with([](Bench& b) { b.devices[0].isHeld = false; });
    for (int i = 0; i < 1000; ++i) {
        pass(0.001);
        const device::DeviceState state = device->read(core::monotonicNow_ns());
        device->write(state.p_D);
    }
    std::vector<std::int64_t> found = bench.delays();
    device->stop();
    QVERIFY2(found.size() > 300, qPrintable(QString::number(found.size())));
    std::sort(found.begin(), found.end());
    qInfo("%zu round trips: median %.3f ms, longest %.3f ms", found.size(),
          static_cast<double>(found[found.size() / 2]) * 1e-6, static_cast<double>(found.back()) * 1e-6);
    QVERIFY(found.back() <= own_ns + 1'000'000);
}

/// A hand that presses on a block through a driver, for tests that break something meanwhile.
template<class Bench>
class PressingHand
{
  public:
    PressingHand(SharedDevices<Bench>& bench, device::PluginHost& host)
        : m_bench(bench)
        , m_host(host)
    {
    }

    /// Presses, unless the hand was kept by the last row.
    /// @param starting_s  time that the driver needs before it drives a force
    void press(double starting_s = 0.0)
    {
        if (loop != nullptr) {
            return;
        }
        device = m_bench.make(m_host);
        QVERIFY(device != nullptr);
        loop = std::make_unique<servo::ServoLoop>();
        loop->setScene(blockScene(0.5));
        const core::Status started = loop->start(*device, {.askRealtime = false});
        QVERIFY2(started.isOk(), started.message().c_str());
        pass(starting_s);
        liftAndPress();
    }
    /// A contact begins outside of the block.
    void liftAndPress()
    {
        m_bench.lift(10, 0.12);
        pass(0.15);
        m_bench.lift(-10, 0.12);
        pass(0.45);
        QVERIFY2(!loop->fault().isFaulted(), loop->fault().message.english().c_str());
        QCOMPARE(device->report().condition, device::DeviceCondition::Working);
        QVERIFY2(m_bench.pressure_N() > 2.0, "the hand presses");
    }
    void release()
    {
        m_keptFor.clear();
        if (loop != nullptr) {
            loop->stop();
        }
        loop.reset();
        device.reset();
        QCOMPARE(m_bench.motors().norm(), 0.0);
    }
    /// The hand presses as at the begin of the row, whose faults are over: the next row of the test goes on from here.
    void keep() { m_keptFor = QTest::currentTestFunction(); }
    /// At the begin of a row. @return true if the hand was kept by the last row; otherwise the hand is released
    [[nodiscard]] bool isKept()
    {
        const bool isKept = m_keptFor == QTest::currentTestFunction();
        m_keptFor.clear();
        if (!isKept) {
            release();
        }
        return isKept;
    }
    /// At the end of a row: releases a hand that was not kept, or did not do as it should.
    void finishRow()
    {
        if (m_keptFor.isEmpty() || QTest::currentTestFailed()) {
            release();
        }
    }
    /// The force never misses for long: the largest of the next 20 ms.
    [[nodiscard]] double largestForce_N()
    {
        double largest_N = 0.0;
        for (int i = 0; i < 20; ++i) {
            largest_N = std::max(largest_N, m_bench.pressure_N());
            pass(0.001);
        }
        return largest_N;
    }

    std::unique_ptr<device::HapticDevice> device;
    std::unique_ptr<servo::ServoLoop> loop;

  private:
    SharedDevices<Bench>& m_bench;
    device::PluginHost& m_host;
    QByteArray m_keptFor; ///< name of the test
};

/// The child process of a test that kills it: presses until killed, or calls exit() when `isOver`.
template<class Bench>
void pressForever(
    const SharedDevices<Bench>& bench, const std::function<bool()>& isOver = [] { return false; })
{
    const auto host = shippingPlugins();
    const auto device = bench.make(*host);
    QVERIFY(device != nullptr);
    servo::ServoLoop loop;
    loop.setScene(blockScene(0.5));
    const core::Status started = loop.start(*device, {});
    QVERIFY2(started.isOk(), started.message().c_str());
    for (;;) {
        pass(0.05);
        if (isOver()) {
            std::exit(0);
        }
        if (loop.fault().isFaulted()) { // on a busy machine a late tick may count as a fault
            loop.rearm();
        }
    }
}

/// Starts the child process, the function `pressForever` of the test `name`, and moves its hand until it presses.
/// @param variable  environment variable with the bench of the child
/// @return the force; 0: the child does not press
template<class Bench>
double startPressing(SharedDevices<Bench>& bench, QProcess& child, const char* variable, const char* name)
{
    const core::Vec3 above_m = 0.010 * bench.out_U();
    bench.with([&](Bench& b) { b.devices[0].p = b.devices[0].to = {above_m.x(), above_m.y(), above_m.z()}; });
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QString::fromLatin1(variable), QString::fromStdString(bench.file()));
    child.setProcessEnvironment(environment);
    child.start(QCoreApplication::applicationFilePath(), {QString::fromLatin1(name), QStringLiteral("pressForever")});
    if (!child.waitForStarted()) {
        return 0.0;
    }
    double force_N = 0.0;
    for (int i = 0; i < 30 && force_N < 0.5; ++i) { // again after a fault, on a busy machine
        bench.lift(10, 0.3);
        pass(1.0);
        bench.lift(-10, 0.5);
        for (int j = 0; j < 200 && force_N < 0.5; ++j) {
            pass(0.005);
            force_N = bench.motors().norm();
        }
    }
    return force_N;
}

} // namespace palpate::test
