// SPDX-License-Identifier: BSD-3-Clause
// Replacement for hidapi's C interface on top of the bench. A plugin that needs a function missing here fails to load.
//
// PALPATE_STANDIN names the file of the bench; without this variable the process has a private bench with the arm
// plugged in. PALPATE_STANDIN_HAND names a CSV of the hand's path for the private bench, rows of time_s,x,y,z [mm, the
// arm's frame].
#include "Bench.h"
#include "Time.h"

#include <hidapi/hidapi.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <cwchar>

struct hid_device_
{
    bool isPuck = false;
    std::uint32_t plugins = 0; // plug count of the device when opened
};

namespace {

using namespace standin;

constexpr const char* kArmPath = "standin:arm";
constexpr const char* kPuckPath = "standin:puck";
constexpr const char* kStrangerPath = "standin:stranger";
constexpr std::int64_t kWriteTimeout_ns = 5'000'000'000; // timeout of the kernel's interrupt transfers

void readHand(Hand& hand, const char* path)
{
    std::FILE* file = std::fopen(path, "r");
    if (file == nullptr) {
        std::fprintf(stderr, "stand-in: %s: could not be read\n", path);
        std::abort();
    }
    char line[256];
    while (std::fgets(line, sizeof line, file) != nullptr) {
        Knot knot;
        if (std::sscanf(line, "%lf,%lf,%lf,%lf", &knot.time_s, &knot.p_mm[0], &knot.p_mm[1], &knot.p_mm[2]) == 4 &&
            hand.knots < static_cast<int>(hand.path.size())) {
            hand.path[static_cast<std::size_t>(hand.knots++)] = knot;
        }
    }
    std::fclose(file);
}

Bench& bench()
{
    static Bench* const one = [] {
        const char* path = std::getenv("PALPATE_STANDIN");
        Bench* made = openBench(path);
        if (made == nullptr) {
            std::fprintf(stderr, "stand-in: no bench at %s\n", path == nullptr ? "(memory)" : path);
            std::abort();
        }
        if (const char* hand = std::getenv("PALPATE_STANDIN_HAND"); hand != nullptr && path == nullptr) {
            readHand(made->arm.hand, hand);
        }
        return made;
    }();
    return *one;
}

/// Locks the bench and advances the simulation to the current time.
class Now
{
  public:
    Now()
        : m_now_ns(now_ns())
    {
        lockBench(bench());
        advance(bench(), m_now_ns);
    }
    ~Now() { unlockBench(bench()); }
    Now(const Now&) = delete;
    Now& operator=(const Now&) = delete;
    [[nodiscard]] std::int64_t time_ns() const { return m_now_ns; }

  private:
    std::int64_t m_now_ns;
};

bool isThere(const hid_device_& device)
{
    const Bench& b = bench();
    return device.isPuck ? b.puck.isPlugged && b.puck.plugins == device.plugins
                         : b.arm.isPlugged && b.arm.plugins == device.plugins;
}

hid_device_info* entry(hid_device_info* next, const char* path, int vendor, int product, const wchar_t* name, int usage)
{
    auto* one = static_cast<hid_device_info*>(std::calloc(1, sizeof(hid_device_info)));
    one->path = strdup(path);
    one->vendor_id = static_cast<unsigned short>(vendor);
    one->product_id = static_cast<unsigned short>(product);
    one->product_string = wcsdup(name);
    one->manufacturer_string = wcsdup(L"stand-in");
    one->serial_number = wcsdup(L"");
    one->usage_page = usage == 0 ? 0xff00 : 1;
    one->usage = static_cast<unsigned short>(usage);
    one->next = next;
    return one;
}

} // namespace

