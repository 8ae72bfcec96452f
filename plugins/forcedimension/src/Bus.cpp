// SPDX-License-Identifier: BSD-3-Clause
#include "Bus.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace palpate::forcedimension {

using core::Status;
using core::StatusCode;

namespace {

constexpr int kMostDevices = 16;

device::FoundDevice foundDevice(const DeviceIdentity& identity)
{
    const std::string serial = identity.serial > 0 ? std::to_string(identity.serial) : "";
    return {identity.name, serial, ""};
}

} // namespace

std::vector<device::FoundDevice> Bus::list()
{
    const std::lock_guard lock(m_mutex);
    std::vector<device::FoundDevice> found;
    if (!m_open.empty()) {
        std::transform(m_open.begin(), m_open.end(), std::back_inserter(found), foundDevice);
        return found;
    }
    const int count = std::min(m_dhd->getDeviceCount(), kMostDevices);
    for (int index = 0; index < count; ++index) {
        const int id = m_dhd->openID(static_cast<char>(index));
        if (id < 0) {
            found.push_back({"Force Dimension device", "", openingError(*m_dhd).english()});
            continue;
        }
        found.push_back(foundDevice(identify(*m_dhd, static_cast<char>(id))));
        m_dhd->close(static_cast<char>(id));
    }
    return found;
}

core::Result<std::unique_ptr<OpenDevice>> Bus::open(int serial)
{
    const std::lock_guard lock(m_mutex);
    int opened = -1;
    if (serial > 0) {
        opened = m_dhd->openSerial(serial);
        if (opened < 0) {
            return Status(StatusCode::NotFound,
                          PALPATE_TEXT("forcedimension: the device with serial number %1 could not be opened: %2"),
                          serial, openingError(*m_dhd));
        }
    } else {
        const int count = m_dhd->getDeviceCount();
        if (count <= 0) {
            return Status(StatusCode::NotFound,
                          PALPATE_TEXT("forcedimension: no device is connected: plug it in, switch it on, and install "
                                       "Palpate's udev rule (in lib/udev/rules.d)"));
        }
        if (count > 1) {
            return Status(StatusCode::NotFound,
                          PALPATE_TEXT("forcedimension: %1 devices are connected, expected one: choose by \"serial\" "
                                       "in ~/.config/Palpate/forcedimension.json; \"palpate devices\" lists the "
                                       "serial numbers"),
                          count);
        }
        opened = m_dhd->openID(0);
        if (opened < 0) {
            return Status(StatusCode::NotFound, PALPATE_TEXT("forcedimension: the device could not be opened: %1"),
                          openingError(*m_dhd));
        }
    }
    const char id = static_cast<char>(opened);
    if (std::any_of(m_open.begin(), m_open.end(), [id](const DeviceIdentity& other) { return other.id == id; })) {
        return Status(StatusCode::NotFound, PALPATE_TEXT("forcedimension: the device is already in use by this "
                                                         "program"));
    }
    DeviceIdentity identity = identify(*m_dhd, id);
    if (serial > 0 && identity.serial != serial) {
        m_dhd->close(id);
        return Status(StatusCode::Mismatch,
                      PALPATE_TEXT("forcedimension: found the serial number %1, expected %2; plug the device in again"),
                      identity.serial, serial);
    }
    m_open.push_back(identity);
    return std::make_unique<OpenDevice>(m_dhd, std::move(identity));
}

void Bus::close(std::unique_ptr<OpenDevice> device) noexcept
{
    device->letGo(); // before waiting for other devices to be opened or closed
    const std::lock_guard lock(m_mutex);
    std::erase_if(m_open, [&device](const DeviceIdentity& other) { return other.id == device->identity().id; });
    device.reset();
}

} // namespace palpate::forcedimension
