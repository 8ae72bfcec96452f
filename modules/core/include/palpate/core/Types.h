// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace palpate::core {

/// Units everywhere in Palpate: mm, N, s, rad, N/mm, N·s/mm, in double precision.
///
/// Frames are denoted by one letter as a suffix of the variable: W world (patient, LPS), M mesh file, D device, H
/// haptic interface point (HIP), G god-object, V view. `p_WG` is the position of G in W, `v_WH` the velocity of H in W.
using Vec3 = Eigen::Vector3d;
using Quaternion = Eigen::Quaterniond;
using Transform = Eigen::Isometry3d; ///< rigid motion, `X_WM` maps mesh coordinates to world coordinates

/// Axis-aligned box [mm]; `isEmpty()` until the first `extend`.
using Box = Eigen::AlignedBox3d;

} // namespace palpate::core
