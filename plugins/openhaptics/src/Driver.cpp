// SPDX-License-Identifier: BSD-3-Clause
#include "Driver.h"

#include <utility>

namespace palpate::openhaptics {

using core::Status;
using core::StatusCode;
using device::DeviceCondition;

namespace {

constexpr double kSlow_Hz = 900.0;

/// Instruction for the user; empty without trouble.
const char* troubleText(Trouble trouble)
{
    switch (trouble) {
    case Trouble::NeedsUpdate:
        return "The device is being calibrated. Move the stylus a little.";
    case Trouble::NeedsInkwell:
        return "The device is not calibrated. Put the stylus into the inkwell, wait two seconds, and take it out.";
    case Trouble::NeedsReset:
        return "The device is not calibrated. Hold its arm in the reset pose, with right angles between all links, and "
               "choose Device > Calibrate.";
    case Trouble::TooFast:
        return "The device was moved too fast, and its library took the force away. It returns by itself.";
    case Trouble::TooMuchForce:
        return "The library of the device refused a force. The force returns by itself.";
    case Trouble::NoLicence:
        return "The licence of OpenHaptics is missing or has expired. Install the licence with the maker's tools.";
    case Trouble::None:
    case Trouble::Starting:
        break;
    }
    return "";
}

} // namespace

Driver::Driver(Scheduler& scheduler, Settings settings, std::string wanted)
    : m_scheduler(scheduler)
    , m_settings(std::move(settings))
    , m_wanted(std::move(wanted))
    , m_limits(limitsOf({}, m_settings))
    , m_name(m_limits.name)
{
    // Callers need the limits before `start`, which opens a missing device again and reports the reason.
    (void)open();
}

Driver::~Driver()
{
    stop();
}

Status Driver::open()
{
    auto opened = m_scheduler.open(m_wanted, m_settings);
    if (!opened.isOk()) {
        return opened.status();
    }
    m_channel = std::move(opened).value();
    m_limits = m_channel->limits();
    m_name = m_channel->statement().model.empty() ? std::string(m_limits.name) : m_channel->statement().model;
    return {};
}

device::DeviceInfo Driver::info() const
{
    device::DeviceInfo info;
    info.id = "openhaptics";
    info.name = m_name;
    info.sensesOrientation = true;
    info.buttons = kButtons;
    info.actuatedAxes = 3;
    info.maxForce_N = m_limits.maxForce_N;
    info.maxStiffness_N_per_mm = m_limits.maxStiffness_N_per_mm;
    info.maxDamping_Ns_per_mm = m_limits.maxDamping_Ns_per_mm;
    info.resolution_mm = m_limits.resolution_mm;
    info.workspaceRadius_mm = m_limits.workspaceRadius_mm;
    return info; // the frame of the device is the user frame: x to the right, y up, z towards the user
}

Status Driver::start()
{
    if (m_isStarted) {
        return {StatusCode::Internal, PALPATE_TEXT("%1: already started"), "openhaptics"};
    }
    if (m_channel == nullptr) {
        if (Status opened = open(); !opened.isOk()) {
            return opened;
        }
    }
    Status driven = m_scheduler.drive(m_channel);
    if (!driven.isOk()) { // unplugged since it was opened
        m_scheduler.close(m_channel);
        m_channel.reset();
        if (Status opened = open(); !opened.isOk()) {
            return opened;
        }
        driven = m_scheduler.drive(m_channel);
    }
    m_isStarted = driven.isOk();
    if (!m_isStarted) {
        stop();
    }
    return driven;
}

void Driver::stop() noexcept
{
    if (m_channel != nullptr) {
        m_scheduler.close(m_channel);
        m_channel.reset();
    }
    m_isStarted = false;
}

device::DeviceState Driver::read(std::int64_t) noexcept PALPATE_NONBLOCKING
{
    return m_channel == nullptr ? device::DeviceState{} : m_channel->exchange().read();
}

void Driver::write(const core::Vec3& f_D) noexcept PALPATE_NONBLOCKING
{
    if (m_channel != nullptr) {
        m_channel->exchange().write(f_D);
    }
}

device::DeviceReport Driver::report() const
{
    device::DeviceReport report;
    if (m_channel == nullptr) {
        return report;
    }
    const Channel& channel = *m_channel;
    const Trouble trouble = channel.trouble();
    if (m_isStarted && m_scheduler.isSilent()) {
        report.condition = DeviceCondition::Lost;
        report.text =
            "The library of the device does not answer. Check cable and power; it is started again by itself.";
    } else if (channel.lostSince_ns() != 0) {
        report.condition = DeviceCondition::Lost;
        report.text = "The device does not answer. Check its cable and power; it is found by itself.";
    } else if (trouble != Trouble::None && trouble != Trouble::Starting) {
        report.condition = DeviceCondition::NeedsCalibration;
        report.text = troubleText(trouble);
    } else if (channel.isWarm()) {
        report.text = "The motors are warm. The force is reduced until they have cooled down.";
    } else if (channel.rate_Hz() > 0.0 && channel.rate_Hz() < kSlow_Hz) {
        report.text = "The library runs the device at less than 1 kHz: stiff surfaces may vibrate.";
    } else if (!m_limits.isKnown && m_settings.maxForce_N <= 0.0) {
        report.text = "The limits of this model are not known, so it is driven with 3 N. Set max_force_N, "
                      "max_stiffness_N_per_mm and workspace_radius_mm in openhaptics.json.";
    }
    report.latency = channel.exchange().latency();
    report.states = channel.states();
    report.refused = channel.refused();
    report.losses = channel.losses();
    return report;
}

Status Driver::calibrate()
{
    if (m_channel == nullptr) {
        return {StatusCode::DeviceLost, PALPATE_TEXT("The device is not connected.")};
    }
    const unsigned styles = m_channel->statement().calibrationStyles;
    if ((styles & (kEncoderReset | kAutomatic)) == 0 && (styles & kInkwell) != 0) {
        return {StatusCode::Unsupported,
                PALPATE_TEXT("This device is calibrated in its inkwell: put the stylus into it, wait two seconds, and "
                             "take it out.")};
    }
    m_channel->requestCalibration();
    return {};
}

} // namespace palpate::openhaptics
