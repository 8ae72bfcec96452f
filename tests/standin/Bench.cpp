// SPDX-License-Identifier: BSD-3-Clause
// The bus and the firmware.
#include "Bench.h"

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

constexpr std::int64_t kStep_ns = 100'000;    // time step of the mechanics
constexpr std::int64_t kFrame_ns = 1'000'000; // frame of full-speed USB
constexpr std::int64_t kInPhase_ns = 500'000; // within a frame, the host receives after sending
constexpr std::int64_t kWatchdog_ns = 500'000'000;
constexpr std::int64_t kLongestGap_ns = 5'000'000'000;

void initialise(Bench& bench)
{
    new (&bench) Bench;
    pthread_mutexattr_t attributes;
    pthread_mutexattr_init(&attributes);
    pthread_mutexattr_setpshared(&attributes, PTHREAD_PROCESS_SHARED);
    pthread_mutexattr_setrobust(&attributes, PTHREAD_MUTEX_ROBUST); // a lock holder may be killed
    pthread_mutex_init(&bench.lock, &attributes);
    pthread_mutexattr_destroy(&attributes);
    bench.arm.q = restPose(bench.arm.unit);
    bench.magic = kMagic;
}

std::int16_t wrap(double count)
{
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(static_cast<std::int64_t>(std::floor(count + 0.5))));
}

void sampleCounters(Arm& arm)
{
    const auto counts = countsOf(arm.unit, arm.q);
    for (std::size_t i = 0; i < 6; ++i) {
        arm.counters[i] = wrap((i < 3 ? counts[i] : 0.0) + arm.counterOffset[i]);
    }
    arm.sampled_mm = tipOf(arm.unit, arm.q);
}

void setAmps(Arm& arm, const V3& amps)
{
    for (std::size_t i = 0; i < 3; ++i) {
        arm.amps[i] = std::clamp(amps[i], -arm.unit.fullScale_A, arm.unit.fullScale_A);
    }
    const V3 f = forceOf(arm.unit, arm.q, arm.amps);
    const double force_N = std::hypot(f[0], f[1], f[2]);
    arm.largestForce_N = std::max(arm.largestForce_N, force_N);
    if (force_N > 0.0) {
        arm.forceSince_ns = arm.forceSince_ns == 0 ? arm.sim_ns : arm.forceSince_ns;
    } else {
        arm.forceSince_ns = 0;
    }
}

std::int16_t fieldAt(const Packet& packet, int index)
{
    const auto at = static_cast<std::size_t>(2 * index);
    return static_cast<std::int16_t>(packet.bytes[at] | packet.bytes[at + 1] << 8);
}

/// The firmware receives a report from the host.
void hear(Arm& arm, const Packet& packet)
{
    const int expected = arm.unit.protocol == 2 ? 14 : 8;
    arm.isReportDue = arm.isAwaitingHost;
    arm.isAwaitingHost = false;
    if (packet.length != expected) {
        return; // the endpoint accepts the report, the firmware does not
    }
    arm.lastHost_ns = arm.sim_ns;
    Taken taken;
    taken.time_ns = arm.sim_ns;
    taken.sampled_mm = arm.sampled_mm;
    taken.p_mm = tipOf(arm.unit, arm.q);
    taken.countStep_mm = countStepOf(arm.unit, arm.q);
    taken.command = arm.unit.protocol == 2 ? fieldAt(packet, 3) : static_cast<std::int16_t>(0);
    if (taken.command == 1) {
        const auto counts = countsOf(arm.unit, arm.q);
        for (std::size_t i = 0; i < 3; ++i) {
            arm.counterOffset[i] = fieldAt(packet, 4 + static_cast<int>(i)) - counts[i];
            arm.counterOffset[3 + i] = fieldAt(packet, static_cast<int>(i));
        }
        arm.isButtonDown = false;
    } else {
        for (std::size_t i = 0; i < 3; ++i) {
            taken.mA[i] = fieldAt(packet, static_cast<int>(i));
        }
        setAmps(arm, {taken.mA[0] * 1e-3, taken.mA[1] * 1e-3, taken.mA[2] * 1e-3});
    }
    taken.f_D = forceOf(arm.unit, arm.q, arm.amps);
    arm.taken[arm.takenCount++ % arm.taken.size()] = taken;
}

