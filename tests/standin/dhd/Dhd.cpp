// SPDX-License-Identifier: BSD-3-Clause
// Stand-in for the library of Force Dimension, with the entry points that the plugin needs, in the library's own axes:
// x towards the user, y to the right, z up. Never installed.
#include "DhdBench.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <mutex>
#include <unistd.h>

namespace {

using namespace standin;

constexpr std::int64_t kReadTime_ns = 200'000; // of a transfer over USB
constexpr std::int64_t kWriteTime_ns = 100'000;

constexpr int kMostHandles = 100; // a handle is a char

enum Error
{
    kNone = 0,
    kFailed = 1,
    kCom = 2,
    kNoDevice = 5,
    kInUse = 20,
    kInvalid = 21
};

thread_local int t_error = kNone;

struct Handle
{
    int device;
    std::uint32_t plugins;
    bool isEarly = false;
    V3 last{};
};

struct Handles
{
    std::mutex lock;
    std::map<int, Handle> open;
    int next = 0;
};

Handles& handles()
{
    static auto* const all = new Handles; // outlives every thread
    return *all;
}

DhdBench& bench()
{
    static DhdBench* const one = [] {
        DhdBench* made = openShared<DhdBench>(std::getenv("PALPATE_STANDIN_DHD"), kDhdMagic);
        if (made == nullptr) {
            std::fprintf(stderr, "stand-in: PALPATE_STANDIN_DHD names no bench\n");
            std::abort();
        }
        return made;
    }();
    return *one;
}

std::int64_t nowHere_ns()
{
    timespec t{};
    clock_gettime(CLOCK_MONOTONIC, &t);
    return static_cast<std::int64_t>(t.tv_sec) * 1'000'000'000 + t.tv_nsec;
}

void sleepHere(std::int64_t until_ns)
{
    const timespec until{until_ns / 1'000'000'000, until_ns % 1'000'000'000};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) != 0) {
    }
}

/// Locks the bench and advances it to the current time.
class Now
{
  public:
    Now()
        : time_ns(nowHere_ns())
    {
        lockShared(bench());
        advanceDhd(bench(), time_ns);
    }
    ~Now() { unlockShared(bench()); }
    Now(const Now&) = delete;
    Now& operator=(const Now&) = delete;
    const std::int64_t time_ns;
};

/// Waits as long as a call takes, then finds the handle. @return null: the call fails with t_error
Handle* enter(int id, std::int64_t takes_ns)
{
    std::int64_t until_ns = 0;
    {
        const Now now;
        if (id < 0) {
            ++bench().unnamedCalls;
        }
        until_ns = now.time_ns + takes_ns;
        const std::lock_guard guard(handles().lock);
        const auto found = handles().open.find(id);
        if (found == handles().open.end()) {
            ++bench().lateCalls;
            t_error = kInvalid;
            return nullptr;
        }
        until_ns =
            std::max(until_ns, bench().devices[static_cast<std::size_t>(found->second.device)].faults.stallUntil_ns);
    }
    if (takes_ns > 0 || until_ns > nowHere_ns()) {
        sleepHere(until_ns);
    }
    const std::lock_guard guard(handles().lock);
    Handle& handle = handles().open.at(id);
    const Now now;
    const DhdDevice& device = bench().devices[static_cast<std::size_t>(handle.device)];
    if (!device.isPlugged || device.plugins != handle.plugins) {
        t_error = kCom;
        return nullptr;
    }
    if (device.faults.error != kNone || drawShared(bench()) < device.faults.failing) {
        t_error = device.faults.error != kNone ? device.faults.error : kFailed;
        return nullptr;
    }
    return &handle;
}

DhdDevice& deviceOf(const Handle& handle)
{
    return bench().devices[static_cast<std::size_t>(handle.device)];
}

int openDevice(int index)
{
    const Now now;
    if (index < 0) {
        t_error = kNoDevice;
        return -1;
    }
    DhdDevice& device = bench().devices[static_cast<std::size_t>(index)];
    if (device.faults.openError != kNone) {
        t_error = device.faults.openError;
        return -1;
    }
    const bool isOwned = device.owner != 0 && (device.owner == getpid() || kill(device.owner, 0) == 0);
    if (isOwned) {
        t_error = kInUse;
        return -1;
    }
    device.owner = getpid();
    device.isForceOn = false; // until the program enables forces
    device.watchdog = 0;
    device.lastForce_ns = 0;
    const std::lock_guard guard(handles().lock);
    // Other numbers for as long as possible, so that calls with a closed handle are noticed.
    handles().next = (handles().next + 1) % kMostHandles;
    handles().open[handles().next] = {index, device.plugins};
    return handles().next;
}

