// SPDX-License-Identifier: BSD-3-Clause
#include "law/Damper.h"

#include "law/Foot.h"

namespace palpate::haptics::law {

Vec3 Damper::force(const Touch& touch) noexcept
{
    const TissueMap& map = touch.structure.maps.damping;
    return map.isEmpty() ? LinearDamper::force(touch) : Vec3(-Foot(touch).valueOf(map).value * touch.v_WH);
}

} // namespace palpate::haptics::law