/// The firmware sends its position, and the bus may drop or corrupt the report.
void speak(Bench& bench)
{
    Arm& arm = bench.arm;
    const Faults& faults = bench.faults;
    arm.isReportDue = false;
    arm.isAwaitingHost = true;
    sampleCounters(arm);
    Packet packet;
    const bool isTwo = arm.unit.protocol == 2;
    packet.length = isTwo ? 14 : 8;
    for (std::size_t i = 0; i < static_cast<std::size_t>(packet.length) / 2; ++i) {
        std::uint16_t bits = 0;
        if (isTwo && i == 6) {
            bits = arm.isButtonDown ? 1 : 0;
        } else if (i < (isTwo ? 6U : 3U)) {
            bits = static_cast<std::uint16_t>(arm.counters[i]);
            bits = isTwo ? bits : static_cast<std::uint16_t>(-bits);
        }
        packet.bytes[2 * i] = static_cast<std::uint8_t>(bits & 0xff);
        packet.bytes[2 * i + 1] = static_cast<std::uint8_t>(bits >> 8);
    }
    if (bench.strangerLength > 0) {
        packet.length = bench.strangerLength;
    }
    packet.ready_ns = arm.sim_ns;
    if (draw(bench) < faults.dropIn) {
        return;
    }
    if (draw(bench) < faults.random) {
        for (int i = 0; i < packet.length; ++i) {
            packet.bytes[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(draw(bench) * 256.0);
        }
    }
    if (draw(bench) < faults.shortened) {
        packet.length = static_cast<int>(draw(bench) * packet.length);
    } else if (draw(bench) < faults.lengthened) {
        packet.length += 1 + static_cast<int>(draw(bench) * 40.0);
    }
    if (draw(bench) < faults.delay) {
        packet.ready_ns +=
            std::llround((faults.delayLeast_s + draw(bench) * (faults.delayMost_s - faults.delayLeast_s)) * 1e9);
    }
    push(arm.toHost, packet);
    if (draw(bench) < faults.repeat) {
        push(arm.toHost, packet);
    }
}

void advanceArm(Bench& bench, std::int64_t now_ns)
{
    Arm& arm = bench.arm;
    if (arm.sim_ns == 0) {
        arm.sim_ns = now_ns / kStep_ns * kStep_ns;
        arm.plugged_ns = arm.sim_ns;
    }
    arm.sim_ns = std::max(arm.sim_ns, (now_ns - kLongestGap_ns) / kStep_ns * kStep_ns);
    while (arm.sim_ns + kStep_ns <= now_ns) {
        stepArm(arm, static_cast<double>(kStep_ns) * 1e-9);
        arm.sim_ns += kStep_ns;
        if (!arm.isPlugged || arm.sim_ns < bench.faults.stalledUntil_ns) {
            continue;
        }
        if (arm.lastHost_ns != 0 && arm.sim_ns - arm.lastHost_ns > kWatchdog_ns) {
            setAmps(arm, {});
            arm.lastHost_ns = 0;
            ++arm.watchdogs;
        }
        const std::int64_t phase = arm.sim_ns % kFrame_ns;
        if (phase == 0) {
            Packet packet;
            if (pop(arm.toDevice, arm.sim_ns, packet) && draw(bench) >= bench.faults.dropOut) {
                hear(arm, packet);
            }
        } else if (phase == kInPhase_ns && arm.isReportDue) {
            speak(bench);
        }
    }
}

} // namespace

double draw(Bench& bench)
{
    // xorshift64*: the same faults for the same seed.
    bench.random ^= bench.random >> 12;
    bench.random ^= bench.random << 25;
    bench.random ^= bench.random >> 27;
    return static_cast<double>((bench.random * 0x2545F4914F6CDD1DULL) >> 11) / 9007199254740992.0;
}

bool push(Queue& queue, const Packet& packet)
{
    const int size = static_cast<int>(queue.packets.size());
    const bool isFull = queue.count == size;
    if (isFull) {
        queue.first = (queue.first + 1) % size;
        --queue.count;
    }
    queue.packets[static_cast<std::size_t>((queue.first + queue.count++) % size)] = packet;
    return !isFull;
}

bool pop(Queue& queue, std::int64_t now_ns, Packet& out)
{
    if (queue.count == 0 || queue.packets[static_cast<std::size_t>(queue.first)].ready_ns > now_ns) {
        return false;
    }
    out = queue.packets[static_cast<std::size_t>(queue.first)];
    queue.first = (queue.first + 1) % static_cast<int>(queue.packets.size());
    --queue.count;
    return true;
}

void advance(Bench& bench, std::int64_t now_ns)
{
    advanceArm(bench, now_ns);
    advancePuck(bench.puck, now_ns);
}

std::int64_t nextEvent(std::int64_t now_ns)
{
    return (now_ns / kInPhase_ns + 1) * kInPhase_ns;
}

void plugArm(Bench& bench, bool isPlugged, std::int64_t now_ns)
{
    Arm& arm = bench.arm;
    advance(bench, now_ns);
    if (isPlugged && !arm.isPlugged) {
        ++arm.plugins;
        // The board was without power: its counters start at zero at the arm's current pose.
        const auto counts = countsOf(arm.unit, arm.q);
        for (std::size_t i = 0; i < 6; ++i) {
            arm.counterOffset[i] = i < 3 ? -counts[i] : 0.0;
        }
        arm.toHost = {};
        arm.toDevice = {};
        arm.isAwaitingHost = true;
        arm.isReportDue = false;
        arm.lastHost_ns = 0;
    }
    arm.isPlugged = isPlugged;
    if (!isPlugged) {
        setAmps(arm, {});
    }
}

void plugPuck(Bench& bench, bool isPlugged)
{
    bench.puck.plugins += isPlugged && !bench.puck.isPlugged ? 1 : 0;
    bench.puck.isPlugged = isPlugged;
    bench.puck.toHost = {};
}

Bench* openBench(const char* path)
{
    if (path == nullptr) {
        void* memory = mmap(nullptr, sizeof(Bench), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (memory == MAP_FAILED) {
            return nullptr;
        }
        auto* bench = static_cast<Bench*>(memory);
        initialise(*bench);
        return bench;
    }
    const int file = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0) {
        return nullptr;
    }
    flock(file, LOCK_EX); // two processes may start simultaneously
    Bench* bench = nullptr;
    if (ftruncate(file, sizeof(Bench)) == 0) {
        void* memory = mmap(nullptr, sizeof(Bench), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        if (memory != MAP_FAILED) {
            bench = static_cast<Bench*>(memory);
            if (bench->magic != kMagic) {
                initialise(*bench);
            }
        }
    }
    flock(file, LOCK_UN);
    close(file);
    return bench;
}

void lockBench(Bench& bench)
{
    if (pthread_mutex_lock(&bench.lock) == EOWNERDEAD) {
        pthread_mutex_consistent(&bench.lock);
    }
}

void unlockBench(Bench& bench)
{
    pthread_mutex_unlock(&bench.lock);
}

} // namespace standin