/// Returns the device at this place of the bus, of those that are plugged in; -1: none.
int deviceAt(int place)
{
    for (int i = 0; i < bench().count; ++i) {
        const int index = bench().order[static_cast<std::size_t>(i)];
        if (bench().devices[static_cast<std::size_t>(index)].isPlugged && place-- == 0) {
            return index;
        }
    }
    return -1;
}

int answerPosition(int id, double* x, double* y, double* z)
{
    std::int64_t block_ns = 0;
    {
        const Now now;
        const std::lock_guard guard(handles().lock);
        const auto found = handles().open.find(id);
        block_ns = found == handles().open.end() ? 0 : deviceOf(found->second).faults.blockEach_ns;
    }
    Handle* const handle = enter(id, kReadTime_ns + block_ns);
    if (handle == nullptr) {
        return -1;
    }
    const Now now;
    DhdDevice& device = deviceOf(*handle);
    const DhdFaults& faults = device.faults;
    handle->isEarly = faults.isEverySecondEarly && !handle->isEarly;
    if (!handle->isEarly && !faults.isFrozen) {
        handle->last = device.p;
        device.samples[device.sampleCount++ % device.samples.size()] = {now.time_ns, device.p};
    }
    *x = faults.isPoisoned ? faults.poison : handle->last[2] + faults.jump_m;
    *y = handle->last[0];
    *z = handle->last[1];
    return handle->isEarly ? 1 : 0;
}

int takeForce(int id, double x, double y, double z)
{
    Handle* const handle = enter(id, kWriteTime_ns);
    if (handle == nullptr) {
        return -1;
    }
    const Now now;
    DhdDevice& device = deviceOf(*handle);
    device.lastForce_ns = now.time_ns;
    setMotors(device, {y, z, x});
    device.forces[device.forceCount++ % device.forces.size()] = {now.time_ns, {y, z, x}};
    return device.faults.isSaturated ? 2 : 0;
}

} // namespace

extern "C" {

int dhdGetDeviceCount()
{
    const Now now;
    int count = 0;
    while (deviceAt(count) >= 0) {
        ++count;
    }
    return count;
}

int dhdOpenID(char place)
{
    int index = -1;
    {
        const Now now;
        index = deviceAt(place);
    }
    return openDevice(index);
}

int dhdClose(char id)
{
    (void)enter(id, 0); // waits, and counts a closed handle
    const Now now;
    const std::lock_guard guard(handles().lock);
    if (handles().open.count(id) == 0) {
        return -1;
    }
    DhdDevice& device = deviceOf(handles().open.at(id));
    if (device.plugins == handles().open.at(id).plugins) {
        device.owner = 0;
        device.isForceOn = false;
        setMotors(device, {});
    }
    handles().open.erase(id);
    return 0;
}

int dhdGetPosition(double* x, double* y, double* z, char id)
{
    return answerPosition(id, x, y, z);
}

int dhdSetForce(double x, double y, double z, char id)
{
    return takeForce(id, x, y, z);
}

int dhdErrorGetLast()
{
    return t_error;
}

const char* dhdErrorGetLastStr()
{
    return "error of the stand-in";
}

void dhdGetSDKVersion(int* major, int* minor, int* release, int* revision)
{
    const Now now;
    *major = bench().sdkMajor;
    *minor = 14;
    *release = 0;
    *revision = 0;
}

#ifndef PALPATE_STANDIN_HALF

int dhdOpenSerial(int serial)
{
    int found = -1;
    {
        const Now now;
        for (int place = 0; deviceAt(place) >= 0; ++place) {
            const int index = deviceAt(place);
            found = bench().devices[static_cast<std::size_t>(index)].serial == serial ? index : found;
        }
    }
    return openDevice(found);
}

int dhdStop(char id)
{
    Handle* const handle = enter(id, kWriteTime_ns);
    if (handle == nullptr) {
        return -1;
    }
    const Now now;
    DhdDevice& device = deviceOf(*handle);
    device.isForceOn = false;
    device.offCause = 4;
    setMotors(device, {});
    return 0;
}

int dhdGetPositionAndOrientationFrame(double* x, double* y, double* z, double R[3][3], char id)
{
    const int answer = answerPosition(id, x, y, z);
    if (answer < 0) {
        return answer;
    }
    const Now now;
    const std::lock_guard guard(handles().lock);
    const V3& w = deviceOf(handles().open.at(id)).turn;
    const double angle = std::hypot(w[0], w[1], w[2]);
    const double a = angle > 0.0 ? std::sin(angle) / angle : 1.0;
    const double b = angle > 0.0 ? (1.0 - std::cos(angle)) / (angle * angle) : 0.5;
    const double cross[3][3] = {{0, -w[2], w[1]}, {w[2], 0, -w[0]}, {-w[1], w[0], 0}};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) { // Rodrigues
            double square = 0.0;
            for (int k = 0; k < 3; ++k) {
                square += cross[i][k] * cross[k][j];
            }
            R[i][j] = (i == j ? 1.0 : 0.0) + a * cross[i][j] + b * square;
        }
    }
    return answer;
}

