// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace palpate::view {

/// A text beside a disc on screen. Logical pixels from the view's middle, x right, y up.
struct DiscLabel
{
    Eigen::Vector2d disc_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d size_px = Eigen::Vector2d::Zero();
    /// From the disc's centre to the text's: in, where it was the last time (zero: nowhere yet); out, where it is.
    Eigen::Vector2d offset_px = Eigen::Vector2d::Zero();
    /// It is not at its usual place, up and right of the disc, so that a line must say whose it is.
    bool isMoved = false;
};

/// Places labels so that none covers another, nor a disc, nor what is taken: each, in order, at its usual place, else
/// where it was, so that it doesn't jump while the view turns, else at the nearest free place about the disc, whose
/// line crosses no other's if there is such a one. Without a free place it takes the usual one.
///
/// Each tries at most 146 places against its neighbours on screen.
/// @param taken  boxes that labels stay clear of besides, logical pixels from the view's middle; a few
void placeLabels(std::vector<DiscLabel>& labels, double discRadius_px,
                 const std::vector<Eigen::AlignedBox2d>& taken = {});

/// A text beside a point on screen, at one of a number of places about it.
struct PointLabel
{
    Eigen::Vector2d point_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d size_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d towards = Eigen::Vector2d::UnitX(); ///< where it had best be
    int place = -1;                                     ///< the one of the last time, -1: none yet
};

/// Finds where a text reads best: inside the view and off what it must not cover, nearest to its point, and in the
/// direction that it had best be; where it was, as long as that is free, so that it doesn't jump. Without a free place
/// it still is inside the view.
/// @param taken  boxes that it must not cover; @param view  box of the view; all in logical pixels
/// @return the text's centre. It tries at most 192 places against all.
[[nodiscard]] Eigen::Vector2d placeBeside(PointLabel& label, const std::vector<Eigen::AlignedBox2d>& taken,
                                          const Eigen::AlignedBox2d& view);

} // namespace palpate::view
