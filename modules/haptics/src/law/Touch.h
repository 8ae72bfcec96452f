// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/Contact.h"
#include "palpate/haptics/Tissue.h"

#include <palpate/geometry/SurfaceIndex.h>

#include <cstdint>

namespace palpate::haptics::law {

/// All that a term of a force law may ask in a tick.
struct Touch
{
    const Tissue& tissue; ///< of what is touched
    const geometry::SurfaceIndex& surface;
    std::uint32_t triangle; ///< position in it
    const Vec3& p_WG;       ///< god-object [mm]
    const Vec3& p_WH;       ///< HIP [mm]
    const Vec3& v_WH;       ///< its velocity [mm/s]
};

} // namespace palpate::haptics::law
