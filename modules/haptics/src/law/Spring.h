// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/Touch.h"

namespace palpate::haptics::law {

/// `f_W = k (p_WG - p_WH)` [N].
/// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876, section 5.
struct LinearSpring
{
    [[nodiscard]] static bool isIn(const HapticStructure&) noexcept { return true; }
    [[nodiscard]] static Vec3 force(const Touch& touch) noexcept
    {
        return touch.structure.tissue.stiffness_N_per_mm * (touch.p_WG - touch.p_WH);
    }
};

/// What a tissue stores: `U = s(x) W(d)` with d = |p_WG - p_WH|, W' = F the law of force by depth, and s the map of
/// stiffness at the god-object's foot x. `f_W = -grad U = s F(d) n - W(d) P grad s` [N] with n from the HIP to the
/// god-object and P the projector on what the contact leaves the foot free to do. The linear spring where there is
/// neither law nor map.
///
/// Where lumps below are felt through the surface, `s(x) W(d)` becomes `s(x) sum_j s_j(x) W_j(d)`: see FeltBelow.h.
///
/// With friction the foot does not follow the HIP, so the last term is left out; law/Friction.h makes up for it.
/// @par Source resources/docs/laws.md, "One energy".
struct Spring
{
    [[nodiscard]] static bool isIn(const HapticStructure&) noexcept { return true; }
    [[nodiscard]] static Vec3 force(const Touch& touch) noexcept;
};

} // namespace palpate::haptics::law
