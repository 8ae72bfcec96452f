// SPDX-License-Identifier: BSD-3-Clause
#include "Hd.h"

#include "Configurations.h"

#include <vendor/VendorLibrary.h>

#include <string>
#include <utility>

namespace palpate::openhaptics {

using core::Status;
using core::StatusCode;

namespace {

constexpr core::MessageText<> kRemedy =
    PALPATE_TEXT("install OpenHaptics and the Touch driver of 3D Systems, or set \"library\" in "
                 "~/.config/Palpate/openhaptics.json to the path of libHD.so.3.4; see the page \"devices\" of the "
                 "documentation");

vendor::LibraryKind hdKind()
{
    // The last two names also find other versions, which are then refused by their number and not as missing.
    return {"openhaptics",
            {"libHD.so.3.4", "libHD.so.3.0", "libHD.so.3", "libHD.so"},
            {"/usr/local/lib", "/usr/lib", "/usr/lib64", "/usr/lib/x86_64-linux-gnu"},
            kRemedy,
            {"/opt/OpenHaptics"}};
}

locale_t cLocale() noexcept
{
    static const locale_t locale = newlocale(LC_ALL_MASK, "C", nullptr); // never freed: threads of the library use it
    return locale;
}

} // namespace

NumericLocale::NumericLocale() noexcept
    : m_before(uselocale(cLocale()))
{
}

NumericLocale::~NumericLocale()
{
    uselocale(m_before);
}

core::Result<std::shared_ptr<const Hd>> loadHd(const Settings& settings)
{
    const NumericLocale locale;
    auto opened = vendor::VendorLibrary::open(hdKind(), settings.library);
    if (!opened.isOk()) {
        return opened.status();
    }
    vendor::VendorLibrary& library = opened.value();
    auto hd = std::make_shared<Hd>();
    library.require("hdInitDevice", hd->initDevice)
        .require("hdDisableDevice", hd->disableDevice)
        .require("hdMakeCurrentDevice", hd->makeCurrentDevice)
        .require("hdBeginFrame", hd->beginFrame)
        .require("hdEndFrame", hd->endFrame)
        .require("hdGetError", hd->getError)
        .require("hdGetErrorString", hd->getErrorString)
        .require("hdEnable", hd->enable)
        .require("hdDisable", hd->disable)
        .require("hdIsEnabled", hd->isEnabled)
        .require("hdGetIntegerv", hd->getIntegerv)
        .require("hdGetDoublev", hd->getDoublev)
        .require("hdSetDoublev", hd->setDoublev)
        .require("hdGetString", hd->getString)
        .require("hdCheckCalibration", hd->checkCalibration)
        .require("hdUpdateCalibration", hd->updateCalibration)
        .require("hdStartScheduler", hd->startScheduler)
        .require("hdStopScheduler", hd->stopScheduler)
        .require("hdScheduleAsynchronous", hd->scheduleAsynchronous)
        .require("hdUnschedule", hd->unschedule)
        .find("hdSetSchedulerRate", hd->setSchedulerRate);
    if (Status status = library.status(); !status.isOk()) {
        return status;
    }
    return std::shared_ptr<const Hd>(std::move(hd));
}

Status checkVersion(const Hd& hd)
{
    const char* const stated = hd.getString(kVersion);
    (void)takeErrors(hd);
    const std::string version = stated == nullptr ? "" : stated;
    const bool isNumber = !version.empty() && version.front() >= '0' && version.front() <= '9';
    if (!isNumber || version == "3" || version.starts_with("3.")) {
        return {};
    }
    return {StatusCode::Mismatch, PALPATE_TEXT("openhaptics: libHD is version %1, expected version 3; %2"), version,
            core::Message(kRemedy)};
}

HdError takeErrors(const Hd& hd) noexcept
{
    HdError oldest;
    for (int i = 0; i < kMostErrors; ++i) {
        const HdError error = hd.getError();
        if (error.code == kSuccess) {
            break;
        }
        oldest = error;
    }
    return oldest;
}

core::Message openingError(const Hd& hd, const HdError& error)
{
    switch (error.code) {
    case kInvalidLicense:
        return {PALPATE_TEXT("the licence of OpenHaptics is missing or has expired: install the licence with the "
                             "maker's tools")};
    case kDeviceAlreadyInitiated:
        return {PALPATE_TEXT("it is not free: close other programs that use it")};
    case kCommError:
        return {PALPATE_TEXT("it does not answer: connect its cable and its power supply, install Palpate's udev rule "
                             "(in lib/udev/rules.d), and plug it in again")};
    case kCommConfigError:
    case kBadHandle:
        return {PALPATE_TEXT("its configuration does not fit: run the maker's Touch_Setup; configurations are read "
                             "from %1"),
                configurationFolder()};
    case kDeviceFault:
        return {PALPATE_TEXT("it reports a fault: disconnect its power supply, wait five seconds, and connect it "
                             "again")};
    default:
        break;
    }
    const char* const text = hd.getErrorString(error.code);
    return {PALPATE_TEXT("error %1 of libHD (%2): run the maker's Touch_Diagnostic; configurations are read from %3"),
            error.code, text == nullptr || text[0] == '\0' ? "-" : text, configurationFolder()};
}

} // namespace palpate::openhaptics
