// SPDX-License-Identifier: BSD-3-Clause
// The arm's mechanics: three driven links with distributed mass, capstan drives, friction, and a hand at the tip.
// Derived from the mechanism and independent of the driver, so that agreement of both is a test.
#include "Bench.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace standin {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d vec(const V3& v)
{
    return {v[0], v[1], v[2]};
}

V3 arr(const Vector3d& v)
{
    return {v[0], v[1], v[2]};
}

/// A point at `b` along link b's direction and `c` along link c's from the shoulder: position, Jacobian and time
/// derivative of the Jacobian.
struct Point
{
    Vector3d p;
    Matrix3d j;
    Matrix3d jDot;
};

Point pointAt(const Vector3d& q, const Vector3d& v, double b, double c)
{
    const double ca = std::cos(q[0]), sa = std::sin(q[0]), cb = std::cos(q[1]), sb = std::sin(q[1]),
                 cc = std::cos(q[2]), sc = std::sin(q[2]);
    const double r = b * sb + c * sc;
    const double rDot = b * cb * v[1] + c * cc * v[2];
    Point out;
    out.p = {ca * r, sa * r, b * cb - c * cc};
    out.j << -sa * r, ca * b * cb, ca * c * cc, ca * r, sa * b * cb, sa * c * cc, 0, -b * sb, c * sc;
    out.jDot << -ca * r * v[0] - sa * rDot, -sa * b * cb * v[0] - ca * b * sb * v[1],
        -sa * c * cc * v[0] - ca * c * sc * v[2], -sa * r * v[0] + ca * rDot, ca * b * cb * v[0] - sa * b * sb * v[1],
        ca * c * cc * v[0] - sa * c * sc * v[2], 0, -b * cb * v[1], c * cc * v[2];
    return out;
}

/// Returns motor turns per turn of each link; the sign is the direction of the encoder relative to the link angle.
Vector3d reduction(const ArmUnit& unit)
{
    return vec(unit.body_m).cwiseQuotient(vec(unit.capstan_m));
}

Vector3d jointTorques(const ArmUnit& unit, const V3& amps)
{
    // Amplifiers and motors in the kit's wiring: a positive current turns a forwards, b and c backwards.
    const Vector3d sense = unit.variant == 1 ? Vector3d(1, -1, 1) : Vector3d(1, -1, -1);
    return sense.cwiseProduct(vec(amps)).cwiseProduct(vec(unit.torqueConstant)).cwiseProduct(reduction(unit));
}

double smooth(double x)
{
    x = std::clamp(x, 0.0, 1.0);
    return x * x * x * (10.0 + x * (-15.0 + 6.0 * x));
}

} // namespace

V3 restPose(const ArmUnit& unit)
{
    constexpr double kRight = std::numbers::pi / 2;
    return unit.variant == 1 ? V3{0, kRight, 0} : V3{0, 0, kRight};
}

V3 tipOf(const ArmUnit& unit, const V3& q)
{
    Vector3d p = pointAt(vec(q), Vector3d::Zero(), unit.link_m[1], unit.link_m[2]).p;
    p.z() += unit.link_m[0];
    return arr((p - vec(unit.origin_m)) * 1000.0);
}

V3 forceOf(const ArmUnit& unit, const V3& q, const V3& amps)
{
    const Matrix3d j = pointAt(vec(q), Vector3d::Zero(), unit.link_m[1], unit.link_m[2]).j;
    return arr(j.transpose().inverse() * jointTorques(unit, amps));
}

std::array<double, 3> countsOf(const ArmUnit& unit, const V3& q)
{
    const Vector3d sense = unit.variant == 1 ? Vector3d(1, -1, 1) : Vector3d(-1, -1, -1);
    const Vector3d turned = vec(q) - vec(restPose(unit));
    return arr(turned.cwiseProduct(sense).cwiseProduct(reduction(unit)).cwiseProduct(vec(unit.countsPerTurn)) /
               (2.0 * std::numbers::pi));
}

