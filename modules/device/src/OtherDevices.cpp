// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/device/OtherDevices.h"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <system_error>

namespace palpate::device {

namespace {

struct Known
{
    std::string_view vendor;  ///< four hexadecimal digits; empty: any
    std::string_view product; ///< four hexadecimal digits; empty: any
    std::string_view stated;  ///< substring of the manufacturer or product name; empty: any
    std::string_view name;
    std::string_view needs;
    std::string_view plugin = {}; ///< as in OtherDevice
};

constexpr std::string_view kTouchNeeds =
    "its maker's Touch driver and OpenHaptics, which are closed: Palpate would need a plugin that is built on them";
constexpr std::string_view kFalconNeeds =
    "a plugin that speaks to its FTDI chip and loads its firmware at each start, as libnifalcon does";
constexpr std::string_view kInverseNeeds = "its maker's Inverse Service (version 3.1 or later) running, as the page "
                                           "\"devices\" of the documentation describes";
constexpr std::string_view kForceDimensionNeeds = "its maker's library libdhd.so.3 (Force Dimension SDK 3) and access "
                                                  "to USB through Palpate's udev rule, as the page "
                                                  "\"devices\" of the documentation describes";

constexpr Known kKnown[] = {
    {"2988", "", "", "3D Systems Touch", kTouchNeeds},
    {"0301", "2988", "", "3D Systems Touch", kTouchNeeds},
    {"", "", "3D Systems", "3D Systems Touch", kTouchNeeds},
    {"", "", "SensAble", "SensAble PHANToM", kTouchNeeds},
    {"0403", "cb48", "", "Novint Falcon", kFalconNeeds},
    {"", "", "Haply", "Haply Inverse3", kInverseNeeds, "haply"},
    {"", "", "Inverse3", "Haply Inverse3", kInverseNeeds, "haply"},
    {"1451", "", "", "Force Dimension", kForceDimensionNeeds, "forcedimension"},
    {"", "", "Force Dimension", "Force Dimension", kForceDimensionNeeds, "forcedimension"},
};

std::string firstLine(const std::filesystem::path& file)
{
    std::string line;
    std::ifstream stream(file);
    std::getline(stream, line);
    return line;
}

} // namespace

std::vector<OtherDevice> recogniseOtherDevices(const std::filesystem::path& usb)
{
    std::vector<std::filesystem::path> places;
    std::error_code error;
    for (std::filesystem::directory_iterator it(usb, error), end; !error && it != end; it.increment(error)) {
        places.push_back(it->path());
    }
    std::sort(places.begin(), places.end());
    std::vector<OtherDevice> found;
    for (const std::filesystem::path& place : places) {
        const std::string vendor = firstLine(place / "idVendor");
        if (vendor.empty()) {
            continue; // USB interface or hub port
        }
        const std::string product = firstLine(place / "idProduct");
        const std::string stated = firstLine(place / "manufacturer") + '\n' + firstLine(place / "product");
        for (const Known& known : kKnown) {
            if ((known.vendor.empty() || known.vendor == vendor) &&
                (known.product.empty() || known.product == product) &&
                (known.stated.empty() || stated.find(known.stated) != std::string::npos)) {
                found.push_back({std::string(known.name), std::string(known.needs), std::string(known.plugin)});
                break;
            }
        }
    }
    return found;
}

} // namespace palpate::device
