// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"
#include "probe/PointProbe.h"

#include <span>

namespace palpate::haptics::law {

/// All that a term of a force law may ask in a tick.
struct Touch
{
    const HapticStructure& structure;         ///< touched
    const internal::Facet& facet;             ///< of it
    double fingertip_mm;                      ///< radius of what touches
    const Vec3& p_WG;                         ///< god-object [mm]
    const Vec3& push_W;                       ///< from the HIP to it [mm]
    double depth_mm;                          ///< length of that
    const Vec3& up_W;                         ///< its direction; means nothing without a depth
    const Vec3& v_WH;                         ///< velocity of the HIP [mm/s]
    std::span<const ActiveConstraint> planes; ///< that hold the god-object
    double& scale;                            ///< a term that scales the law by a map says here by how much [1]
};

} // namespace palpate::haptics::law
