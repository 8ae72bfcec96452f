// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <Bench.h>
#include <Kinematics.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace palpate;
using core::Vec3;

namespace {

woodenhaptics::Config vintage()
{
    woodenhaptics::Config c;
    c.variant = 1;
    c.capstanDiameter_m = {0.013, 0.010, 0.010};
    c.bodyDiameter_m = {0.117, 0.077, 0.077};
    c.linkLength_m = {0.056, 0.138, 0.112};
    c.origin_m = {0.140, 0.0, 0.0};
    c.torqueConstant_Nm_per_A = {0.0163, 0.0163, 0.0163};
    c.countsPerTurn = {4000, 4000, 4000};
    return c;
}

/// Returns the emulated arm's parameters for the same configuration.
standin::ArmUnit unitOf(const woodenhaptics::Config& c)
{
    standin::ArmUnit unit;
    unit.variant = c.variant;
    unit.capstan_m = c.capstanDiameter_m;
    unit.body_m = c.bodyDiameter_m;
    unit.link_m = c.linkLength_m;
    unit.origin_m = c.origin_m;
    unit.torqueConstant = c.torqueConstant_Nm_per_A;
    unit.countsPerTurn = c.countsPerTurn;
    unit.motorFriction_Nm = 0.0;
    unit.jointViscosity = 0.0;
    return unit;
}

standin::V3 arr(const Vec3& v)
{
    return {v[0], v[1], v[2]};
}

} // namespace

class Kinematics : public QObject
{
    Q_OBJECT

  private:
    static void units()
    {
        QTest::addColumn<bool>("isVintage");
        QTest::newRow("kit") << false;
        QTest::newRow("vintage PHANToM") << true;
    }

    static woodenhaptics::Config config()
    {
        return *static_cast<bool*>(QTest::qData("isVintage", qMetaTypeId<bool>())) ? vintage()
                                                                                   : woodenhaptics::Config();
    }

    static std::vector<Vec3> poses()
    {
        std::vector<Vec3> poses;
        std::mt19937 random(1);
        std::uniform_real_distribution<double> turn(-0.8, 0.8);
        for (int i = 0; i < 200; ++i) {
            poses.emplace_back(turn(random), 0.8 + turn(random), 0.9 + turn(random));
        }
        return poses;
    }

  private Q_SLOTS:
    void calibrationPoseIsTheKits()
    {
        // Link b vertical, link c horizontal: computed by hand from the lengths, minus the workspace's origin.
        const woodenhaptics::Kinematics kit{woodenhaptics::Config()};
        const Vec3 p = kit.position_m(kit.angles(Vec3::Zero()));
        QVERIFY((p - Vec3(0.245 - 0.220, 0.0, 0.080 + 0.205 - 0.080)).norm() < 1e-12);
        // One turn of motor b tilts link b backwards by 30 degrees: 10 mm on 120 mm.
        const Vec3 q = kit.angles(Vec3(0, 2000, 0));
        QVERIFY(std::abs(q[1] + 2.0 * 3.14159265358979 / 12.0) < 1e-9);
    }

    void jacobianIsTheFiniteDifference_data() { units(); }
    void jacobianIsTheFiniteDifference()
    {
        const woodenhaptics::Kinematics k(config());
        for (const Vec3& q : poses()) {
            const Eigen::Matrix3d j = k.jacobian(q);
            for (int i = 0; i < 3; ++i) {
                Vec3 d = Vec3::Zero();
                d[i] = 1e-6;
                const Vec3 difference = (k.position_m(q + d) - k.position_m(q - d)) / 2e-6;
                QVERIFY((difference - j.col(i)).norm() < 1e-9);
            }
        }
    }

    /// Half a count of each encoder in the worst combination gives half of the reported resolution: never more, and
    /// almost reached somewhere.
    void resolutionIsWhatCountsCannotSay_data() { units(); }
    void resolutionIsWhatCountsCannotSay()
    {
        const woodenhaptics::Config c = config();
        const woodenhaptics::Kinematics k(c);
        const Vec3 turn = (k.angles(Vec3::Ones()) - k.angles(Vec3::Zero())).cwiseAbs();
        double worst = 0.0;
        for (const double a : {-0.4, -0.2, 0.0, 0.2, 0.4}) {
            for (double b = 0.0; b < 2.0; b += 0.05) {
                for (double g = 0.0; g < 2.0; g += 0.05) {
                    const Vec3 q(a, b, g);
                    if (k.position_m(q).norm() <= c.workspaceRadius_m) {
                        worst = std::max(worst, (k.jacobian(q).cwiseAbs() * turn).maxCoeff());
                    }
                }
            }
        }
        const QString found = QString("%1 mm of %2").arg(1e3 * worst).arg(1e3 * k.resolution_m());
        QVERIFY2(worst <= k.resolution_m(), qPrintable(found));
        QVERIFY2(worst >= 0.8 * k.resolution_m(), qPrintable(found));
    }

