// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/Touch.h"

namespace palpate::haptics::law {

/// `f_W = k (p_WG - p_WH)` [N].
/// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876, section 5.
struct Spring
{
    [[nodiscard]] static bool isIn(const Tissue&) noexcept { return true; }
    [[nodiscard]] static Vec3 force(const Touch& touch) noexcept
    {
        return touch.tissue.stiffness_N_per_mm * (touch.p_WG - touch.p_WH);
    }
};

} // namespace palpate::haptics::law
