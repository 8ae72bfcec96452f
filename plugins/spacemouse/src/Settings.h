// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RateHand.h"

#include <palpate/core/Status.h>

#include <filesystem>
#include <vector>

namespace palpate::spacemouse {

/// Reads spacemouse.json from the first folder that contains one: an object with any of speed_mm_per_s,
/// turn_rad_per_s, dead_zone, stale_after_s, reach_mm. Returns the defaults without a file.
[[nodiscard]] core::Result<RateSettings> readSettings(const std::vector<std::filesystem::path>& folders);

} // namespace palpate::spacemouse
