// SPDX-License-Identifier: BSD-3-Clause
#include "DeviceModel.h"

#include <palpate/device/DevicePresets.h>

#include <algorithm>
#include <cmath>

namespace palpate::vendor {

DeviceModel presetModel(std::string_view id, std::string_view name)
{
    const device::DevicePreset& preset = *device::findDevicePreset(id);
    return {name,
            preset.maxForce_N,
            preset.maxStiffness_N_per_mm,
            preset.maxDamping_Ns_per_mm,
            preset.mechanics.resolution_mm,
            preset.workspaceRadius_mm,
            core::Vec3::Zero(),
            true};
}

DeviceModel limited(DeviceModel model, const VendorSettings& settings)
{
    const auto apply = [&model](double stated, double& limit) {
        if (stated > 0.0) {
            limit = model.isKnown ? std::min(stated, limit) : stated;
        }
    };
    apply(settings.maxForce_N, model.maxForce_N);
    apply(settings.maxStiffness_N_per_mm, model.maxStiffness_N_per_mm);
    apply(settings.maxDamping_Ns_per_mm, model.maxDamping_Ns_per_mm);
    apply(settings.workspaceRadius_mm, model.workspaceRadius_mm);
    return model;
}

void lowerTo(double reported, double& limit) noexcept
{
    if (std::isfinite(reported) && reported > 0.0) {
        limit = std::min(limit, reported);
    }
}

} // namespace palpate::vendor
