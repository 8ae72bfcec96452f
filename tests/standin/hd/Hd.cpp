// SPDX-License-Identifier: BSD-3-Clause
// Stand-in for the library of 3D Systems (HDAPI), with the entry points that the plugin needs, in millimetres, and with
// a scheduler thread of its own. Never installed.
#include "HdBench.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <limits>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace {

using namespace standin;

enum Code : unsigned
{
    kInvalidEnum = 0x0100,
    kInvalidValue = 0x0101,
    kInvalidOperation = 0x0102,
    kInvalidType = 0x0103,
    kBadHandle = 0x0104,
    kMaxForce = 0x0201,
    kInitiated = 0x0301,
    kComm = 0x0302,
    kConfig = 0x0303,
    kIllegalBegin = 0x0400,
    kIllegalEnd = 0x0401,
    kFrame = 0x0402,
};

constexpr unsigned kNone = 0xFFFFFFFFU;

struct Error
{
    unsigned code;
    int internal;
    unsigned device;
};

/// A device that is open.
struct Open
{
    std::size_t device;
    std::uint32_t plugins;
    bool isInFrame = false;
    double scale = 1.0; ///< from the text of the configuration
    V3 last{};          ///< position of the frame
    V3 f{};             ///< set in the frame
    bool hasForce = false;
};

struct Scheduled
{
    unsigned long handle;
    unsigned (*run)(void*);
    void* data;
};

struct Library
{
    std::recursive_mutex lock; ///< guards everything below
    std::map<unsigned, Open> open;
    unsigned next = 0;
    unsigned current = kNone;
    std::vector<Error> errors;
    std::vector<Scheduled> scheduled;
    unsigned long nextScheduled = 1;
    std::thread thread;
    std::atomic<bool> isStopWanted{false};
    bool isRunning = false;
};

Library& library()
{
    static auto* const one = new Library; // outlives every thread
    return *one;
}

