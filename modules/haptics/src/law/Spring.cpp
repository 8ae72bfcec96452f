// SPDX-License-Identifier: BSD-3-Clause
#include "law/Spring.h"

#include "law/Foot.h"
#include "palpate/haptics/ForceTable.h"

namespace palpate::haptics::law {

Vec3 Spring::force(const Touch& touch) noexcept
{
    const HapticStructure& on = touch.structure;
    if (on.law == nullptr && on.maps.stiffness.isEmpty()) {
        return LinearSpring::force(touch);
    }
    const Vec3 push = touch.p_WG - touch.p_WH;
    const double depth = push.norm();
    if (!(depth > 0.0)) {
        return Vec3::Zero();
    }
    const ForceTable::Value law = on.lawAt(depth);
    if (on.maps.stiffness.isEmpty()) {
        return law.force_N / depth * push;
    }
    const Foot foot(touch);
    const MapValue s = foot.valueOf(on.maps.stiffness);
    const Vec3 f_W = s.value * law.force_N / depth * push;
    return on.tissue.hasFriction() ? f_W : Vec3(f_W - law.energy_mJ * foot.freePart(s.gradient));
}

} // namespace palpate::haptics::law
