// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/device/DevicePresets.h"

#include <array>

namespace palpate::device {

namespace {

constexpr std::array<DevicePreset, 8> kPresets{{
    {"touch", "Touch", 3.3, 0.4, 0.004, 75.0, {0.045, 0.0005, 0.13, 0.055}},
    {"phantom-desktop", "PHANToM Desktop", 7.9, 1.0, 0.005, 100.0, {0.045, 0.0005, 0.03, 0.023}},
    {"phantom-premium-1.5", "PHANToM Premium 1.5", 8.5, 0.8, 0.005, 120.0, {0.075, 0.0005, 0.02, 0.03}},
    {"phantom-1995", "PHANToM (1995)", 18.0, 0.8, 0.005, 120.0, {0.075, 0.0005, 0.02, 0.03}},
    {"falcon", "Falcon", 8.0, 3.0, 0.020, 40.0, {0.15, 0.001, 0.1, 0.06}},
    {"omega", "omega", 12.0, 5.0, 0.030, 75.0, {0.15, 0.001, 0.05, 0.01}},
    {"delta", "delta", 20.0, 5.0, 0.030, 150.0, {0.25, 0.001, 0.1, 0.03}},
    {"woodenhaptics", "WoodenHaptics", 5.0, 1.0, 0.008, 100.0, {0.1, 0.0005, 0.05, 0.1}},
}};

} // namespace

std::span<const DevicePreset> devicePresets() noexcept
{
    return kPresets;
}

const DevicePreset* findDevicePreset(std::string_view id) noexcept
{
    for (const DevicePreset& preset : kPresets) {
        if (preset.id == id) {
            return &preset;
        }
    }
    return nullptr;
}

DeviceInfo deviceInfo(const DevicePreset& preset)
{
    DeviceInfo info;
    info.id = preset.id;
    info.name = preset.name;
    info.actuatedAxes = 3;
    info.maxForce_N = preset.maxForce_N;
    info.maxStiffness_N_per_mm = preset.maxStiffness_N_per_mm;
    info.maxDamping_Ns_per_mm = preset.maxDamping_Ns_per_mm;
    info.ownDamping_Ns_per_mm = preset.mechanics.damping_Ns_per_mm;
    info.resolution_mm = preset.mechanics.resolution_mm;
    info.workspaceRadius_mm = preset.workspaceRadius_mm;
    return info;
}

} // namespace palpate::device
