// SPDX-License-Identifier: BSD-3-Clause
#include "Driver.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <new>
#include <pthread.h>
#include <sched.h>
#include <utility>

namespace palpate::forcedimension {

using core::Status;
using core::StatusCode;
using device::DeviceCondition;
using Reading = OpenDevice::Reading;

namespace {

constexpr std::int64_t kMillisecond_ns = 1'000'000;
constexpr std::int64_t kPeriod_ns = kMillisecond_ns / 4; // shortest loop of the I/O thread, where no call blocks
constexpr std::int64_t kStatusEvery_ns = 10 * kMillisecond_ns;
constexpr std::int64_t kEnableEvery_ns = 100 * kMillisecond_ns;
constexpr std::int64_t kFindEvery_ns = 100 * kMillisecond_ns;
// Without a successful call for so long, the device is opened anew.
constexpr std::int64_t kLostAfter_ns = 100 * kMillisecond_ns;
constexpr int kStartAttempts = 10;
constexpr int kWatchdogAttempts = 50; // half a second; then the device works without, and `report` warns
constexpr int kButtons = 8;
constexpr int kPriority = 75; // above the servo thread; each iteration is short

/// Instruction for the user; empty without trouble.
const char* troubleText(Trouble trouble)
{
    switch (trouble) {
    case Trouble::NoPower:
        return "The device has no power. Connect its power supply and switch it on.";
    case Trouble::Reset:
        return "The device is not calibrated. Put the end of its handle into the calibration pit and hold it there "
               "until its light is steady.";
    case Trouble::Fault:
        return "The device reports a fault. Switch it off, wait five seconds, and switch it on again.";
    case Trouble::TooFast:
        return "The device was moved too fast and has braked itself. Forces are off: press the device's button.";
    case Trouble::ForcesOff:
        return "Forces are off. Press the device's button.";
    case Trouble::DeadMan:
        return "The device feels no hand. Hold its handle.";
    case Trouble::Watchdog:
        return "The link to the device was interrupted. Forces are being enabled again.";
    case Trouble::None:
    case Trouble::Starting:
        break;
    }
    return "";
}

Trouble troubleOf(const std::array<int, Dhd::kStatusCount>& status)
{
    if (status[kStatusPower] == 0) {
        return Trouble::NoPower;
    }
    if (status[kStatusReset] != 0) {
        return Trouble::Reset;
    }
    if (status[kStatusError] != 0) {
        return Trouble::Fault;
    }
    if (status[kStatusForce] != 0 && status[kStatusBrake] == 0) {
        return Trouble::None;
    }
    switch (static_cast<ForceOffCause>(status[kStatusForceOffCause])) {
    case ForceOffCause::None: // forces are not enabled yet, as after opening
    case ForceOffCause::Watchdog:
    case ForceOffCause::Usb:
        return Trouble::Watchdog;
    case ForceOffCause::Velocity:
        return Trouble::TooFast;
    case ForceOffCause::DeadMan:
        return Trouble::DeadMan;
    default:
        return Trouble::ForcesOff;
    }
}

/// Tries to read a position.
bool answers(OpenDevice& device)
{
    core::Vec3 p_mm = core::Vec3::Zero();
    core::Quaternion q = core::Quaternion::Identity();
    for (int i = 0; i < kStartAttempts; ++i) {
        if (device.sense(p_mm, q) != Reading::Failed) {
            return true;
        }
        core::sleepUntil_ns(core::monotonicNow_ns() + kMillisecond_ns);
    }
    return false;
}

} // namespace

Driver::Driver(std::shared_ptr<Bus> bus, Settings settings, int serial)
    : m_bus(std::move(bus))
    , m_settings(std::move(settings))
    , m_serial(serial)
    , m_model(limited(modelOf(-1), m_settings, 0.0))
{
    // Callers need the limits before `start`, which opens a missing device again and reports the reason.
    if (auto opened = m_bus->open(m_serial); opened.isOk()) {
        m_ready = std::move(opened).value();
        adopt(*m_ready);
    }
}

Driver::~Driver()
{
    stop();
    if (m_ready != nullptr) {
        m_bus->close(std::move(m_ready));
    }
}

void Driver::adopt(const OpenDevice& device)
{
    m_identity = device.identity();
    m_model = limited(modelOf(m_identity.type), m_settings, device.reportedForce_N());
}

device::DeviceInfo Driver::info() const
{
    device::DeviceInfo info;
    info.id = "forcedimension";
    info.name = m_identity.name.empty() ? std::string(m_model.name) : m_identity.name;
    info.sensesOrientation = m_identity.hasWrist;
    info.buttons = kButtons;
    info.actuatedAxes = 3;
    info.maxForce_N = m_model.maxForce_N;
    info.maxStiffness_N_per_mm = m_model.maxStiffness_N_per_mm;
    info.maxDamping_Ns_per_mm = m_model.maxDamping_Ns_per_mm;
    info.resolution_mm = m_model.resolution_mm;
    info.workspaceRadius_mm = m_model.workspaceRadius_mm;
    // In the device's frame, x points to the user, y to the right, z up (CHAI3D passes positions on unchanged).
    Eigen::Matrix3d R_UD;
    R_UD << 0, 1, 0, 0, 0, 1, 1, 0, 0;
    info.q_UD = core::Quaternion(R_UD);
    return info;
}

Status Driver::start()
{
    if (m_thread.joinable()) {
        return {StatusCode::Internal, PALPATE_TEXT("%1: already started"), "forcedimension"};
    }
    std::unique_ptr<OpenDevice> device = std::move(m_ready);
    if (device != nullptr && !answers(*device)) { // unplugged since
        m_bus->close(std::move(device));
    }
    if (device == nullptr) {
        auto opened = m_bus->open(m_serial);
        if (!opened.isOk()) {
            return opened.status();
        }
        device = std::move(opened).value();
        if (!answers(*device)) {
            m_bus->close(std::move(device));
            return {StatusCode::DeviceLost,
                    PALPATE_TEXT("forcedimension: the device was opened but gives no position; switch it off and on")};
        }
    }
    adopt(*device);
    m_sensed = {};
    m_isStopWanted = false;
    m_isLost = false;
    m_states = 0;
    m_refused = 0;
    m_losses = 0;
    m_exchange.reset();
    m_thread = std::thread([this, first = std::move(device)]() mutable { run(std::move(first)); });
    return {};
}

void Driver::stop() noexcept
{
    if (m_thread.joinable()) {
        m_isStopWanted = true;
        m_thread.join();
    }
}

void Driver::run(std::unique_ptr<OpenDevice> device) noexcept
{
    pthread_setname_np(pthread_self(), "palpate-dhd");
    sched_param param{};
    param.sched_priority = kPriority;
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &param); // without permission the policy stays unchanged
    while (!m_isStopWanted) {
        if (device != nullptr) {
            serve(*device);
            m_bus->close(std::move(device));
            if (m_isStopWanted) {
                return;
            }
            m_isLost = true;
            ++m_losses;
            publish(false, true);
        }
        core::sleepUntil_ns(core::monotonicNow_ns() + kFindEvery_ns);
        device = reopen();
    }
    if (device != nullptr) {
        m_bus->close(std::move(device));
    }
}

