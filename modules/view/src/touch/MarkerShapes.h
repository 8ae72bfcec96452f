// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Finding.h>

#include <Eigen/Core>

#include <vector>

namespace palpate::view::internal {

/// Outline of a finding type's marker around its centre: counter-clockwise and star-shaped. [logical px]
[[nodiscard]] const std::vector<Eigen::Vector2d>& markerOutline(core::FindingType type);

/// Radius of the largest marker including its rim. [logical px]
inline constexpr double kMarkerRadius_px = 8.0;

} // namespace palpate::view::internal
