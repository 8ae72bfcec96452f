// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Types.h"

namespace palpate::core {

/// Camera pose and focal point.
struct ViewPose
{
    Vec3 position_W = Vec3(0, -500, 0); ///< [mm]
    Vec3 focus_W = Vec3::Zero();        ///< [mm]
    Vec3 up_W = Vec3::UnitZ();
    double viewAngle_deg = 30.0;

    friend bool operator==(const ViewPose&, const ViewPose&) = default;
};

} // namespace palpate::core
