// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"
#include "TouchScenes.h"

#include <palpate/device/DevicePresets.h>
#include <palpate/servo/SafetyGate.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

using palpate::device::DeviceState;
using palpate::servo::FaultKind;
using palpate::servo::ForceRequest;
using palpate::servo::GatedInput;
using palpate::servo::GateLimits;
using palpate::servo::Vec3;
using palpate::test::limitsOf;
using Gate = palpate::servo::SafetyGate;

namespace {

constexpr double kDt_s = 0.001;
constexpr std::int64_t kDt_ns = 1'000'000;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

/// Drives a gate tick by tick, as the servo loop does.
struct Driver
{
    explicit Driver(const GateLimits& limits)
        : gate(limits, kDt_s)
    {
    }

    GatedInput admit(const Vec3& p, std::int64_t age_ns = 0)
    {
        DeviceState state;
        state.isPresent = true;
        state.p_D = p;
        now_ns += kDt_ns;
        state.time_ns = now_ns - age_ns;
        return gate.admit(state, now_ns);
    }
    GatedInput admitNobody(bool isLost = false)
    {
        DeviceState state;
        state.isLost = isLost;
        now_ns += kDt_ns;
        return gate.admit(state, now_ns);
    }
    Vec3 release(const Vec3& f, bool isInContact = true, bool isSceneChanged = false)
    {
        return gate.release({f, isInContact, isSceneChanged});
    }
    /// Runs a tick with a resting hand.
    Vec3 tick(const Vec3& f, bool isInContact = true)
    {
        static_cast<void>(admit(Vec3::Zero()));
        return release(f, isInContact);
    }
    /// Completes the ramp-in under a constant force `f`.
    void settle(const Vec3& f)
    {
        for (int i = 0; i < 600; ++i) {
            static_cast<void>(tick(f));
        }
    }

    Gate gate;
    std::int64_t now_ns = 1'000'000'000;
};

double adversarialNumber(std::mt19937_64& random)
{
    switch (random() % 8) {
    case 0:
        return std::bit_cast<double>(random()); // any bits: NaN, infinite, denormal, huge
    case 1:
        return 0.0;
    case 2: {
        constexpr double kSpecial[] = {kNan, kInf, -kInf, 1e308, -1e308, 5e-324, 1e8, -1e8, 1e-300};
        return kSpecial[random() % std::size(kSpecial)];
    }
    case 3:
        return std::ldexp(static_cast<double>(random() % 2048) - 1024.0, static_cast<int>(random() % 64) - 32);
    default:
        return (static_cast<double>(random() % 20'001) - 10'000.0) / 500.0; // within +- 20
    }
}

Vec3 adversarialVector(std::mt19937_64& random)
{
    return {adversarialNumber(random), adversarialNumber(random), adversarialNumber(random)};
}

/// Returns states of a plausible hand for long stretches, with single and lasting faults in between.
/// @param hip  position of the hand, updated by the call [mm]
DeviceState randomState(std::mt19937_64& random, Vec3& hip, std::int64_t now_ns)
{
    const bool isWild = random() % 512 == 0;
    for (int axis = 0; axis < 3; ++axis) {
        hip[axis] += (static_cast<double>(random() % 2001) - 1000.0) * 2e-3;
        hip[axis] = std::clamp(hip[axis], -100.0, 100.0);
    }
    DeviceState state;
    state.isPresent = random() % 2048 != 0;
    state.isLost = random() % 32768 == 0;
    state.p_D = isWild ? adversarialVector(random) : hip;
    state.time_ns = random() % 8192 == 0 ? static_cast<std::int64_t>(random()) : now_ns;
    return state;
}

ForceRequest randomRequest(std::mt19937_64& random, const Vec3& hip)
{
    ForceRequest request;
    const auto mode = random() % 64;
    request.f_D = mode == 0 ? adversarialVector(random) : Vec3(0.1 * hip + Vec3::Constant(mode < 8 ? 30.0 : 0.0));
    if (!request.f_D.allFinite() && random() % 64 != 0) {
        request.f_D.setZero(); // occasional faults
    }
    request.isInContact = random() % 32 != 0;
    request.isSceneChanged = random() % 128 == 0;
    return request;
}

} // namespace

class SafetyGate : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void takesLimitsFromTheDevice()
    {
        const GateLimits touch = limitsOf("touch");
        QCOMPARE(touch.maxForce_N, 3.3);
        QVERIFY(touch.jumpRule == palpate::servo::JumpRule::Refuse);
        QCOMPARE(touch.overrunRun, 20U);
        palpate::device::DeviceInfo mouse;
        mouse.maxForce_N = kNan;
        const GateLimits shown = GateLimits::forDevice(mouse);
        QCOMPARE(shown.maxForce_N, 0.0);
        QVERIFY(shown.jumpRule == palpate::servo::JumpRule::Follow);
        QCOMPARE(shown.overrunRun, 0U);
    }

