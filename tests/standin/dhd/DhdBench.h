// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SharedBench.h"

#include <array>
#include <cstdint>
#include <pthread.h>

/// Emulated devices of Force Dimension: a plain struct in a file shared between processes, so that a device outlives
/// the process that drives it. Guarded by `lock`. Everything here is in metres, newtons and the user frame U (x right,
/// y up, z towards the user); the stand-in library converts to the axes of the maker's library.
namespace standin {

/// Faults of the library, for one device.
struct DhdFaults
{
    std::int64_t blockEach_ns = 0;   ///< each position read blocks for this long
    std::int64_t stallUntil_ns = 0;  ///< every call blocks until then
    bool isEverySecondEarly = false; ///< every second position read reports TIMEGUARD
    bool isSaturated = false;        ///< force calls report MOTOR_SATURATED
    int error = 0;                   ///< every call fails with this error
    double failing = 0.0;            ///< probability that a call fails
    bool isFrozen = false;           ///< positions do not change
    double jump_m = 0.0;             ///< added to positions
    bool isPoisoned = false;         ///< positions are `poison`
    double poison = 0.0;
    bool hasNoWatchdog = false; ///< the watchdog cannot be set
    int openError = 0;          ///< opening fails with this error
};

/// A force call.
struct DhdForce
{
    std::int64_t time_ns = 0;
    V3 f{};
};

/// A position read.
struct DhdSample
{
    std::int64_t time_ns = 0;
    V3 p{};
};

struct DhdDevice : HeldTip
{
    int type = 33; ///< omega.3
    int serial = 1001;
    bool hasName = true;
    bool hasWrist = false;
    bool hasGripper = false;
    bool isGripperAButton = false; ///< set by dhdEmulateButton
    double reportedForce_N = -1.0; ///< answer of dhdGetMaxForce
    V3 turn{};                     ///< axis of the handle's orientation times angle, in the library's frame
    unsigned buttons = 0;

    // State of the controller.
    bool isPlugged = true;
    std::uint32_t plugins = 0; ///< number of times plugged in; handles from before fail
    bool hasPower = true;
    bool isReset = false;
    bool isForceOn = false;
    int offCause = 0;
    unsigned watchdog = 0; ///< units of 125 us; 0: off
    double velocityLimit_m_per_s = 0.5;
    int owner = 0; ///< process that has the device open; 0: none
    std::int64_t lastForce_ns = 0;
    V3 f{}; ///< of the motors

    // Observations.
    double largestForce_N = 0.0;
    std::int64_t longestSilence_ns = 0; ///< longest time that motors drove without a new force call
    std::uint64_t watchdogs = 0;
    std::uint64_t enablings = 0; ///< calls that enabled forces
    std::uint64_t forceCount = 0, sampleCount = 0;
    std::array<DhdForce, 4096> forces{};
    std::array<DhdSample, 4096> samples{};

    DhdFaults faults;
};

inline DhdDevice secondDhd()
{
    DhdDevice device;
    device.serial = 1002;
    return device;
}

struct DhdBench
{
    std::uint64_t magic = 0;
    pthread_mutex_t lock;
    std::uint64_t random = 1;
    std::int64_t sim_ns = 0;
    int sdkMajor = 3;
    int count = 1;                  ///< devices on the bus, of `devices`
    std::array<int, 2> order{0, 1}; ///< index on the bus -> device
    std::array<DhdDevice, 2> devices{DhdDevice{}, secondDhd()};
    std::uint64_t unnamedCalls = 0; ///< calls for the default device, which changes with each opening
    std::uint64_t lateCalls = 0;    ///< calls with a closed handle
};

inline constexpr std::uint64_t kDhdMagic = 0x70616c7064686431; ///< of an initialised bench

/// Advances the mechanics and the watchdogs to `now_ns`.
void advanceDhd(DhdBench& bench, std::int64_t now_ns);
/// Unplugs the device, or plugs it in.
void plugDhd(DhdDevice& device, bool isPlugged);
/// The user presses the device's force button.
void pressForceButton(DhdDevice& device);
void setMotors(DhdDevice& device, const V3& f);

} // namespace standin
