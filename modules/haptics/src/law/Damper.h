// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/Foot.h"
#include "law/Touch.h"

namespace palpate::haptics::law {

/// `f_W = -b v_WH` [N].
/// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876, section 5.
struct LinearDamper
{
    [[nodiscard]] static bool isIn(const HapticStructure& structure) noexcept
    {
        return structure.tissue.damping_Ns_per_mm != 0.0;
    }
    [[nodiscard]] static Vec3 force(const Touch& touch) noexcept
    {
        return -touch.structure.tissue.damping_Ns_per_mm * touch.hip.velocity();
    }
};

/// LinearDamper with b from a map at the god-object's foot.
struct MapDamper
{
    [[nodiscard]] static bool isIn(const HapticStructure& structure) noexcept
    {
        return LinearDamper::isIn(structure) || !structure.maps.damping.isEmpty();
    }
    [[nodiscard]] PALPATE_ALWAYS_INLINE static Vec3 force(const MappedTouch& touch) noexcept
    {
        const TissueMap& map = touch.structure.maps.damping;
        return map.isEmpty() ? LinearDamper::force(touch) : Vec3(-touch.foot.numberOf(map) * touch.hip.velocity());
    }
};

} // namespace palpate::haptics::law
