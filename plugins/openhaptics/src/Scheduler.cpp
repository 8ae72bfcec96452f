// SPDX-License-Identifier: BSD-3-Clause
#include "Scheduler.h"

#include "Configurations.h"
#include "Ending.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <pthread.h>
#include <thread>
#include <utility>

namespace palpate::openhaptics {

using core::Status;
using core::StatusCode;

namespace {

constexpr unsigned long kRate_Hz = 1000;
constexpr std::int64_t kSilent_ns = 100 * kMillisecond_ns;
constexpr std::int64_t kRestartAfter_ns = 1000 * kMillisecond_ns; // of silence
constexpr std::int64_t kSuperviseEvery_ns = 20 * kMillisecond_ns;
constexpr std::int64_t kReopenEvery_ns = 500 * kMillisecond_ns;
// An attempt interrupts the other devices, so that a device which stays away must not disturb them often.
constexpr std::int64_t kLongestPause_ns = 60'000 * kMillisecond_ns;
constexpr std::int64_t kStartTimeout_ns = 1000 * kMillisecond_ns;
constexpr std::int64_t kOpenTimeout_ns = 5000 * kMillisecond_ns;
constexpr std::int64_t kCloseTimeout_ns = 2000 * kMillisecond_ns;
constexpr std::int64_t kZeroTimeout_ns = 50 * kMillisecond_ns;
constexpr std::int64_t kLeaveTimeout_ns = 1000 * kMillisecond_ns;
constexpr unsigned kZeroFrames = 3;

/// Sleeps in short steps until the condition holds. @return false: timed out
template<class Condition>
bool waitUntil(std::int64_t wait_ns, const Condition& isTrue)
{
    const std::int64_t deadline_ns = core::monotonicNow_ns() + wait_ns;
    while (!isTrue()) {
        const std::int64_t now_ns = core::monotonicNow_ns();
        if (now_ns >= deadline_ns) {
            return false;
        }
        core::sleepUntil_ns(now_ns + kMillisecond_ns / 2);
    }
    return true;
}

std::string text(const char* stated)
{
    return stated == nullptr ? "" : stated;
}

/// Reads what the current device states about itself.
Statement readStatement(const Hd& hd)
{
    const auto number = [&hd](unsigned name) {
        double value = std::numeric_limits<double>::quiet_NaN();
        hd.getDoublev(name, &value);
        return takeErrors(hd).code == kSuccess ? value : std::numeric_limits<double>::quiet_NaN();
    };
    Statement statement;
    statement.model = text(hd.getString(kModelType));
    statement.serial = text(hd.getString(kSerialNumber));
    (void)takeErrors(hd);
    statement.maxForce_N = number(kNominalMaxForce);
    statement.continuousForce_N = number(kNominalMaxContinuousForce);
    statement.maxStiffness_N_per_mm = number(kNominalMaxStiffness);
    statement.maxDamping_Ns_per_mm = number(kNominalMaxDamping);
    double corners[6] = {};
    hd.getDoublev(kUsableWorkspace, corners);
    if (takeErrors(hd).code == kSuccess) {
        statement.least_mm = core::Vec3(corners);
        statement.most_mm = core::Vec3(corners + 3);
    }
    int styles = 0;
    hd.getIntegerv(kCalibrationStyle, &styles);
    statement.calibrationStyles = takeErrors(hd).code == kSuccess ? static_cast<unsigned>(styles) : 0U;
    return statement;
}

/// Opens a device, which becomes the current one.
Hd::Device init(const Hd& hd, const std::string& name, HdError& error)
{
    (void)takeErrors(hd);
    const Hd::Device device = hd.initDevice(name.empty() ? nullptr : name.c_str());
    error = takeErrors(hd);
    if (device == Hd::kNoDevice) {
        return device;
    }
    if (error.code != kSuccess && error.code != kWarmMotors) {
        hd.disableDevice(device);
        (void)takeErrors(hd);
        return Hd::kNoDevice;
    }
    hd.makeCurrentDevice(device);
    return device;
}

void disable(const Hd& hd, Hd::Device device) noexcept
{
    hd.makeCurrentDevice(device);
    hd.disable(kForceOutput);
    hd.disableDevice(device);
    (void)takeErrors(hd);
}

/// The line of `palpate devices`: "Touch, Default Device (110-22)".
device::FoundDevice foundDevice(const std::string& name, const Statement& statement)
{
    const std::string model = statement.model.empty() ? "3D Systems device" : statement.model;
    return {name.empty() ? model : model + ", " + name, statement.serial.empty() ? name : statement.serial, ""};
}

Status alreadyInUse()
{
    return {StatusCode::NotFound, PALPATE_TEXT("%1: the device is already in use by this program"), "openhaptics"};
}

Status noAnswer()
{
    return {StatusCode::DeviceLost,
            PALPATE_TEXT("openhaptics: libHD does not answer: switch the device off and on, and start Palpate again")};
}

} // namespace

Scheduler::Scheduler(std::shared_ptr<const Hd> hd)
    : m_hd(std::move(hd))
{
}

bool Scheduler::lockWithin(std::int64_t wait_ns) noexcept
{
    return waitUntil(wait_ns, [this] { return m_lock.try_lock(); });
}

std::vector<device::FoundDevice> Scheduler::list()
{
    std::vector<device::FoundDevice> found;
    if (!lockWithin(kOpenTimeout_ns)) {
        return found;
    }
    const std::lock_guard lock(m_lock, std::adopt_lock);
    const NumericLocale locale;
    std::vector<std::string> names = configuredDevices();
    for (const std::shared_ptr<Channel>& channel : m_open) {
        found.push_back(foundDevice(channel->name(), channel->statement()));
        std::erase(names, channel->name());
    }
    for (const std::string& name : names) {
        if (!m_open.empty()) {
            found.push_back({name, name, ""});
            continue;
        }
        HdError error;
        const Hd::Device device = init(*m_hd, name, error);
        if (device == Hd::kNoDevice) {
            found.push_back({name, name, openingError(*m_hd, error).english()});
            continue;
        }
        if (const Status version = checkVersion(*m_hd); version.isOk()) {
            found.push_back(foundDevice(name, readStatement(*m_hd)));
        } else {
            found.push_back({name, name, version.message()});
        }
        disable(*m_hd, device);
    }
    return found;
}

core::Result<std::shared_ptr<Channel>> Scheduler::open(const std::string& wanted, const Settings& settings)
{
    if (!lockWithin(kOpenTimeout_ns)) {
        return noAnswer();
    }
    const std::lock_guard lock(m_lock, std::adopt_lock);
    const NumericLocale locale;
    const std::vector<std::string> names = configuredDevices();
    if (wanted.empty()) {
        const std::string name = defaultOf(names);
        if (name.empty() && names.size() > 1) {
            return Status(
                StatusCode::NotFound,
                PALPATE_TEXT("openhaptics: %1 devices are configured, expected one: choose by \"device\" in "
                             "~/.config/Palpate/openhaptics.json; \"palpate devices\" lists the names and the "
                             "serial numbers"),
                names.size());
        }
        return openNamed(name, settings);
    }
    if (std::find(names.begin(), names.end(), wanted) != names.end()) {
        return openNamed(wanted, settings);
    }
    if (std::any_of(m_open.begin(), m_open.end(),
                    [&wanted](const auto& other) { return other->statement().serial == wanted; })) {
        return alreadyInUse();
    }
    for (const std::string& name : names) { // by serial number
        if (std::any_of(m_open.begin(), m_open.end(), [&name](const auto& other) { return other->name() == name; })) {
            continue;
        }
        auto opened = openNamed(name, settings);
        if (opened.isOk() && opened.value()->statement().serial == wanted) {
            return opened;
        }
        if (opened.isOk()) {
            m_open.pop_back();
            disable(*m_hd, opened.value()->device());
        }
    }
    return Status(StatusCode::NotFound,
                  PALPATE_TEXT("openhaptics: no device has the name or the serial number \"%1\": run the maker's "
                               "Touch_Setup; configurations are read from %2"),
                  wanted, configurationFolder());
}

core::Result<std::shared_ptr<Channel>> Scheduler::openNamed(const std::string& name, const Settings& settings)
{
    if (std::any_of(m_open.begin(), m_open.end(), [&name](const auto& other) { return other->name() == name; })) {
        return alreadyInUse();
    }
    const bool wasRunning = m_isRunning;
    if (!halt()) {
        return noAnswer();
    }
    core::Result<std::shared_ptr<Channel>> opened = openHalted(name, settings);
    if (wasRunning) {
        begin();
    }
    return opened;
}

core::Result<std::shared_ptr<Channel>> Scheduler::openHalted(const std::string& name, const Settings& settings)
{
    HdError error;
    const Hd::Device device = init(*m_hd, name, error);
    if (device == Hd::kNoDevice) {
        return Status(StatusCode::NotFound, PALPATE_TEXT("openhaptics: the device \"%1\" could not be opened: %2"),
                      name.empty() ? "Default Device" : name, openingError(*m_hd, error));
    }
    if (Status version = checkVersion(*m_hd); !version.isOk()) {
        disable(*m_hd, device);
        return version;
    }
    Statement statement = readStatement(*m_hd);
    const Limits limits = limitsOf(statement, settings);
    m_open.push_back(std::make_shared<Channel>(m_hd, name, device, std::move(statement), limits));
    return m_open.back();
}

Status Scheduler::drive(const std::shared_ptr<Channel>& channel)
{
    if (!lockWithin(kOpenTimeout_ns)) {
        return noAnswer();
    }
    {
        const std::lock_guard lock(m_lock, std::adopt_lock);
        const NumericLocale locale;
        const auto free = std::find_if(m_driven.begin(), m_driven.end(),
                                       [](const Driven& driven) { return driven.channel == nullptr; });
        if (free == m_driven.end()) {
            return {StatusCode::Unsupported, PALPATE_TEXT("openhaptics: %1 devices are in use, no more are possible"),
                    kMostDevices};
        }
        if (!halt()) {
            return noAnswer();
        }
        channel->reset();
        *free = {channel, 0, kReopenEvery_ns};
        m_hd->makeCurrentDevice(channel->device());
        channel->enableForces();
        (void)takeErrors(*m_hd);
        ending::arm();
        begin();
        if (!m_isSupervised) {
            m_isSupervised = true;
            std::thread([this] { supervise(); }).detach();
        }
    }
    if (waitUntil(kStartTimeout_ns, [&channel] { return channel->states() > 0; })) {
        return {};
    }
    close(channel);
    return {StatusCode::DeviceLost,
            PALPATE_TEXT("openhaptics: the device was opened but gives no position; switch it off and on")};
}

void Scheduler::close(const std::shared_ptr<Channel>& channel) noexcept
{
    channel->retire();
    if (!lockWithin(kCloseTimeout_ns)) {
        return;
    }
    const std::lock_guard lock(m_lock, std::adopt_lock);
    const NumericLocale locale;
    if (halt()) {
        release(channel);
    }
}

void Scheduler::release(const std::shared_ptr<Channel>& channel) noexcept
{
    const auto driven = std::find_if(m_driven.begin(), m_driven.end(),
                                     [&channel](const Driven& one) { return one.channel == channel; });
    if (driven != m_driven.end()) {
        *driven = {};
    }
    std::erase(m_open, channel);
    if (channel->device() != Hd::kNoDevice) {
        disable(*m_hd, channel->device());
        channel->setDevice(Hd::kNoDevice);
    }
    if (isDriving()) {
        begin();
    } else {
        ending::disarm();
    }
}

bool Scheduler::isDriving() const noexcept
{
    return std::any_of(m_driven.begin(), m_driven.end(),
                       [](const Driven& driven) { return driven.channel != nullptr; });
}

void Scheduler::holdAll(bool isHeld) noexcept
{
    for (const Driven& driven : m_driven) {
        if (driven.channel != nullptr) {
            driven.channel->hold(isHeld);
        }
    }
}

void Scheduler::waitForZero() noexcept
{
    // Not for a library that does not call, and not for devices that do not answer.
    (void)waitUntil(kZeroTimeout_ns, [this] {
        return std::all_of(m_driven.begin(), m_driven.end(), [](const Driven& driven) {
            return driven.channel == nullptr || driven.channel->lostSince_ns() != 0 ||
                   driven.channel->heldFrames() >= kZeroFrames;
        });
    });
}

void Scheduler::begin() noexcept
{
    if (m_hd->setSchedulerRate != nullptr) {
        m_hd->setSchedulerRate(kRate_Hz);
    }
    (void)takeErrors(*m_hd); // a refused rate: the library keeps its own
    m_called_ns = core::monotonicNow_ns();
    m_isOpen = true;
    m_scheduled = m_hd->scheduleAsynchronous(callback, this, Hd::kDefaultPriority);
    m_hd->startScheduler();
    (void)takeErrors(*m_hd);
    m_isRunning = true;
    holdAll(false);
}

bool Scheduler::halt() noexcept
{
    if (!m_isRunning) {
        return true;
    }
    holdAll(true);
    waitForZero();
    m_isOpen = false;
    // A callback that hangs in the library would use devices which are about to change.
    if (!waitUntil(kLeaveTimeout_ns, [this] { return !m_isInside.load(); })) {
        m_isOpen = true;
        holdAll(false);
        return false;
    }
    m_hd->stopScheduler();
    m_hd->unschedule(m_scheduled);
    (void)takeErrors(*m_hd);
    m_isRunning = false;
    m_called_ns = 0;
    return true;
}

unsigned Scheduler::callback(void* scheduler) noexcept
{
    static_cast<Scheduler*>(scheduler)->serve();
    return Hd::kCallbackContinue;
}

void Scheduler::serve() noexcept
{
    if (m_isInside.exchange(true)) {
        return; // twice at once
    }
    if (m_isOpen) {
        const NumericLocale locale;
        m_called_ns = core::monotonicNow_ns();
        const bool isEnding = ending::isNear();
        for (const Driven& driven : m_driven) {
            if (driven.channel != nullptr) {
                driven.channel->frame(isEnding);
            }
        }
        if (isEnding) {
            ending::noteZero();
        }
    }
    m_isInside = false;
}

bool Scheduler::isSilent() const noexcept
{
    const std::int64_t called_ns = m_called_ns;
    return called_ns != 0 && core::monotonicNow_ns() - called_ns > kSilent_ns;
}

void Scheduler::supervise() noexcept
{
    pthread_setname_np(pthread_self(), "palpate-hd");
    for (;;) {
        core::sleepUntil_ns(core::monotonicNow_ns() + kSuperviseEvery_ns);
        if (!m_lock.try_lock()) {
            continue;
        }
        const std::lock_guard lock(m_lock, std::adopt_lock);
        if (!isDriving()) {
            m_isSupervised = false;
            return;
        }
        const NumericLocale locale;
        try {
            recover();
        } catch (const std::exception&) { // no memory: retried later
        }
    }
}

void Scheduler::recover()
{
    const std::int64_t now_ns = core::monotonicNow_ns();
    if (isSilent()) {
        for (const Driven& driven : m_driven) {
            if (driven.channel != nullptr) {
                driven.channel->markLost(now_ns);
            }
        }
        if (now_ns - m_called_ns > kRestartAfter_ns && halt()) {
            begin();
        }
        return;
    }
    for (Driven& driven : m_driven) {
        if (driven.channel != nullptr && driven.channel->isRetired()) {
            if (halt()) { // the library hung when the device was closed
                release(std::shared_ptr<Channel>(driven.channel));
            }
        } else if (driven.channel == nullptr || driven.channel->lostSince_ns() == 0) {
            driven.due_ns = 0;
            driven.pause_ns = kReopenEvery_ns;
        } else if (now_ns >= driven.due_ns && halt()) {
            const bool isAlone = std::all_of(m_driven.begin(), m_driven.end(), [](const Driven& other) {
                return other.channel == nullptr || other.channel->lostSince_ns() != 0;
            });
            reopen(*driven.channel);
            begin();
            driven.pause_ns = isAlone ? kReopenEvery_ns : std::min(2 * driven.pause_ns, kLongestPause_ns);
            driven.due_ns = core::monotonicNow_ns() + driven.pause_ns;
        }
    }
}

void Scheduler::reopen(Channel& channel)
{
    if (channel.device() != Hd::kNoDevice) {
        disable(*m_hd, channel.device());
        channel.setDevice(Hd::kNoDevice);
    }
    HdError error;
    const Hd::Device device = init(*m_hd, channel.name(), error);
    if (device == Hd::kNoDevice) {
        return;
    }
    // Only the same device: another device would have other limits.
    const Statement found = readStatement(*m_hd);
    if (found.serial != channel.statement().serial || found.model != channel.statement().model) {
        disable(*m_hd, device);
        return;
    }
    channel.setDevice(device);
    channel.enableForces();
    (void)takeErrors(*m_hd);
}

} // namespace palpate::openhaptics
