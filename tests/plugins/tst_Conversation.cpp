// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <Conversation.h>

#include <cmath>
#include <random>

using namespace palpate;
using core::Vec3;

namespace {

constexpr std::int64_t kMs = 1'000'000;

std::vector<std::uint8_t> bytes(const std::vector<int>& fields)
{
    std::vector<std::uint8_t> out;
    for (const int field : fields) {
        out.push_back(static_cast<std::uint8_t>(field & 0xff));
        out.push_back(static_cast<std::uint8_t>((field >> 8) & 0xff));
    }
    return out;
}

/// Counters in the middle of the kit's workspace: link b is at 0.34 rad, link c at 0.66 rad from the vertical.
const std::vector<int> kMiddle{0, -1299, 3476, 0, 0, 0, 0};

/// Feeds reports of an arm at rest until the conversation is ready.
void settle(woodenhaptics::Conversation& talk, std::int64_t& now_ns, const std::vector<int>& fields = kMiddle)
{
    for (int i = 0; i < 5; ++i) {
        now_ns += kMs;
        (void)talk.take(bytes(fields), now_ns);
    }
}

} // namespace

class Conversation : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void answersByteForByte()
    {
        std::int64_t now_ns = kMs;
        woodenhaptics::Conversation talk({}, true);
        settle(talk, now_ns);
        QCOMPARE(talk.protocol(), 2);
        QVERIFY(talk.state().isPresent);
        QVERIFY(talk.state().p_D.norm() < 3.0);
        // y only: motor a alone, force times lever arm over reduction and torque constant; r is 0.22 m here.
        const auto answer = talk.answer(Vec3(0, 1.0, 0), now_ns);
        QCOMPARE(answer.size(), std::size_t{15});
        QCOMPARE(answer[0], std::uint8_t{0});
        const int mA = answer[1] | answer[2] << 8;
        QVERIFY2(std::abs(mA - 1000.0 * 0.2195 / 16.0 / 0.0259) < 2.0, qPrintable(QString::number(mA)));
        for (std::size_t i = 3; i < 15; ++i) {
            QCOMPARE(answer[i], std::uint8_t{0});
        }
    }

    void speaksProtocolOne()
    {
        std::int64_t now_ns = kMs;
        woodenhaptics::Conversation one({}, true);
        woodenhaptics::Conversation two({}, true);
        settle(one, now_ns, {0, 1299, -3476, 0}); // counts in the other direction
        settle(two, now_ns);
        QCOMPARE(one.protocol(), 1);
        QVERIFY((one.state().p_D - two.state().p_D).norm() < 1e-9);
        QCOMPARE(one.answer(Vec3(1, 0, 0), now_ns).size(), std::size_t{9});
        // Calibration is a separate offset: the current pose becomes the calibration pose, 206 mm from the middle.
        one.calibrate();
        const auto answer = one.answer(Vec3(1, 0, 0), now_ns);
        QCOMPARE(answer.size(), std::size_t{9});
        settle(one, now_ns, {0, 1299, -3476, 0});
        QVERIFY((one.state().p_D - Vec3(25, 0, 205)).norm() < 1e-6);
    }

    void calibratesProtocolTwoByCommand()
    {
        woodenhaptics::Config config;
        config.calibrationCounts = {10, -20, 30, 40, -50, 60};
        std::int64_t now_ns = kMs;
        woodenhaptics::Conversation talk(config, false);
        settle(talk, now_ns);
        QVERIFY(!talk.isCalibrated() && !talk.state().isPresent);
        talk.calibrate();
        const auto answer = talk.answer(Vec3(3, 3, 3), now_ns);
        QCOMPARE(std::vector<std::uint8_t>(answer.begin() + 1, answer.end()), bytes({40, -50, 60, 1, 10, -20, 30}));
        settle(talk, now_ns); // the old counters, still in transit
        QVERIFY(!talk.isCalibrated());
        settle(talk, now_ns, {11, -20, 30, 40, -50, 60, 0});
        QVERIFY(talk.isCalibrated());
    }

    void buttonHeldDownCalibratesAndOneWildReportDoesNot()
    {
        std::int64_t now_ns = kMs;
        woodenhaptics::Conversation talk({}, true);
        settle(talk, now_ns);
        std::vector<int> pressed = kMiddle;
        pressed[6] = 1;
        settle(talk, now_ns, pressed);
        QCOMPARE(talk.answer(Vec3::Zero(), now_ns)[7], std::uint8_t{0});
        settle(talk, now_ns);
        for (int i = 0; i < 5; ++i) {
            settle(talk, now_ns, pressed);
        }
        QCOMPARE(talk.answer(Vec3::Zero(), now_ns)[7], std::uint8_t{1});
    }

    void countersWrapWithoutAJump()
    {
        woodenhaptics::Config config;
        config.countsPerTurn = {40000, 40000, 40000}; // a tenth of a turn of the arm is more than 16 bits
        std::int64_t now_ns = kMs;
        woodenhaptics::Conversation talk(config, true);
        settle(talk, now_ns, {0, 0, 0, 0, 0, 0, 0});
        Vec3 last = talk.state().p_D;
        long count = 0;
        for (int i = 0; i < 1000; ++i) {
            now_ns += kMs;
            count += 100;
            QVERIFY(talk.take(bytes({0, 0, static_cast<std::int16_t>(count), 0, 0, 0, 0}), now_ns));
            QVERIFY((talk.state().p_D - last).norm() < 0.5);
            last = talk.state().p_D;
        }
        // 100000 counts are 2.5 turns of the motor, and link c has turned by 2.5 / 12 of a turn from level.
        const double angle = 2.0 * 3.14159265358979 * 2.5 / 12.0;
        QVERIFY(std::abs(last.x() - (245.0 * std::cos(angle) - 220.0)) < 0.01);
    }

    /// A wild report may by chance be plausible, once in thousands, but has no effect after the next valid report.
    void wildReportsLeaveNothingBehind()
    {
        std::int64_t now_ns = kMs;
        woodenhaptics::Conversation talk({}, true);
        settle(talk, now_ns);
        const Vec3 p = talk.state().p_D;
        const std::uint64_t before = talk.refused();
        std::mt19937 random(3);
        int taken = 0;
        for (int i = 0; i < 100'000; ++i) {
            now_ns += kMs;
            std::vector<std::uint8_t> wild(random() % 65);
            for (std::uint8_t& b : wild) {
                b = static_cast<std::uint8_t>(random());
            }
            taken += talk.take(wild, now_ns) ? 1 : 0;
            if (i % 7 == 0) {
                now_ns += kMs;
                QVERIFY(talk.take(bytes(kMiddle), now_ns));
                QCOMPARE(talk.state().p_D, p);
            }
        }
        QVERIFY2(taken < 10, qPrintable(QString::number(taken)));
        QVERIFY(talk.isCalibrated());
        QCOMPARE(talk.refused() - before, std::uint64_t{100'000} - static_cast<std::uint64_t>(taken));
    }

    void countersThatBeginAnewNeedCalibration()
    {
        std::int64_t now_ns = kMs;
        woodenhaptics::Conversation talk({}, true);
        settle(talk, now_ns);
        for (int i = 0; i < 6; ++i) { // the firmware restarted
            settle(talk, now_ns, {0, 0, 0, 0, 0, 0, 0});
        }
        QVERIFY(!talk.isCalibrated());
        QVERIFY(!talk.state().isPresent);
        const auto answer = talk.answer(Vec3(1, 1, 1), now_ns);
        QVERIFY(std::all_of(answer.begin(), answer.end(), [](std::uint8_t b) { return b == 0; }));
    }

    void currentsStayWithinTheAmplifiersInTheForcesDirection()
    {
        woodenhaptics::Config config;
        config.maxForce_N = 100.0;
        std::int64_t now_ns = kMs;
        woodenhaptics::Conversation talk(config, true);
        settle(talk, now_ns);
        std::mt19937 random(4);
        std::normal_distribution<double> normal(0.0, 100.0);
        for (int i = 0; i < 1000; ++i) {
            const Vec3 f(normal(random), normal(random), normal(random));
            const auto small = talk.answer(f * (0.5 / f.norm()), now_ns);
            std::array<double, 3> a{}, b{};
            for (std::size_t m = 0; m < 3; ++m) {
                a[m] = static_cast<std::int16_t>(small[1 + 2 * m] | small[2 + 2 * m] << 8);
            }
            const auto large = talk.answer(f, now_ns);
            for (std::size_t m = 0; m < 3; ++m) {
                b[m] = static_cast<std::int16_t>(large[1 + 2 * m] | large[2 + 2 * m] << 8);
                QVERIFY(std::abs(b[m]) <= 2000.0);
            }
            const Vec3 va(a[0], a[1], a[2]), vb(b[0], b[1], b[2]);
            QVERIFY(va.normalized().dot(vb.normalized()) > 0.9999);
        }
        for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
            const auto answer = talk.answer(Vec3(bad, 1, 1), now_ns);
            QVERIFY(std::all_of(answer.begin(), answer.end(), [](std::uint8_t b) { return b == 0; }));
        }
    }

    void noHandFarOutsideTheWorkspace()
    {
        std::int64_t now_ns = kMs;
        woodenhaptics::Conversation talk({}, true);
        settle(talk, now_ns, {0, 0, 0, 0, 0, 0, 0}); // the calibration pose is 206 mm from the middle
        QVERIFY(!talk.state().isPresent);
        QVERIFY(talk.isCalibrated());
    }
};

PALPATE_TEST(Conversation)
#include "tst_Conversation.moc"
