// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Settings.h"

#include <palpate/core/Status.h>

#include <memory>
#include <string>

namespace palpate::forcedimension {

/// Functions of the maker's library DHD, version 3, resolved at run time. Metres, newtons, radians. Success is a result
/// of at least 0: reads return kTimeGuard when the position is still the last one, force calls return a positive value
/// when motors saturate. The last argument is the device: -1 would be the device opened last, so that each call of the
/// plugin names its device.
/// @par Source Prototypes and constants: dhdc.h of the SDK 3.7 (as in WPI-AIM/ambf) and the Python binding for 3.16
/// (EmDash00/forcedimension_core-python), which agree.
/// @par Thread The maker states that the library is thread-safe. Calls block on USB.
struct Dhd
{
    static constexpr int kTimeGuard = 1;
    static constexpr int kStatusCount = 32; ///< the library writes 16; room for more of later versions

    int (*getDeviceCount)() = nullptr;
    int (*openID)(char index) = nullptr;
    int (*openSerial)(int serial) = nullptr;
    int (*close)(char id) = nullptr;
    int (*stop)(char id) = nullptr; ///< forces off, brakes on
    int (*getPosition)(double* x, double* y, double* z, char id) = nullptr;
    int (*getPositionAndOrientationFrame)(double* x, double* y, double* z, double R[3][3], char id) = nullptr;
    int (*setForce)(double x, double y, double z, char id) = nullptr;
    int (*setForceAndTorqueAndGripperForce)(double x, double y, double z, double tx, double ty, double tz,
                                            double gripper, char id) = nullptr;
    int (*enableForce)(unsigned char isOn, char id) = nullptr;
    int (*setGravityCompensation)(int isOn, char id) = nullptr;
    unsigned (*getButtonMask)(char id) = nullptr;
    int (*getSystemType)(char id) = nullptr;
    const char* (*getSystemName)(char id) = nullptr; ///< may return a null pointer
    int (*getSerialNumber)(unsigned short* serial, char id) = nullptr;
    int (*getStatus)(int* status, char id) = nullptr;
    bool (*hasWrist)(char id) = nullptr;
    bool (*hasGripper)(char id) = nullptr;
    int (*errorGetLast)() = nullptr; ///< of the calling thread
    const char* (*errorGetLastStr)() = nullptr;

    // Null where the library lacks them.
    int (*enableExpertMode)() = nullptr;
    int (*setWatchdog)(unsigned char units, char id) = nullptr; ///< units of 125 us, 0: off
    int (*emulateButton)(unsigned char isOn, char id) = nullptr;
    double (*getMaxForce)(char id) = nullptr; ///< [N]; negative: no limit is set
    int (*setMaxForce)(double limit_N, char id) = nullptr;
    void (*getSDKVersion)(int* major, int* minor, int* release, int* revision) = nullptr;
};

/// Indices into the status array of `getStatus`.
enum DhdStatus : int
{
    kStatusPower = 0,
    kStatusConnected = 1,
    kStatusReset = 3,
    kStatusForce = 5,
    kStatusBrake = 6,
    kStatusError = 9,
    kStatusWristInit = 12,
    kStatusForceOffCause = 14,
};

/// Reasons for forces being off, in `kStatusForceOffCause`.
enum class ForceOffCause : int
{
    None = 0,
    Button = 1,
    Velocity = 2,
    Watchdog = 3,
    Software = 4,
    Usb = 5,
    DeadMan = 6,
};

/// Opens the library and resolves its functions.
/// @return NotFound, Unreadable, Mismatch or BadCommandLine with the next step
[[nodiscard]] core::Result<std::shared_ptr<const Dhd>> loadDhd(const Settings& settings);

/// Describes the last error of the calling thread, after an opening of a device failed.
[[nodiscard]] core::Message openingError(const Dhd& dhd);

} // namespace palpate::forcedimension
