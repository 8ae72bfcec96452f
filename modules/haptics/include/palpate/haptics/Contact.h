// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <cstdint>

namespace palpate::haptics {

using core::Vec3;

/// Friction state of a god-object.
enum class Friction : std::uint8_t
{
    None,   ///< the touched structure has no friction
    Holds,  ///< static friction: the god-object sticks
    Slides, ///< kinetic friction: the god-object is dragged along by the hand
};

/// A structure in contact with the god-object of its layer, and its share of the force.
struct Contact
{
    Vec3 p_WG; ///< god-object position [mm], world frame
    /// Unit contact normal, from the surface to free space: the direction of the combined push of the structure's
    /// planes. For a single frictionless structure, the direction of the spring from HIP to god-object.
    Vec3 n_W;
    Vec3 f_W;              ///< force of this structure on the hand [N], world frame
    double depth_mm;       ///< penetration depth [mm]: distance of the HIP from the god-object; if structures share the
                           ///< god-object, the distance along `n_W`, at least 0
    double stiffnessScale; ///< factor on the law's force from stiffness maps and buried lumps [1]; not recorded
    std::uint32_t structure; ///< index of the structure in the scene
    std::uint32_t triangle;  ///< touched triangle, as an index into the structure's mesh as passed to `repair`
    std::uint32_t layer;     ///< index into the scene's layers, 0 is the outermost
    Friction friction;
};

} // namespace palpate::haptics
