// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/device/HandScript.h>

#include <cmath>
#include <limits>
#include <random>

using palpate::core::StatusCode;
using palpate::core::Vec3;
using palpate::device::HandTarget;
using Script = palpate::device::HandScript;

class HandScript : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void refusesBadTargets()
    {
        QVERIFY(Script::make({}).status().code() == StatusCode::Empty);
        QVERIFY(Script::make({{1.0, Vec3::Zero()}, {1.0, Vec3::Ones()}}).status().code() == StatusCode::OutOfRange);
        QVERIFY(Script::make({{1.0, Vec3::Zero()}, {0.5, Vec3::Ones()}}).status().code() == StatusCode::OutOfRange);
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(Script::make({{nan, Vec3::Zero()}}).status().code() == StatusCode::NonFinite);
        QVERIFY(Script::make({{0.0, Vec3(0.0, nan, 0.0)}}).status().code() == StatusCode::NonFinite);
    }

    void standsStillOutsideItsTime()
    {
        const auto script = Script::make({{1.0, Vec3(1, 2, 3)}, {2.0, Vec3(4, 5, 6)}}).value();
        QVERIFY(script.at(-5.0).p_W == Vec3(1, 2, 3));
        QVERIFY(script.at(1.0).v_W.isZero(0.0));
        QVERIFY(script.at(2.0).p_W == Vec3(4, 5, 6));
        QVERIFY(script.at(99.0).v_W.isZero(0.0));
        QCOMPARE(script.end_s(), 2.0);
        QVERIFY(Script().at(1.0).p_W.isZero(0.0));
    }

    void passesThroughItsTargetsSmoothlyWithoutOvershoot()
    {
        std::mt19937 random(7); // NOLINT: a fixed seed
        std::uniform_real_distribution<double> coordinate(-50.0, 50.0);
        std::uniform_real_distribution<double> gap(0.05, 1.0);
        std::vector<HandTarget> targets;
        double t = 0.0;
        for (int i = 0; i < 40; ++i) {
            targets.push_back({t, Vec3(coordinate(random), coordinate(random), i % 4 < 2 ? 3.0 : -8.0)});
            t += gap(random);
        }
        const auto script = Script::make(targets).value();
        for (std::size_t i = 0; i + 1 < targets.size(); ++i) {
            QVERIFY((script.at(targets[i].time_s).p_W - targets[i].p_W).norm() < 1e-12);
            const Vec3 low = targets[i].p_W.cwiseMin(targets[i + 1].p_W);
            const Vec3 high = targets[i].p_W.cwiseMax(targets[i + 1].p_W);
            const double h = targets[i + 1].time_s - targets[i].time_s;
            for (int k = 1; k < 100; ++k) {
                const double at = targets[i].time_s + h * k / 100.0;
                const auto motion = script.at(at);
                QVERIFY(((motion.p_W - low).array() >= -1e-12).all());
                QVERIFY(((high - motion.p_W).array() >= -1e-12).all());
                // The velocity is the derivative: central difference, error of order d^2 / h^3.
                const double d = 1e-5 * h;
                const Vec3 slope = (script.at(at + d).p_W - script.at(at - d).p_W) / (2.0 * d);
                QVERIFY((slope - motion.v_W).norm() < 1e-4 * 200.0 / h);
            }
            const double eps = 1e-9;
            QVERIFY((script.at(targets[i].time_s + eps).v_W - script.at(targets[i].time_s - eps).v_W).norm() < 1e-2);
        }
    }
};

PALPATE_TEST(HandScript)
#include "tst_HandScript.moc"