    void easesInOverHalfASecond()
    {
        Driver driver(limitsOf("omega"));
        const Vec3 f(0, 0, 10.0);
        for (int i = 1; i <= 600; ++i) {
            const double expected = 10.0 * std::min(1.0, i / 500.0);
            QVERIFY(std::abs(driver.tick(f)[2] - expected) < 1e-9);
        }
    }

    void easesInAnewWhenTheHandComesBack()
    {
        Driver driver(limitsOf("omega"));
        driver.settle(Vec3(0, 0, 10));
        static_cast<void>(driver.admitNobody());
        QVERIFY(driver.release(Vec3(0, 0, 10)).isZero(0.0));
        const GatedInput back = driver.admit(Vec3::Zero());
        QVERIFY(back.isPresent && back.isFirst);
        QVERIFY(std::abs(driver.release(Vec3(0, 0, 10))[2] - 10.0 / 500.0) < 1e-9);
    }

    void firstContactIsFeltInItsTickAndAnythingElseIsBounded()
    {
        const GateLimits limits = limitsOf("omega");
        const double bound = limits.maxForceRate_N_per_s * kDt_s;
        Driver driver(limits);
        for (int i = 0; i < 600; ++i) {
            static_cast<void>(driver.tick(Vec3::Zero(), false));
        }
        QCOMPARE(driver.tick(Vec3(0, 0, 9.0))[2], 9.0); // hits a wall
        QVERIFY(std::abs(driver.tick(Vec3(0, 0, -9.0))[2] - (9.0 - bound)) < 1e-12);
        // Release and contact while a force is still sent do not count as a first contact.
        QVERIFY(std::abs(driver.tick(Vec3::Zero(), false)[2] - (9.0 - 2.0 * bound)) < 1e-12);
        QVERIFY(std::abs(driver.tick(Vec3(0, 0, 12.0))[2] - (9.0 - bound)) < 1e-12);
    }

    void contactThatAChangeOfSceneMakesIsBounded()
    {
        const GateLimits limits = limitsOf("omega");
        Driver driver(limits);
        for (int i = 0; i < 600; ++i) {
            static_cast<void>(driver.tick(Vec3::Zero(), false));
        }
        static_cast<void>(driver.admit(Vec3::Zero()));
        QVERIFY(std::abs(driver.release(Vec3(0, 0, 9.0), true, true)[2] - limits.maxForceRate_N_per_s * kDt_s) < 1e-12);
    }

    void boundsTheMagnitudeAndKeepsTheDirection_data()
    {
        QTest::addColumn<double>("scale");
        for (const double scale : {1.0, 10.0, 1e6, 1e155, 1e300}) {
            QTest::newRow(qPrintable(QString::number(scale))) << scale;
        }
    }
    void boundsTheMagnitudeAndKeepsTheDirection()
    {
        QFETCH(double, scale);
        Driver driver(limitsOf("touch"));
        const Vec3 f = scale * Vec3(3.0, -4.0, 12.0);
        driver.settle(f);
        const Vec3 sent = driver.tick(f);
        QVERIFY(std::abs(sent.norm() - 3.3) < 1e-12);
        QVERIFY((sent / 3.3 - Vec3(3.0, -4.0, 12.0) / 13.0).norm() < 1e-12);
    }

    void boundsThePowerGivenToTheHand()
    {
        const GateLimits limits = limitsOf("omega");
        Driver driver(limits);
        driver.settle(Vec3(0, 0, 12.0));
        // Moving away at 3 m/s along the force: three times the power limit.
        static_cast<void>(driver.admit(Vec3(0, 0, 3.0)));
        QVERIFY(std::abs(driver.release(Vec3(0, 0, 12.0))[2] - 4.0) < 1e-9);
        // Against the force the hand supplies power; only the rate limit applies.
        static_cast<void>(driver.admit(Vec3(0, 0, 0.0)));
        QVERIFY(std::abs(driver.release(Vec3(0, 0, 12.0))[2] - (4.0 + limits.maxForceRate_N_per_s * kDt_s)) < 1e-9);
    }

