// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

namespace palpate::view {

/// A text beside a disc on screen. Logical pixels, x right, y up, any origin.
struct DiscLabel
{
    Eigen::Vector2d disc_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d size_px = Eigen::Vector2d::Zero();
    /// From the disc's centre to the text's: in, where it was the last time (zero: nowhere yet); out, where it is.
    Eigen::Vector2d offset_px = Eigen::Vector2d::Zero();
    /// It is not at its usual place, up and right of the disc, so that a line must say whose it is.
    bool isMoved = false;
};

/// Places labels so that none covers another, nor a disc: each, in order, at its usual place, else where it was, so
/// that it doesn't jump while the view turns, else at the nearest free place about the disc, whose line crosses no
/// other's if there is such a one. Without a free place it takes the usual one.
///
/// Each tries at most 146 places against all.
void placeLabels(std::vector<DiscLabel>& labels, double discRadius_px);

} // namespace palpate::view
