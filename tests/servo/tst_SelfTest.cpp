// SPDX-License-Identifier: BSD-3-Clause
// The self-test against a simulated device with and without a hand, in virtual time, and with everything that a device
// can do wrong.
#include "RealtimeGuard.h"
#include "TestRunner.h"

#include <palpate/device/DevicePresets.h>
#include <palpate/servo/SelfTestResult.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

using namespace palpate;
using core::Vec3;
using servo::SelfTestStep;
using servo::SelfTestStop;

namespace {

enum class Wrong
{
    Nothing,
    Lost,
    Absent,
    NaN,
    Stalled, // an old state
    Jump,
    Frozen,   // the position stands still, with good times
    Reversed, // the motors push against the command
};

/// Device with one axis, z, and a hand that may hold it.
class Bench
{
  public:
    device::DeviceInfo info = device::deviceInfo(*device::findDevicePreset("omega"));
    double mass_kg = 0.15;
    double damping_Ns_per_m = 1.0;
    double friction_N = 0.0;
    std::size_t delayTicks = 1;
    bool isHeld = false;
    double handMass_kg = 0.1;
    double handStiffness_N_per_m = 500.0;
    double handDamping_Ns_per_m = 5.0;
    double tremor_mm = 0.0; ///< of the hand's target, at 9.3 Hz
    Wrong wrong = Wrong::Nothing;

    device::DeviceState read(std::int64_t now_ns)
    {
        step();
        device::DeviceState state;
        state.isPresent = wrong != Wrong::Absent;
        state.isLost = wrong == Wrong::Lost;
        m_time_ns = wrong == Wrong::Stalled ? m_time_ns : now_ns;
        state.time_ns = m_time_ns;
        const double q = info.resolution_mm;
        m_shown = wrong == Wrong::Frozen ? m_shown : std::round(1000.0 * m_x / q) * q;
        state.p_D.z() = wrong == Wrong::NaN    ? std::numeric_limits<double>::quiet_NaN()
                        : wrong == Wrong::Jump ? m_shown + 1000.0
                                               : m_shown;
        return state;
    }
    void write(const Vec3& f)
    {
        m_waiting[m_tick % m_waiting.size()] = f.z();
        largest_N = std::max(largest_N, f.norm());
        last = f;
        ++m_tick;
    }
    double largest_N = 0.0;
    Vec3 last = Vec3::Zero();

  private:
    void step()
    {
        if (m_tick <= delayTicks) {
            return;
        }
        double f = m_waiting[(m_tick - 1 - delayTicks) % m_waiting.size()];
        f *= wrong == Wrong::Reversed ? -1.0 : 1.0;
        const double mass = mass_kg + (isHeld ? handMass_kg : 0.0);
        const double target =
            1e-3 * tremor_mm * std::sin(2.0 * std::numbers::pi * 9.3 * 1e-3 * static_cast<double>(m_tick));
        for (int i = 0; i < 20; ++i) {
            const double dt = 5e-5;
            double total = f - damping_Ns_per_m * m_v;
            total += isHeld ? handStiffness_N_per_m * (target - m_x) - handDamping_Ns_per_m * m_v : 0.0;
            m_v += total / mass * dt;
            const double lost = friction_N / mass * dt;
            m_v = std::abs(m_v) > lost ? m_v - std::copysign(lost, m_v) : 0.0;
            m_x += m_v * dt;
        }
    }
    double m_x = 0.0, m_v = 0.0, m_shown = 0.0; // [m]
    std::array<double, 16> m_waiting{};
    std::size_t m_tick = 0;
    std::int64_t m_time_ns = 0;
};

using Each = std::function<void(servo::SelfTest&, Bench&, double)>;

/// Runs a test to its end. @return its result
servo::SelfTestResult run(Bench& bench, const Each& each = {}, int pulses = 40)
{
    servo::SelfTestOptions options;
    options.lead_s = 0.5;
    options.handTimeout_s = 3.0;
    options.pulses = pulses;
    servo::SelfTest test(bench.info, options);
    test.setDelay(static_cast<int>(bench.delayTicks));
    for (std::int64_t n = 0; !test.isFinished() && n < 200'000; ++n) {
        const std::int64_t now_ns = 1'000'000'000 + n * 1'000'000;
        const device::DeviceState state = bench.read(now_ns);
        if (each) {
            each(test, bench, static_cast<double>(n) * 1e-3);
        }
        bench.write(test.tick(state, now_ns));
    }
    return servo::evaluate(test.record());
}

/// Hand at a device.
struct AnyHand
{
    double mass_kg, stiffness_N_per_m, ratio; // of critical damping
    double friction_N;
    int delay;
    const char* device;

