// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Settings.h"

#include <vendor/DeviceModel.h>

namespace palpate::forcedimension {

/// Returns the model of a system type of the maker's library. A type without published limits gets cautious ones, so
/// that a new model works at once, weakly.
/// @par Source Types: dhdc.h of the SDK 3.7 and the bindings for 3.16. Limits: device table of CHAI3D
/// (CDeltaDevices.cpp); resolutions as in `device::devicePresets`.
[[nodiscard]] vendor::DeviceModel modelOf(int systemType);

/// Applies the limits of the user's settings. Published limits can only be lowered.
/// @param reportedForce_N  the device's own force limit; not positive or not finite: unknown
[[nodiscard]] vendor::DeviceModel limited(vendor::DeviceModel model, const Settings& settings, double reportedForce_N);

} // namespace palpate::forcedimension
