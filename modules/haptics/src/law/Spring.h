// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/Foot.h"
#include "law/Touch.h"
#include "law/Transmission.h"

namespace palpate::haptics::law {

/// `f_W = k (p_WG - p_WH)` [N].
/// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876, section 5.
struct LinearSpring
{
    [[nodiscard]] static bool isIn(const HapticStructure&) noexcept { return true; }
    [[nodiscard]] static Vec3 force(const Touch& touch) noexcept
    {
        return touch.structure.tissue.stiffness_N_per_mm * touch.push_W;
    }
};

/// `f_W = F(d) n` [N] with d = |p_WG - p_WH|, n from the HIP to the god-object, and F the force law.
struct LawSpring
{
    [[nodiscard]] static bool isIn(const HapticStructure&) noexcept { return true; }
    [[nodiscard]] static Vec3 force(const Touch& touch) noexcept
    {
        if (touch.structure.law == nullptr) {
            return LinearSpring::force(touch);
        }
        return touch.structure.law->force(touch.depth_mm) * touch.up_W;
    }
};

/// Derives the force from the stored energy `U = s(x) W(d)`, with d = |p_WG - p_WH|, W' = F the force law, and s the
/// stiffness map at the god-object's foot x: `f_W = -grad U = s F(d) n - W(d) P grad s` [N], with n from the HIP to the
/// god-object and P the projector on the directions in which the contact leaves the foot free to move.
///
/// With friction the foot does not follow the HIP, so the last term is omitted; goal/CoulombFriction.h compensates for
/// the missing term.
/// @par Source resources/docs/laws.md, "One energy".
struct MapSpring
{
    [[nodiscard]] static bool isIn(const HapticStructure&) noexcept { return true; }
    [[nodiscard]] PALPATE_ALWAYS_INLINE static Vec3 force(const MappedTouch& touch) noexcept
    {
        const HapticStructure& on = touch.structure;
        const TissueMap& map = on.maps.stiffness;
        if (map.isEmpty()) {
            return LawSpring::force(touch);
        }
        if (on.tissue.hasFriction()) {
            touch.scale = touch.foot.numberOf(map);
            return touch.scale * on.lawAt(touch.depth_mm).force_N * touch.up_W;
        }
        const ForceTable::Value law = on.lawAt(touch.depth_mm);
        const MapSample s = touch.foot.valueOf(map);
        touch.scale = s.value;
        return s.value * law.force_N * touch.up_W - law.energy_mJ * touch.foot.freePart(s.gradient);
    }
};

/// Same as MapSpring, with buried lumps: `U = s(x) sum_j s_j(x) W_j(d)`, see Transmission.h.
struct TransmissionSpring
{
    [[nodiscard]] static bool isIn(const HapticStructure&) noexcept { return true; }
    [[nodiscard]] PALPATE_ALWAYS_INLINE static Vec3 force(const MappedTouch& touch) noexcept
    {
        if (!(touch.depth_mm > 0.0)) {
            return Vec3::Zero();
        }
        const HapticStructure& on = touch.structure;
        if (on.tissue.hasFriction()) [[unlikely]] { // with friction, the gradient of the stored energy is omitted
            const double s = on.maps.stiffness.isEmpty() ? 1.0 : touch.foot.numberOf(on.maps.stiffness);
            touch.scale = s * Transmission::scaleAt(touch.foot.place(), on, touch.depth_mm);
            return touch.scale * on.lawAt(touch.depth_mm).force_N * touch.up_W;
        }
        const ForceTable::Value law = on.lawAt(touch.depth_mm);
        const Transmission felt = Transmission::at(touch.foot.place(), on, touch.depth_mm, law);
        const MapSample s = on.maps.stiffness.isEmpty() ? MapSample{} : touch.foot.valueOf(on.maps.stiffness);
        touch.scale = s.value * felt.scale;
        const Vec3 f_W = touch.scale * law.force_N * touch.up_W;
        return f_W - touch.foot.freePart(s.value * felt.gradient + felt.energy_mJ * s.gradient);
    }
};

} // namespace palpate::haptics::law
