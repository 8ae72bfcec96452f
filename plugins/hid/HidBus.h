// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <vector>

struct hid_device_;

namespace palpate::hid {

/// HID interface on the bus.
struct HidEntry
{
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    std::uint16_t usagePage = 0; ///< type of interface by the HID usage tables; 0: unknown
    std::uint16_t usage = 0;
    std::string path;        ///< for `HidDevice::open`
    std::string productName; ///< as reported by the device, UTF-8
    std::string problem;     ///< why the interface cannot be opened, and a remedy; empty: no known problem
};

/// Lists HID interfaces of a vendor and product; 0: any.
/// @param bus  locked during the call: enumeration, opening and closing are not thread-safe in hidapi
[[nodiscard]] std::vector<HidEntry> listHid(std::mutex& bus, std::uint16_t vendor, std::uint16_t product);

/// Open HID device. @par Thread One thread reads and writes.
class HidDevice
{
  public:
    static core::Result<HidDevice> open(std::mutex& bus, const std::string& path);
    HidDevice(HidDevice&& other) noexcept;
    HidDevice& operator=(HidDevice&&) = delete;
    ~HidDevice();

    /// Waits for a report.
    /// @return length of the report; 0: timeout after `timeout_ms`; -1: device lost
    [[nodiscard]] int read(std::span<std::uint8_t> report, int timeout_ms) noexcept;
    /// Writes a report whose first byte is the report id. Blocks until the bus has accepted the report.
    /// @return false: device lost
    [[nodiscard]] bool write(std::span<const std::uint8_t> report) noexcept;

  private:
    HidDevice(std::mutex& bus, hid_device_* device) noexcept
        : m_bus(&bus)
        , m_device(device)
    {
    }

    std::mutex* m_bus;
    hid_device_* m_device;
};

} // namespace palpate::hid