    void rampsToZeroWithinTenMilliseconds_data()
    {
        QTest::addColumn<int>("cause");
        QTest::newRow("stop") << 0;
        QTest::newRow("stale input") << static_cast<int>(FaultKind::StaleInput);
        QTest::newRow("input that is no number") << static_cast<int>(FaultKind::NonFiniteInput);
        QTest::newRow("force that is no number") << static_cast<int>(FaultKind::NonFiniteForce);
        QTest::newRow("run of overruns") << static_cast<int>(FaultKind::OverrunRun);
    }
    void rampsToZeroWithinTenMilliseconds()
    {
        QFETCH(int, cause);
        const auto kind = static_cast<FaultKind>(cause);
        Driver driver(limitsOf("omega"));
        const Vec3 f(0, 12.0, 0);
        driver.settle(f);
        if (kind == FaultKind::None) {
            driver.gate.beginStop();
        } else if (kind == FaultKind::OverrunRun) {
            for (int i = 0; i < 20; ++i) {
                QVERIFY(driver.gate.fault() == FaultKind::None);
                driver.gate.noteOverrun(true);
            }
        }
        double last = 12.0;
        for (int i = 1; i <= 9; ++i) {
            const bool isStale = kind == FaultKind::StaleInput;
            const bool isNoNumber = kind == FaultKind::NonFiniteInput && i == 1;
            const GatedInput input = driver.admit(Vec3(isNoNumber ? kNan : 0.0, 0, 0), isStale ? 6 * kDt_ns : 0);
            QVERIFY(input.isPresent);
            QVERIFY(input.p_D.isZero(0.0));
            QCOMPARE(input.isGated, isStale || isNoNumber);
            const Vec3 sent = driver.release(kind == FaultKind::NonFiniteForce && i == 1 ? Vec3(0, kNan, 0) : f);
            QVERIFY(sent.allFinite());
            QVERIFY(sent[1] < last || last == 0.0);
            QVERIFY(last - sent[1] <= 12.0 / 8.0 + 1e-12);
            last = sent[1];
        }
        QCOMPARE(last, 0.0);
        QVERIFY(driver.gate.isAtRest());
        QVERIFY(driver.gate.fault() == kind);
        for (int i = 0; i < 100; ++i) {
            QVERIFY(driver.tick(f).isZero(0.0));
        }
        driver.gate.rearm();
        const bool wasStop = kind == FaultKind::None;
        const GatedInput input = driver.admit(Vec3(500.0, 0, 0));
        QVERIFY(input.isFirst && !input.isGated); // the first input is accepted unchanged
        QCOMPARE(driver.release(f)[1] > 0.0, !wasStop);
        QVERIFY(driver.gate.fault() == FaultKind::None);
    }

    /// Ticks that are late by many periods must not extend a ramp by as many ticks.
    void ticksThatComeLateDoNotStretchTheRamp()
    {
        Driver driver(limitsOf("omega"));
        const Vec3 f(0, 12.0, 0);
        driver.settle(f);
        for (int i = 0; i < 20; ++i) {
            driver.gate.noteOverrun(true);
        }
        driver.now_ns += 3 * kDt_ns; // 4 ms after the previous tick
        QVERIFY(std::abs(driver.tick(f)[1] - 6.0) < 1e-9);
        driver.now_ns += 3 * kDt_ns;
        QVERIFY(driver.tick(f).isZero(0.0));
        QVERIFY(driver.gate.isAtRest());
    }

    void latchesTheFirstFaultOnly()
    {
        Driver driver(limitsOf("touch"));
        driver.gate.raise(FaultKind::OverrunRun);
        static_cast<void>(driver.admit(Vec3(kNan, 0, 0)));
        static_cast<void>(driver.release(Vec3(kInf, 0, 0)));
        QVERIFY(driver.gate.fault() == FaultKind::OverrunRun);
    }

    void deviceThatIsLostIsAFaultWithoutForce()
    {
        Driver driver(limitsOf("touch"));
        driver.settle(Vec3(1, 0, 0));
        QVERIFY(!driver.admitNobody(true).isPresent);
        QVERIFY(driver.release(Vec3(1, 0, 0)).isZero(0.0));
        QVERIFY(driver.gate.fault() == FaultKind::DeviceLost);
        driver.settle(Vec3(1, 0, 0));
        QVERIFY(driver.tick(Vec3(1, 0, 0)).isZero(0.0));
    }

