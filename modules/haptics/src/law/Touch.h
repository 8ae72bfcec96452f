// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"

#include <cstdint>
#include <span>

namespace palpate::haptics::law {

/// All that a term of a force law may ask in a tick.
struct Touch
{
    const HapticStructure& structure;         ///< touched
    std::uint32_t triangle;                   ///< position in its SurfaceIndex
    double fingertip_mm;                      ///< radius of what touches
    const Vec3& p_WG;                         ///< god-object [mm]
    const Vec3& p_WH;                         ///< HIP [mm]
    const Vec3& v_WH;                         ///< its velocity [mm/s]
    std::span<const ActiveConstraint> planes; ///< that hold the god-object
};

} // namespace palpate::haptics::law