    [[nodiscard]] Bench bench() const
    {
        const device::DevicePreset& preset = *device::findDevicePreset(device);
        Bench bench;
        bench.info = device::deviceInfo(preset);
        bench.mass_kg = preset.mechanics.mass_kg;
        bench.friction_N = friction_N;
        bench.isHeld = mass_kg > 0.0;
        bench.handMass_kg = mass_kg;
        bench.handStiffness_N_per_m = stiffness_N_per_m;
        bench.handDamping_Ns_per_m =
            std::max(0.5, 2.0 * ratio * std::sqrt(stiffness_N_per_m * (mass_kg + bench.mass_kg)));
        bench.tremor_mm = 0.1;
        bench.delayTicks = static_cast<std::size_t>(delay);
        return bench;
    }
    [[nodiscard]] QString name() const
    {
        return QStringLiteral("%1 kg, %2 N/m, %3 of critical, %4 N, %5 ticks, %6")
            .arg(mass_kg)
            .arg(stiffness_N_per_m)
            .arg(ratio)
            .arg(friction_N)
            .arg(delay)
            .arg(QLatin1String(device));
    }
};

std::vector<AnyHand> anyHands()
{
    std::vector<AnyHand> hands;
    const std::pair<const char*, double> devices[] = {{"omega", 0.0}, {"touch", 0.13}};
    for (const auto& [device, friction_N] : devices) {
        for (const int delay : {0, 5}) {
            hands.push_back({0.0, 0.0, 0.0, friction_N, delay, device});
            for (const double mass_kg : {0.1, 1.0}) {
                for (const double stiffness : {0.0, 500.0, 2000.0}) {
                    hands.push_back({mass_kg, stiffness, 0.2, friction_N, delay, device});
                    hands.push_back({mass_kg, stiffness, 1.0, friction_N, delay, device});
                }
            }
        }
    }
    return hands;
}

/// Runs a test until it asks for a hand, then cancels it.
servo::SelfTestRecord runToTheHand(Bench& bench, int pulses)
{
    servo::SelfTest test(bench.info, {.lead_s = 0.3, .pulses = pulses});
    for (std::int64_t n = 0; !test.isFinished(); ++n) {
        const std::int64_t now_ns = 1'000'000'000 + n * 1'000'000;
        const device::DeviceState state = bench.read(now_ns);
        if (test.record().step == SelfTestStep::Hand) {
            test.stop(SelfTestStop::Cancelled);
        }
        bench.write(test.tick(state, now_ns));
    }
    return test.record();
}

} // namespace
Q_DECLARE_METATYPE(Wrong)
Q_DECLARE_METATYPE(servo::SelfTestStep)

