// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace palpate::view {

/// Text beside a disc on screen. Logical pixels from the centre of the view, x right, y up.
struct DiscLabel
{
    Eigen::Vector2d disc_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d size_px = Eigen::Vector2d::Zero();
    /// From the centre of the disc to the centre of the text. In: the previous offset (zero: none yet). Out: the new
    /// offset.
    Eigen::Vector2d offset_px = Eigen::Vector2d::Zero();
    /// The text is not at the default place (up and right of the disc) and needs a leader line.
    bool isMoved = false;
};

/// Places labels without overlaps with each other, with discs or with `taken`. Labels are placed in order. Each label
/// takes the first free candidate: the default place, the previous place (so that labels do not jump while the view
/// turns), then the nearest place around the disc, preferably with a leader line that crosses no other. If no place
/// is free, the label takes the default place.
///
/// Each label tries at most 146 places and tests them against its neighbours on screen only.
/// @param taken  a few additional boxes to avoid, logical pixels from the centre of the view
PALPATE_EXPORT void placeLabels(std::vector<DiscLabel>& labels, double discRadius_px,
                                const std::vector<Eigen::AlignedBox2d>& taken = {});

/// Text beside a point on screen, at one of a fixed set of candidate places.
struct PointLabel
{
    Eigen::Vector2d point_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d size_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d towards = Eigen::Vector2d::UnitX(); ///< preferred direction
    int place = -1;                                     ///< index of the previous place, -1: none yet
};

/// Finds the best place for a text: inside the view, clear of `taken`, close to the point and in the preferred
/// direction. The previous place is kept while free, so that the text does not jump. If no place is free, the text
/// overlaps `taken` but stays inside the view.
/// @param taken  boxes to avoid; @param view  box of the view; all in logical pixels
/// @return the centre of the text. @par Cost At most 192 places, each tested against all of `taken`.
[[nodiscard]] PALPATE_EXPORT Eigen::Vector2d
placeBeside(PointLabel& label, const std::vector<Eigen::AlignedBox2d>& taken, const Eigen::AlignedBox2d& view);

} // namespace palpate::view
