// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"
#include "probe/PointProbe.h"

#include <span>

namespace palpate::haptics::law {

/// Motion of the HIP since the previous tick.
struct Motion
{
    const Vec3& from_W; ///< [mm]
    const Vec3& to_W;   ///< [mm]
    double dt_s;        ///< duration; <= 0 if there was no previous tick
    const Vec3* v_W;    ///< velocity estimated by the caller [mm/s]; null: use the difference of the two positions

    /// Computed on demand, because most tissues need no velocity and should not pay for the division. [mm/s]
    [[nodiscard]] Vec3 velocity() const noexcept
    {
        if (v_W != nullptr) {
            return *v_W;
        }
        return dt_s > 0.0 ? Vec3((to_W - from_W) / dt_s) : Vec3::Zero();
    }
};

/// Input of the terms of a force law in one tick.
struct Touch
{
    const HapticStructure& structure; ///< touched structure
    const internal::Facet& facet;     ///< touched facet
    double fingertip_mm;              ///< radius of the probe
    const Vec3& p_WG;                 ///< god-object position [mm]
    const Vec3& push_W;               ///< from the HIP to the god-object [mm]
    double depth_mm;                  ///< length of push_W
    const Vec3& up_W;                 ///< direction of push_W; undefined at depth 0
    Motion hip;
    std::span<const ActiveConstraint> planes; ///< active planes of the god-object
    double& scale;                            ///< output: factor of the law by maps, set by terms that use maps [1]
};

} // namespace palpate::haptics::law
