// SPDX-License-Identifier: BSD-3-Clause
// Everything that a bus, a firmware and a hand can do wrong, at random, for minutes of virtual time: the motors never
// push more than they may, and are off whenever they must be.
#include "EmulatedArm.h"
#include "TestRunner.h"

#include <palpate/servo/ServoLoop.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace palpate;
using namespace palpate::test;

namespace {

constexpr double kForceLimit_N = 5.0;
// Half a milliampere in three motors, and how far the arm can turn away under an answer that is on its way.
constexpr double kForceSlack_N = 0.25;
// Loss is noticed, the force is ramped down, the answer travels; then the motors are off.
constexpr double kUntilOff_s = 0.040;

/// Chance from a fixed seed.
class Dice
{
  public:
    bool chance(double p) { return between(0, 1) < p; }
    double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(m_random); }

  private:
    std::mt19937 m_random{7};
};

/// Faults of the next second; none in one of four cases.
standin::Faults randomFaults(Dice& dice, std::int64_t now_ns)
{
    standin::Faults f;
    if (dice.chance(0.25)) {
        return f;
    }
    f.dropIn = dice.chance(0.3) ? dice.between(0, 0.3) : 0.0;
    f.dropOut = dice.chance(0.3) ? dice.between(0, 0.3) : 0.0;
    f.repeat = dice.chance(0.3) ? dice.between(0, 0.5) : 0.0;
    f.shortened = dice.chance(0.2) ? dice.between(0, 0.3) : 0.0;
    f.lengthened = dice.chance(0.2) ? dice.between(0, 0.3) : 0.0;
    f.random = dice.chance(0.3) ? dice.between(0, 0.3) : 0.0;
    f.delay = dice.chance(0.3) ? dice.between(0, 0.5) : 0.0;
    if (dice.chance(0.1)) {
        f.stalledUntil_ns = now_ns + static_cast<std::int64_t>(dice.between(0.001, 0.9) * 1e9);
    }
    return f;
}

double norm(const standin::V3& v)
{
    return std::hypot(v[0], v[1], v[2]);
}

} // namespace

class Faults : public QObject
{
    Q_OBJECT

  private:
    std::unique_ptr<EmulatedBench> m_bench;
    std::unique_ptr<device::PluginHost> m_host;

    void freshArm()
    {
        m_bench->with([](standin::Bench& b) {
            b.arm = {};
            b.arm.q = standin::restPose(b.arm.unit);
            b.faults = {};
        });
    }

    std::unique_ptr<device::HapticDevice> makeArm()
    {
        auto made = m_host->make("woodenhaptics");
        return made.isOk() ? std::move(made).value() : nullptr;
    }

    /// Force of the arm's motors per second.
    struct Pushed
    {
        double most_N = 0.0;
        double aside = 0.0; ///< calibration error in counts
        int calibrated = 0; ///< seconds without calibration
    };
    void judgePush(double second, Pushed& pushed)
    {
        m_bench->with([&](standin::Bench& b) {
            pushed.most_N = std::max(pushed.most_N, b.arm.largestForce_N);
            QVERIFY(std::isfinite(b.arm.largestForce_N));
            // An arm calibrated in a wrong pose pushes in a wrong direction, with the same current.
            const auto& offset = b.arm.counterOffset;
            const double aside = std::max({std::abs(offset[0]), std::abs(offset[1]), std::abs(offset[2])});
            if (aside + pushed.aside < 10.0) {
                QVERIFY2(b.arm.largestForce_N <= kForceLimit_N + kForceSlack_N,
                         qPrintable(QStringLiteral("%1 N in second %2").arg(b.arm.largestForce_N).arg(second)));
                ++pushed.calibrated;
            }
            pushed.aside = aside;
            b.arm.largestForce_N = 0.0;
            for (double amps : b.arm.amps) {
                QVERIFY(std::abs(amps) <= 2.0);
            }
        });
    }

    /// The hand takes the arm to its calibration pose, on a bus that behaves, and presses the button.
    void calibrateByHand()
    {
        standin::V3 rest{};
        m_bench->with([&](standin::Bench& b) {
            b.faults = {};
            b.arm.hand.isHolding = true;
            b.arm.isButtonDown = false;
            rest = standin::tipOf(b.arm.unit, standin::restPose(b.arm.unit));
        });
        m_bench->moveHand({{1.0, rest}});
        pass(2.0);
        m_bench->with([](standin::Bench& b) { b.arm.isButtonDown = true; });
        pass(0.2);
    }

