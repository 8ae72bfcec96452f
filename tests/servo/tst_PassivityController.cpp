// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/device/DevicePresets.h>
#include <palpate/servo/PassivityController.h>

#include <cmath>
#include <limits>
#include <tuple>

using palpate::device::DeviceInfo;
using palpate::servo::PassivityLimits;
using palpate::servo::Vec3;
using Controller = palpate::servo::PassivityController;

namespace {

/// Runs one tick of the controller with the hand at `p`.
Vec3 damped(Controller& controller, const Vec3& f, const Vec3& p, bool isInContact)
{
    controller.follow(p);
    return controller.damping(f, isInContact);
}

constexpr double kTick_s = 0.001;
constexpr double kStiffness = 2.0; // [N/mm]

PassivityLimits limits(int delayTicks, double own = 0.0)
{
    PassivityLimits out;
    out.delayTicks = delayTicks;
    out.ownDamping_Ns_per_mm = own;
    out.maxDamping_Ns_per_mm = 0.1;
    return out;
}

/// Returns the force of a wall at x < 0, acting directly on the device.
Vec3 wall(double x)
{
    return {x < 0.0 ? -kStiffness * x : 0.0, 0.0, 0.0};
}

/// Moves the hand along `x(n)`; the damping of the controller is computed but never applied.
template<class Path>
double excessAfter(Controller& controller, int ticks, Path x)
{
    for (int n = 0; n < ticks; ++n) {
        const Vec3 f = wall(x(n));
        static_cast<void>(damped(controller, f, Vec3(x(n), 0, 0), true));
        controller.noteSent(f);
    }
    return controller.state().excess_mJ;
}

} // namespace

