// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Settings.h"

#include <palpate/core/Status.h>

#include <clocale>
#include <memory>

namespace palpate::openhaptics {

/// An error of the library, as the library returns it by value.
struct HdError
{
    unsigned code = 0;
    int internal = 0;
    unsigned device = 0;
};
static_assert(sizeof(HdError) == 12);

/// Functions of the maker's library HDAPI (OpenHaptics 3), resolved at run time. Millimetres, newtons, N/mm, N s/mm.
/// Every get and set acts on the current device, within a frame of this device.
/// @par Source Prototypes and constants: headers of OpenHaptics 3.0.66 (as in hhmai/PhantomAPI) and a Unity binding,
/// which agree.
struct Hd
{
    using Device = unsigned;
    using Callback = unsigned (*)(void*);

    static constexpr Device kNoDevice = 0xFFFFFFFFU;
    static constexpr unsigned kCallbackDone = 0; ///< a callback is not called again
    static constexpr unsigned kCallbackContinue = 1;
    static constexpr unsigned short kDefaultPriority = 32767;

    Device (*initDevice)(const char* name) = nullptr; ///< null: the default device
    void (*disableDevice)(Device device) = nullptr;
    void (*makeCurrentDevice)(Device device) = nullptr;
    void (*beginFrame)(Device device) = nullptr;
    void (*endFrame)(Device device) = nullptr;
    HdError (*getError)() = nullptr; ///< newest first, and removes it
    const char* (*getErrorString)(unsigned code) = nullptr;
    void (*enable)(unsigned capability) = nullptr;
    void (*disable)(unsigned capability) = nullptr;
    unsigned char (*isEnabled)(unsigned capability) = nullptr;
    void (*getIntegerv)(unsigned name, int* value) = nullptr;
    void (*getDoublev)(unsigned name, double* values) = nullptr;
    void (*setDoublev)(unsigned name, const double* values) = nullptr;
    const char* (*getString)(unsigned name) = nullptr;
    unsigned (*checkCalibration)() = nullptr;
    void (*updateCalibration)(unsigned style) = nullptr;
    void (*startScheduler)() = nullptr;
    void (*stopScheduler)() = nullptr;
    unsigned long (*scheduleAsynchronous)(Callback callback, void* data, unsigned short priority) = nullptr;
    void (*unschedule)(unsigned long scheduled) = nullptr;

    // Null where the library lacks it.
    void (*setSchedulerRate)(unsigned long rate_Hz) = nullptr;
};

/// Names of values, for gets and sets.
enum HdName : unsigned
{
    kCurrentButtons = 0x2000,
    kCurrentPosition = 0x2050,
    kCurrentTransform = 0x2052,
    kVersion = 0x2500,
    kModelType = 0x2501,
    kSerialNumber = 0x2504,
    kUsableWorkspace = 0x2551,
    kCalibrationStyle = 0x2555,
    kNominalMaxStiffness = 0x2602,
    kNominalMaxForce = 0x2603,
    kNominalMaxContinuousForce = 0x2604,
    kNominalMaxDamping = 0x2609,
    kCurrentForce = 0x2700,
    kForceOutput = 0x4000,
    kMaxForceClamping = 0x4001,
    kForceRamping = 0x4002,
};

enum HdCalibration : unsigned
{
    kCalibrationOk = 0x5000,
    kCalibrationNeedsUpdate = 0x5001,
    kCalibrationNeedsManualInput = 0x5002,
};

/// Styles of calibration: bits of `kCalibrationStyle`.
enum HdCalibrationStyle : unsigned
{
    kEncoderReset = 1,
    kAutomatic = 2,
    kInkwell = 4,
};

enum HdErrorCode : unsigned
{
    kSuccess = 0,
    kBadHandle = 0x0104,
    kWarmMotors = 0x0200,
    kExceededMaxForce = 0x0201,
    kExceededMaxForceImpulse = 0x0202,
    kExceededMaxVelocity = 0x0203,
    kForceError = 0x0204,
    kDeviceFault = 0x0300,
    kDeviceAlreadyInitiated = 0x0301,
    kCommError = 0x0302,
    kCommConfigError = 0x0303,
    kIllegalBegin = 0x0400,
    kInvalidLicense = 0x0600,
};

/// Sets the C locale for the calling thread while an object lives. The library reads configurations and tables with the
/// C library's functions, which expect a decimal comma under many locales: joint angles then stay zero.
/// @par Real-time Wait-free after the first object.
class NumericLocale
{
  public:
    NumericLocale() noexcept;
    ~NumericLocale();
    NumericLocale(const NumericLocale&) = delete;
    NumericLocale& operator=(const NumericLocale&) = delete;

  private:
    locale_t m_before;
};

/// Opens the library and resolves its functions.
/// @return NotFound, Unreadable, Mismatch or BadCommandLine with the next step
[[nodiscard]] core::Result<std::shared_ptr<const Hd>> loadHd(const Settings& settings);

/// Checks the version that the library states once a device is open; a library without a version passes.
/// @return Mismatch with the next step
[[nodiscard]] core::Status checkVersion(const Hd& hd);

/// Errors that are taken at once: a library that never runs out of errors must not stop the program.
inline constexpr int kMostErrors = 64;

/// Removes all pending errors. @return the oldest, usually the cause of the others; code 0: none
HdError takeErrors(const Hd& hd) noexcept;

/// Describes why a device could not be opened, with the next step.
[[nodiscard]] core::Message openingError(const Hd& hd, const HdError& error);

} // namespace palpate::openhaptics