    double motorForce_N()
    {
        double force_N = 0.0;
        m_bench->with([&](standin::Bench& b) { force_N = norm(standin::forceOf(b.arm.unit, b.arm.q, b.arm.amps)); });
        return force_N;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        m_bench = std::make_unique<EmulatedBench>();
        m_host = shippingPlugins();
        standin_makeTimeVirtual();
    }

    void oneFaultTakesTheForceAway_data()
    {
        QTest::addColumn<int>("what");
        QTest::newRow("firmware hangs") << 0;
        QTest::newRow("unplugged") << 1;
        QTest::newRow("only random reports") << 2;
        QTest::newRow("only short reports") << 3;
        QTest::newRow("every report dropped") << 4;
    }

    void oneFaultTakesTheForceAway()
    {
        QFETCH(const int, what);
        freshArm();
        m_bench->moveHand({{1.0, {0, 0, 10}}, {2.0, {0, 0, -8}}});
        const auto arm = makeArm();
        QVERIFY(arm != nullptr);
        servo::ServoLoop loop;
        loop.setScene(blockScene(0.5));
        QVERIFY(loop.start(*arm, {.askRealtime = false}).isOk());
        pass(3.5);
        QVERIFY2(motorForce_N() > 0.5, "the hand presses before anything goes wrong");
        m_bench->with([&](standin::Bench& b) {
            const std::int64_t now_ns = b.arm.sim_ns;
            switch (what) {
            case 0:
                b.faults.stalledUntil_ns = now_ns + 3'000'000'000;
                break;
            case 1:
                standin::plugArm(b, false, now_ns);
                break;
            case 2:
                b.faults.random = 1.0;
                break;
            case 3:
                b.faults.shortened = 1.0;
                break;
            default:
                b.faults.dropIn = 1.0;
            }
        });
        pass(kUntilOff_s);
        // A hanging firmware keeps driving until the firmware or the power returns; the host requests zero force.
        if (what != 0) {
            QCOMPARE(motorForce_N(), 0.0);
        }
        QVERIFY(loop.fault().isFaulted());
        servo::TickRecord tick;
        QVERIFY(loop.fetchSnapshot(tick));
        QCOMPARE(tick.fSent_W.norm(), 0.0);
        m_bench->with([](standin::Bench& b) { b.faults = {}; });
        pass(1.0);
        QCOMPARE(motorForce_N(), 0.0); // latched, though all is well again
        loop.stop();
    }

    void comesBackWhenPluggedInAgainAndCalibrated()
    {
        freshArm();
        const auto arm = makeArm();
        QVERIFY(arm != nullptr);
        servo::ServoLoop loop;
        loop.setScene(blockScene(0.5));
        QVERIFY(loop.start(*arm, {.askRealtime = false}).isOk());
        m_bench->moveHand({{1.0, {0, 0, 10}}, {2.0, {0, 0, -8}}});
        pass(3.5);
        QVERIFY(motorForce_N() > 0.5);
        m_bench->with([](standin::Bench& b) { standin::plugArm(b, false, b.arm.sim_ns); });
        pass(0.5);
        QCOMPARE(arm->report().condition, device::DeviceCondition::Lost);
        QVERIFY(loop.fault().isFaulted());
        m_bench->with([](standin::Bench& b) { standin::plugArm(b, true, b.arm.sim_ns); });
        pass(0.5);
        QCOMPARE(arm->report().condition, device::DeviceCondition::NeedsCalibration);
        loop.rearm();
        pass(1.0);
        QCOMPARE(motorForce_N(), 0.0); // where the arm is, nobody knows: no hand, no force
        // Back to the calibration pose, and the button.
        calibrateByHand();
        QCOMPARE(arm->report().condition, device::DeviceCondition::Working);
        m_bench->moveHand({{1.0, {0, 0, 10}}, {2.0, {0, 0, -8}}});
        pass(3.5);
        QVERIFY2(!loop.fault().isFaulted(), loop.fault().message.english().c_str());
        QVERIFY2(motorForce_N() > 0.5, "the hand presses again");
        // Calibrated by a hand, the pose is right to the hand's own steadiness.
        servo::TickRecord tick;
        QVERIFY(loop.fetchSnapshot(tick));
        m_bench->with([&](standin::Bench& b) {
            const standin::V3 p = standin::tipOf(b.arm.unit, b.arm.q);
            QVERIFY((tick.p_WH - core::Vec3(p[0], p[1], p[2])).norm() < 2.0);
        });
        loop.stop();
    }

