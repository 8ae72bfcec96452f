// SPDX-License-Identifier: BSD-3-Clause
#include "HdBench.h"

#include <algorithm>

namespace standin {

namespace {

void stepHd(HdDevice& device, std::int64_t now_ns)
{
    if (length(device.f) > 0.0) {
        const std::int64_t silence_ns = now_ns - device.lastForce_ns;
        if (silence_ns > device.watchdog_ns) {
            device.f = {};
            ++device.watchdogs;
        } else {
            device.longestSilence_ns = std::max(device.longestSilence_ns, silence_ns);
        }
    }
    stepTip(device, device.f, 0.0, 0.0, now_ns); // the arm is balanced
}

} // namespace

void advanceHd(HdBench& bench, std::int64_t now_ns)
{
    advanceShared(bench, now_ns, stepHd);
}

void plugHd(HdDevice& device, bool isPlugged)
{
    device.plugins += isPlugged && !device.isPlugged ? 1 : 0;
    device.isPlugged = isPlugged;
    device.owner = 0;
    device.isForceOn = false;
    device.f = {};
}

} // namespace standin
