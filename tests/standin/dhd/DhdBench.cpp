// SPDX-License-Identifier: BSD-3-Clause
#include "DhdBench.h"

#include <algorithm>

namespace standin {

namespace {

constexpr std::int64_t kWatchdogUnit_ns = 125'000;
constexpr std::int64_t kGravitySilence_ns = 20'000'000;
constexpr double kGravity_m_per_s2 = 9.81;
constexpr double kBrake_Ns_per_m = 40.0;
constexpr int kVelocityCause = 2;
constexpr int kWatchdogCause = 3;

void forcesOff(DhdDevice& device, int cause)
{
    device.isForceOn = false;
    device.offCause = cause;
    setMotors(device, {});
}

void step(DhdDevice& device, std::int64_t now_ns)
{
    const std::int64_t silence_ns = now_ns - device.lastForce_ns;
    if (device.isForceOn && device.watchdog != 0 && device.lastForce_ns != 0 &&
        silence_ns > static_cast<std::int64_t>(device.watchdog) * kWatchdogUnit_ns) {
        forcesOff(device, kWatchdogCause);
        ++device.watchdogs;
    }
    if (device.isForceOn && length(device.v) > device.velocityLimit_m_per_s) {
        forcesOff(device, kVelocityCause);
    }
    if (length(device.f) > 0.0) {
        device.longestSilence_ns = std::max(device.longestSilence_ns, silence_ns);
    }
    // The library compensates gravity with each force that it sends.
    const bool isSinking = !device.isForceOn || silence_ns > kGravitySilence_ns;
    stepTip(device, device.f, device.isForceOn ? 0.0 : kBrake_Ns_per_m,
            isSinking ? device.mass_kg * kGravity_m_per_s2 : 0.0, now_ns);
}

} // namespace

void setMotors(DhdDevice& device, const V3& f)
{
    device.f = device.isForceOn && device.isPlugged && device.hasPower && !device.isReset ? f : V3{};
    device.largestForce_N = std::max(device.largestForce_N, length(device.f));
}

void advanceDhd(DhdBench& bench, std::int64_t now_ns)
{
    advanceShared(bench, now_ns, step);
}

void plugDhd(DhdDevice& device, bool isPlugged)
{
    device.plugins += isPlugged && !device.isPlugged ? 1 : 0;
    device.isPlugged = isPlugged;
    device.owner = 0;
    device.watchdog = 0;
    device.lastForce_ns = 0;
    forcesOff(device, 0);
}

void pressForceButton(DhdDevice& device)
{
    if (device.isForceOn) {
        forcesOff(device, 1);
    } else {
        device.isForceOn = true;
        device.offCause = 0;
    }
}

} // namespace standin
