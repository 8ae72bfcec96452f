// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

namespace palpate::haptics {

using core::Vec3;

/// How a structure feels: a spring and a damper between god-object and HIP. "N/mm as felt", not a tissue modulus.
struct Tissue
{
    double stiffness_N_per_mm = 0.5; ///< k >= 0
    double damping_Ns_per_mm = 0.0;  ///< b >= 0; 0 costs nothing
};

} // namespace palpate::haptics
