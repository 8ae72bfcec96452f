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

// Eigen's own quaternion and isometry are aligned to 32 bytes in programs built with AVX and to 16 bytes otherwise, so
// that structures with such members would have another layout in a caller than in the library. Without alignment the
// layout does not depend on the caller's flags. tests/package builds a caller with AVX.
using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;
/// Rigid motion; `X_WM` maps mesh coordinates to world coordinates.
using Transform = Eigen::Transform<double, 3, Eigen::Isometry, Eigen::DontAlign>;

/// Axis-aligned box [mm]; `isEmpty()` until the first `extend`.
using Box = Eigen::AlignedBox3d;

static_assert(alignof(Quaternion) == alignof(double) && sizeof(Quaternion) == 4 * sizeof(double));
static_assert(alignof(Transform) == alignof(double) && sizeof(Transform) == 16 * sizeof(double));
static_assert(alignof(Vec3) == alignof(double) && alignof(Box) == alignof(double));

} // namespace palpate::core
