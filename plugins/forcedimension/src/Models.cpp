// SPDX-License-Identifier: BSD-3-Clause
#include "Models.h"

namespace palpate::forcedimension {

namespace {

/// @param side  +1: right-handed unit, -1: left-handed
vendor::DeviceModel sigma(std::string_view name, double side)
{
    // CHAI3D adds (-0.01, +-0.02, 0) m to positions of the sigma. Its damping limit is not in that table: the lowest
    // of the maker's other models.
    return {name, 12.0, 4.0, 0.020, 0.01, 75.0, core::Vec3(10.0, -20.0 * side, 0.0), true};
}

} // namespace

vendor::DeviceModel modelOf(int systemType)
{
    switch (systemType) {
    case 63:
        return vendor::presetModel("delta", "delta.3");
    case 64:
        return vendor::presetModel("delta", "delta.6");
    case 33:
        return vendor::presetModel("omega", "omega.3");
    case 34:
    case 36:
        return vendor::presetModel("omega", "omega.6");
    case 35:
    case 37:
        return vendor::presetModel("omega", "omega.7");
    case 60:
        return vendor::presetModel("falcon", "Falcon");
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
    vendor::DeviceModel model{"Force Dimension", 3.0, 0.3, 0.004, 0.05, 100.0, core::Vec3::Zero(), false};
    if (systemType == 108 || systemType == 109) {
        model.name = "lambda.7";
    } else if (systemType == 203) {
        model.name = "lambda.3";
    }
    return model;
}

vendor::DeviceModel limited(vendor::DeviceModel model, const Settings& settings, double reportedForce_N)
{
    model = vendor::limited(model, settings);
    vendor::lowerTo(reportedForce_N, model.maxForce_N);
    return model;
}

} // namespace palpate::forcedimension
