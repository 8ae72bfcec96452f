// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Config.h"

#include <palpate/core/Types.h>

namespace palpate::woodenhaptics {

using core::Vec3;
using Matrix3 = Eigen::Matrix3d;

/// Where the arm is and how it is driven. Frame D: x away from the foot, z up, origin where the configuration says.
///
/// The angles q = (alpha, beta, gamma) [rad] are those of the links themselves: alpha of the whole arm about the
/// vertical, beta of link b from the vertical, gamma of link c from the vertical downwards. The arm's own angles are
/// theta = 2 pi count d / (cpr D), turned by the sense in which each motor is mounted; then variant 0 has
/// beta = theta_b and gamma = pi/2 - theta_c, variant 1 beta = theta_b + pi/2 and gamma = theta_c. The tip is at
///   r = L_b sin beta + L_c sin gamma,   (r cos alpha, r sin alpha, L_a + L_b cos beta - L_c cos gamma) - origin.
/// All pure; metres, newtons.
class Kinematics
{
  public:
    explicit Kinematics(const Config& config);

    /// @param counts  of encoders a, b, c in protocol 2's sense
    [[nodiscard]] Vec3 angles(const Vec3& counts) const noexcept;
    [[nodiscard]] Vec3 position_m(const Vec3& q) const noexcept;
    /// d position / d q.
    [[nodiscard]] Matrix3 jacobian(const Vec3& q) const noexcept;
    /// A coordinate of the tip is off by at most half of this anywhere in the workspace [m]: a count of the foot's
    /// encoder there where the arm reaches farthest, or of both links' together where both point the same way.
    [[nodiscard]] double resolution_m() const noexcept;
    /// Torques about q [N m] that make the tip push with `f_D` [N], with what holds the links' own weight.
    [[nodiscard]] Vec3 torques(const Vec3& q, const Vec3& f_D) const noexcept;
    /// Motor currents [A] for torques about q. The sense of each motor is its own, independent of its encoder's.
    [[nodiscard]] Vec3 currents(const Vec3& torques_Nm) const noexcept;

  private:
    Config m_config;
    Vec3 m_perCount;  // q per count [rad]
    Vec3 m_offset;    // q at count 0 [rad]
    Vec3 m_perTorque; // current per torque about q [A / N m]
};

} // namespace palpate::woodenhaptics
