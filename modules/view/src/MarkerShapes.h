// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Finding.h>

#include <Eigen/Core>

#include <vector>

namespace palpate::view::internal {

/// The outline of a type's shape about its middle, counter-clockwise, seen whole from there. [logical px]
[[nodiscard]] const std::vector<Eigen::Vector2d>& markerOutline(core::FindingType type);

/// How far the largest shape reaches with its rim. [logical px]
inline constexpr double kMarkerRadius_px = 8.0;

} // namespace palpate::view::internal