extern "C" {

int hid_init(void)
{
    return 0;
}

int hid_exit(void)
{
    return 0;
}

hid_device_info* hid_enumerate(unsigned short vendor, unsigned short product)
{
    const Now now;
    const auto isAsked = [&](int v, int p) { return (vendor == 0 || vendor == v) && (product == 0 || product == p); };
    hid_device_info* all = nullptr;
    const Bench& b = bench();
    if (b.arm.isPlugged && isAsked(0x1234, 0x0006)) {
        all = entry(all, kArmPath, 0x1234, 0x0006, L"WoodenHaptics", 0);
    }
    if (b.hasStranger && isAsked(0x1234, 0x0006)) {
        all = entry(all, kStrangerPath, 0x1234, 0x0006, L"Blinking lamp", 0);
    }
    if (b.puck.isPlugged && isAsked(b.puck.vendor, b.puck.product)) {
        all = entry(all, kPuckPath, b.puck.vendor, b.puck.product, L"Puck", 8);
    }
    return all;
}

void hid_free_enumeration(hid_device_info* all)
{
    while (all != nullptr) {
        hid_device_info* const next = all->next;
        std::free(all->path);
        std::free(all->product_string);
        std::free(all->manufacturer_string);
        std::free(all->serial_number);
        std::free(all);
        all = next;
    }
}

hid_device* hid_open_path(const char* path)
{
    const Now now;
    Bench& b = bench();
    if (std::strcmp(path, kArmPath) == 0 && b.arm.isPlugged) {
        b.arm.toHost = {}; // reports from before opening are dropped
        return new hid_device_{false, b.arm.plugins};
    }
    if (std::strcmp(path, kPuckPath) == 0 && b.puck.isPlugged) {
        b.puck.toHost = {};
        return new hid_device_{true, b.puck.plugins};
    }
    return nullptr;
}

void hid_close(hid_device* device)
{
    delete device;
}

int hid_read_timeout(hid_device* device, unsigned char* data, size_t length, int milliseconds)
{
    std::int64_t deadline_ns = -1;
    for (;;) {
        std::int64_t time_ns = 0;
        {
            const Now now;
            time_ns = now.time_ns();
            if (!isThere(*device)) {
                return -1;
            }
            Packet packet;
            if (pop(device->isPuck ? bench().puck.toHost : bench().arm.toHost, time_ns, packet)) {
                const size_t taken = std::min(length, static_cast<size_t>(packet.length));
                std::memcpy(data, packet.bytes.data(), taken);
                return static_cast<int>(taken);
            }
        }
        deadline_ns = deadline_ns < 0 ? time_ns + static_cast<std::int64_t>(milliseconds) * 1'000'000 : deadline_ns;
        if (milliseconds >= 0 && time_ns >= deadline_ns) {
            return 0;
        }
        sleepUntil(milliseconds < 0 ? nextEvent(time_ns) : std::min(nextEvent(time_ns), deadline_ns));
    }
}

/// Blocks until the bus accepts the report, like write() of hidraw.
int hid_write(hid_device* device, const unsigned char* data, size_t length)
{
    if (length < 1 || length > 64) {
        return -1;
    }
    std::int64_t begin_ns = 0;
    {
        const Now now;
        begin_ns = now.time_ns();
        if (!isThere(*device)) {
            return -1;
        }
        if (device->isPuck) {
            if (length == 2 && data[0] == 4) {
                bench().puck.light = data[1];
            }
            return static_cast<int>(length);
        }
        Packet packet;
        packet.length = static_cast<int>(length) - 1; // report id 0 is not sent
        std::memcpy(packet.bytes.data(), data + 1, length - 1);
        push(bench().arm.toDevice, packet);
    }
    for (;;) {
        std::int64_t time_ns = 0;
        {
            const Now now;
            time_ns = now.time_ns();
            if (!isThere(*device)) {
                return -1;
            }
            if (bench().arm.toDevice.count == 0) {
                return static_cast<int>(length);
            }
        }
        if (time_ns - begin_ns > kWriteTimeout_ns) {
            return -1;
        }
        sleepUntil(nextEvent(time_ns));
    }
}

const wchar_t* hid_error(hid_device*)
{
    return L"the stand-in has no such device";
}

} // extern "C"
