// SPDX-License-Identifier: BSD-3-Clause
#include "Bench.h"

#include <algorithm>

namespace standin {

namespace {

constexpr std::int64_t kPeriod_ns = 8'000'000;

Packet report(std::uint8_t id, const std::int16_t* values, int count, std::int64_t ready_ns)
{
    Packet packet;
    packet.bytes[0] = id;
    for (int i = 0; i < count; ++i) {
        const auto bits = static_cast<std::uint16_t>(values[i]);
        packet.bytes[static_cast<std::size_t>(1 + 2 * i)] = static_cast<std::uint8_t>(bits & 0xff);
        packet.bytes[static_cast<std::size_t>(2 + 2 * i)] = static_cast<std::uint8_t>(bits >> 8);
    }
    packet.length = 1 + 2 * count;
    packet.ready_ns = ready_ns;
    return packet;
}

} // namespace

void advancePuck(Puck& puck, std::int64_t now_ns)
{
    if (!puck.isPlugged) {
        return;
    }
    for (puck.next_ns = std::max(puck.next_ns, now_ns - 20 * kPeriod_ns); puck.next_ns <= now_ns;
         puck.next_ns += kPeriod_ns) {
        const bool isHeld = std::any_of(puck.axes.begin(), puck.axes.end(), [](std::int16_t a) { return a != 0; });
        if (isHeld || puck.wasHeld) { // the last reports after a release are zeros
            if (puck.hasSixAxisReport) {
                push(puck.toHost, report(1, puck.axes.data(), 6, puck.next_ns));
            } else {
                push(puck.toHost, report(1, puck.axes.data(), 3, puck.next_ns));
                push(puck.toHost, report(2, puck.axes.data() + 3, 3, puck.next_ns));
            }
        }
        puck.wasHeld = isHeld;
        if (puck.buttons != puck.buttonsSent) {
            puck.buttonsSent = puck.buttons;
            const std::int16_t bits[] = {static_cast<std::int16_t>(puck.buttons & 0xffff)};
            push(puck.toHost, report(3, bits, 1, puck.next_ns));
        }
    }
}

} // namespace standin
