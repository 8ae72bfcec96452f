// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Realtime.h>
#include <palpate/core/Types.h>

namespace palpate::haptics {

using core::Vec3;

/// How a structure feels: a spring and a damper between god-object and HIP. "N/mm as felt", not a tissue modulus.
struct Tissue
{
    double stiffness_N_per_mm = 0.5; ///< k >= 0
    double damping_Ns_per_mm = 0.0;  ///< b >= 0; 0 costs nothing
};

/// Force on the hand, `f_W = k (p_WG - p_WH) - b v_WH` [N].
/// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876, section 5.
/// @par Real-time Wait-free.
[[nodiscard]] inline Vec3 springDamperForce(const Tissue& tissue, const Vec3& p_WG, const Vec3& p_WH,
                                            const Vec3& v_WH) noexcept PALPATE_NONBLOCKING
{
    Vec3 f = tissue.stiffness_N_per_mm * (p_WG - p_WH);
    if (tissue.damping_Ns_per_mm != 0.0) {
        f -= tissue.damping_Ns_per_mm * v_WH;
    }
    return f;
}

} // namespace palpate::haptics