HdBench& bench()
{
    static HdBench* const one = [] {
        HdBench* made = openShared<HdBench>(std::getenv("PALPATE_STANDIN_HD"), kHdMagic);
        if (made == nullptr) {
            std::fprintf(stderr, "stand-in: PALPATE_STANDIN_HD names no bench\n");
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

/// Called at the begin (1) and the end (2) of a callback, and when a callback enters (3) and leaves (4) the library:
/// for tests that count what a callback does on its own.
std::atomic<void (*)(int)> hook{nullptr};
thread_local bool t_isInCallback = false;

void callHook(int what)
{
    if (auto* const function = hook.load(); function != nullptr) {
        function(what);
    }
}

/// Locks library and bench and advances the bench to the current time.
class Call
{
  public:
    Call()
    {
        if (t_isInCallback) {
            callHook(3);
        }
        library().lock.lock();
        lockShared(bench());
        time_ns = nowHere_ns();
        advanceHd(bench(), time_ns);
    }
    ~Call()
    {
        unlockShared(bench());
        library().lock.unlock();
        if (t_isInCallback) {
            callHook(4);
        }
    }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;
    std::int64_t time_ns = 0;
};

void push(unsigned code)
{
    library().errors.push_back({code, 0, library().current});
}

void misuse(const char* what, unsigned code)
{
    ++bench().misuses;
    std::snprintf(bench().lastMisuse.data(), bench().lastMisuse.size(), "%s", what);
    push(code);
}

HdDevice& deviceOf(const Open& open)
{
    return bench().devices[open.device];
}

/// Returns the current device; null, with an error: none, or lost.
Open* current(const char* what)
{
    const auto found = library().open.find(library().current);
    if (found == library().open.end()) {
        misuse(what, kBadHandle);
        return nullptr;
    }
    const HdDevice& device = deviceOf(found->second);
    if (device.faults.callError != 0) {
        push(device.faults.callError);
        return nullptr;
    }
    if (!device.isPlugged || device.plugins != found->second.plugins) {
        push(kComm);
        return nullptr;
    }
    return &found->second;
}

/// As `current`, for calls that belong into a frame.
Open* inFrame(const char* what)
{
    Open* const open = current(what);
    if (open != nullptr && !open->isInFrame) {
        misuse(what, kFrame);
        return nullptr;
    }
    return open;
}

void runCallbacks()
{
    std::vector<Scheduled> all;
    {
        const Call call;
        all = library().scheduled;
        // Another part of the program may have made another device current.
        if (library().open.size() > 1) {
            library().current =
                drawShared(bench()) < 0.5 ? library().open.begin()->first : library().open.rbegin()->first;
        }
    }
    for (const Scheduled& one : all) {
        t_isInCallback = true;
        callHook(1);
        const unsigned answer = one.run(one.data);
        callHook(2);
        t_isInCallback = false;
        if (answer == 0) {
            const Call call;
            std::erase_if(library().scheduled, [&one](const Scheduled& s) { return s.handle == one.handle; });
        }
    }
}

void schedule()
{
    std::int64_t next_ns = nowHere_ns();
    for (int tick = 0; !library().isStopWanted; ++tick) {
        HdSchedulerFaults faults;
        std::int64_t late_ns = 0;
        {
            const Call call;
            faults = bench().scheduler;
            const std::int64_t period_ns =
                faults.isBursting ? 20'000'000 : static_cast<std::int64_t>(1e9 / bench().rate_Hz);
            next_ns = std::max(next_ns + period_ns, faults.stallUntil_ns);
            late_ns = static_cast<std::int64_t>(drawShared(bench()) * static_cast<double>(faults.lateMost_ns));
        }
        if (faults.isDead) {
            return;
        }
        sleepHere(next_ns + late_ns);
        {
            const Call call;
            if (bench().scheduler.stallUntil_ns > call.time_ns) {
                continue;
            }
        }
        const int times = (faults.isDoubled ? 2 : 1) * (faults.isBursting ? 20 : 1);
        for (int i = 0; i < times && !library().isStopWanted; ++i) {
            runCallbacks();
        }
    }
}

bool isOwned(const HdDevice& device)
{
    return device.owner != 0 && (device.owner == getpid() || kill(device.owner, 0) == 0);
}

/// Number of a limit; NaN: no such number.
double limitOf(const HdDevice& device, unsigned name)
{
    switch (name) {
    case 0x2602:
        return device.maxStiffness_N_per_mm;
    case 0x2603:
        return device.maxForce_N;
    case 0x2604:
        return device.continuousForce_N;
    default:
        return device.maxDamping_Ns_per_mm;
    }
}

/// Answers what belongs into no frame. @return false: another name
bool answerLimit(const Open& open, unsigned name, double* values)
{
    const HdDevice& device = deviceOf(open);
    const bool isNumber = (name >= 0x2602 && name <= 0x2604) || name == 0x2609;
    if (!isNumber && name != 0x2551) {
        return false;
    }
    if (!device.statesLimits) {
        push(kInvalidEnum);
    } else if (isNumber) {
        *values = limitOf(device, name);
    } else {
        std::copy(device.workspace_mm.begin(), device.workspace_mm.end(), values);
    }
    return true;
}

/// Writes the orientation and the position, column by column.
void answerTransform(const V3& w, const V3& p_mm, double* values)
{
    const double angle = length(w);
    const double a = angle > 0.0 ? std::sin(angle) / angle : 1.0;
    const double b = angle > 0.0 ? (1.0 - std::cos(angle)) / (angle * angle) : 0.5;
    const double cross[3][3] = {{0, -w[2], w[1]}, {w[2], 0, -w[0]}, {-w[1], w[0], 0}};
    std::fill(values, values + 16, 0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) { // Rodrigues
            double square = 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                square += cross[i][k] * cross[k][j];
            }
            values[4 * j + i] = (i == j ? 1.0 : 0.0) + a * cross[i][j] + b * square;
        }
        values[12 + i] = p_mm[i];
    }
    values[0] += 1e-4; // orthogonal up to small errors, as users report
    values[15] = 1.0;
}

} // namespace

