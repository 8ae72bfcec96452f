// SPDX-License-Identifier: BSD-3-Clause
#include "EmulatedHd.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace palpate::test {

EmulatedHd::EmulatedHd(const std::string& file)
    : SharedDevices({"openhaptics", "PALPATE_STANDIN_HD", PALPATE_HD_WHOLE "/libHD.so.3.4", standin::kHdMagic,
                     standin::advanceHd, core::Vec3::UnitZ()},
                    file)
{
    setenv("GTDD_HOME", (folder() + "/touch").c_str(), 1);
    configureDevices({"Default Device"});
}

void EmulatedHd::configureDevices(const std::vector<std::string>& names)
{
    const std::filesystem::path config = folder() + "/touch/config";
    std::filesystem::remove_all(config);
    std::filesystem::create_directories(config);
    for (const std::string& name : names) {
        std::ofstream(config / (name + ".config")) << "0.5\n";
    }
}

void EmulatedHd::renew()
{
    configure();
    configureDevices({"Default Device"});
    with([](standin::HdBench& b) {
        const std::uint32_t plugins = b.devices[0].plugins + 1;
        b.devices = {standin::HdDevice{}, standin::secondHd()};
        for (standin::HdDevice& device : b.devices) {
            device.plugins = plugins;
        }
        b.scheduler = {};
        b.version = {"3.4.0"};
        b.rate_Hz = 1000.0;
        b.misuses = 0;
    });
}

QString EmulatedHd::violation(double limit_N)
{
    std::string found;
    with([&](standin::HdBench& b) {
        for (const standin::HdDevice& d : b.devices) {
            if (!(d.largestForce_N <= limit_N * (1.0 + 1e-9))) {
                found += "driven with " + std::to_string(d.largestForce_N) + " N; ";
            }
            if (d.longestSilence_ns > 10'000'000) {
                found += "driven for " + std::to_string(d.longestSilence_ns) + " ns without a new force; ";
            }
        }
        if (b.misuses > 0) {
            found += std::to_string(b.misuses) + " misuses, the last: " + b.lastMisuse.data();
        }
    });
    return QString::fromStdString(found);
}

} // namespace palpate::test
