// SPDX-License-Identifier: BSD-3-Clause
#include "law/Spring.h"

#include "law/FeltBelow.h"
#include "law/Foot.h"
#include "palpate/haptics/ForceTable.h"

namespace palpate::haptics::law {

Vec3 Spring::force(const Touch& touch) noexcept
{
    const HapticStructure& on = touch.structure;
    const bool isMapped = !on.maps.stiffness.isEmpty(), hasFelt = on.maps.hasFelt();
    if (on.law == nullptr && !isMapped && !hasFelt) {
        return LinearSpring::force(touch);
    }
    const Vec3 push = touch.p_WG - touch.p_WH;
    const double depth = push.norm();
    if (!(depth > 0.0)) {
        return Vec3::Zero();
    }
    const ForceTable::Value law = on.lawAt(depth);
    if (!isMapped && !hasFelt) {
        return law.force_N / depth * push;
    }
    const Foot foot(touch);
    const MapValue s = isMapped ? foot.valueOf(on.maps.stiffness) : MapValue{};
    if (hasFelt) {
        const FeltBelow felt = FeltBelow::at(foot, on, depth, law);
        const Vec3 f_W = s.value * felt.scale * law.force_N / depth * push;
        const Vec3 tilt_N = s.value * felt.gradient + felt.energy_mJ * s.gradient;
        return on.tissue.hasFriction() ? f_W : Vec3(f_W - foot.freePart(tilt_N));
    }
    const Vec3 f_W = s.value * law.force_N / depth * push;
    return on.tissue.hasFriction() ? f_W : Vec3(f_W - law.energy_mJ * foot.freePart(s.gradient));
}

} // namespace palpate::haptics::law
