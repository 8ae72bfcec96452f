// SPDX-License-Identifier: BSD-3-Clause
#include "Driver.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <array>
#include <new>
#include <pthread.h>

namespace palpate::spacemouse {

using core::Status;
using core::StatusCode;

namespace {

constexpr int kReadTimeout_ms = 50; // how long `stop` may wait
constexpr std::int64_t kFindEvery_ns = 250'000'000;
constexpr std::array<std::uint8_t, 2> kLightOn{4, 1};
constexpr std::array<std::uint8_t, 2> kLightOff{4, 0};
constexpr std::uint16_t kDesktopPage = 1;
constexpr std::uint16_t kMultiAxis = 8;

} // namespace

std::vector<hid::HidEntry> listMice(std::mutex& bus)
{
    std::vector<hid::HidEntry> mice = hid::listHid(bus, 0, 0);
    std::erase_if(mice, [](const hid::HidEntry& entry) {
        const bool isOtherPart = entry.usagePage != 0 && (entry.usagePage != kDesktopPage || entry.usage != kMultiAxis);
        return isOtherPart || findModel(entry.vendor, entry.product) == nullptr;
    });
    return mice;
}

Driver::Driver(const device::PluginServices& services, const RateSettings& settings, std::string address)
    : m_bus(services.bus)
    , m_settings(settings)
    , m_address(std::move(address))
    , m_hand(settings)
{
}

Driver::~Driver()
{
    stop();
}

device::DeviceInfo Driver::info() const
{
    device::DeviceInfo info;
    info.id = "spacemouse";
    info.name = "SpaceMouse";
    info.sensesOrientation = true;
    info.buttons = 32;
    info.maxForce_N = device::kShownForceLimit_N;
    // As the hand it lies before its user as a force device does: x right, y away, z up.
    Eigen::Matrix3d R_UD;
    R_UD << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    info.q_UD = core::Quaternion(R_UD);
    info.workspaceRadius_mm = m_settings.reach_mm;
    info.isRateControlled = true;
    info.rate_Hz = 125.0;
    return info;
}

std::optional<hid::HidDevice> Driver::find() noexcept
{
    try {
        for (const hid::HidEntry& entry : listMice(m_bus)) {
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
        return {StatusCode::Internal, "spacemouse: already started"};
    }
    const std::vector<hid::HidEntry> mice = listMice(m_bus);
    const auto mouse = std::find_if(mice.begin(), mice.end(), [this](const hid::HidEntry& entry) {
        return m_address.empty() || entry.path == m_address;
    });
    if (mouse == mice.end()) {
        return {StatusCode::NotFound, "spacemouse: no 6-axis mouse is on the bus; plug one in"};
    }
    auto opened = hid::HidDevice::open(m_bus, mouse->path);
    if (!opened.isOk()) {
        return opened.status();
    }
    m_isStopRequested = false;
    m_isLost = false;
    m_isRecentreWanted = false;
    m_states = 0;
    m_refused = 0;
    m_losses = 0;
    m_heard.write(Heard{});
    m_hand = RateHand(m_settings);
    m_thread = std::thread([this, device = std::move(opened).value()]() mutable { run(std::move(device)); });
    return {};
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
    pthread_setname_np(pthread_self(), "palpate-puck");
    std::optional<hid::HidDevice> mouse(std::move(first));
    while (!m_isStopRequested) {
        if (mouse) {
            m_isLost = false;
            serve(*mouse);
            mouse.reset();
            if (m_isStopRequested) {
                return;
            }
            m_heard.write(Heard{}); // an unplugged puck leaves its last way: nobody holds it any more
            m_isLost = true;
            ++m_losses;
        }
        core::sleepUntil_ns(core::monotonicNow_ns() + kFindEvery_ns);
        std::optional<hid::HidDevice> found = find();
        if (found) {
            mouse.emplace(*std::move(found));
        }
    }
}

void Driver::serve(hid::HidDevice& mouse) noexcept
{
    Puck puck;
    std::array<std::uint8_t, 64> buffer{};
    (void)mouse.write(kLightOn); // models without a light refuse; one that is lost shows in the next read
    while (!m_isStopRequested) {
        const int length = mouse.read(buffer, kReadTimeout_ms);
        if (length < 0) {
            return;
        }
        if (length == 0) {
            continue; // it says nothing while nobody holds it
        }
        if (puck.take({buffer.data(), static_cast<std::size_t>(length)})) {
            ++m_states;
            m_heard.write(Heard{puck.held(), core::monotonicNow_ns()});
        } else {
            ++m_refused;
        }
    }
    (void)mouse.write(kLightOff);
}

device::DeviceState Driver::read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING
{
    m_heard.fetch();
    const Heard heard = m_heard.value().get();
    if (m_isRecentreWanted.exchange(false)) {
        m_hand.recentre();
    }
    return m_hand.advance(heard.held, heard.time_ns, now_ns);
}

void Driver::write(const core::Vec3&) noexcept PALPATE_NONBLOCKING {}

device::DeviceReport Driver::report() const
{
    device::DeviceReport report;
    if (m_isLost) {
        report.condition = device::DeviceCondition::Lost;
        report.text = "The SpaceMouse is unplugged; it is found by itself when it is back.";
    }
    report.states = m_states;
    report.refused = m_refused;
    report.losses = m_losses;
    return report;
}

Status Driver::calibrate()
{
    m_isRecentreWanted = true;
    return {};
}

} // namespace palpate::spacemouse
