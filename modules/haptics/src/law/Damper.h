// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/Touch.h"

namespace palpate::haptics::law {

/// `f_W = -b v_WH` [N].
/// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876, section 5.
struct Damper
{
    [[nodiscard]] static bool isIn(const Tissue& tissue) noexcept { return tissue.damping_Ns_per_mm != 0.0; }
    [[nodiscard]] static Vec3 force(const Touch& touch) noexcept
    {
        return -touch.tissue.damping_Ns_per_mm * touch.v_WH;
    }
};

} // namespace palpate::haptics::law