    void oneWrongPositionIsHeldOffAndARunOfThemIsAFault()
    {
        Driver driver(limitsOf("touch"));
        static_cast<void>(driver.admit(Vec3(1, 2, 3)));
        const GatedInput held = driver.admit(Vec3(1, 2, 53.0));
        QVERIFY(held.isPresent && held.isGated && !held.isFirst);
        QVERIFY(held.p_D == Vec3(1, 2, 3));
        const GatedInput good = driver.admit(Vec3(1, 2, 3.5));
        QVERIFY(!good.isGated && good.p_D == Vec3(1, 2, 3.5));
        for (int i = 0; i < 5; ++i) {
            QVERIFY(driver.gate.fault() == FaultKind::None);
            QVERIFY(driver.admit(Vec3(1, 2, 90.0)).p_D == Vec3(1, 2, 3.5));
        }
        QVERIFY(driver.gate.fault() == FaultKind::InputJump);
    }

    void slowDeviceMayMoveMoreBetweenItsStates()
    {
        Driver driver(limitsOf("touch"));
        static_cast<void>(driver.admit(Vec3::Zero()));
        static_cast<void>(driver.admit(Vec3::Zero(), kDt_ns)); // the same state again
        const GatedInput input = driver.admit(Vec3(15.0, 0, 0));
        QVERIFY(!input.isGated);
    }

    void pointerThatJumpsIsFollowedAtTheSpeedOfAHand()
    {
        palpate::device::DeviceInfo mouse;
        mouse.maxForce_N = 20.0;
        Driver driver(GateLimits::forDevice(mouse));
        static_cast<void>(driver.admit(Vec3::Zero()));
        Vec3 last = Vec3::Zero();
        for (int i = 1; i <= 12; ++i) {
            const GatedInput input = driver.admit(Vec3(0, 105.0, 0));
            QVERIFY(input.isPresent && !input.isFirst);
            QCOMPARE(input.isGated, i <= 10);
            QVERIFY((input.p_D - last).norm() <= 10.0 + 1e-9);
            last = input.p_D;
        }
        QVERIFY(last == Vec3(0, 105.0, 0));
        QVERIFY(driver.gate.fault() == FaultKind::None);
    }

    void positionsOutsideTheWorkspaceAreRefused()
    {
        GateLimits limits = limitsOf("touch");
        limits.workspaceRadius_mm = 100.0;
        Driver driver(limits);
        QVERIFY(!driver.admit(Vec3(101.0, 0, 0)).isPresent); // no valid previous state
        QVERIFY(driver.admit(Vec3(99.0, 0, 0)).isPresent);
        for (int i = 0; i < 5; ++i) {
            QVERIFY(driver.admit(Vec3(101.0, 0, 0)).p_D == Vec3(99.0, 0, 0));
        }
        QVERIFY(driver.gate.fault() == FaultKind::OutOfWorkspace);
    }

