// SPDX-License-Identifier: BSD-3-Clause
#include "DhdBench.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fcntl.h>
#include <new>
#include <sys/file.h>
#include <sys/mman.h>
#include <unistd.h>

namespace standin {

namespace {

constexpr std::uint64_t kDhdMagic = 0x70616c7064686431;
constexpr std::int64_t kStep_ns = 100'000;
constexpr std::int64_t kLongestGap_ns = 20'000'000'000;
constexpr std::int64_t kWatchdogUnit_ns = 125'000;
constexpr std::int64_t kGravitySilence_ns = 20'000'000;
constexpr double kGravity_m_per_s2 = 9.81;
constexpr double kBrake_Ns_per_m = 40.0;
// As the hand of the other stand-in (Bench.h).
constexpr double kGripStiffness_N_per_m = 500.0;
constexpr double kGripDamping_Ns_per_m = 5.0;
constexpr double kGripMass_kg = 0.1;
constexpr int kVelocityCause = 2;
constexpr int kWatchdogCause = 3;

double length(const V3& v)
{
    return std::hypot(v[0], v[1], v[2]);
}

void forcesOff(DhdDevice& device, int cause)
{
    device.isForceOn = false;
    device.offCause = cause;
    setMotors(device, {});
}

void step(DhdDevice& device, std::int64_t now_ns)
{
    const double dt_s = static_cast<double>(kStep_ns) * 1e-9;
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
    const double since_s = static_cast<double>(now_ns - device.begin_ns) * 1e-9;
    const double u = device.duration_s > 0.0 ? std::clamp(since_s / device.duration_s, 0.0, 1.0) : 1.0;
    const double share = u * u * u * (10.0 + u * (-15.0 + 6.0 * u));
    const double rate = device.duration_s > 0.0 ? 30.0 * u * u * (1.0 - u) * (1.0 - u) / device.duration_s : 0.0;
    // The library compensates gravity with each force that it sends.
    const bool isSinking = !device.isForceOn || silence_ns > kGravitySilence_ns;
    const double mass_kg = device.mass_kg + (device.isHeld ? kGripMass_kg : 0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        double f = device.f[i] - device.viscosity_Ns_per_m * device.v[i];
        f -= device.isForceOn ? 0.0 : kBrake_Ns_per_m * device.v[i];
        f -= isSinking && i == 1 ? device.mass_kg * kGravity_m_per_s2 : 0.0;
        if (device.isHeld) {
            const double way = device.to[i] - device.from[i];
            f += kGripStiffness_N_per_m * (device.from[i] + way * share - device.p[i]) +
                 kGripDamping_Ns_per_m * (way * rate - device.v[i]);
        }
        device.v[i] += f / mass_kg * dt_s;
        device.p[i] += device.v[i] * dt_s;
    }
}

} // namespace

void setMotors(DhdDevice& device, const V3& f)
{
    device.f = device.isForceOn && device.isPlugged && device.hasPower && !device.isReset ? f : V3{};
    device.largestForce_N = std::max(device.largestForce_N, length(device.f));
}

double drawDhd(DhdBench& bench)
{
    // xorshift64*: the same faults for the same seed.
    bench.random ^= bench.random >> 12;
    bench.random ^= bench.random << 25;
    bench.random ^= bench.random >> 27;
    return static_cast<double>((bench.random * 0x2545F4914F6CDD1DULL) >> 11) / 9007199254740992.0;
}

void advanceDhd(DhdBench& bench, std::int64_t now_ns)
{
    if (bench.sim_ns == 0) {
        bench.sim_ns = now_ns / kStep_ns * kStep_ns;
    }
    bench.sim_ns = std::max(bench.sim_ns, (now_ns - kLongestGap_ns) / kStep_ns * kStep_ns);
    while (bench.sim_ns + kStep_ns <= now_ns) {
        bench.sim_ns += kStep_ns;
        for (DhdDevice& device : bench.devices) {
            step(device, bench.sim_ns);
        }
    }
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

DhdBench* openDhdBench(const char* path)
{
    const int file = path == nullptr ? -1 : open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0) {
        return nullptr;
    }
    flock(file, LOCK_EX); // two processes may start simultaneously
    DhdBench* bench = nullptr;
    if (ftruncate(file, sizeof(DhdBench)) == 0) {
        void* memory = mmap(nullptr, sizeof(DhdBench), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        if (memory != MAP_FAILED) {
            bench = static_cast<DhdBench*>(memory);
            if (bench->magic != kDhdMagic) {
                new (bench) DhdBench;
                bench->devices[1].serial = 1002;
                pthread_mutexattr_t attributes;
                pthread_mutexattr_init(&attributes);
                pthread_mutexattr_setpshared(&attributes, PTHREAD_PROCESS_SHARED);
                pthread_mutexattr_setrobust(&attributes, PTHREAD_MUTEX_ROBUST); // a lock holder may be killed
                pthread_mutex_init(&bench->lock, &attributes);
                pthread_mutexattr_destroy(&attributes);
                bench->magic = kDhdMagic;
            }
        }
    }
    flock(file, LOCK_UN);
    close(file);
    return bench;
}

void lockDhd(DhdBench& bench)
{
    if (pthread_mutex_lock(&bench.lock) == EOWNERDEAD) {
        pthread_mutex_consistent(&bench.lock);
    }
}

void unlockDhd(DhdBench& bench)
{
    pthread_mutex_unlock(&bench.lock);
}

} // namespace standin
