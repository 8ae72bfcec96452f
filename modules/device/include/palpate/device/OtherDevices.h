// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::device {

/// A haptic device on the USB that Palpate knows and cannot drive.
struct OtherDevice
{
    std::string name;
    std::string needs; ///< what it would take, one sentence
};

/// Recognises 3D Systems Touch, Novint Falcon, Haply Inverse3 and Force Dimension devices by vendor, product and the
/// names that they state. Any thread but the servo thread.
/// @param usb  folder of the kernel's list of USB devices; one that is not there holds none
[[nodiscard]] std::vector<OtherDevice> recogniseOtherDevices(const std::filesystem::path& usb = "/sys/bus/usb/devices");

} // namespace palpate::device