    void timesThatCannotBeAreStale_data()
    {
        QTest::addColumn<qint64>("time");
        QTest::addColumn<bool>("isStale");
        const qint64 now = 50'000'000'000;
        QTest::newRow("now") << now << false;
        QTest::newRow("just fresh") << now - 4'900'000 << false;
        QTest::newRow("just stale") << now - 5'100'000 << true;
        QTest::newRow("a bit ahead of the tick") << now + 100'000 << false;
        QTest::newRow("future") << now + 6'000'000 << true;
        QTest::newRow("zero") << qint64{0} << true;
        QTest::newRow("smallest") << std::numeric_limits<qint64>::min() << true;
        QTest::newRow("largest") << std::numeric_limits<qint64>::max() << true;
    }
    void timesThatCannotBeAreStale()
    {
        QFETCH(qint64, time);
        QFETCH(bool, isStale);
        Gate gate(limitsOf("touch"), kDt_s);
        DeviceState state;
        state.isPresent = true;
        state.time_ns = time;
        const GatedInput input = gate.admit(state, 50'000'000'000);
        QCOMPARE(input.isPresent, !isStale);
        QCOMPARE(gate.fault() == FaultKind::StaleInput, isStale);
    }

    /// Random and adversarial inputs, a million (or PALPATE_GATE_INPUTS): checks each guarantee in each tick.
    void everyOutputIsFiniteAndBounded_data()
    {
        QTest::addColumn<QByteArray>("preset");
        QTest::addColumn<double>("rate");
        QTest::newRow("touch, 1 kHz") << QByteArray("touch") << 1000.0;
        QTest::newRow("omega, 4 kHz") << QByteArray("omega") << 4000.0;
        QTest::newRow("delta, 50 Hz") << QByteArray("delta") << 50.0;
    }
    void everyOutputIsFiniteAndBounded()
    {
        QFETCH(QByteArray, preset);
        QFETCH(double, rate);
        const char* asked = std::getenv("PALPATE_GATE_INPUTS");
        const long total = asked != nullptr ? std::strtol(asked, nullptr, 10) : 1'000'000;

        GateLimits limits = limitsOf(preset.constData());
        limits.workspaceRadius_mm = 200.0;
        const double dt_s = 1.0 / rate;
        const double change = limits.maxForceRate_N_per_s * dt_s;
        const double slack = 1e-9; // rounding, in N and N mm/s relative to at most 1e5
        Gate gate(limits, dt_s);
        std::mt19937_64 random(99); // NOLINT: a fixed seed
        std::int64_t now_ns = 1'000'000'000;
        Vec3 hip = Vec3::Zero();
        Vec3 last = Vec3::Zero();
        Vec3 lastHip = Vec3::Zero();
        bool wasInContact = false;
        long forces = 0;
        long firstContacts = 0;
        long byKind[9] = {};
        for (long i = 0; i < total / 3; ++i) {
            now_ns += static_cast<std::int64_t>(dt_s * 1e9);
            const GatedInput input = gate.admit(randomState(random, hip, now_ns), now_ns);
            QVERIFY(input.p_D.allFinite());
            QVERIFY(input.p_D.norm() <= 200.0 + slack);
            QVERIFY(!input.isFirst || input.isPresent);

            const ForceRequest request = randomRequest(random, hip);
            const bool mayBegin = request.isInContact && (!wasInContact || input.isFirst) && !request.isSceneChanged &&
                                  last.norm() <= change + slack;
            wasInContact = request.isInContact;
            const Vec3 sent = gate.release(request);

            QVERIFY(sent.allFinite());
            QVERIFY(sent.norm() <= limits.maxForce_N + slack);
            if (!input.isPresent) {
                QVERIFY(sent.isZero(0.0));
            } else if (gate.fault() != FaultKind::None) {
                QVERIFY(sent.norm() <= last.norm() + slack);
            } else {
                const Vec3 v = input.isFirst ? Vec3(Vec3::Zero()) : Vec3((input.p_D - lastHip) / dt_s);
                QVERIFY(sent.dot(v) <= limits.maxPower_Nmm_per_s * (1.0 + slack));
                const bool isPowerBound = sent.dot(v) >= limits.maxPower_Nmm_per_s * (1.0 - slack);
                QVERIFY(mayBegin || isPowerBound || (sent - last).norm() <= change + slack);
                firstContacts += (sent - last).norm() > change + slack ? 1 : 0;
                forces += sent.isZero(0.0) ? 0 : 1;
            }
            last = sent;
            lastHip = input.p_D;
            gate.noteOverrun(random() % 4096 < 4090 && i % 20'000 < 25);
            ++byKind[static_cast<int>(gate.fault())];
            if (gate.fault() != FaultKind::None && random() % 256 == 0) {
                gate.rearm();
            }
        }
        QVERIFY(forces > total / 12);                              // not only faults
        QVERIFY(firstContacts > 0 || change >= limits.maxForce_N); // at 50 Hz the rate limit allows any step
        for (const FaultKind kind : {FaultKind::NonFiniteInput, FaultKind::StaleInput, FaultKind::DeviceLost,
                                     FaultKind::NonFiniteForce, FaultKind::OverrunRun}) {
            QVERIFY2(byKind[static_cast<int>(kind)] > 0, text(kind).english().c_str());
        }
    }

    void everyFaultHasWords()
    {
        QVERIFY(text(FaultKind::None).isEmpty());
        for (int i = 1; i <= static_cast<int>(FaultKind::LoopFailed); ++i) {
            QVERIFY(text(static_cast<FaultKind>(i)).english().size() > 20);
        }
    }
};

PALPATE_TEST(SafetyGate)
#include "tst_SafetyGate.moc"
