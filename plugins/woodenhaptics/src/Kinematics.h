// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Config.h"

#include <palpate/core/Types.h>

namespace palpate::woodenhaptics {

using core::Vec3;
using Matrix3 = Eigen::Matrix3d;

/// Kinematics and statics of the arm, without state. Frame D: x away from the foot, z up, origin as configured.
/// Metres, newtons.
///
/// The angles q = (alpha, beta, gamma) [rad] are absolute: alpha of the whole arm about the vertical, beta of link b
/// from the vertical, gamma of link c from the downward vertical. Joint angles are theta = 2 pi count d / (cpr D),
/// signed by the mounting of each motor. Variant 0 has beta = theta_b and gamma = pi/2 - theta_c, variant 1 has beta
/// = theta_b + pi/2 and gamma = theta_c. The tip is at
///   r = L_b sin beta + L_c sin gamma,   (r cos alpha, r sin alpha, L_a + L_b cos beta - L_c cos gamma) - origin.
class Kinematics
{
  public:
    explicit Kinematics(const Config& config);

    /// Joint angles. @param counts  encoders a, b, c with the sign of protocol 2
    [[nodiscard]] Vec3 angles(const Vec3& counts) const noexcept;
    [[nodiscard]] Vec3 position_m(const Vec3& q) const noexcept;
    /// Jacobian d position / d q.
    [[nodiscard]] Matrix3 jacobian(const Vec3& q) const noexcept;
    /// Worst-case resolution of a tip coordinate [m]; the quantisation error is at most half of this everywhere in
    /// the workspace. One count of the foot's encoder at full reach, or of both link encoders together where both
    /// links point the same way.
    [[nodiscard]] double resolution_m() const noexcept;
    /// Torques about q [N m] for a tip force `f_D` [N], plus gravity compensation of the links.
    [[nodiscard]] Vec3 torques(const Vec3& q, const Vec3& f_D) const noexcept;
    /// Motor currents [A] for torques about q. The sign of each motor is independent of its encoder's sign.
    [[nodiscard]] Vec3 currents(const Vec3& torques_Nm) const noexcept;

  private:
    Config m_config;
    Vec3 m_perCount;  // q per count [rad]
    Vec3 m_offset;    // q at count 0 [rad]
    Vec3 m_perTorque; // current per torque about q [A / N m]
};

} // namespace palpate::woodenhaptics
