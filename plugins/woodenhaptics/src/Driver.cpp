// SPDX-License-Identifier: BSD-3-Clause
#include "Driver.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <cctype>
#include <new>
#include <pthread.h>
#include <sched.h>

namespace palpate::woodenhaptics {

using core::Status;
using core::StatusCode;
using device::DeviceCondition;

namespace {

constexpr std::uint16_t kVendor = 0x1234; // mbed's defaults
constexpr std::uint16_t kProduct = 0x0006;
constexpr int kReadTimeout_ms = 10;
constexpr std::int64_t kMillisecond_ns = 1'000'000;
constexpr std::int64_t kStartTimeout_ns = 1500 * kMillisecond_ns;
constexpr std::int64_t kFindEvery_ns = 100 * kMillisecond_ns;
// A force that the servo thread does not renew is not wanted any more.
constexpr std::int64_t kPushEnds_ns = 20 * kMillisecond_ns;
constexpr int kPriority = 75; // above the servo thread's, which waits for nobody; each turn is short

void makeThreadReady() noexcept
{
    pthread_setname_np(pthread_self(), "palpate-arm");
    sched_param param{};
    param.sched_priority = kPriority;
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &param); // without permission it stays as it is
}

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
    : m_bus(services.bus)
    , m_config(config)
    , m_address(std::move(address))
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
    // The arm reaches out along x towards the user and lifts along z, as the kinematics have it.
    Eigen::Matrix3d R_UD;
    R_UD << 0, 1, 0, 0, 0, 1, 1, 0, 0;
    info.q_UD = core::Quaternion(R_UD);
    return info;
}

std::optional<hid::HidDevice> Driver::find() noexcept
{
    try {
        for (const hid::HidEntry& entry : listArms(m_bus)) {
            // An arm that was named keeps its name only while it stays plugged in: afterwards any is taken.
            auto opened = hid::HidDevice::open(m_bus, entry.path);
            if (opened.isOk()) {
                return std::move(opened).value();
            }
        }
    } catch (const std::bad_alloc&) { // tried again later
    }
    return std::nullopt;
}

Status Driver::start()
{
    if (m_thread.joinable()) {
        return {StatusCode::Internal, "woodenhaptics: already started"};
    }
    const std::vector<hid::HidEntry> arms = listArms(m_bus);
    const auto arm = std::find_if(arms.begin(), arms.end(), [this](const hid::HidEntry& entry) {
        return m_address.empty() || entry.path == m_address;
    });
    if (arm == arms.end()) {
        return {StatusCode::NotFound,
                "woodenhaptics: no arm is on the bus (USB 1234:0006); plug it in and switch it on"};
    }
    auto opened = hid::HidDevice::open(m_bus, arm->path);
    if (!opened.isOk()) {
        return opened.status();
    }
    m_isStopRequested = false;
    m_isCalibrationWanted = false;
    m_condition = DeviceCondition::Working;
    m_protocol = 0;
    m_strangeLength = 0;
    m_states = 0;
    m_refused = 0;
    m_losses = 0;
    m_latency.clear();
    m_answers_ns = 0;
    m_push.write(Push{});
    m_state.write(device::DeviceState{});
    m_thread = std::thread([this, device = std::move(opened).value()]() mutable { run(std::move(device)); });
    const std::int64_t deadline_ns = core::monotonicNow_ns() + kStartTimeout_ns;
    while (m_protocol == 0 && core::monotonicNow_ns() < deadline_ns) {
        core::sleepUntil_ns(core::monotonicNow_ns() + kMillisecond_ns);
    }
    if (m_protocol != 0) {
        return {};
    }
    stop();
    if (const std::size_t length = m_strangeLength; length != 0) {
        return {StatusCode::Unsupported, "woodenhaptics: " + arm->path + ": its reports have " +
                                             std::to_string(length) +
                                             " bytes, expected 14 or 8: another device with mbed's ids"};
    }
    return {StatusCode::DeviceLost, "woodenhaptics: " + arm->path + ": it does not answer; is it switched on?"};
}

void Driver::stop() noexcept
{
    if (m_thread.joinable()) {
        m_isStopRequested = true;
        m_thread.join();
    }
}

void Driver::run(hid::HidDevice first) noexcept
{
    makeThreadReady();
    std::optional<hid::HidDevice> arm(std::move(first));
    bool isTrusted = true; // it was switched on in its calibration pose, as its makers ask
    while (!m_isStopRequested) {
        if (arm) {
            serve(*arm, isTrusted);
            isTrusted = false;
            arm.reset();
            if (m_isStopRequested) {
                return;
            }
            device::DeviceState lost;
            lost.isLost = true;
            m_state.write(lost);
            m_condition = DeviceCondition::Lost;
            ++m_losses;
        }
        core::sleepUntil_ns(core::monotonicNow_ns() + kFindEvery_ns);
        std::optional<hid::HidDevice> found = find();
        if (found) {
            arm.emplace(*std::move(found));
        }
    }
}

void Driver::serve(hid::HidDevice& arm, bool isTrusted) noexcept
{
    Conversation talk(m_config, isTrusted);
    const std::uint64_t refusedBefore = m_refused;
    std::array<std::uint8_t, 64> buffer{};
    std::int64_t answered_ns = 0;
    while (!m_isStopRequested) {
        int length = arm.read(buffer, kReadTimeout_ms);
        if (length == 0 && !arm.write(talk.zero())) { // it waits for us: nothing came from it, so nothing is due
            return;
        }
        bool isNew = false;
        bool isAnswerDue = false;
        // The queue may hold several; all are looked at, because counters that wrap must not miss one, and the newest
        // is answered.
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
        m_strangeLength = talk.strangeLength();
        publish(talk);
        if (m_isCalibrationWanted.exchange(false)) {
            talk.calibrate();
        }
        m_push.fetch();
        const Push push = m_push.value().get();
        const std::int64_t now_ns = core::monotonicNow_ns();
        const bool isWanted = isNew && now_ns - push.time_ns < kPushEnds_ns;
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
    m_answers_ns = state.time_ns;
    return state;
}

void Driver::write(const core::Vec3& f_D) noexcept PALPATE_NONBLOCKING
{
    m_push.write(Push{f_D, m_answers_ns, core::monotonicNow_ns()});
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
