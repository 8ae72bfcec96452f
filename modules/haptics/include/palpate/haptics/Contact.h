// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <cstdint>

namespace palpate::haptics {

using core::Vec3;

/// Where the god-object of one layer touches, and what is felt there.
struct Contact
{
    Vec3 p_WG;               ///< god-object [mm]
    Vec3 n_W;                ///< unit normal of the contact, from surface to free space
    Vec3 f_W;                ///< the layer's share of the force on the hand [N]
    double depth_mm;         ///< of the HIP below the god-object
    std::uint32_t structure; ///< touched, as its number in the scene; of several the stiffest: the hand can't pass it
    std::uint32_t triangle;  ///< touched, as its index in the structure's mesh as given to `repair`
    std::uint32_t layer;     ///< position in the scene's layers, 0 the outermost
};

} // namespace palpate::haptics
