// SPDX-License-Identifier: BSD-3-Clause
#include "Kinematics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace palpate::woodenhaptics {

Kinematics::Kinematics(const Config& config)
    : m_config(config)
{
    constexpr double kPi = std::numbers::pi;
    const bool isVintage = config.variant == 1;
    // Sign of q relative to the encoder, and of the motor relative to q.
    const Vec3 encoderSense = isVintage ? Vec3(1, -1, 1) : Vec3(-1, -1, -1);
    const Vec3 motorSense = isVintage ? Vec3(1, -1, 1) : Vec3(1, -1, -1);
    m_offset = isVintage ? Vec3(0, kPi / 2, 0) : Vec3(0, 0, kPi / 2);
    for (int i = 0; i < 3; ++i) {
        const auto n = static_cast<std::size_t>(i);
        const double ratio = config.capstanDiameter_m[n] / config.bodyDiameter_m[n];
        m_perCount[i] = encoderSense[i] * 2.0 * kPi / config.countsPerTurn[n] * ratio;
        m_perTorque[i] = motorSense[i] * ratio / config.torqueConstant_Nm_per_A[n];
    }
}

Vec3 Kinematics::angles(const Vec3& counts) const noexcept
{
    return m_offset + m_perCount.cwiseProduct(counts);
}

Vec3 Kinematics::position_m(const Vec3& q) const noexcept
{
    const auto& [La, Lb, Lc] = m_config.linkLength_m;
    const double r = Lb * std::sin(q[1]) + Lc * std::sin(q[2]);
    return {std::cos(q[0]) * r - m_config.origin_m[0], std::sin(q[0]) * r - m_config.origin_m[1],
            La + Lb * std::cos(q[1]) - Lc * std::cos(q[2]) - m_config.origin_m[2]};
}

Matrix3 Kinematics::jacobian(const Vec3& q) const noexcept
{
    const double Lb = m_config.linkLength_m[1];
    const double Lc = m_config.linkLength_m[2];
    const double ca = std::cos(q[0]), sa = std::sin(q[0]);
    const double cb = std::cos(q[1]), sb = std::sin(q[1]);
    const double cc = std::cos(q[2]), sc = std::sin(q[2]);
    const double r = Lb * sb + Lc * sc;
    Matrix3 j;
    j << -sa * r, ca * Lb * cb, ca * Lc * cc, //
        ca * r, sa * Lb * cb, sa * Lc * cc,   //
        0.0, -Lb * sb, Lc * sc;
    return j;
}

double Kinematics::resolution_m() const noexcept
{
    const Vec3 turn = m_perCount.cwiseAbs();
    const double links = m_config.linkLength_m[1] * turn[1] + m_config.linkLength_m[2] * turn[2];
    const double reach = std::min(std::hypot(m_config.origin_m[0], m_config.origin_m[1]) + m_config.workspaceRadius_m,
                                  m_config.linkLength_m[1] + m_config.linkLength_m[2]);
    return std::max(links, reach * turn[0]);
}

Vec3 Kinematics::torques(const Vec3& q, const Vec3& f_D) const noexcept
{
    Vec3 torques = jacobian(q).transpose() * f_D;
    // Gravity compensation: the weight of each link times the gradient of the height of its centre of mass.
    const double g = m_config.gravity_m_per_s2;
    torques[1] -=
        g * std::sin(q[1]) * (m_config.massB_kg * m_config.centreB_m + m_config.massC_kg * m_config.linkLength_m[1]);
    torques[2] += g * std::sin(q[2]) * m_config.massC_kg * m_config.centreC_m;
    return torques;
}

Vec3 Kinematics::currents(const Vec3& torques_Nm) const noexcept
{
    return m_perTorque.cwiseProduct(torques_Nm);
}

} // namespace palpate::woodenhaptics
