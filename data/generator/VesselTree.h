// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Organ.h"

#include <palpate/geometry/TriangleMesh.h>

#include <span>
#include <vector>

namespace palpate::phantom {

/// A branching vessel as points that each hang on an earlier one.
struct VesselTree
{
    struct Node
    {
        Vec3 p_W;
        int parent; ///< -1 at the root
        double radius_mm;
        int branch = 0; ///< a node and its thickest child are on one branch
    };
    std::vector<Node> nodes;
};

/// Where a tree begins: its trunk, from outside the organ inwards, and the least radius that trunk has.
struct Trunk
{
    std::vector<Vec3> points_W;
    double radius_mm;
};

/// Grows a tree from its trunk until it reaches each of `supplied`: every point pulls the nearest node towards it and
/// is settled when a node comes close (space colonisation, Runions et al. 2007, doi:10.2312/NPH/NPH07/063-070). Radii
/// follow from the twigs by Murray's law, r^3 = sum of the children's r^3.
/// @param inside  keeps the branches inside the organ and off what must stay free: negative where they may run
[[nodiscard]] VesselTree growTree(const Trunk& trunk, std::vector<Vec3> supplied, const Distance& inside);

/// Evenly scattered points where `inside` is below `-margin_mm`, the same on every run.
/// @param count  of points tried in the organ's box
[[nodiscard]] std::vector<Vec3> scatter(const Distance& inside, double margin_mm, int count, int skip);

/// Adds a tree that stands alone; where the two overlap, their surfaces become one.
void add(VesselTree& tree, const VesselTree& other);

/// The tree's wall as one closed surface, rounded where branches meet.
[[nodiscard]] geometry::TriangleMesh vesselSurface(const VesselTree& tree, double cell_mm);

} // namespace palpate::phantom
