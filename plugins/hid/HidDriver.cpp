// SPDX-License-Identifier: BSD-3-Clause
#include "HidDriver.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <new>
#include <utility>

namespace palpate::hid {

using core::Status;
using core::StatusCode;

HidDriver::HidDriver(const device::PluginServices& services, const Kind& kind, std::string address)
    : m_bus(services.bus)
    , m_kind(kind)
    , m_address(std::move(address))
{
}

core::Result<HidDevice> HidDriver::open()
{
    if (isRunning()) {
        return Status(StatusCode::Internal, PALPATE_TEXT("%1: already started"), m_kind.id);
    }
    const std::vector<HidEntry> there = list(m_bus);
    const auto found = std::find_if(there.begin(), there.end(), [this](const HidEntry& entry) {
        return m_address.empty() || entry.path == m_address;
    });
    if (found == there.end()) {
        return Status(StatusCode::NotFound, PALPATE_TEXT("%1: %2"), m_kind.id, core::Message(m_kind.missing));
    }
    m_path = found->path;
    return HidDevice::open(m_bus, m_path);
}

void HidDriver::run(HidDevice device)
{
    m_isStopWanted = false;
    m_states = 0;
    m_refused = 0;
    m_losses = 0;
    m_thread = std::thread([this, first = std::move(device)]() mutable { talk(std::move(first)); });
}

void HidDriver::stop() noexcept
{
    if (m_thread.joinable()) {
        m_isStopWanted = true;
        m_thread.join();
    }
}

void HidDriver::talk(HidDevice first) noexcept
{
    prepareThread();
    std::optional<HidDevice> device(std::move(first));
    while (!m_isStopWanted) {
        if (device) {
            serve(*device);
            device.reset();
            if (m_isStopWanted) {
                return;
            }
            onDeviceLost();
            ++m_losses;
        }
        core::sleepUntil_ns(core::monotonicNow_ns() + m_kind.findEvery_ns);
        std::optional<HidDevice> found = find();
        if (found) {
            device.emplace(*std::move(found));
        }
    }
}

std::optional<HidDevice> HidDriver::find() noexcept
{
    try {
        // A path is valid only while its device stays plugged in, so any matching device is accepted when
        // reconnecting.
        for (const HidEntry& entry : list(m_bus)) {
            auto opened = HidDevice::open(m_bus, entry.path);
            if (opened.isOk()) {
                return std::move(opened).value();
            }
        }
    } catch (const std::bad_alloc&) { // retried later
    }
    return std::nullopt;
}

} // namespace palpate::hid