class SelfTest : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void measuresAnUnattendedDevice_data()
    {
        QTest::addColumn<double>("friction_N");
        QTest::addColumn<double>("resolution_mm");
        QTest::addColumn<int>("delay");
        QTest::newRow("fine") << 0.05 << 0.01 << 1;
        QTest::newRow("friction, coarse") << 0.13 << 0.055 << 1;
        QTest::newRow("late") << 0.05 << 0.03 << 4;
    }

    void measuresAnUnattendedDevice()
    {
        QFETCH(const double, friction_N);
        QFETCH(const double, resolution_mm);
        QFETCH(const int, delay);
        Bench bench;
        bench.friction_N = friction_N;
        bench.info.resolution_mm = resolution_mm;
        bench.delayTicks = static_cast<std::size_t>(delay);
        const servo::SelfTestResult result = run(bench);
        QCOMPARE(result.stopped, SelfTestStop::NoHand);
        QVERIFY(result.rest && result.friction_N && result.roundTrip);
        qInfo("friction %.3f N, resolution %.4f mm, round trip %.2f (p99 %.2f) ms, mass %.3f kg; largest force %.2f N, "
              "%.0f s",
              *result.friction_N, result.rest->resolution_mm, result.roundTrip->median_ms, result.roundTrip->p99_ms,
              result.roundTrip->mass_kg, bench.largest_N, result.duration_s);
        QVERIFY(std::abs(*result.friction_N - friction_N) < 0.03);
        QVERIFY(std::abs(result.rest->resolution_mm - resolution_mm) < 0.1 * resolution_mm);
        QCOMPARE(result.rest->noise_mm, 0.0);
        QVERIFY(std::abs(result.rest->states_per_s - 1000.0) < 1.0);
        QVERIFY(std::abs(result.roundTrip->median_ms - delay) < 0.5);
        QVERIFY(std::abs(result.roundTrip->mass_kg - bench.mass_kg) < 0.2 * bench.mass_kg);
        // The mean response to a forward pulse is a forward motion.
        double way_mm = 0.0;
        for (const auto& [t_ms, x_mm] : result.roundTrip->response_mm) {
            way_mm = t_ms < 24.0 ? x_mm : way_mm;
        }
        QVERIFY2(way_mm > 0.0, qPrintable(QString::number(way_mm)));
        QVERIFY(!result.held_N_per_mm && !result.heldControlled_N_per_mm && !result.isComplete());
        QVERIFY(bench.largest_N <= 1.3); // no wall
        QCOMPARE(bench.last, Vec3(Vec3::Zero()));
        QVERIFY(!servo::unmeasured(result).empty());
    }

    /// Hands of all kinds at two devices, right and reversed: never the wrong verdict, and rarely none.
    void judgesTheDirectionInAnyHand()
    {
        int cases = 0, unclear = 0;
        for (const AnyHand& hand : anyHands()) {
            for (const bool isReversed : {false, true}) {
                Bench bench = hand.bench();
                bench.wrong = isReversed ? Wrong::Reversed : Wrong::Nothing;
                const servo::SelfTestRecord record = runToTheHand(bench, 100);
                const bool hasPassed = record.stopped == SelfTestStop::Cancelled; // asked for a hand
                QVERIFY2(isReversed ? !hasPassed : record.stopped != SelfTestStop::Reversed, qPrintable(hand.name()));
                ++cases;
                unclear += record.stopped == SelfTestStop::NoResponse ? 1 : 0;
            }
        }
        qInfo("%d cases, %d without a clear answer", cases, unclear);
        QVERIFY(cases > 100 && 20 * unclear < cases);
    }

    void measuresTheRoundTripOfAHeldHandle_data()
    {
        QTest::addColumn<double>("mass_kg");
        QTest::addColumn<double>("stiffness");
        QTest::addColumn<double>("ratio");
        QTest::addColumn<double>("friction_N");
        QTest::addColumn<int>("delay");
        QTest::newRow("light, soft") << 0.1 << 150.0 << 1.0 << 0.05 << 3;
        QTest::newRow("stiff, resonant") << 0.1 << 2000.0 << 0.3 << 0.0 << 5;
        QTest::newRow("heavy") << 1.0 << 500.0 << 0.5 << 0.1 << 0;
        QTest::newRow("heavy, free") << 1.0 << 0.0 << 1.0 << 0.0 << 2;
    }

    void measuresTheRoundTripOfAHeldHandle()
    {
        QFETCH(const double, mass_kg);
        QFETCH(const double, stiffness);
        QFETCH(const double, ratio);
        QFETCH(const double, friction_N);
        QFETCH(const int, delay);
        Bench bench = AnyHand{mass_kg, stiffness, ratio, friction_N, delay, "omega"}.bench();
        const servo::SelfTestResult result = servo::evaluate(runToTheHand(bench, 60));
        QVERIFY(result.roundTrip.has_value());
        qInfo("%.2f ms (p99 %.2f) of %d, mass %.3f kg", result.roundTrip->median_ms, result.roundTrip->p99_ms, delay,
              result.roundTrip->mass_kg);
        QVERIFY(std::abs(result.roundTrip->median_ms - delay) < 0.5);
    }

    void measuresHeldWalls()
    {
        Bench bench;
        bench.isHeld = true;
        const servo::SelfTestResult result = run(bench);
        QCOMPARE(result.stopped, SelfTestStop::None);
        QVERIFY2(result.isComplete(), "everything was measured");
        qInfo("held %.2f, with the controller %.2f N/mm; %zu walls, %.0f s; largest force %.1f N",
              *result.held_N_per_mm, *result.heldControlled_N_per_mm, result.walls.size(), result.duration_s,
              bench.largest_N);
        // Hulin's condition with a margin: a swing of 3 mm falls below 0.05 mm within 1 s at the rate
        // (6 N s/m - 1.5 ms K) / (2 * 0.25 kg), which gives 2.6 N/mm.
        QVERIFY(*result.held_N_per_mm > 2.3 && *result.held_N_per_mm < 2.9);
        QVERIFY(*result.heldControlled_N_per_mm > 1.5 * *result.held_N_per_mm);
        QVERIFY(bench.largest_N <= 7.5 * (1.0 + 1e-9));
        QVERIFY(result.duration_s < 80.0);
        QCOMPARE(bench.last, Vec3(Vec3::Zero()));
        // No stiffer wall after the first that was lost.
        for (const bool isControlled : {false, true}) {
            double lost = std::numeric_limits<double>::infinity();
            for (const servo::SelfTestWall& wall : result.walls) {
                if (wall.isControlled == isControlled) {
                    QVERIFY(wall.stiffness_N_per_mm < lost);
                    lost = wall.isHeld ? lost : wall.stiffness_N_per_mm;
                }
            }
            QVERIFY(std::isfinite(lost));
        }
        QCOMPARE(result.traces.size(), std::size_t{4});
    }

    void endsWithZeroForceAfterAFault_data()
    {
        QTest::addColumn<SelfTestStep>("step");
        QTest::addColumn<Wrong>("wrong");
        const std::pair<const char*, Wrong> faults[] = {{"dies", Wrong::Lost},
                                                        {"absent", Wrong::Absent},
                                                        {"NaN", Wrong::NaN},
                                                        {"stalls", Wrong::Stalled},
                                                        {"jumps by 1 m", Wrong::Jump}};
        const std::pair<const char*, SelfTestStep> steps[] = {{"rest", SelfTestStep::Rest},
                                                              {"friction", SelfTestStep::Friction},
                                                              {"pulses", SelfTestStep::RoundTrip},
                                                              {"walls", SelfTestStep::Walls},
                                                              {"controlled walls", SelfTestStep::ControlledWalls}};
        for (const auto& [step, at] : steps) {
            for (const auto& [name, wrong] : faults) {
                if (at == SelfTestStep::ControlledWalls && wrong != Wrong::NaN) {
                    continue; // as at the other walls, and late
                }
                QTest::addRow("%s: %s", step, name) << at << wrong;
            }
        }
    }

    void endsWithZeroForceAfterAFault()
    {
        QFETCH(const SelfTestStep, step);
        QFETCH(const Wrong, wrong);
        Bench bench;
        bench.isHeld = true;
        double began_s = -1.0, inStep_s = 0.0, zero_s = -1.0;
        const servo::SelfTestResult result = run(
            bench,
            [&](servo::SelfTest& test, Bench& b, double time_s) {
                inStep_s += test.record().step == step ? 1e-3 : 0.0;
                if (inStep_s >= 1.5 && began_s < 0.0) {
                    began_s = time_s;
                    b.wrong = wrong;
                }
                if (began_s >= 0.0 && b.last.isZero(0.0)) {
                    zero_s = zero_s < 0.0 ? time_s : zero_s;
                } else if (began_s >= 0.0) {
                    zero_s = -1.0;
                }
            },
            20);
        QVERIFY(began_s > 0.0);
        QCOMPARE(result.stopped, wrong == Wrong::Absent ? SelfTestStop::NoPosition : SelfTestStop::Fault);
        QCOMPARE(result.lastStep, step);
        QVERIFY(result.isFailed());
        QCOMPARE(bench.last, Vec3(Vec3::Zero()));
        QVERIFY2(zero_s < 0.0 || zero_s - began_s <= 0.03, "the force is gone within 30 ms, and stays away");
        const auto lines = servo::unmeasured(result);
        QVERIFY(!lines.empty() && !lines.front().english().empty());
    }

    void pressesNoWallWithADeviceThatLies_data()
    {
        QTest::addColumn<Wrong>("wrong");
        QTest::addColumn<int>("stop");
        QTest::newRow("frozen") << Wrong::Frozen << static_cast<int>(SelfTestStop::NoResponse);
        QTest::newRow("reversed") << Wrong::Reversed << static_cast<int>(SelfTestStop::Reversed);
    }

    void pressesNoWallWithADeviceThatLies()
    {
        QFETCH(const Wrong, wrong);
        QFETCH(const int, stop);
        Bench bench;
        bench.isHeld = true;
        bench.wrong = wrong;
        const servo::SelfTestResult result = run(bench, {}, 20);
        QCOMPARE(static_cast<int>(result.stopped), stop);
        QVERIFY(result.walls.empty());
        QVERIFY(!result.roundTrip && !result.held_N_per_mm);
        QVERIFY(bench.largest_N <= 2.0);
        QCOMPARE(bench.last, Vec3(Vec3::Zero()));
    }

    /// A device that freezes while a wall presses gives a constant force, which the hand holds; it is bounded.
    void freezingAtAWallIsBounded()
    {
        Bench bench;
        bench.isHeld = true;
        const servo::SelfTestResult result = run(
            bench,
            [](servo::SelfTest& test, Bench& b, double) {
                if (test.record().walls.size() == 3) {
                    b.wrong = Wrong::Frozen;
                }
            },
            20);
        QVERIFY(bench.largest_N <= 7.5 * (1.0 + 1e-9));
        QVERIFY(result.duration_s < 150.1);
        QCOMPARE(bench.last, Vec3(Vec3::Zero()));
    }

    void notesThatTheHandLetGo()
    {
        Bench bench;
        bench.isHeld = true;
        double released_s = -1.0, end_s = 0.0;
        const servo::SelfTestResult result = run(
            bench,
            [&](servo::SelfTest& test, Bench& b, double time_s) {
                if (test.record().walls.size() == 5 && released_s < 0.0) {
                    b.isHeld = false;
                    released_s = time_s;
                }
                end_s = time_s;
            },
            20);
        QCOMPARE(result.stopped, SelfTestStop::LetGo);
        QVERIFY(end_s - released_s < 4.0);
        QVERIFY(!result.held_N_per_mm);
        QCOMPARE(bench.last, Vec3(Vec3::Zero()));
    }

    void stopsOnRequest()
    {
        Bench bench;
        bench.isHeld = true;
        const servo::SelfTestResult result = run(
            bench,
            [](servo::SelfTest& test, Bench&, double) {
                if (test.record().step == SelfTestStep::Walls && test.record().walls.size() == 2) {
                    test.stop(SelfTestStop::Cancelled);
                }
            },
            20);
        QCOMPARE(result.stopped, SelfTestStop::Cancelled);
        QVERIFY(result.isFailed());
        QCOMPARE(bench.last, Vec3(Vec3::Zero()));
    }

    void testsNoForceWithoutMotors()
    {
        Bench bench;
        bench.info.actuatedAxes = 0;
        const servo::SelfTestResult result = run(bench);
        QCOMPARE(result.stopped, SelfTestStop::NoMotors);
        QVERIFY(result.rest);
        QCOMPARE(bench.largest_N, 0.0);
    }

    void ticksAllocateNothing()
    {
        if (!test::RealtimeGuard::isAvailable()) {
            QSKIP("a sanitizer replaces malloc");
        }
        Bench bench;
        bench.isHeld = true;
        servo::SelfTest tested(bench.info, {.lead_s = 0.1, .pulses = 20});
        std::uint64_t calls = 0;
        for (std::int64_t n = 0; !tested.isFinished() && n < 200'000; ++n) {
            const std::int64_t now_ns = 1'000'000'000 + n * 1'000'000;
            const device::DeviceState state = bench.read(now_ns);
            Vec3 force;
            {
                const test::RealtimeGuard guard;
                force = tested.tick(state, now_ns);
                calls += guard.all();
            }
            bench.write(force);
        }
        QCOMPARE(tested.record().stopped, SelfTestStop::None);
        QCOMPARE(calls, std::uint64_t{0});
    }
};

PALPATE_TEST(SelfTest)
#include "tst_SelfTest.moc"
