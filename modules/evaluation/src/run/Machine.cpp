// SPDX-License-Identifier: BSD-3-Clause
#include "run/Machine.h"

#include <palpate/session/Recording.h>

#include <chrono>
#include <ctime>
#include <fstream>
#include <thread>

namespace palpate::evaluation {

namespace {

std::string processorName()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return "unknown processor";
}

} // namespace

Machine thisMachine()
{
    Machine machine;
    machine.cpu = processorName();
#ifdef __clang__
    machine.compiler = "clang " __clang_version__;
#else
    machine.compiler = "gcc " __VERSION__;
#endif
    machine.build = session::buildId();
    machine.cores = static_cast<int>(std::thread::hardware_concurrency());
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm utc{};
    gmtime_r(&now, &utc);
    char stamp[32];
    std::strftime(stamp, sizeof stamp, "%Y-%m-%dT%H:%M:%SZ", &utc);
    machine.startedUtc = stamp;
    std::ifstream("/proc/loadavg") >> machine.load;
    return machine;
}

} // namespace palpate::evaluation
