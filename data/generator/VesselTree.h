// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Organ.h"

#include <palpate/geometry/TriangleMesh.h>

#include <span>
#include <vector>

namespace palpate::phantom {

/// Branching vessel: nodes, each with an earlier node as parent.
struct VesselTree
{
    struct Node
    {
        Vec3 p_W;
        int parent; ///< -1 for the root
        double radius_mm;
        int branch = 0; ///< a node and its thickest child share a branch
    };
    std::vector<Node> nodes;
};

/// Trunk of a tree, from outside the organ inwards, with a minimum radius.
struct Trunk
{
    std::vector<Vec3> points_W;
    double radius_mm;
};

/// Grows a tree from a trunk until all points of `supplied` are reached. Each point attracts the nearest node and is
/// removed when a node comes close (space colonisation, Runions et al. 2007, doi:10.2312/NPH/NPH07/063-070). Radii
/// are computed from the tips by Murray's law, r^3 = sum of the children's r^3.
/// @param inside  distance function of the allowed region, negative inside the organ and outside obstacles
[[nodiscard]] VesselTree growTree(const Trunk& trunk, std::vector<Vec3> supplied, const Distance& inside);

/// Scatters quasi-random points where `inside` < `-margin_mm`. Deterministic.
/// @param count  number of points tried in the organ's box
[[nodiscard]] std::vector<Vec3> scatter(const Distance& inside, double margin_mm, int count, int skip);

/// Adds a separate tree; overlapping surfaces are merged.
void add(VesselTree& tree, const VesselTree& other);

/// Makes the vessel wall as one closed surface, blended at the junctions.
[[nodiscard]] geometry::TriangleMesh vesselSurface(const VesselTree& tree, double cell_mm);

} // namespace palpate::phantom
