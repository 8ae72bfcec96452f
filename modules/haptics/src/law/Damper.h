// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/Foot.h"
#include "law/Touch.h"

namespace palpate::haptics::law {

/// `f_W = -b v_WH` [N], b as a map has it at the god-object's foot, else the tissue.
/// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876, section 5.
struct Damper
{
    [[nodiscard]] static bool isIn(const HapticStructure& structure) noexcept
    {
        return structure.tissue.damping_Ns_per_mm != 0.0 || !structure.maps.damping.isEmpty();
    }
    [[nodiscard]] static Vec3 force(const Touch& touch) noexcept
    {
        const TissueMap& map = touch.structure.maps.damping;
        const double b = map.isEmpty() ? touch.structure.tissue.damping_Ns_per_mm : Foot(touch).valueOf(map).value;
        return -b * touch.v_WH;
    }
};

} // namespace palpate::haptics::law
