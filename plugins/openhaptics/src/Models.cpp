// SPDX-License-Identifier: BSD-3-Clause
#include "Models.h"

#include <palpate/device/DevicePresets.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace palpate::openhaptics {

namespace {

constexpr double kCautiousForce_N = 3.0;
// Of a device that states no continuous force: about the share of the maximum that the published figures of the Touch
// and the Phantom Desktop have (0.88 of 3.3 N, 1.75 of 7.9 N), rounded down.
constexpr double kContinuousShare = 0.2;
constexpr double kFarthestCentre_mm = 300.0;
constexpr double kLeastRadius_mm = 20.0;
constexpr double kMostRadius_mm = 300.0;

std::string lowerCase(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

vendor::DeviceModel publishedModel(const std::string& stated)
{
    const std::string model = lowerCase(stated);
    const auto has = [&model](const char* part) { return model.find(part) != std::string::npos; };
    if (has("premium")) {
        if (has("1.5") && !has("hf") && !has("high")) {
            return vendor::presetModel("phantom-premium-1.5", "Phantom Premium 1.5");
        }
    } else if (has("desktop") || has("touch x") || has("touchx")) {
        return vendor::presetModel("phantom-desktop", has("touch") ? "Touch X" : "Phantom Desktop");
    } else if (has("omni") || has("touch")) {
        return vendor::presetModel("touch", has("omni") ? "Phantom Omni" : "Touch");
    }
    return {"3D Systems device", kCautiousForce_N, 0.3, 0.004, 0.055, 75.0, core::Vec3::Zero(), false};
}

bool isStated(double value)
{
    return std::isfinite(value) && value > 0.0;
}

/// Takes centre and size of the usable workspace, if the numbers can be those of a device.
void applyWorkspace(const Statement& statement, vendor::DeviceModel& model)
{
    const core::Vec3 half_mm = 0.5 * (statement.most_mm - statement.least_mm);
    const core::Vec3 centre_mm = 0.5 * (statement.most_mm + statement.least_mm);
    const double radius_mm = half_mm.mean(); // the workspaces of these devices are flat boxes, not balls
    if (!half_mm.allFinite() || !centre_mm.allFinite() || !(half_mm.minCoeff() > 0.0) ||
        centre_mm.norm() > kFarthestCentre_mm || radius_mm < kLeastRadius_mm || radius_mm > kMostRadius_mm) {
        return;
    }
    model.centre_mm = centre_mm;
    model.workspaceRadius_mm = model.isKnown ? std::min(model.workspaceRadius_mm, radius_mm) : radius_mm;
}

} // namespace

Limits limitsOf(const Statement& statement, const Settings& settings)
{
    vendor::DeviceModel model = publishedModel(statement.model);
    if (!model.isKnown && isStated(statement.maxForce_N)) {
        model.maxForce_N = device::kShownForceLimit_N;
        model.isKnown = true; // from the device
    }
    vendor::lowerTo(statement.maxForce_N, model.maxForce_N);
    vendor::lowerTo(statement.maxStiffness_N_per_mm, model.maxStiffness_N_per_mm);
    vendor::lowerTo(statement.maxDamping_Ns_per_mm, model.maxDamping_Ns_per_mm);
    applyWorkspace(statement, model);
    Limits limits{vendor::limited(model, settings), 0.0};
    const double share_N = kContinuousShare * limits.maxForce_N;
    limits.continuousForce_N =
        isStated(statement.continuousForce_N) ? std::min(statement.continuousForce_N, limits.maxForce_N) : share_N;
    return limits;
}

} // namespace palpate::openhaptics