class PassivityController : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void countsWhatSamplingMakesOfASpring_data()
    {
        QTest::addColumn<int>("delay");
        for (const int delay : {0, 1, 2}) {
            QTest::addRow("%d ticks late", delay) << delay;
        }
    }
    /// Pressing in and coming back by d per tick generates an excess of (1/2 + delay) K d^2 per tick.
    void countsWhatSamplingMakesOfASpring()
    {
        QFETCH(int, delay);
        constexpr double kMove = 0.01;
        constexpr int kWay = 200;
        Controller controller(limits(delay), kTick_s);
        const double excess = excessAfter(controller, 2 * kWay + 1, [](int n) {
            return -1.0 - kMove * (n < kWay ? n : 2 * kWay - n); // starts inside: the first tick counts no motion
        });
        const double expected = 2 * kWay * (0.5 + delay) * kStiffness * kMove * kMove;
        // The first ticks have no force yet and the turning point counts in reverse: a few ticks' worth of error.
        QVERIFY2(std::abs(excess - expected) < 0.05 * expected + 2.5 * delay * kStiffness * kMove,
                 qPrintable(QString("%1, expected %2").arg(excess).arg(expected)));
    }

    /// A device damping of b = (1/2 + delay) K T removes the whole excess: the passivity bound.
    void theDevicesOwnDampingPaysFirst()
    {
        const double enough = 0.5 * kStiffness * kTick_s;
        const auto path = [](int n) { return -1.0 + 0.5 * std::sin(0.1 * n); };
        Controller paid(limits(0, 1.001 * enough), kTick_s);
        static_cast<void>(excessAfter(paid, 50, path));
        QVERIFY(excessAfter(paid, 500, path) < 1e-9);
        Controller unpaid(limits(0, 0.9 * enough), kTick_s);
        QVERIFY(excessAfter(unpaid, 500, path) > 0.01);
    }

    void restAndSlowTissueCostNothing()
    {
        Controller controller(limits(1, 0.001), kTick_s);
        for (int n = 0; n < 1000; ++n) {
            const Vec3 f(0.2 * n * 0.01, 0, 0); // 0.2 N/mm: (1/2 + 1) K T is below the device's damping
            const Vec3 added = damped(controller, f, Vec3(-0.01 * n, 0, 0), true);
            controller.noteSent(f);
            QVERIFY(n < 5 || added.isZero(0.0));
        }
        const Vec3 f(2.0, 0, 0);
        static_cast<void>(damped(controller, f, Vec3(-10, 0, 0), true));
        for (int n = 0; n < 10; ++n) {
            QVERIFY(damped(controller, f, Vec3(-10, 0, 0), true).isZero(0.0));
        }
    }

    /// A slow press with a quantised sensor: the added force stays below K times half a quantum, the uncertainty of the
    /// sensor, and the controller does not react to a whole quantum in one tick as to a velocity.
    void aStepOfTheSensorIsNoMotion()
    {
        constexpr double kSensor_mm = 0.064;
        PassivityLimits stepped = limits(1);
        stepped.maxDamping_Ns_per_mm = 0.008;
        const auto mostAdded = [&](double known_mm) {
            stepped.resolution_mm = known_mm;
            Controller controller(stepped, kTick_s);
            double most = 0.0;
            for (int n = 0; n < 2000; ++n) {
                const double x = -1.0 - 0.005 * (n < 1000 ? n : 2000 - n);
                const double seen = kSensor_mm * std::round(x / kSensor_mm);
                const Vec3 added = damped(controller, wall(seen), Vec3(seen, 0, 0), true);
                controller.noteSent(wall(seen) + added);
                most = n >= 100 ? std::max(most, added.norm()) : most;
            }
            return most;
        };
        const double most_N = mostAdded(kSensor_mm);
        QVERIFY2(most_N > 0.0 && most_N < 0.5 * kStiffness * kSensor_mm, qPrintable(QString::number(most_N)));
        QVERIFY(mostAdded(0.0) < 0.5 * kStiffness * kSensor_mm); // the quantum is detected
    }

    void dampsAgainstTheMotionAndNeverBeyondItsBound()
    {
        PassivityLimits bounded = limits(1);
        bounded.maxDamping_Ns_per_mm = 0.003;
        Controller controller(bounded, kTick_s);
        double most = 0.0;
        Vec3 last = Vec3::Zero();
        for (int n = 0; n < 500; ++n) {
            const Vec3 p(-1.0 + 0.5 * std::sin(0.3 * n), 0.2 * std::cos(0.2 * n), 0);
            const Vec3 f = wall(p[0]);
            const Vec3 added = damped(controller, f, p, true);
            controller.noteSent(f + added);
            const Vec3 v = n > 0 ? Vec3((p - last) / kTick_s) : Vec3(Vec3::Zero());
            QVERIFY((added + controller.state().damping_Ns_per_mm * v).norm() < 1e-12);
            QVERIFY(controller.state().damping_Ns_per_mm <= 0.003);
            most = std::max(most, controller.state().damping_Ns_per_mm);
            last = p;
        }
        QCOMPARE(most, 0.003);
    }

    void dampingThatWasSentPaysTheExcessBack()
    {
        const auto path = [](int n) { return -1.0 + 0.1 * std::sin(0.1 * n); };
        Controller idle(limits(0), kTick_s);
        const double unpaid = excessAfter(idle, 1000, path);
        Controller controller(limits(0), kTick_s);
        double worst = 0.0;
        for (int n = 0; n < 1000; ++n) {
            const Vec3 f = wall(path(n)) + damped(controller, wall(path(n)), Vec3(path(n), 0, 0), true);
            controller.noteSent(f);
            worst = std::max(worst, controller.state().excess_mJ);
        }
        QVERIFY(unpaid > 0.0);
        QVERIFY2(worst < 0.05 * unpaid, qPrintable(QString("%1 of %2").arg(worst).arg(unpaid)));
    }

    /// Energy generated by the model: a soft press, a stiff release.
    void whatTheModelMakesIsDampedToo()
    {
        PassivityLimits sure = limits(0, 0.01); // the device damping covers sampling
        Controller controller(sure, kTick_s);
        bool isDamped = false;
        for (int n = 0; n < 200; ++n) {
            const bool isOut = n >= 100;
            const double x = isOut ? -0.99 + 0.01 * (n - 100) : -0.01 * n; // stiffens while at rest
            const Vec3 f((isOut ? -10.0 : -1.0) * x, 0, 0);
            isDamped = !damped(controller, f, Vec3(x, 0, 0), true).isZero(0.0) || isDamped;
            controller.noteSent(f);
            QVERIFY(!isDamped || isOut);
        }
        QVERIFY(isDamped);
        QVERIFY(controller.state().energy_mJ < 0.0);

        // A switch to a stiffer scene generates no energy that needs dissipation.
        Controller changed(sure, kTick_s);
        for (int n = 0; n < 200; ++n) {
            const bool isOut = n >= 100;
            const double x = isOut ? -0.99 + 0.01 * (n - 100) : -0.01 * n; // stiffens while at rest
            const Vec3 f((isOut ? -10.0 : -1.0) * x, 0, 0);
            if (n == 100) {
                changed.noteStored(0.5 * 10.0 * x * x);
            }
            QVERIFY(damped(changed, f, Vec3(x, 0, 0), true).isZero(0.0));
            changed.noteSent(f);
        }
    }

    void freeSpaceAndANewHandForget()
    {
        Controller controller(limits(1), kTick_s);
        QVERIFY(excessAfter(controller, 100, [](int n) { return -1.0 + 0.5 * std::sin(0.3 * n); }) > 0.0);
        static_cast<void>(damped(controller, Vec3::Zero(), Vec3(1, 0, 0), false));
        QCOMPARE(controller.state().excess_mJ, 0.0);
        QVERIFY(excessAfter(controller, 100, [](int n) { return -1.0 + 0.5 * std::sin(0.3 * n); }) > 0.0);
        controller.reset();
        QCOMPARE(controller.state().excess_mJ, 0.0);
        // a jump of position without contact
        QVERIFY(damped(controller, Vec3(5, 0, 0), Vec3(-100, 0, 0), true).isZero(0.0));
    }

    /// After a change of the delay to two ticks during contact, the new delay applies from then on.
    void theDelayMayChange()
    {
        const auto path = [](int n) { return -1.0 - 0.01 * (n < 200 ? n : 400 - n); };
        Controller told(limits(0), kTick_s), known(limits(2), kTick_s);
        told.setDelay(2);
        QCOMPARE(excessAfter(told, 401, path), excessAfter(known, 401, path));
        Controller beyond(limits(0), kTick_s);
        beyond.setDelay(1000000);
        QVERIFY(std::isfinite(excessAfter(beyond, 401, path)));
    }

    void latencyIsRoundedUpToTicks()
    {
        palpate::core::TimingSummary latency;
        latency.count = 5000;
        latency.p50_ns = 900'000;
        for (const auto& [p99_ns, rate, ticks] :
             {std::tuple(900'000, 1000.0, 1), std::tuple(1'003'000, 1000.0, 1), std::tuple(1'500'000, 1000.0, 2),
              std::tuple(1'500'000, 4000.0, 6), std::tuple(0, 1000.0, 1)}) {
            latency.p99_ns = p99_ns;
            QCOMPARE(palpate::servo::delayTicksOf(latency, rate), ticks);
        }
        latency.count = 10; // too few samples
        latency.p99_ns = 9'000'000;
        QCOMPARE(palpate::servo::delayTicksOf(latency, 1000.0), 1);
    }

    void offItWatchesOnly()
    {
        PassivityLimits off = limits(1);
        off.isOn = false;
        Controller controller(off, kTick_s);
        for (int n = 0; n < 200; ++n) {
            const double x = -1.0 + 0.5 * std::sin(0.3 * n);
            QVERIFY(damped(controller, wall(x), Vec3(x, 0, 0), true).isZero(0.0));
            controller.noteSent(wall(x));
        }
        QVERIFY(controller.state().excess_mJ > 0.0);
        QVERIFY(controller.state().energy_mJ != 0.0);
    }

    void whatIsNoNumberIsForgotten()
    {
        Controller controller(limits(1), kTick_s);
        const double nan = std::numeric_limits<double>::quiet_NaN();
        static_cast<void>(damped(controller, Vec3(1, 0, 0), Vec3::Zero(), true));
        QVERIFY(damped(controller, Vec3(nan, 0, 0), Vec3(1, 0, 0), true).isZero(0.0));
        QVERIFY(damped(controller, Vec3(1, 0, 0), Vec3(0, nan, 0), true).isZero(0.0));
        QVERIFY(damped(controller, Vec3(1, 0, 0), Vec3(-1, 0, 0), true).allFinite());
        QVERIFY(std::isfinite(controller.state().energy_mJ));
    }

    void boundsAreThePapers()
    {
        using namespace palpate::servo;
        QCOMPARE(passiveStiffness_N_per_mm(0.0005, 0.0, 0.001), 1.0); // b = 0.5 N s/m at 1 ms: 1 N/mm
        QCOMPARE(passiveStiffness_N_per_mm(0.0005, -0.0003, 0.001), 0.4);
        QCOMPARE(passiveStiffness_N_per_mm(0.0005, 0.001, 0.001), 0.0);
        QCOMPARE(stableStiffness_N_per_mm(0.0015, 0.001, 0.001), 1.0);
        DeviceInfo touch = palpate::device::deviceInfo(*palpate::device::findDevicePreset("touch"));
        QCOMPARE(heldStiffness_N_per_mm(touch, 1000.0, true), 0.4);
        QVERIFY(heldStiffness_N_per_mm(touch, 250.0, true) < 0.2);
        QVERIFY(heldStiffness_N_per_mm(touch, 1000.0, false) < 0.24);
        DeviceInfo omega = palpate::device::deviceInfo(*palpate::device::findDevicePreset("omega"));
        QCOMPARE(heldStiffness_N_per_mm(omega, 1000.0, true), 5.0); // equals the formula
        double before = 5.0;
        for (const int delay : {2, 3, 4, 8, 30}) { // a larger delay lowers the limit
            const double held = heldStiffness_N_per_mm(omega, 1000.0, true, delay);
            QVERIFY(held < before && held > 0.0);
            before = held;
        }
        omega.resolution_mm = 0.2; // motion below the resolution is not damped
        QVERIFY(heldStiffness_N_per_mm(omega, 1000.0, true) < 2.0);
        QVERIFY(heldStiffness_N_per_mm(omega, 1000.0, true) > heldStiffness_N_per_mm(omega, 1000.0, false));
        touch.actuatedAxes = 0;
        QVERIFY(std::isinf(heldStiffness_N_per_mm(touch, 1000.0, true)));
    }
};

PALPATE_TEST(PassivityController)
#include "tst_PassivityController.moc"