std::unique_ptr<OpenDevice> Driver::reopen() noexcept
{
    try {
        // Only the same device: another device would have other limits.
        auto opened = m_bus->open(m_identity.serial > 0 ? m_identity.serial : m_serial);
        if (opened.isOk() && opened.value()->identity().type == m_identity.type) {
            return std::move(opened).value();
        }
        if (opened.isOk()) {
            m_bus->close(std::move(opened).value());
        }
    } catch (const std::bad_alloc&) { // retried later
    }
    return nullptr;
}

void Driver::serve(OpenDevice& device) noexcept
{
    m_trouble = Trouble::Starting;
    m_isWatched = false;
    m_watchdogAttempts = 0;
    device.enableForces(m_model.maxForce_N);
    m_enabled_ns = core::monotonicNow_ns();
    std::int64_t answered_ns = m_enabled_ns; // last success of both calls
    std::int64_t statusDue_ns = 0;
    while (!m_isStopWanted) {
        const std::int64_t begin_ns = core::monotonicNow_ns();
        core::Vec3 p_mm = core::Vec3::Zero();
        const Reading reading = device.sense(p_mm, m_sensed.q_D);
        if (begin_ns >= statusDue_ns) {
            statusDue_ns = begin_ns + kStatusEvery_ns;
            checkStatus(device);
        }
        if (reading == Reading::New) {
            ++m_states;
            m_sensed.p_D = p_mm - m_model.centre_mm;
            // The position may have been measured at any time during the call.
            m_sensed.time_ns = begin_ns;
            m_isLost = false;
            publish(m_trouble == Trouble::None, false);
        } else if (reading == Reading::Implausible) {
            ++m_refused;
        }
        const std::int64_t now_ns = core::monotonicNow_ns();
        const bool isSensed = reading == Reading::New || reading == Reading::Same;
        const core::Vec3 f_D = isSensed ? wantedForce(now_ns) : core::Vec3(core::Vec3::Zero());
        const bool isPushed = device.push(f_D);
        if (isPushed) {
            m_exchange.noteSent(f_D, core::monotonicNow_ns());
        }
        if (isPushed && reading != Reading::Failed) {
            answered_ns = now_ns;
        } else if (now_ns - answered_ns > kLostAfter_ns) {
            return;
        }
        core::sleepUntil_ns(begin_ns + kPeriod_ns);
    }
}

