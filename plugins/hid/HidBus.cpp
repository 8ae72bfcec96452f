// SPDX-License-Identifier: BSD-3-Clause
#include "hid/HidBus.h"

#include <hidapi/hidapi.h>

#include <cwchar>
#include <unistd.h>
#include <utility>

namespace palpate::hid {

using core::Status;
using core::StatusCode;

namespace {

std::string utf8(const wchar_t* text)
{
    std::string out;
    for (; text != nullptr && *text != 0; ++text) {
        const auto c = static_cast<std::uint32_t>(*text);
        if (c < 0x80) {
            out += static_cast<char>(c);
        } else if (c < 0x800) {
            out += static_cast<char>(0xc0 | (c >> 6));
            out += static_cast<char>(0x80 | (c & 0x3f));
        } else {
            out += '?'; // device names are plain text
        }
    }
    return out;
}

core::Message permissionProblem(const std::string& path)
{
    if (path.starts_with("/dev/") && access(path.c_str(), R_OK | W_OK) != 0) {
        return {PALPATE_TEXT("%1 may not be opened: install Palpate's udev rule (in lib/udev/rules.d) and plug the "
                             "device in anew"),
                path};
    }
    return {};
}

} // namespace

std::vector<HidEntry> listHid(std::mutex& bus, std::uint16_t vendor, std::uint16_t product)
{
    const std::lock_guard lock(bus);
    std::vector<HidEntry> found;
    hid_device_info* const all = hid_enumerate(vendor, product);
    for (const hid_device_info* one = all; one != nullptr; one = one->next) {
        found.push_back(
            {one->vendor_id, one->product_id, one->usage_page, one->usage, one->path, utf8(one->product_string), {}});
        found.back().problem = permissionProblem(found.back().path).english();
    }
    hid_free_enumeration(all);
    return found;
}

core::Result<HidDevice> HidDevice::open(std::mutex& bus, const std::string& path)
{
    const std::lock_guard lock(bus);
    hid_device* const device = hid_open_path(path.c_str());
    if (device == nullptr) {
        const core::Message problem = permissionProblem(path);
        return Status(StatusCode::Unreadable,
                      problem.isEmpty()
                          ? core::Message(PALPATE_TEXT("%1: could not be opened: %2"), path, utf8(hid_error(nullptr)))
                          : problem);
    }
    return HidDevice(bus, device);
}

HidDevice::HidDevice(HidDevice&& other) noexcept
    : m_bus(other.m_bus)
    , m_device(std::exchange(other.m_device, nullptr))
{
}

HidDevice::~HidDevice()
{
    if (m_device != nullptr) {
        const std::lock_guard lock(*m_bus);
        hid_close(m_device);
    }
}

int HidDevice::read(std::span<std::uint8_t> report, int timeout_ms) noexcept
{
    return hid_read_timeout(m_device, report.data(), report.size(), timeout_ms);
}

bool HidDevice::write(std::span<const std::uint8_t> report) noexcept
{
    return hid_write(m_device, report.data(), report.size()) == static_cast<int>(report.size());
}

} // namespace palpate::hid
