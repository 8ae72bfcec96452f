// SPDX-License-Identifier: BSD-3-Clause
#include "Dhd.h"

#include <vendor/VendorLibrary.h>

#include <cstdlib>
#include <string>

namespace palpate::forcedimension {

using core::Status;

namespace {

constexpr int kMajorVersion = 3;

vendor::LibraryKind dhdKind()
{
    vendor::LibraryKind kind{"forcedimension",
                             {"libdhd.so.3", "libdrd.so.3"}, // the second contains the first
                             {"/usr/local/lib", "/usr/lib/x86_64-linux-gnu", "/usr/lib"},
                             PALPATE_TEXT("install the Force Dimension SDK 3 of the maker, or set \"library\" in "
                                          "~/.config/Palpate/forcedimension.json to the path of libdhd.so.3"),
                             {}};
    if (const char* const sdk = std::getenv("FDSDK"); sdk != nullptr && sdk[0] == '/') {
        kind.trees.emplace_back(sdk);
    }
    return kind;
}

} // namespace

core::Result<std::shared_ptr<const Dhd>> loadDhd(const Settings& settings)
{
    auto opened = vendor::VendorLibrary::open(dhdKind(), settings.library);
    if (!opened.isOk()) {
        return opened.status();
    }
    vendor::VendorLibrary& library = opened.value();
    auto dhd = std::make_shared<Dhd>();
    library.require("dhdGetDeviceCount", dhd->getDeviceCount)
        .require("dhdOpenID", dhd->openID)
        .require("dhdOpenSerial", dhd->openSerial)
        .require("dhdClose", dhd->close)
        .require("dhdStop", dhd->stop)
        .require("dhdGetPosition", dhd->getPosition)
        .require("dhdGetPositionAndOrientationFrame", dhd->getPositionAndOrientationFrame)
        .require("dhdSetForce", dhd->setForce)
        .require("dhdSetForceAndTorqueAndGripperForce", dhd->setForceAndTorqueAndGripperForce)
        .require("dhdEnableForce", dhd->enableForce)
        .require("dhdSetGravityCompensation", dhd->setGravityCompensation)
        .require("dhdGetButtonMask", dhd->getButtonMask)
        .require("dhdGetSystemType", dhd->getSystemType)
        .require("dhdGetSystemName", dhd->getSystemName)
        .require("dhdGetSerialNumber", dhd->getSerialNumber)
        .require("dhdGetStatus", dhd->getStatus)
        .require("dhdHasWrist", dhd->hasWrist)
        .require("dhdHasGripper", dhd->hasGripper)
        .require("dhdErrorGetLast", dhd->errorGetLast)
        .require("dhdErrorGetLastStr", dhd->errorGetLastStr)
        .find("dhdEnableExpertMode", dhd->enableExpertMode)
        .find("dhdSetWatchdog", dhd->setWatchdog)
        .find("dhdEmulateButton", dhd->emulateButton)
        .find("dhdGetMaxForce", dhd->getMaxForce)
        .find("dhdSetMaxForce", dhd->setMaxForce)
        .find("dhdGetSDKVersion", dhd->getSDKVersion);
    if (dhd->getSDKVersion != nullptr) {
        int major = 0, minor = 0, release = 0, revision = 0;
        dhd->getSDKVersion(&major, &minor, &release, &revision);
        if (major != kMajorVersion) {
            return library.unsuitable(std::to_string(major) + '.' + std::to_string(minor),
                                      std::to_string(kMajorVersion));
        }
    }
    if (const Status status = library.status(); !status.isOk()) {
        return status;
    }
    return std::shared_ptr<const Dhd>(std::move(dhd));
}

core::Message openingError(const Dhd& dhd)
{
    constexpr int kBusy = 3, kNoDriver = 4, kNoDevice = 5, kNotAvailable = 6, kInUse = 20;
    switch (dhd.errorGetLast()) {
    case kBusy:
    case kNotAvailable:
    case kInUse:
        return {PALPATE_TEXT("it is not free: close other programs that use it")};
    case kNoDriver:
        return {PALPATE_TEXT("access is refused: install Palpate's udev rule (in lib/udev/rules.d) and plug the device "
                             "in again")};
    case kNoDevice:
        return {PALPATE_TEXT("it is not connected: plug it in and switch it on")};
    default:
        break;
    }
    const char* const text = dhd.errorGetLastStr();
    return core::Message::untranslated(text == nullptr ? "?" : text);
}

} // namespace palpate::forcedimension
