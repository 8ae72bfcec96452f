// SPDX-License-Identifier: BSD-3-Clause
#include "Motions.h"
#include "TestRunner.h"
#include "Trials.h"

#include <palpate/geometry/SurfaceMotion.h>

#include <Eigen/SVD>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace palpate;
using namespace palpate::test;
using core::Vec3;
using geometry::Breath;
using geometry::MotionLattice;
using geometry::SurfaceMotion;

namespace {

const core::Box kBox(Vec3(-60, -50, -40), Vec3(60, 50, 40));

Breath ramp(double amplitude_mm, double length_mm)
{
    Breath breath;
    breath.amplitude_mm = Vec3(0.0, 0.2 * amplitude_mm, amplitude_mm);
    breath.still_W = Vec3(0, 0, -0.5 * length_mm);
    breath.full_W = Vec3(0, 0, 0.5 * length_mm);
    return breath;
}

} // namespace

class SurfaceMotionTest : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void breathMovesTheWholeByItsFormula()
    {
        Breath breath;
        breath.amplitude_mm = Vec3(0, 3, 15);
        breath.period_s = 4.0;
        const auto motion = SurfaceMotion::breath(breath, kBox).value();
        QVERIFY(motion->isMoving() && motion->strain() == 0.0);
        for (int i = 0; i < trials(5000); ++i) {
            const double t = 0.0017 * i, share = std::pow(std::sin(std::numbers::pi * t / 4.0), 4);
            const auto moment = motion->at(t);
            QVERIFY((motion->toWorld(moment, Vec3(1, 2, 3)) - Vec3(1, 2, 3) - share * breath.amplitude_mm).norm() <
                    2e-5);
            const double h = 1e-5;
            const Vec3 by = (motion->toWorld(motion->at(t + h), Vec3(1, 2, 3)) -
                             motion->toWorld(motion->at(t - h), Vec3(1, 2, 3))) /
                            (2.0 * h);
            QVERIFY((motion->velocity(moment, Vec3(1, 2, 3)) - by).norm() < 1e-4); // its slope jumps at a knot
        }
        QVERIFY(motion->toWorld(motion->at(0.0), Vec3(1, 2, 3)) == Vec3(1, 2, 3));
    }

    void restPositionIsTheInverse_data()
    {
        QTest::addColumn<bool>("isRandom");
        QTest::addColumn<bool>("startsFar");
        QTest::newRow("breath") << false << false;
        QTest::newRow("breath, far start") << false << true;
        QTest::newRow("random frames of 30 %") << true << false;
        QTest::newRow("random frames of 30 %, far start") << true << true;
    }
    void restPositionIsTheInverse()
    {
        QFETCH(bool, isRandom);
        QFETCH(bool, startsFar);
        std::mt19937 random(7);
        std::uniform_real_distribution<double> of(-1.0, 1.0);
        for (int trial = 0; trial < (isRandom ? 10 : 1); ++trial) {
            const auto motion = isRandom ? randomMotion(kBox, 10.0, 4, 100 + static_cast<unsigned>(trial))
                                         : SurfaceMotion::breath(ramp(15.0, 100.0), kBox).value();
            QVERIFY(motion->strain() > 0.2 && motion->strain() <= SurfaceMotion::kMaxStrain);
            for (int i = 0; i < trials(2000); ++i) {
                const Vec3 X(80.0 * of(random), 80.0 * of(random), 80.0 * of(random));
                const auto moment = motion->at(2.0 + 2.0 * of(random));
                const Vec3 p = motion->toWorld(moment, X);
                const Vec3 near = X + (startsFar ? 100.0 : 1.0) * Vec3(of(random), of(random), of(random));
                const auto rest = motion->toRest(moment, p, near);
                QVERIFY(rest.isExact());
                QVERIFY((motion->toWorld(moment, rest.X) - p).norm() <= 1e-9);
                QVERIFY((rest.X - X).norm() <= 1e-8); // the only one
            }
        }
    }

    void gradientIsTheDerivative()
    {
        const auto motion = randomMotion(kBox, 12.0, 5, 3);
        std::mt19937 random(8);
        std::uniform_real_distribution<double> of(-50.0, 50.0);
        for (int i = 0; i < 1000; ++i) {
            const Vec3 X(of(random), of(random), of(random));
            const auto moment = motion->at(0.01 * i);
            const auto rest = motion->toRest(moment, motion->toWorld(moment, X), X);
            const double h = 1e-5;
            for (int axis = 0; axis < 3; ++axis) {
                const Vec3 e = h * Vec3::Unit(axis);
                const Vec3 by = (motion->toWorld(moment, X + e) - motion->toWorld(moment, X - e)) / (2.0 * h);
                QVERIFY((rest.F.col(axis) - by).norm() < 1e-6);
            }
            QVERIFY((rest.F * rest.invF - Eigen::Matrix3d::Identity()).norm() < 1e-12);
            const Vec3 v =
                (motion->toWorld(motion->at(0.01 * i + h), X) - motion->toWorld(motion->at(0.01 * i - h), X)) /
                (2.0 * h);
            QVERIFY((motion->velocity(moment, X) - v).norm() < 1e-5);
        }
    }

    void strainBoundsTheGradientEverywhere()
    {
        std::mt19937 random(9);
        std::uniform_real_distribution<double> of(-60.0, 60.0);
        for (unsigned seed = 0; seed < 5; ++seed) {
            const auto motion = randomMotion(kBox, 20.0, 3, seed);
            double most = 0.0;
            for (int i = 0; i < trials(8000); ++i) {
                const Vec3 X(of(random), of(random), of(random));
                const auto moment = motion->at(0.1 * of(random));
                const auto F = motion->toRest(moment, motion->toWorld(moment, X), X).F;
                const Eigen::JacobiSVD<Eigen::Matrix3d> svd(F - Eigen::Matrix3d::Identity());
                most = std::max(most, svd.singularValues().maxCoeff());
            }
            QVERIFY2(most <= motion->strain(), qPrintable(QString("%1 > %2").arg(most).arg(motion->strain())));
            QVERIFY2(most >= 0.4 * motion->strain(), qPrintable(QString("%1 << %2").arg(most).arg(motion->strain())));
        }
    }

    void posesTurnAndShift()
    {
        std::vector<geometry::PoseKey> keys;
        for (int i = 0; i <= 64; ++i) { // one turn about z in 2 s, 10 mm along x and back
            const double turn = 2.0 * std::numbers::pi * i / 64.0;
            core::Transform pose = core::Transform::Identity();
            pose.linear() = Eigen::AngleAxisd(turn, Vec3::UnitZ()).toRotationMatrix();
            pose.translation() = Vec3(10.0 * std::sin(turn), 0, 0);
            keys.push_back({i / 32.0, pose});
        }
        const auto motion = SurfaceMotion::poses(keys, true).value();
        for (int i = 0; i < trials(3000); ++i) {
            const double t = -1.0 + 0.003 * i, turn = std::numbers::pi * t, h = 1e-5;
            const Vec3 X(3, -4, 5);
            const auto moment = motion->at(t);
            const Vec3 to = Eigen::AngleAxisd(turn, Vec3::UnitZ()) * X + Vec3(10.0 * std::sin(turn), 0, 0);
            QVERIFY((motion->toWorld(moment, X) - to).norm() < 2e-3);
            const auto rest = motion->toRest(moment, motion->toWorld(moment, X), Vec3::Zero());
            QVERIFY((rest.X - X).norm() < 1e-12);
            QVERIFY((rest.F.transpose() * rest.F - Eigen::Matrix3d::Identity()).norm() < 1e-12);
            const Vec3 v = (motion->toWorld(motion->at(t + h), X) - motion->toWorld(motion->at(t - h), X)) / (2.0 * h);
            QVERIFY((motion->velocity(moment, X) - v).norm() < 1e-4);
        }
        // Held before and after, when it does not repeat.
        const auto once = SurfaceMotion::poses({keys[0], keys[1], keys[2]}).value();
        QVERIFY((once->toWorld(once->at(-5.0), Vec3(1, 2, 3)) - Vec3(1, 2, 3)).norm() < 1e-12);
        QVERIFY(once->velocity(once->at(9.0), Vec3(1, 2, 3)).isZero(0.0));
    }

    void badMotionsAreRefusedWithTheirPlace()
    {
        const auto refused = [](const SurfaceMotion::Made& made, const char* said) {
            return !made.isOk() && QString::fromStdString(made.status().message()).contains(said)
                       ? QString()
                       : "expected \"" + QString(said) + "\", found \"" +
                             QString::fromStdString(made.isOk() ? "a motion" : made.status().message()) + '"';
        };
        const MotionLattice lattice = MotionLattice::around(kBox, 20.0);
        std::vector<std::vector<Vec3>> frames(3, std::vector<Vec3>(lattice.controlCount(), Vec3::Zero()));
        QCOMPARE(refused(SurfaceMotion::frames(4.0, lattice, {frames[0]}), "found 1 frames, expected at least two"),
                 QString());
        frames[1].pop_back();
        QCOMPARE(refused(SurfaceMotion::frames(4.0, lattice, frames), "frame 1: found"), QString());
        frames[1].push_back(Vec3::Zero());
        frames[2][lattice.control(2, 3, 1)] = Vec3(0, std::numeric_limits<double>::quiet_NaN(), 0);
        QCOMPARE(refused(SurfaceMotion::frames(4.0, lattice, frames), "frame 2, control point"), QString());
        frames[2][lattice.control(2, 3, 1)] = Vec3(60, 0, 0); // three cells
        const SurfaceMotion::Made folded = SurfaceMotion::frames(4.0, lattice, frames);
        QCOMPARE(refused(folded, "may fold"), QString());
        QCOMPARE(refused(folded, "frame 2, cell ("), QString());
        frames[2][lattice.control(2, 3, 1)] = Vec3(10, 0, 0);
        QCOMPARE(refused(SurfaceMotion::frames(4.0, lattice, frames), "expected at most 30 %"), QString());
        QCOMPARE(refused(SurfaceMotion::breath(ramp(15.0, 60.0), kBox), "expected at most 30 %"), QString());
        Breath breath = ramp(15.0, 100.0);
        breath.exponent = 3;
        QCOMPARE(refused(SurfaceMotion::breath(breath, kBox), "exponent: found 3"), QString());
        breath.exponent = 4;
        breath.period_s = 0.0;
        QCOMPARE(refused(SurfaceMotion::breath(breath, kBox), "period_s: found 0"), QString());
        QCOMPARE(refused(SurfaceMotion::poses({{}}), "found 1 poses"), QString());
        QCOMPARE(refused(SurfaceMotion::poses({{}, {}}), "pose 1"), QString());
        core::Transform away = core::Transform::Identity();
        away.translation() = Vec3(1, 0, 0);
        QCOMPARE(refused(SurfaceMotion::poses({{}, {1.0, away}}, true), "expected the same"), QString());
        QCOMPARE(refused(SurfaceMotion::pulse(1.0, -0.5), "share: found -0.5"), QString());
    }

    void bytesGiveTheSameBits()
    {
        const auto random = SurfaceMotion::pulse(0.8, 0.2, randomMotion(kBox, 20.0, 3, 5)).value();
        for (const auto& motion : {random->withClock(1.5, 0.25, 0.5), random->withAmplitude(0.5),
                                   random->changedAt(1.5, 0.3, {0.5, 2.0, 0.25})->startingAt(0.4),
                                   SurfaceMotion::breath(ramp(15.0, 100.0), kBox).value()}) {
            const auto bytes = motion->bytes();
            const auto back = SurfaceMotion::fromBytes(bytes);
            QVERIFY2(back.isOk(), back.status().message().c_str());
            QVERIFY(*back.value() == *motion);
            QCOMPARE(back.value()->strain(), motion->strain());
            for (int i = 0; i < 100; ++i) {
                const Vec3 X(i - 50, 0.3 * i, 10 - 0.2 * i);
                const auto a = motion->at(0.11 * i), b = back.value()->at(0.11 * i);
                QVERIFY(motion->toWorld(a, X) == back.value()->toWorld(b, X));
                QVERIFY(motion->toRest(a, X, X).X == back.value()->toRest(b, X, X).X);
                QVERIFY(a.factor == b.factor);
            }
            // Any prefix and any longer text is refused, and no changed number crashes.
            for (std::size_t n = 0; n < bytes.size(); n += 1 + bytes.size() / 300) {
                QVERIFY(!SurfaceMotion::fromBytes(std::span(bytes).first(n)).isOk());
            }
            auto longer = bytes;
            longer.resize(longer.size() + 8);
            QVERIFY(!SurfaceMotion::fromBytes(longer).isOk());
            std::mt19937 at(11);
            for (int i = 0; i < trials(300); ++i) {
                auto changed = bytes;
                changed[at() % std::min<std::size_t>(changed.size(), i % 2 == 0 ? 400 : changed.size())] ^=
                    static_cast<std::byte>(1 + at() % 255);
                (void)SurfaceMotion::fromBytes(changed);
            }
        }
    }

    void clockHoldsAndSlows()
    {
        const auto motion = SurfaceMotion::breath(ramp(15.0, 100.0), kBox).value();
        const Vec3 X(1, 2, 30);
        const auto held = motion->withClock(7.0, 1.2, 0.0), slow = motion->withClock(7.0, 1.2, 0.5);
        QVERIFY(held->toWorld(held->at(7.0), X) == motion->toWorld(motion->at(1.2), X));
        QVERIFY(held->toWorld(held->at(99.0), X) == held->toWorld(held->at(7.0), X));
        QVERIFY(held->velocity(held->at(8.0), X).isZero(0.0));
        QVERIFY(slow->toWorld(slow->at(9.0), X) == motion->toWorld(motion->at(2.2), X));
        QVERIFY((slow->velocity(slow->at(8.0), X) - 0.5 * motion->velocity(motion->at(1.7), X)).norm() < 1e-9);
        QVERIFY(held->shape() == motion->shape() && !(*held == *motion));
        const auto half = motion->withAmplitude(0.5);
        QVERIFY((half->toWorld(half->at(2.0), X) - X - 0.5 * (motion->toWorld(motion->at(2.0), X) - X)).norm() < 1e-12);
    }

    /// Place, velocity and pulse are those of before up to the change, continuous in it, and of the new pace after it.
    void changeOfPaceDoesNotJump()
    {
        constexpr double kStart_s = 1.7, kEase_s = 0.3, kStep_s = 1e-4;
        const auto breath = SurfaceMotion::breath(ramp(15.0, 100.0), kBox).value();
        const Vec3 X(1, 2, 30);
        for (const auto& motion : {SurfaceMotion::pulse(0.8, 0.2, breath).value(), randomMotion(kBox, 20.0, 3, 5),
                                   oscillation({0, 0, 8}, 1.0)}) {
            const bool isPose = motion->period_s() == 0.0;
            for (const SurfaceMotion::Pace pace :
                 {SurfaceMotion::Pace{0.0, 1.0, 1.0}, {2.0, 2.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 0.5}}) {
                const auto changed = motion->changedAt(kStart_s, kEase_s, pace);
                QVERIFY(changed->pace() == pace && changed->shape() == motion->shape() && !(*changed == *motion));
                QCOMPARE(changed->settled_s(), kStart_s + kEase_s);
                for (double t = 0.0; t < 3.0; t += 0.0307) {
                    const auto now = changed->at(t), next = changed->at(t + kStep_s), back = changed->at(t - kStep_s);
                    const Vec3 v = (changed->toWorld(next, X) - changed->toWorld(back, X)) / (2.0 * kStep_s);
                    QVERIFY2((changed->velocity(now, X) - v).norm() < 1e-4 * (1.0 + v.norm()),
                             qPrintable(QString("at %1 s").arg(t)));
                    QVERIFY(std::abs((next.factor - back.factor) / (2.0 * kStep_s) - now.factorSlope) < 1e-4);
                    if (t <= kStart_s) {
                        QVERIFY((changed->toWorld(now, X) - motion->toWorld(motion->at(t), X)).norm() < 1e-12);
                        QVERIFY((changed->velocity(now, X) - motion->velocity(motion->at(t), X)).norm() < 1e-9);
                        QVERIFY(std::abs(now.factor - motion->at(t).factor) < 1e-12);
                    }
                }
                const auto a = changed->at(2.5), b = changed->at(2.9);
                QVERIFY(pace.rate != 0.0 || changed->toWorld(a, X) == changed->toWorld(b, X));
                QVERIFY(pace.pulseRate != 0.0 || a.factor == b.factor);
                QVERIFY(pace.amplitude != 0.0 || isPose || changed->toWorld(a, X) == X);
                QVERIFY(std::abs(changed->phase_s(2.9) - changed->phase_s(2.5) - 0.4 * pace.rate) < 1e-12);
                const auto again = changed->startingAt(2.5);
                QVERIFY((again->toWorld(again->at(0.4), X) - changed->toWorld(b, X)).norm() < 1e-9);
            }
        }
    }
};

PALPATE_TEST_NAMED("SurfaceMotion", SurfaceMotionTest)
#include "tst_SurfaceMotion.moc"
