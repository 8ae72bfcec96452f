// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SharedBench.h"

#include <array>
#include <cstdint>
#include <pthread.h>

/// Emulated devices of 3D Systems: a plain struct in a file shared between processes, so that a device outlives the
/// process that drives it. Guarded by `lock`. Everything here is in metres, newtons and the user frame U (x right, y
/// up, z towards the user), as are the axes of the maker's library, which works in millimetres.
namespace standin {

/// What the library does wrong, for one device.
struct HdFaults
{
    unsigned initError = 0;        ///< opening fails with this error
    unsigned frameError = 0;       ///< pushed in the middle of each frame
    std::uint64_t frameErrors = 0; ///< number of frames with `frameError`; 0: all
    unsigned callError = 0;        ///< every call that reads or writes the device fails with this error
    double failing = 0.0;          ///< probability that reading the position fails
    std::int64_t blockEach_ns = 0; ///< each reading of the position blocks for this long
    bool isFrozen = false;         ///< positions do not change
    double jump_mm = 0.0;          ///< added to positions
    bool isPoisoned = false;       ///< positions are `poison`
    double poison = 0.0;
    bool isFrameLeftOpen = false; ///< the next begin of a frame fails once
    bool disablesForces = false;  ///< after an error the library switches forces off
};

/// What the library's scheduler does wrong.
struct HdSchedulerFaults
{
    std::int64_t stallUntil_ns = 0; ///< no callback until then
    std::int64_t lateMost_ns = 0;   ///< random delay of each callback
    bool isDoubled = false;         ///< each callback is called twice
    bool isBursting = false;        ///< 20 callbacks at once, every 20 ms
    bool callsAfterStop = false;    ///< calls three times more after it was stopped
    bool isDead = false;            ///< its thread ends
};

/// A force that reached the device.
struct HdForce
{
    std::int64_t time_ns = 0;
    V3 f{};
};

/// The position at the begin of a frame.
struct HdSample
{
    std::int64_t time_ns = 0;
    V3 p{};
};

struct HdDevice : HeldTip
{
    std::array<char, 32> name{"Default Device"}; ///< of the configuration
    std::array<char, 32> model{"Touch"};
    std::array<char, 32> serial{"110-01"};
    bool statesLimits = true; ///< false: asking for a limit is an error
    double maxForce_N = 3.3;
    double continuousForce_N = 0.88;
    double maxStiffness_N_per_mm = 0.5;
    double maxDamping_Ns_per_mm = 0.005;
    std::array<double, 6> workspace_mm{-80, -60, -35, 80, 60, 35};
    V3 turn{}; ///< axis of the stylus's orientation times angle
    int buttons = 0;
    int styles = 4;                ///< of calibration: the inkwell
    unsigned calibration = 0x5000; ///< answer of hdCheckCalibration
    double offset_mm = 0.0;        ///< of positions until calibrated

    // State of the controller.
    bool isPlugged = true;
    std::uint32_t plugins = 0; ///< number of times plugged in; handles from before fail
    int owner = 0;             ///< process that has the device open; 0: none
    bool isForceOn = false;
    bool isClamping = false;
    V3 f{}; ///< of the motors
    std::int64_t lastForce_ns = 0;
    std::int64_t watchdog_ns = 9'000'000; ///< the motors stop after this time without a frame

    // Observations.
    double largestForce_N = 0.0;        ///< asked for, before the library clamps
    std::int64_t longestSilence_ns = 0; ///< longest time that motors drove without a new force
    std::uint64_t watchdogs = 0;
    std::uint64_t calibrations = 0;
    unsigned calibrationStyle = 0; ///< of the last calibration
    std::uint64_t inits = 0;
    std::uint64_t forceCount = 0, sampleCount = 0;
    std::array<HdForce, 4096> forces{};
    std::array<HdSample, 4096> samples{};

    HdFaults faults;
};

/// A second device, for tests with two.
inline HdDevice secondHd()
{
    HdDevice device;
    device.name = {"Left Device"};
    device.serial = {"110-02"};
    return device;
}

struct HdBench
{
    std::uint64_t magic = 0;
    pthread_mutex_t lock;
    std::uint64_t random = 1;
    std::int64_t sim_ns = 0;
    std::array<char, 16> version{"3.4.0"};
    double rate_Hz = 1000.0; ///< of the scheduler, which accepts no other
    std::array<HdDevice, 2> devices{HdDevice{}, secondHd()};
    HdSchedulerFaults scheduler;
    std::uint64_t misuses = 0; ///< calls without a frame, for the wrong device, with a closed handle
    std::array<char, 64> lastMisuse{};
};

inline constexpr std::uint64_t kHdMagic = 0x70616c7068646431; ///< of an initialised bench

/// Advances the mechanics and the watchdogs to `now_ns`.
void advanceHd(HdBench& bench, std::int64_t now_ns);
/// Unplugs the device, or plugs it in.
void plugHd(HdDevice& device, bool isPlugged);

} // namespace standin
