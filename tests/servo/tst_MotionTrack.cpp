// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/servo/MotionTrack.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

using palpate::servo::Vec3;
using Track = palpate::servo::MotionTrack;

namespace {

constexpr double kStep_mm = 0.064;

double counted(double x)
{
    return kStep_mm * std::round(x / kStep_mm);
}

Vec3 counted(const Vec3& p)
{
    return {counted(p[0]), counted(p[1]), counted(p[2])};
}

} // namespace

class MotionTrack : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void anExactSensorIsBelieved()
    {
        Track track(0.0);
        std::mt19937 random(1);
        std::normal_distribution<double> normal;
        Vec3 before(100.0, -3.0, 0.1);
        QVERIFY(track.step(before).isZero(0.0));
        for (int n = 0; n < 1000; ++n) {
            const Vec3 p = before + 0.1 * Vec3(normal(random), normal(random), normal(random));
            QCOMPARE(track.step(p), Vec3(p - before));
            before = p;
        }
    }

    /// The estimated velocity of a hand at 10 mm/s, with known or detected sensor quanta.
    void countsGiveASteadyVelocity_data()
    {
        QTest::addColumn<double>("step_mm");
        for (const double step_mm : {0.01, 0.0137, 0.02, 0.034, 0.055, 0.064, 0.09, 0.12}) {
            QTest::addRow("%g mm", step_mm) << step_mm;
        }
    }
    void countsGiveASteadyVelocity()
    {
        QFETCH(const double, step_mm);
        std::mt19937 random(7);
        std::normal_distribution<double> normal;
        for (int trial = 0; trial < 40; ++trial) {
            Vec3 way(normal(random), normal(random), normal(random));
            way = trial == 0 ? Vec3(0, 0, -0.01) : Vec3(0.01 * way.normalized());
            Track known(step_mm), unknown(0.0);
            for (int n = 0; n < 1000; ++n) {
                Vec3 p = Vec3(0.3, -20.0, 5.1) + n * way;
                for (double& x : p) {
                    x = step_mm * std::round(x / step_mm);
                }
                known.step(p);
                unknown.step(p);
                if (n >= 150) {
                    QVERIFY2((known.slope() - way).norm() <= 0.004, qPrintable(QString::number(known.slope().norm())));
                    QVERIFY2((unknown.slope() - way).norm() <= 0.004,
                             qPrintable(QString::number(unknown.slope().norm())));
                }
            }
        }
    }

    /// For exact input the velocity is the difference, bit for bit: a smooth path, and a scripted path on a round grid.
    void anExactVelocityIsTheDifference()
    {
        const auto smooth = [](int n) { return Vec3(3.0 * std::sin(0.01 * n), std::cos(0.003 * n), 0.0123456789 * n); };
        const auto scripted = [](int n) { // in, rest, across, out
            return n < 50    ? Vec3(0, 0, 5 - 0.1 * n)
                   : n < 90  ? Vec3(0, 0, 0.1)
                   : n < 200 ? Vec3(0.05 * (n - 90), 0, 0.1)
                             : Vec3(5.5, 0, 0.1 * (n - 199));
        };
        for (const auto& path : {std::function<Vec3(int)>(smooth), std::function<Vec3(int)>(scripted)}) {
            Track track(0.0);
            track.step(path(0));
            QVERIFY(track.slope().isZero(0.0));
            for (int n = 1; n < 300; ++n) {
                track.step(path(n));
                QVERIFY(track.slope() == path(n) - path(n - 1));
            }
        }
    }

    /// Under acceleration the lag is within the documented bound.
    void lagsNoMoreThanStated()
    {
        constexpr double kAcceleration = 0.001; // mm per tick^2: 1 m/s^2
        Track track(kStep_mm);
        const double bound = 2.0 * std::sqrt(kStep_mm * kAcceleration) + kStep_mm / Track::kLongestSlope;
        double most = 0.0;
        for (int n = 0; n < 400; ++n) {
            track.step(counted(Vec3(0.5 * kAcceleration * n * n, 0, 0)));
            most = std::max(most, std::abs(track.slope().x() - kAcceleration * n));
        }
        QVERIFY2(most <= bound, qPrintable(QString("%1 against %2").arg(most).arg(bound)));
    }

    /// Many ticks per sensor step: the motion is spread evenly and not concentrated in one tick.
    void aSlowTipMovesEvenly_data()
    {
        QTest::addColumn<double>("ticksAStep");
        for (const double ticks : {2.5, 7.0, 13.3, 30.0}) {
            QTest::addRow("a step every %g ticks", ticks) << ticks;
        }
    }
    void aSlowTipMovesEvenly()
    {
        QFETCH(const double, ticksAStep);
        Track track(kStep_mm);
        const double real = kStep_mm / ticksAStep;
        double most = 0.0, sum = 0.0;
        for (int n = 0; n < 500; ++n) {
            const double moved = track.step(counted(Vec3(real * n, 0, -2.0 * real * n)))[0];
            if (n >= 100) {
                most = std::max(most, moved);
                sum += moved;
            }
        }
        QVERIFY2(most < 2.0 * real, qPrintable(QString("%1 against %2 mm").arg(most).arg(real)));
        QVERIFY(std::abs(sum - 400 * real) <= kStep_mm);
    }

    /// A sensor that flickers between two counts gives at most a tenth of the two-tick difference.
    void aTipOnTheBorderOfTwoCountsRests()
    {
        Track track(kStep_mm);
        std::mt19937 random(2);
        double moved = 0.0, counts = 0.0, before = 0.0;
        for (int n = 0; n < 2000; ++n) {
            const double x = random() % 2 == 0 ? kStep_mm : 0.0;
            moved += std::abs(track.step(Vec3(x, 0, 0))[0]);
            counts += std::abs(x - before);
            before = x;
        }
        QVERIFY2(moved < counts / 10.0, qPrintable(QString("%1 of %2 mm").arg(moved).arg(counts)));
    }

    /// The moves add up to the sensor position without drift.
    void movesAddUp()
    {
        Track track(kStep_mm);
        std::mt19937 random(3);
        std::normal_distribution<double> normal;
        Vec3 p = Vec3::Zero(), v = Vec3::Zero(), sum = Vec3::Zero();
        for (int n = 0; n < 20000; ++n) {
            v = 0.99 * v + 0.002 * Vec3(normal(random), normal(random), normal(random));
            p += v;
            sum += track.step(counted(p));
            if (n == 0) {
                sum = counted(p);
            }
            QVERIFY((sum - counted(p)).cwiseAbs().maxCoeff() <= (0.5 + 1e-9) * kStep_mm);
        }
    }

    /// A reversal is detected at once: in the tick in which the sensor deviates from a line.
    void aFastTurnIsSeen()
    {
        Track track(kStep_mm);
        for (int n = 0; n < 50; ++n) {
            static_cast<void>(track.step(counted(Vec3(0.3 * n, 0, 0))));
        }
        for (int n = 0; n < 3; ++n) {
            const double moved = track.step(counted(Vec3(0.3 * (48 - n), 0, 0)))[0];
            QVERIFY2(moved < -0.3 + kStep_mm, qPrintable(QString::number(moved)));
            QVERIFY(track.window() <= 3.0);
        }
    }

    void afterAResetTheNextIsTheFirst()
    {
        Track track(kStep_mm);
        static_cast<void>(track.step(Vec3(1, 2, 3)));
        static_cast<void>(track.step(Vec3(1.5, 2, 3)));
        track.reset();
        QVERIFY(track.step(Vec3(50, 0, 0)).isZero(0.0));
        QVERIFY((track.step(Vec3(51, 0, 0)) - Vec3(1, 0, 0)).norm() <= kStep_mm);
    }
};

PALPATE_TEST(MotionTrack)
#include "tst_MotionTrack.moc"
