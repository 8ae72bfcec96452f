// SPDX-License-Identifier: BSD-3-Clause
#include "Driver.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <cctype>
#include <pthread.h>
#include <sched.h>
#include <utility>

namespace palpate::woodenhaptics {

using core::Status;
using core::StatusCode;
using device::DeviceCondition;

namespace {

constexpr std::uint16_t kVendor = 0x1234; // mbed's default ids
constexpr std::uint16_t kProduct = 0x0006;
constexpr int kReadTimeout_ms = 10;
constexpr std::int64_t kMillisecond_ns = 1'000'000;
constexpr std::int64_t kStartTimeout_ns = 1500 * kMillisecond_ns;
constexpr hid::HidDriver::Kind kKind{
    "woodenhaptics", PALPATE_TEXT("no WoodenHaptics arm is connected (USB 1234:0006): plug it in and switch it on"),
    100 * kMillisecond_ns};
// A force expires unless the servo thread renews it.
constexpr std::int64_t kForceTimeout_ns = 20 * kMillisecond_ns;
constexpr int kPriority = 75; // above the servo thread; each iteration is short

} // namespace

std::vector<hid::HidEntry> listArms(std::mutex& bus)
{
    std::vector<hid::HidEntry> arms = hid::listHid(bus, kVendor, kProduct);
    std::erase_if(arms, [](const hid::HidEntry& entry) {
        std::string name = entry.productName;
        std::transform(name.begin(), name.end(), name.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        const char* const ours[] = {"wooden", "polhem", "hapti", "hid device"}; // the last is mbed's default
        return !name.empty() && std::none_of(std::begin(ours), std::end(ours), [&name](const char* part) {
            return name.find(part) != std::string::npos;
        });
    });
    return arms;
}

Driver::Driver(const device::PluginServices& services, const Config& config, std::string address)
    : HidDriver(services, kKind, std::move(address))
    , m_config(config)
{
}

Driver::~Driver()
{
    stop();
}

device::DeviceInfo Driver::info() const
{
    device::DeviceInfo info;
    info.id = "woodenhaptics";
    info.name = m_config.variant == 1 ? "WoodenHaptics (rebuilt PHANToM)" : "WoodenHaptics";
    info.actuatedAxes = 3;
    info.maxForce_N = m_config.maxForce_N;
    info.maxStiffness_N_per_mm = m_config.maxStiffness_N_per_m * 1e-3;
    info.maxDamping_Ns_per_mm = m_config.maxDamping_Ns_per_m * 1e-3;
    info.resolution_mm = Kinematics(m_config).resolution_m() * 1e3;
    info.workspaceRadius_mm = m_config.workspaceRadius_m * 1e3;
    // In the frame of the kinematics, the arm extends along x towards the user, and z points up.
    Eigen::Matrix3d R_UD;
    R_UD << 0, 1, 0, 0, 0, 1, 1, 0, 0;
    info.q_UD = core::Quaternion(R_UD);
    return info;
}

Status Driver::start()
{
    auto opened = open();
    if (!opened.isOk()) {
        return opened.status();
    }
    m_isCalibrationWanted = false;
    m_condition = DeviceCondition::Working;
    m_protocol = 0;
    m_unexpectedLength = 0;
    m_isTrusted = true;
    m_latency.clear();
    m_readState_ns = 0;
    m_push.write(ForceCommand{});
    m_state.write(device::DeviceState{});
    run(std::move(opened).value());
    const std::int64_t deadline_ns = core::monotonicNow_ns() + kStartTimeout_ns;
    while (m_protocol == 0 && core::monotonicNow_ns() < deadline_ns) {
        core::sleepUntil_ns(core::monotonicNow_ns() + kMillisecond_ns);
    }
    if (m_protocol != 0) {
        return {};
    }
    stop();
    if (const std::size_t length = m_unexpectedLength; length != 0) {
        return {StatusCode::Unsupported,
                PALPATE_TEXT("woodenhaptics: %1: its reports have %2 bytes, expected 14 or 8: another device with "
                             "mbed's ids"),
                path(), length};
    }
    return {StatusCode::DeviceLost, PALPATE_TEXT("woodenhaptics: %1: it does not answer; is it switched on?"), path()};
}

void Driver::prepareThread() noexcept
{
    pthread_setname_np(pthread_self(), "palpate-arm");
    sched_param param{};
    param.sched_priority = kPriority;
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &param); // without permission the policy stays unchanged
}

void Driver::onDeviceLost() noexcept
{
    device::DeviceState lost;
    lost.isLost = true;
    m_state.write(lost);
    m_condition = DeviceCondition::Lost;
}

void Driver::serve(hid::HidDevice& arm) noexcept
{
    Conversation talk(m_config, std::exchange(m_isTrusted, false));
    const std::uint64_t refusedBefore = m_refused;
    std::array<std::uint8_t, 64> buffer{};
    std::int64_t answered_ns = 0;
    while (!isStopWanted()) {
        int length = arm.read(buffer, kReadTimeout_ms);
        // The firmware waits for the host; without a report, no answer is due.
        if (length == 0 && !arm.write(talk.zero())) {
            return;
        }
        bool isNew = false;
        bool isAnswerDue = false;
        // The queue may hold several reports. All are processed, because no report may be skipped when unwrapping
        // counters; only the latest is answered.
        for (; length > 0; length = arm.read(buffer, 0)) {
            isNew = talk.take({buffer.data(), static_cast<std::size_t>(length)}, core::monotonicNow_ns());
            isAnswerDue = true;
            m_states += isNew ? 1 : 0;
        }
        if (length < 0) {
            return;
        }
        if (!isAnswerDue) {
            continue;
        }
        m_refused = refusedBefore + talk.refused();
        m_unexpectedLength = talk.unexpectedLength();
        publish(talk);
        if (m_isCalibrationWanted.exchange(false)) {
            talk.calibrate();
        }
        m_push.fetch();
        const ForceCommand push = m_push.value().get();
        const std::int64_t now_ns = core::monotonicNow_ns();
        const bool isWanted = isNew && now_ns - push.time_ns < kForceTimeout_ns;
        if (!arm.write(talk.answer(isWanted ? push.f_D : core::Vec3::Zero(), now_ns))) {
            return;
        }
        if (isWanted && push.answers_ns > answered_ns) {
            answered_ns = push.answers_ns;
            m_latency.add(core::monotonicNow_ns() - push.answers_ns);
        }
    }
    (void)arm.write(talk.zero());
}

void Driver::publish(const Conversation& talk) noexcept
{
    if (talk.protocol() == 0) {
        return;
    }
    m_state.write(talk.state());
    m_condition = talk.isCalibrated() ? DeviceCondition::Working : DeviceCondition::NeedsCalibration;
    m_protocol = talk.protocol();
}

device::DeviceState Driver::read(std::int64_t) noexcept PALPATE_NONBLOCKING
{
    m_state.fetch();
    const device::DeviceState state = m_state.value().get();
    m_readState_ns = state.time_ns;
    return state;
}

void Driver::write(const core::Vec3& f_D) noexcept PALPATE_NONBLOCKING
{
    m_push.write(ForceCommand{f_D, m_readState_ns, core::monotonicNow_ns()});
}

device::DeviceReport Driver::report() const
{
    device::DeviceReport report;
    report.condition = m_condition;
    if (report.condition == DeviceCondition::Lost) {
        report.text = "The arm does not answer. Plug it in again; it is found by itself.";
    } else if (report.condition == DeviceCondition::NeedsCalibration) {
        report.text = "Hold the arm in its calibration pose and press its button, or choose Calibrate.";
    }
    report.latency = m_latency.summary();
    report.states = m_states;
    report.refused = m_refused;
    report.losses = m_losses;
    return report;
}

Status Driver::calibrate()
{
    m_isCalibrationWanted = true;
    return {};
}

} // namespace palpate::woodenhaptics
