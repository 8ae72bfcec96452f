// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <cstdint>

namespace palpate::haptics {

using core::Vec3;

/// What friction does to a god-object.
enum class Friction : std::uint8_t
{
    None,   ///< what is touched has none
    Holds,  ///< it sticks where it is
    Slides, ///< the hand drags it along
};

/// A structure that pushes on the god-object of its layer, and what is felt of it.
struct Contact
{
    Vec3 p_WG; ///< god-object [mm]
    /// Unit normal of the contact, from surface to free space: the direction in which the structure's planes push
    /// together. Where the structure is alone and has no friction, that of the spring.
    Vec3 n_W;
    Vec3 f_W;                ///< the structure's share of the force on the hand [N]
    double depth_mm;         ///< of the HIP below the god-object; where structures share it, along `n_W`, at least 0
    double stiffnessScale;   ///< factor of the law's force here, of maps and buried lumps [1]; not recorded
    std::uint32_t structure; ///< its number in the scene
    std::uint32_t triangle;  ///< touched, as its index in the structure's mesh as given to `repair`
    std::uint32_t layer;     ///< position in the scene's layers, 0 the outermost
    Friction friction;
};

} // namespace palpate::haptics