V3 countStepOf(const ArmUnit& unit, const V3& q)
{
    const Matrix3d j = pointAt(vec(q), Vector3d::Zero(), unit.link_m[1], unit.link_m[2]).j;
    V3 step{};
    for (int i = 0; i < 3; ++i) {
        const double turn =
            2.0 * std::numbers::pi / unit.countsPerTurn[static_cast<std::size_t>(i)] / reduction(unit)[i];
        step[static_cast<std::size_t>(i)] = j.col(i).norm() * turn * 1000.0;
    }
    return step;
}

V3 targetOf(const Arm& arm, double time_s)
{
    const Hand& hand = arm.hand;
    Vector3d p = vec(tipOf(arm.unit, restPose(arm.unit)));
    double from_s = 0.0;
    for (int i = 0; i < hand.knots; ++i) {
        const Knot& knot = hand.path[static_cast<std::size_t>(i)];
        const double span = knot.time_s - from_s;
        const double share = span > 0.0 ? smooth((time_s - from_s) / span) : (time_s >= knot.time_s ? 1.0 : 0.0);
        p += (vec(knot.p_mm) - p) * share;
        if (time_s < knot.time_s) {
            break;
        }
        from_s = knot.time_s;
    }
    const double w = 2.0 * std::numbers::pi * hand.tremor_Hz * time_s;
    p += hand.tremor_mm * Vector3d(std::sin(w), std::sin(1.13 * w + 1.0), std::sin(0.91 * w + 2.0));
    return arr(p);
}

void stepArm(Arm& arm, double dt_s)
{
    const ArmUnit& unit = arm.unit;
    const Vector3d q = vec(arm.q);
    const Vector3d v = vec(arm.v);
    const Vector3d n = reduction(unit);
    const Point tip = pointAt(q, v, unit.link_m[1], unit.link_m[2]);
    const Point b = pointAt(q, v, unit.centreB_m, 0.0);
    const Point c = pointAt(q, v, unit.link_m[1], unit.centreC_m);

    Matrix3d mass = Matrix3d::Zero();
    Vector3d torque = jointTorques(unit, arm.amps);
    const auto carry = [&](const Point& point, double m) {
        mass += m * point.j.transpose() * point.j;
        torque -= m * point.j.transpose() * (point.jDot * v + Vector3d(0, 0, unit.gravity));
    };
    carry(b, unit.massB_kg);
    carry(c, unit.massC_kg);
    mass(0, 0) += unit.baseInertia;
    mass(1, 1) += unit.massB_kg * unit.link_m[1] * unit.link_m[1] / 12.0; // slender rods
    mass(2, 2) += unit.massC_kg * unit.link_m[2] * unit.link_m[2] / 12.0;
    for (int i = 0; i < 3; ++i) {
        mass(i, i) += unit.rotorInertia * n[i] * n[i];
        torque[i] -= unit.motorFriction_Nm * n[i] * std::tanh(v[i] / 0.05) + unit.jointViscosity * v[i];
    }
    if (arm.hand.isHolding) {
        const double time_s = static_cast<double>(arm.sim_ns - arm.plugged_ns) * 1e-9;
        const Vector3d target = vec(targetOf(arm, time_s));
        const Vector3d towards = (vec(targetOf(arm, time_s + 1e-4)) - target) / 1e-4;
        const Vector3d p = vec(tipOf(unit, arm.q));
        const Vector3d force =
            (arm.hand.stiffness_N_per_m * (target - p) + arm.hand.damping_Ns_per_m * (towards - tip.j * v * 1000.0)) *
            1e-3;
        mass += arm.hand.mass_kg * tip.j.transpose() * tip.j;
        torque += tip.j.transpose() * (force - arm.hand.mass_kg * (tip.jDot * v));
    }
    const Vector3d next = v + mass.inverse() * torque * dt_s;
    arm.v = arr(next);
    arm.q = arr(q + next * dt_s);
}

} // namespace standin