    /// The work of the motors on the links equals the work of the force at the tip: tau . q' = f . v.
    void torquesDoTheWorkOfTheForce_data() { units(); }
    void torquesDoTheWorkOfTheForce()
    {
        const woodenhaptics::Kinematics k(config());
        std::mt19937 random(2);
        std::normal_distribution<double> normal;
        for (const Vec3& q : poses()) {
            const Vec3 f(normal(random), normal(random), normal(random));
            const Vec3 rate(normal(random), normal(random), normal(random));
            const double h = 1e-6;
            const Vec3 v = (k.position_m(q + h * rate) - k.position_m(q - h * rate)) / (2.0 * h);
            QVERIFY(std::abs(k.torques(q, f).dot(rate) - f.dot(v)) < 1e-8);
        }
    }

    /// The same against the emulated mechanism, which has only currents and counts.
    void agreesWithTheEmulatedArm_data() { units(); }
    void agreesWithTheEmulatedArm()
    {
        const woodenhaptics::Config c = config();
        const woodenhaptics::Kinematics k(c);
        const standin::ArmUnit unit = unitOf(c);
        for (const Vec3& q : poses()) {
            const standin::V3 counts = standin::countsOf(unit, arr(q));
            QVERIFY((k.angles(Vec3(counts[0], counts[1], counts[2])) - q).norm() < 1e-12);
            const standin::V3 tip = standin::tipOf(unit, arr(q));
            QVERIFY((k.position_m(q) * 1000.0 - Vec3(tip[0], tip[1], tip[2])).norm() < 1e-9);
            const Vec3 f(1.0, -2.0, 0.5);
            const standin::V3 pushed = standin::forceOf(unit, arr(q), arr(k.currents(k.torques(q, f))));
            QVERIFY((Vec3(pushed[0], pushed[1], pushed[2]) - f).norm() < 1e-9);
        }
    }

    void forceAlongAnAxisAcceleratesTheTipThatWay_data() { units(); }
    void forceAlongAnAxisAcceleratesTheTipThatWay()
    {
        const woodenhaptics::Config c = config();
        const woodenhaptics::Kinematics k(c);
        for (int axis = 0; axis < 3; ++axis) {
            standin::Arm arm;
            arm.unit = unitOf(c);
            arm.hand.isHolding = false;
            arm.q = c.variant == 1 ? standin::V3{0.1, 1.4, 0.3} : standin::V3{0.1, 0.4, 0.7};
            const standin::V3 before = standin::tipOf(arm.unit, arm.q);
            Vec3 f = Vec3::Zero();
            f[axis] = 1.0;
            arm.amps = arr(k.currents(k.torques(Vec3(arm.q[0], arm.q[1], arm.q[2]), f)));
            for (int i = 0; i < 50; ++i) {
                standin::stepArm(arm, 1e-4);
            }
            const standin::V3 after = standin::tipOf(arm.unit, arm.q);
            QVERIFY(after[static_cast<std::size_t>(axis)] > before[static_cast<std::size_t>(axis)] + 1e-3);
        }
    }

    void holdsTheLinksWeight()
    {
        woodenhaptics::Config c;
        c.gravity_m_per_s2 = 9.81;
        const woodenhaptics::Kinematics k(c);
        standin::Arm arm;
        arm.unit = unitOf(c);
        arm.unit.gravity = 9.81;
        arm.hand.isHolding = false;
        arm.q = {0.2, 0.4, 0.7};
        const standin::V3 before = standin::tipOf(arm.unit, arm.q);
        for (int i = 0; i < 2000; ++i) { // 0.2 s: without support the arm would fall by centimetres
            arm.amps = arr(k.currents(k.torques(Vec3(arm.q[0], arm.q[1], arm.q[2]), Vec3::Zero())));
            standin::stepArm(arm, 1e-4);
        }
        const standin::V3 after = standin::tipOf(arm.unit, arm.q);
        QVERIFY(std::abs(after[2] - before[2]) < 0.01);
    }
};

PALPATE_TEST(Kinematics)
#include "tst_Kinematics.moc"
