// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/Touch.h"

namespace palpate::haptics::law {

/// What a tissue stores: `U = s(x) W(d)` with d = |p_WG - p_WH|, W' = F the law of force by depth, and s the map of
/// stiffness at the god-object's foot x. `f_W = -grad U = s F(d) n - W(d) P grad s` [N] with n from the HIP to the
/// god-object and P the projector on what the contact leaves the foot free to do. Without a map and with a linear law
/// that is Zilles & Salisbury's `k (p_WG - p_WH)`.
///
/// With friction the foot does not follow the HIP, so the last term is left out; law/Friction.h makes up for it.
/// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876, section 5; resources/docs/laws.md.
struct Spring
{
    [[nodiscard]] static bool isIn(const HapticStructure&) noexcept { return true; }
    [[nodiscard]] static Vec3 force(const Touch& touch) noexcept
    {
        const HapticStructure& on = touch.structure;
        if (on.law == nullptr && on.maps.stiffness.isEmpty()) {
            return on.tissue.stiffness_N_per_mm * (touch.p_WG - touch.p_WH);
        }
        return general(touch);
    }

  private:
    [[nodiscard]] static Vec3 general(const Touch& touch) noexcept;
};

} // namespace palpate::haptics::law