int dhdSetForceAndTorqueAndGripperForce(double x, double y, double z, double, double, double, double, char id)
{
    return takeForce(id, x, y, z);
}

int dhdEnableForce(unsigned char isOn, char id)
{
    Handle* const handle = enter(id, kWriteTime_ns);
    if (handle == nullptr) {
        return -1;
    }
    const Now now;
    DhdDevice& device = deviceOf(*handle);
    device.enablings += isOn != 0 ? 1 : 0;
    device.isForceOn = isOn != 0 && device.offCause != 2; // braked: only the button helps
    device.offCause = device.isForceOn ? 0 : (device.offCause == 2 ? 2 : 4);
    return 0;
}

int dhdSetGravityCompensation(int, char id)
{
    return enter(id, 0) == nullptr ? -1 : 0;
}

unsigned dhdGetButtonMask(char id)
{
    Handle* const handle = enter(id, 0);
    const Now now;
    return handle == nullptr ? 0U : deviceOf(*handle).buttons;
}

int dhdGetSystemType(char id)
{
    Handle* const handle = enter(id, 0);
    const Now now;
    return handle == nullptr ? -1 : deviceOf(*handle).type;
}

const char* dhdGetSystemName(char id)
{
    Handle* const handle = enter(id, 0);
    const Now now;
    return handle == nullptr || !deviceOf(*handle).hasName ? nullptr : "emulated omega";
}

int dhdGetSerialNumber(unsigned short* serial, char id)
{
    Handle* const handle = enter(id, 0);
    if (handle == nullptr) {
        return -1;
    }
    const Now now;
    *serial = static_cast<unsigned short>(deviceOf(*handle).serial);
    return 0;
}

int dhdGetStatus(int* status, char id)
{
    Handle* const handle = enter(id, kReadTime_ns);
    if (handle == nullptr) {
        return -1;
    }
    const Now now;
    const DhdDevice& device = deviceOf(*handle);
    const int all[16] = {
        device.hasPower, 1, 1, device.isReset, 0, device.isForceOn, !device.isForceOn, 0, 0, 0, 1, 1, 1, 0,
        device.offCause, 0};
    for (int i = 0; i < 16; ++i) {
        status[i] = all[i];
    }
    return 0;
}

bool dhdHasWrist(char id)
{
    Handle* const handle = enter(id, 0);
    const Now now;
    return handle != nullptr && deviceOf(*handle).hasWrist;
}

bool dhdHasGripper(char id)
{
    Handle* const handle = enter(id, 0);
    const Now now;
    return handle != nullptr && deviceOf(*handle).hasGripper;
}

int dhdEnableExpertMode()
{
    return 0;
}

int dhdSetWatchdog(unsigned char units, char id)
{
    Handle* const handle = enter(id, kWriteTime_ns);
    if (handle == nullptr) {
        return -1;
    }
    const Now now;
    if (deviceOf(*handle).faults.hasNoWatchdog) {
        t_error = kFailed;
        return -1;
    }
    deviceOf(*handle).watchdog = units;
    return 0;
}

int dhdEmulateButton(unsigned char isOn, char id)
{
    Handle* const handle = enter(id, 0);
    if (handle == nullptr) {
        return -1;
    }
    const Now now;
    deviceOf(*handle).isGripperAButton = isOn != 0;
    return 0;
}

double dhdGetMaxForce(char id)
{
    Handle* const handle = enter(id, 0);
    const Now now;
    return handle == nullptr ? -1.0 : deviceOf(*handle).reportedForce_N;
}

int dhdSetMaxForce(double, char id)
{
    return enter(id, 0) == nullptr ? -1 : 0;
}

#endif

} // extern "C"
