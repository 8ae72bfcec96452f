// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::device {

/// USB haptic device that does not work with Palpate alone.
struct OtherDevice
{
    std::string name;
    std::string needs;  ///< requirements, part of a sentence
    std::string plugin; ///< id of the plugin that drives the device when the requirements are met; empty: none
};

/// Recognises 3D Systems Touch, Novint Falcon, Haply Inverse3 and Force Dimension devices by USB vendor, product and
/// name strings, whether or not a plugin drives them now. Any thread except the servo thread.
/// @param usb  sysfs folder with the USB devices; a missing folder gives an empty result
[[nodiscard]] PALPATE_EXPORT std::vector<OtherDevice>
recogniseOtherDevices(const std::filesystem::path& usb = "/sys/bus/usb/devices");

} // namespace palpate::device
