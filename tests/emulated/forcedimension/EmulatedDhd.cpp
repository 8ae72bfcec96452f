// SPDX-License-Identifier: BSD-3-Clause
#include "EmulatedDhd.h"

#include <cstdlib>

namespace palpate::test {

EmulatedDhd::EmulatedDhd(const std::string& file)
    : SharedDevices({"forcedimension", "PALPATE_STANDIN_DHD", PALPATE_DHD_WHOLE "/libdhd.so.3", standin::kDhdMagic,
                     standin::advanceDhd, core::Vec3::UnitY()},
                    file)
{
    unsetenv("FDSDK");
}

void EmulatedDhd::renew()
{
    configure();
    with([](standin::DhdBench& b) {
        for (standin::DhdDevice& device : b.devices) {
            const std::uint32_t plugins = device.plugins + 1;
            const int serial = device.serial;
            device = {};
            device.plugins = plugins;
            device.serial = serial;
        }
        b.count = 1;
        b.order = {0, 1};
        b.unnamedCalls = 0;
        b.lateCalls = 0;
    });
}

QString EmulatedDhd::violation(double limit_N)
{
    std::string found;
    with([&](standin::DhdBench& b) {
        for (const standin::DhdDevice& d : b.devices) {
            if (!(d.largestForce_N <= limit_N * (1.0 + 1e-9))) {
                found += "driven with " + std::to_string(d.largestForce_N) + " N; ";
            }
            if (d.longestSilence_ns > 10'000'000) {
                found += "driven for " + std::to_string(d.longestSilence_ns) + " ns without a new force; ";
            }
        }
        if (b.unnamedCalls > 0 || b.lateCalls > 0) {
            found += std::to_string(b.unnamedCalls) + " calls for the default device, " + std::to_string(b.lateCalls) +
                     " after closing; ";
        }
    });
    return QString::fromStdString(found);
}

} // namespace palpate::test