    void refusesAnotherToyWithTheSameIds()
    {
        freshArm();
        m_bench->with([](standin::Bench& b) { b.strangerLength = 5; });
        const auto arm = makeArm();
        const core::Status status = arm->start();
        m_bench->with([](standin::Bench& b) { b.strangerLength = 0; });
        QCOMPARE(status.code(), core::StatusCode::Unsupported);
        QVERIFY2(status.message().find("5 bytes") != std::string::npos, status.message().c_str());
        m_bench->with([](standin::Bench& b) {
            b.arm.isPlugged = false;
            b.hasStranger = true;
        });
        QCOMPARE(arm->start().code(), core::StatusCode::NotFound);
        m_bench->with([](standin::Bench& b) { b.hasStranger = false; });
    }

    void everythingAtRandom()
    {
        const char* asked = std::getenv("PALPATE_FAULT_MINUTES");
        const double minutes = asked == nullptr ? 3.0 : std::atof(asked);
        freshArm();
        m_bench->with([](standin::Bench& b) { b.random = 20251; });
        const auto arm = makeArm();
        QVERIFY(arm != nullptr);
        servo::ServoLoop loop;
        loop.setScene(blockScene(0.5));
        QVERIFY(loop.start(*arm, {.askRealtime = false}).isOk());

        Dice dice;
        int faults = 0;
        int zeros = 0;
        int calibrations = 0;
        Pushed pushed;
        for (double second = 0.0; second < minutes * 60.0; second += 1.0) {
            m_bench->with([&](standin::Bench& b) {
                b.faults = randomFaults(dice, b.arm.sim_ns);
                if (dice.chance(0.07)) {
                    standin::plugArm(b, false, b.arm.sim_ns);
                } else if (!b.arm.isPlugged) {
                    standin::plugArm(b, true, b.arm.sim_ns);
                }
                b.arm.isButtonDown = b.arm.isButtonDown || (dice.chance(0.02) && second > 0.3 * 60.0 * minutes);
                b.arm.hand.isHolding = !dice.chance(0.03);
            });
            if (dice.chance(0.5)) {
                const double time_s = dice.between(0.1, 0.9), x = dice.between(-90, 90), y = dice.between(-90, 90);
                m_bench->moveHand({{time_s, {x, y, dice.between(-15, 30)}}});
            }
            const bool isAway = arm->report().condition == device::DeviceCondition::NeedsCalibration;
            if (isAway || (pushed.aside > 10.0 && dice.chance(0.3))) {
                calibrateByHand();
                calibrations += arm->report().condition == device::DeviceCondition::Working ? 1 : 0;
            }
            if (loop.fault().isFaulted()) {
                ++faults;
                // A latched fault means motors off, once the news has travelled; a hanging firmware hears no news.
                pass(kUntilOff_s);
                bool isHanging = false;
                m_bench->with([&](standin::Bench& b) { isHanging = b.arm.sim_ns < b.faults.stalledUntil_ns; });
                if (!isHanging && loop.fault().isFaulted()) {
                    QCOMPARE(motorForce_N(), 0.0);
                    ++zeros;
                }
                loop.rearm();
            }
            pass(1.0);
            judgePush(second, pushed);
            servo::TickRecord tick;
            if (loop.fetchSnapshot(tick)) {
                QVERIFY(tick.fSent_W.allFinite() && tick.fSent_W.norm() <= kForceLimit_N * (1 + 1e-9));
            }
            QVERIFY(loop.isRunning());
        }
        const device::DeviceReport report = arm->report();
        loop.stop();
        pass(kUntilOff_s);
        m_bench->with([](standin::Bench& b) { b.faults = {}; });
        qInfo("%.1f min: %llu reports taken, %llu refused, lost %llu times, calibrated %d times; %d faults, motors "
              "seen off "
              "after %d of them; largest force %.2f N; %d s with the arm calibrated right",
              minutes, static_cast<unsigned long long>(report.states), static_cast<unsigned long long>(report.refused),
              static_cast<unsigned long long>(report.losses), calibrations, faults, zeros, pushed.most_N,
              pushed.calibrated);
        QVERIFY(report.refused > 100 && report.losses > 0 && faults > 2 && zeros > 0 && calibrations > 0 &&
                pushed.most_N > 0.5);
        // A contact outlasts a fault, so tissue pushes the arm aside while it is calibrated more often than not.
        QVERIFY(pushed.calibrated > minutes * 5.0);
    }
};

PALPATE_TEST(Faults)
#include "tst_Faults.moc"