extern "C" {

void standin_setHook(void (*function)(int))
{
    hook = function;
}

unsigned hdInitDevice(const char* name)
{
    std::int64_t until_ns = 0;
    {
        const Call call;
        until_ns = call.time_ns + 20'000'000; // it takes its time
    }
    sleepHere(until_ns);
    const Call call;
    const char* const wanted = name == nullptr ? "Default Device" : name;
    const auto found = std::find_if(bench().devices.begin(), bench().devices.end(), [wanted](const HdDevice& device) {
        return std::strcmp(device.name.data(), wanted) == 0;
    });
    if (found == bench().devices.end()) {
        push(kConfig);
        return kNone;
    }
    HdDevice& device = *found;
    ++device.inits;
    const unsigned error = device.faults.initError != 0 ? device.faults.initError
                           : !device.isPlugged          ? unsigned{kComm}
                           : isOwned(device)            ? unsigned{kInitiated}
                                                        : 0U;
    if (error != 0) {
        push(error);
        return kNone;
    }
    device.owner = getpid();
    device.isForceOn = false; // until the program enables forces
    device.f = {};
    Open open{static_cast<std::size_t>(found - bench().devices.begin()), device.plugins, false, 1.0, {}, {}, false};
    open.scale = std::strtod("0.5", nullptr) * 2.0; // 0 where the decimal point is a comma
    library().current = ++library().next; // other numbers each time, so that calls with a closed handle are noticed
    library().open[library().current] = open;
    return library().current;
}

void hdDisableDevice(unsigned handle)
{
    const Call call;
    const auto found = library().open.find(handle);
    if (found == library().open.end()) {
        misuse("hdDisableDevice", kBadHandle);
        return;
    }
    HdDevice& device = deviceOf(found->second);
    if (device.plugins == found->second.plugins) {
        if (length(device.f) > 0.0) {
            misuse("hdDisableDevice with a force", 0);
        }
        device.owner = 0;
        device.isForceOn = false;
        device.f = {};
    }
    library().open.erase(found);
}

void hdMakeCurrentDevice(unsigned handle)
{
    const Call call;
    if (library().open.count(handle) == 0) {
        misuse("hdMakeCurrentDevice", kBadHandle);
        return;
    }
    library().current = handle;
}

void hdBeginFrame(unsigned handle)
{
    const Call call;
    if (handle != library().current) {
        misuse("hdBeginFrame of another device", kBadHandle);
        return;
    }
    Open* const open = current("hdBeginFrame");
    if (open == nullptr) {
        return;
    }
    HdDevice& device = deviceOf(*open);
    if (std::exchange(device.faults.isFrameLeftOpen, false) || open->isInFrame) {
        open->isInFrame = true;
        push(kIllegalBegin);
        return;
    }
    open->isInFrame = true;
    open->hasForce = false;
    if (!device.faults.isFrozen) {
        open->last = device.p;
    }
    device.samples[device.sampleCount++ % device.samples.size()] = {call.time_ns, device.p};
}

void hdEndFrame(unsigned handle)
{
    const Call call;
    if (handle != library().current) {
        misuse("hdEndFrame of another device", kBadHandle);
        return;
    }
    Open* const open = current("hdEndFrame");
    if (open == nullptr) {
        return;
    }
    if (!open->isInFrame) {
        push(kIllegalEnd);
        return;
    }
    open->isInFrame = false;
    HdDevice& device = deviceOf(*open);
    V3 f = open->hasForce ? open->f : device.f; // a force holds until another is set
    device.largestForce_N = std::max(device.largestForce_N, length(f));
    if (length(f) > device.maxForce_N * (1.0 + 1e-9) && device.maxForce_N > 0.0 && !device.isClamping) {
        push(kMaxForce);
        f = {};
    }
    device.f = device.isForceOn ? f : V3{};
    device.lastForce_ns = call.time_ns;
    device.forces[device.forceCount++ % device.forces.size()] = {call.time_ns, device.f};
}

Error hdGetError()
{
    const Call call;
    if (library().errors.empty()) {
        return {0, 0, kNone};
    }
    const Error newest = library().errors.back();
    library().errors.pop_back();
    return newest;
}

const char* hdGetErrorString(unsigned)
{
    return "error of the stand-in";
}

void hdEnable(unsigned capability)
{
    const Call call;
    if (Open* const open = current("hdEnable"); open != nullptr) {
        deviceOf(*open).isForceOn |= capability == 0x4000;
        deviceOf(*open).isClamping |= capability == 0x4001;
    }
}

void hdDisable(unsigned capability)
{
    const Call call;
    if (Open* const open = current("hdDisable"); open != nullptr && capability == 0x4000) {
        deviceOf(*open).isForceOn = false;
        deviceOf(*open).f = {};
    }
}

void hdGetIntegerv(unsigned name, int* value)
{
    const Call call;
    if (name == 0x2555) {
        if (const Open* const open = current("styles"); open != nullptr) {
            *value = deviceOf(*open).styles;
        }
    } else if (name == 0x2000) {
        if (const Open* const open = inFrame("buttons"); open != nullptr) {
            *value = deviceOf(*open).buttons;
        }
    } else {
        misuse("hdGetIntegerv", kInvalidType);
    }
}

void hdGetDoublev(unsigned name, double* values)
{
    std::int64_t until_ns = 0;
    {
        const Call call;
        const Open* const limits = name >= 0x2500 ? current("limits") : nullptr;
        if (limits != nullptr && answerLimit(*limits, name, values)) {
            return;
        }
        if (name >= 0x2500) {
            return;
        }
        if (name != 0x2050 && name != 0x2052) {
            misuse("hdGetDoublev", kInvalidType);
            return;
        }
        const Open* const open = inFrame("position");
        if (open == nullptr) {
            return;
        }
        until_ns = call.time_ns + (name == 0x2050 ? deviceOf(*open).faults.blockEach_ns : 0);
    }
    if (until_ns > nowHere_ns()) {
        sleepHere(until_ns);
    }
    const Call call;
    const Open* const open = inFrame("position");
    if (open == nullptr) {
        return;
    }
    HdDevice& device = deviceOf(*open);
    HdFaults& faults = device.faults;
    if (name == 0x2050 && faults.frameError != 0) {
        push(faults.frameError);
        if (faults.disablesForces) {
            device.isForceOn = false;
            device.f = {};
        }
        if (faults.frameErrors != 0 && --faults.frameErrors == 0) {
            faults.frameError = 0;
        }
    }
    if (drawShared(bench()) < faults.failing) {
        push(kComm);
        return;
    }
    V3 p_mm{};
    for (std::size_t i = 0; i < 3; ++i) {
        p_mm[i] = faults.isPoisoned ? faults.poison : open->last[i] * 1000.0 * open->scale + device.offset_mm;
    }
    p_mm[0] += faults.jump_mm;
    if (name == 0x2050) {
        std::copy(p_mm.begin(), p_mm.end(), values);
    } else {
        answerTransform(device.turn, p_mm, values);
    }
}

void hdSetDoublev(unsigned name, const double* values)
{
    const Call call;
    if (name != 0x2700) {
        misuse("hdSetDoublev", kInvalidType);
        return;
    }
    if (Open* const open = inFrame("force"); open != nullptr) {
        open->f = {values[0], values[1], values[2]};
        open->hasForce = true;
    }
}

const char* hdGetString(unsigned name)
{
    const Call call;
    const Open* const open = current("hdGetString");
    if (open == nullptr) {
        return nullptr;
    }
    switch (name) {
    case 0x2500:
        return bench().version.data();
    case 0x2501:
        return deviceOf(*open).model.data();
    case 0x2504:
        return deviceOf(*open).serial.data();
    default:
        misuse("hdGetString", kInvalidEnum);
        return nullptr;
    }
}

void hdStartScheduler()
{
    Library& all = library();
    const Call call;
    if (all.isRunning) {
        misuse("hdStartScheduler twice", kInvalidOperation);
        return;
    }
    all.isRunning = true;
    all.isStopWanted = false;
    all.thread = std::thread(schedule);
}

unsigned long hdScheduleAsynchronous(unsigned (*run)(void*), void* data, unsigned short)
{
    const Call call;
    library().scheduled.push_back({library().nextScheduled, run, data});
    return library().nextScheduled++;
}

#ifndef PALPATE_STANDIN_HALF

unsigned char hdIsEnabled(unsigned capability)
{
    const Call call;
    const Open* const open = current("hdIsEnabled");
    return open != nullptr && (capability == 0x4000 ? deviceOf(*open).isForceOn : deviceOf(*open).isClamping) ? 1 : 0;
}

unsigned hdCheckCalibration()
{
    const Call call;
    const Open* const open = inFrame("hdCheckCalibration");
    return open == nullptr ? 0x5000U : deviceOf(*open).calibration;
}

void hdUpdateCalibration(unsigned style)
{
    const Call call;
    Open* const open = current("hdUpdateCalibration");
    if (open == nullptr) {
        return;
    }
    HdDevice& device = deviceOf(*open);
    if (open->isInFrame || length(device.f) > 0.0) {
        misuse("hdUpdateCalibration in a frame or with a force", kInvalidOperation);
        return;
    }
    ++device.calibrations;
    device.calibrationStyle = style;
    if ((static_cast<unsigned>(device.styles) & style) == 0) {
        push(kInvalidValue);
        return;
    }
    if (device.calibration == 0x5001 || style == 1) {
        device.calibration = 0x5000;
        device.offset_mm = 0.0;
    }
}

void hdStopScheduler()
{
    Library& all = library();
    {
        const Call call;
        if (!all.isRunning) {
            misuse("hdStopScheduler twice", kInvalidOperation);
            return;
        }
        all.isStopWanted = true;
        all.isRunning = false;
    }
    all.thread.join();
    bool callsAgain = false;
    {
        const Call call;
        callsAgain = bench().scheduler.callsAfterStop;
    }
    for (int i = 0; callsAgain && i < 3; ++i) {
        runCallbacks();
    }
}

void hdUnschedule(unsigned long handle)
{
    const Call call;
    if (std::erase_if(library().scheduled, [handle](const Scheduled& s) { return s.handle == handle; }) == 0) {
        misuse("hdUnschedule", kInvalidValue);
    }
}

void hdSetSchedulerRate(unsigned long rate_Hz)
{
    const Call call;
    if (std::abs(static_cast<double>(rate_Hz) - bench().rate_Hz) > 0.5) {
        push(kInvalidValue);
    }
}

#endif

} // extern "C"
