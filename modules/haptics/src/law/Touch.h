// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"
#include "probe/PointProbe.h"

#include <span>

namespace palpate::haptics::law {

/// How the HIP has come from where it was in the tick before.
struct Motion
{
    const Vec3& from_W; ///< [mm]
    const Vec3& to_W;   ///< [mm]
    double dt_s;        ///< in which it did; none where there was no tick before
    const Vec3* v_W;    ///< its velocity, where the caller estimated it; null: the difference of the two places [mm/s]

    /// Most tissues ask for none, and pay for no division. [mm/s]
    [[nodiscard]] Vec3 velocity() const noexcept
    {
        if (v_W != nullptr) {
            return *v_W;
        }
        return dt_s > 0.0 ? Vec3((to_W - from_W) / dt_s) : Vec3::Zero();
    }
};

/// All that a term of a force law may ask in a tick.
struct Touch
{
    const HapticStructure& structure; ///< touched
    const internal::Facet& facet;     ///< of it
    double fingertip_mm;              ///< radius of what touches
    const Vec3& p_WG;                 ///< god-object [mm]
    const Vec3& push_W;               ///< from the HIP to it [mm]
    double depth_mm;                  ///< length of that
    const Vec3& up_W;                 ///< its direction; means nothing without a depth
    Motion hip;
    std::span<const ActiveConstraint> planes; ///< that hold the god-object
    double& scale;                            ///< a term that scales the law by a map says here by how much [1]
};

} // namespace palpate::haptics::law
