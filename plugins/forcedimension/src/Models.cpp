// SPDX-License-Identifier: BSD-3-Clause
#include "Models.h"

#include <palpate/device/DevicePresets.h>

#include <algorithm>
#include <cmath>

namespace palpate::forcedimension {

namespace {

Model presetModel(std::string_view id, std::string_view name)
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

/// @param side  +1: right-handed unit, -1: left-handed
Model sigma(std::string_view name, double side)
{
    // CHAI3D adds (-0.01, +-0.02, 0) m to positions of the sigma. Its damping limit is not in that table: the lowest
    // of the maker's other models.
    return {name, 12.0, 4.0, 0.020, 0.01, 75.0, core::Vec3(10.0, -20.0 * side, 0.0), true};
}

} // namespace

Model modelOf(int systemType)
{
    switch (systemType) {
    case 63:
        return presetModel("delta", "delta.3");
    case 64:
        return presetModel("delta", "delta.6");
    case 33:
        return presetModel("omega", "omega.3");
    case 34:
    case 36:
        return presetModel("omega", "omega.6");
    case 35:
    case 37:
        return presetModel("omega", "omega.7");
    case 60:
        return presetModel("falcon", "Falcon");
    case 104:
        return sigma("sigma.7", 1.0);
    case 105:
        return sigma("sigma.7", -1.0);
    case 106:
        return sigma("sigma.6+", 1.0);
    case 107:
        return sigma("sigma.6+", -1.0);
    case 206:
        return sigma("sigma.3", 1.0);
    default:
        break;
    }
    Model model{"Force Dimension", 3.0, 0.3, 0.004, 0.05, 100.0, core::Vec3::Zero(), false};
    if (systemType == 108 || systemType == 109) {
        model.name = "lambda.7";
    } else if (systemType == 203) {
        model.name = "lambda.3";
    }
    return model;
}

Model limited(Model model, const Settings& settings, double reportedForce_N)
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
    if (std::isfinite(reportedForce_N) && reportedForce_N > 0.0) {
        model.maxForce_N = std::min(model.maxForce_N, reportedForce_N);
    }
    return model;
}

} // namespace palpate::forcedimension
