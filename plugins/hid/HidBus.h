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

/// A HID interface on the bus.
struct HidEntry
{
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    std::uint16_t usagePage = 0; ///< what the interface is, by the HID usage tables; 0: not known
    std::uint16_t usage = 0;
    std::string path;        ///< for `HidDevice::open`
    std::string productName; ///< as the device states it, UTF-8
    std::string problem;     ///< why it cannot be opened and what to do; empty: nothing known against it
};

/// Lists what is on the bus, of one vendor and product; 0: any.
/// @param bus  held meanwhile: hidapi's listing, opening and closing are not thread-safe
[[nodiscard]] std::vector<HidEntry> listHid(std::mutex& bus, std::uint16_t vendor, std::uint16_t product);

/// An open HID device. One thread reads and writes.
class HidDevice
{
  public:
    static core::Result<HidDevice> open(std::mutex& bus, const std::string& path);
    HidDevice(HidDevice&& other) noexcept;
    HidDevice& operator=(HidDevice&&) = delete;
    ~HidDevice();

    /// Waits for a report.
    /// @return its length; 0: none within `timeout_ms`; -1: the device is lost
    [[nodiscard]] int read(std::span<std::uint8_t> report, int timeout_ms) noexcept;
    /// Writes a report whose first byte is its id. Blocks until the bus took it.
    /// @return false: the device is lost
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
