// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Types.h"

#include <string>

namespace palpate::core {

/// Straight distance between two places of a scene, measured by the user. Used in scene files.
struct Tape
{
    std::string name{};
    Vec3 from_W = Vec3::Zero(); ///< [mm]
    Vec3 to_W = Vec3::Zero();
    std::string fromOn{}; ///< structure or finding at this end; may be empty
    std::string toOn{};
    std::string extra{}; ///< unknown fields of a scene file as a JSON object, preserved for newer versions

    [[nodiscard]] double length_mm() const { return (to_W - from_W).norm(); }
    friend bool operator==(const Tape&, const Tape&) = default;
};

} // namespace palpate::core
