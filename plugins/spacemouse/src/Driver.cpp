// SPDX-License-Identifier: BSD-3-Clause
#include "Driver.h"

#include <palpate/core/Clock.h>

#include <array>
#include <pthread.h>

namespace palpate::spacemouse {

using core::Status;
using core::StatusCode;

namespace {

constexpr int kReadTimeout_ms = 50; // maximum delay of `stop`
constexpr hid::HidDriver::Kind kKind{"spacemouse", PALPATE_TEXT("no 6-axis mouse is connected: plug one in"),
                                     250'000'000};
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
    : HidDriver(services, kKind, std::move(address))
    , m_settings(settings)
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
    // As the hand, the mouse is in front of the user like a force-feedback device: x right, y away, z up.
    Eigen::Matrix3d R_UD;
    R_UD << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    info.q_UD = core::Quaternion(R_UD);
    info.workspaceRadius_mm = m_settings.reach_mm;
    info.isRateControlled = true;
    info.rate_Hz = 125.0;
    return info;
}

Status Driver::start()
{
    auto opened = open();
    if (!opened.isOk()) {
        return opened.status();
    }
    m_isLost = false;
    m_isRecentreWanted = false;
    m_heard.write(Heard{});
    m_hand = RateHand(m_settings);
    run(std::move(opened).value());
    return {};
}

void Driver::prepareThread() noexcept
{
    pthread_setname_np(pthread_self(), "palpate-puck");
}

void Driver::onDeviceLost() noexcept
{
    m_heard.write(Heard{}); // unplugging leaves the last deflection in place although the puck is no longer held
    m_isLost = true;
}

void Driver::serve(hid::HidDevice& mouse) noexcept
{
    m_isLost = false;
    Puck puck;
    std::array<std::uint8_t, 64> buffer{};
    (void)mouse.write(kLightOn); // models without a light refuse this; a lost device is detected by the next read
    while (!isStopWanted()) {
        const int length = mouse.read(buffer, kReadTimeout_ms);
        if (length < 0) {
            return;
        }
        if (length == 0) {
            continue; // the puck sends no reports at rest
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
