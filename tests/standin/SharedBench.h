// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fcntl.h>
#include <new>
#include <pthread.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>

/// What the benches of makers' libraries have in common: a plain struct in a file shared between processes, with
/// members `magic`, `lock`, `random` and `sim_ns`, and the mechanics of a tip that a hand holds.
namespace standin {

using V3 = std::array<double, 3>;

/// Opens the bench in the file `path` and creates the file if missing; null on failure.
/// @param magic  marks an initialised bench
template<class Bench>
Bench* openShared(const char* path, std::uint64_t magic)
{
    const int file = path == nullptr ? -1 : open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0) {
        return nullptr;
    }
    flock(file, LOCK_EX); // two processes may start simultaneously
    Bench* bench = nullptr;
    if (ftruncate(file, sizeof(Bench)) == 0) {
        void* memory = mmap(nullptr, sizeof(Bench), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        if (memory != MAP_FAILED) {
            bench = static_cast<Bench*>(memory);
            if (bench->magic != magic) {
                new (bench) Bench;
                pthread_mutexattr_t attributes;
                pthread_mutexattr_init(&attributes);
                pthread_mutexattr_setpshared(&attributes, PTHREAD_PROCESS_SHARED);
                pthread_mutexattr_setrobust(&attributes, PTHREAD_MUTEX_ROBUST); // a lock holder may be killed
                pthread_mutex_init(&bench->lock, &attributes);
                pthread_mutexattr_destroy(&attributes);
                bench->magic = magic;
            }
        }
    }
    flock(file, LOCK_UN);
    close(file);
    return bench;
}

template<class Bench>
void lockShared(Bench& bench)
{
    if (pthread_mutex_lock(&bench.lock) == EOWNERDEAD) {
        pthread_mutex_consistent(&bench.lock);
    }
}

template<class Bench>
void unlockShared(Bench& bench)
{
    pthread_mutex_unlock(&bench.lock);
}

/// Returns a random number in [0, 1).
template<class Bench>
double drawShared(Bench& bench)
{
    // xorshift64*: the same faults for the same seed.
    bench.random ^= bench.random >> 12;
    bench.random ^= bench.random << 25;
    bench.random ^= bench.random >> 27;
    return static_cast<double>((bench.random * 0x2545F4914F6CDD1DULL) >> 11) / 9007199254740992.0;
}

inline constexpr std::int64_t kStep_ns = 100'000;

/// Calls `step(device, time)` for each device and each step up to `now_ns`.
template<class Bench, class Step>
void advanceShared(Bench& bench, std::int64_t now_ns, const Step& step)
{
    constexpr std::int64_t kLongestGap_ns = 20'000'000'000;
    if (bench.sim_ns == 0) {
        bench.sim_ns = now_ns / kStep_ns * kStep_ns;
    }
    bench.sim_ns = std::max(bench.sim_ns, (now_ns - kLongestGap_ns) / kStep_ns * kStep_ns);
    while (bench.sim_ns + kStep_ns <= now_ns) {
        bench.sim_ns += kStep_ns;
        for (auto& device : bench.devices) {
            step(device, bench.sim_ns);
        }
    }
}

/// Mechanics: a mass at the tip, a hand that holds it. In metres and the user frame U.
struct HeldTip
{
    double mass_kg = 0.15;
    double viscosity_Ns_per_m = 1.0;
    bool isHeld = true;
    V3 p{};
    V3 v{};
    V3 from{}, to{}; ///< motion of the hand
    std::int64_t begin_ns = 0;
    double duration_s = 0.0;
};

inline double length(const V3& v)
{
    return std::hypot(v[0], v[1], v[2]);
}

/// Advances the tip by a step.
/// @param f  of the motors [N]
/// @param brake_Ns_per_m  in addition to the viscosity
/// @param weight_N  that nothing compensates
inline void stepTip(HeldTip& tip, const V3& f, double brake_Ns_per_m, double weight_N, std::int64_t now_ns)
{
    // As the hand of the other stand-in (Bench.h).
    constexpr double kGripStiffness_N_per_m = 500.0;
    constexpr double kGripDamping_Ns_per_m = 5.0;
    constexpr double kGripMass_kg = 0.1;
    const double dt_s = static_cast<double>(kStep_ns) * 1e-9;
    const double since_s = static_cast<double>(now_ns - tip.begin_ns) * 1e-9;
    const double u = tip.duration_s > 0.0 ? std::clamp(since_s / tip.duration_s, 0.0, 1.0) : 1.0;
    const double share = u * u * u * (10.0 + u * (-15.0 + 6.0 * u));
    const double rate = tip.duration_s > 0.0 ? 30.0 * u * u * (1.0 - u) * (1.0 - u) / tip.duration_s : 0.0;
    const double mass_kg = tip.mass_kg + (tip.isHeld ? kGripMass_kg : 0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        double sum_N = f[i] - (tip.viscosity_Ns_per_m + brake_Ns_per_m) * tip.v[i] - (i == 1 ? weight_N : 0.0);
        if (tip.isHeld) {
            const double way = tip.to[i] - tip.from[i];
            sum_N += kGripStiffness_N_per_m * (tip.from[i] + way * share - tip.p[i]) +
                     kGripDamping_Ns_per_m * (way * rate - tip.v[i]);
        }
        tip.v[i] += sum_N / mass_kg * dt_s;
        tip.p[i] += tip.v[i] * dt_s;
    }
}

/// Moves the hand to a place, in a smooth motion.
inline void moveTip(HeldTip& tip, const V3& to, double duration_s, std::int64_t now_ns)
{
    tip.from = tip.to;
    tip.to = to;
    tip.begin_ns = now_ns;
    tip.duration_s = duration_s;
}

} // namespace standin