void Driver::checkStatus(OpenDevice& device) noexcept
{
    std::array<int, Dhd::kStatusCount> status{};
    if (!device.status(status)) {
        return; // the next reading fails as well if the device is lost
    }
    m_sensed.buttons = device.buttons() & ((1U << kButtons) - 1U);
    const Trouble trouble = troubleOf(status);
    if (trouble == Trouble::Watchdog) {
        // The hand is away in the meantime, so that the gate eases the force in when it is back.
        const std::int64_t now_ns = core::monotonicNow_ns();
        if (now_ns - m_enabled_ns > kEnableEvery_ns) {
            m_enabled_ns = now_ns;
            device.enableForces(m_model.maxForce_N);
        }
    }
    if (!m_isWatched && m_watchdogAttempts < kWatchdogAttempts) {
        ++m_watchdogAttempts;
        m_isWatched = device.setWatchdog();
    }
    const bool isReady = m_isWatched || m_watchdogAttempts == kWatchdogAttempts;
    m_trouble = trouble == Trouble::None && !isReady ? Trouble::Starting : trouble;
}

core::Vec3 Driver::wantedForce(std::int64_t now_ns) noexcept
{
    const core::Vec3 f_D = m_exchange.wantedForce(now_ns, m_model.maxForce_N);
    return m_trouble == Trouble::None ? f_D : core::Vec3(core::Vec3::Zero());
}

void Driver::publish(bool isPresent, bool isLost) noexcept
{
    device::DeviceState state = m_sensed;
    state.isPresent = isPresent;
    state.isLost = isLost;
    m_exchange.publish(state);
}

device::DeviceState Driver::read(std::int64_t) noexcept PALPATE_NONBLOCKING
{
    return m_exchange.read();
}

void Driver::write(const core::Vec3& f_D) noexcept PALPATE_NONBLOCKING
{
    m_exchange.write(f_D);
}

device::DeviceReport Driver::report() const
{
    device::DeviceReport report;
    const Trouble trouble = m_trouble;
    if (m_isLost) {
        report.condition = DeviceCondition::Lost;
        report.text = "The device does not answer. Check its cable and power; it is found by itself.";
    } else if (trouble != Trouble::None && trouble != Trouble::Starting) {
        report.condition = DeviceCondition::NeedsCalibration;
        report.text = troubleText(trouble);
    } else if (!m_isWatched && trouble == Trouble::None) {
        report.text = "The device's watchdog could not be set: if Palpate crashes, switch the device off.";
    } else if (!m_model.isKnown && m_settings.maxForce_N <= 0.0) {
        report.text = "The limits of this model are not known, so it is driven with 3 N. Set max_force_N, "
                      "max_stiffness_N_per_mm and workspace_radius_mm in forcedimension.json.";
    }
    report.latency = m_exchange.latency();
    report.states = m_states;
    report.refused = m_refused;
    report.losses = m_losses;
    return report;
}

Status Driver::calibrate()
{
    return {StatusCode::Unsupported,
            PALPATE_TEXT("This device is calibrated at the device: put the end of its handle into the calibration pit "
                         "and hold it there until its light is steady.")};
}

} // namespace palpate::forcedimension
