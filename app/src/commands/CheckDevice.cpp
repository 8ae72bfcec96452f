// SPDX-License-Identifier: BSD-3-Clause
#include "commands/CheckDevice.h"

#include "shared/Console.h"
#include "shared/Devices.h"
#include "shared/ProgressLine.h"

#include <palpate/device/SimulatedHand.h>
#include <palpate/servo/SelfTestRun.h>
#include <palpate/study/SelfTestPage.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <system_error>
#include <thread>

namespace palpate::app {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

std::atomic<bool> s_isInterrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free); // set by a signal handler

/// While an object lives, Ctrl+C and requests to end the program set s_isInterrupted, so that the force is removed
/// first.
class Interruptible
{
  public:
    Interruptible()
    {
        s_isInterrupted.store(false);
        for (std::size_t i = 0; i < kSignals.size(); ++i) {
            m_before[i] = std::signal(kSignals[i], [](int) { s_isInterrupted.store(true); });
        }
    }
    ~Interruptible()
    {
        for (std::size_t i = 0; i < kSignals.size(); ++i) {
            (void)std::signal(kSignals[i], m_before[i]);
        }
    }
    Interruptible(const Interruptible&) = delete;
    Interruptible& operator=(const Interruptible&) = delete;

  private:
    static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
    std::array<void (*)(int), kSignals.size()> m_before{};
};

/// A Touch in a light grip that stays in its place.
Result<std::unique_ptr<device::HapticDevice>> simulatedDevice(double rate_Hz)
{
    auto script = device::HandScript::make({{0.0, core::Vec3::Zero()}});
    if (!script.isOk()) {
        return script.status();
    }
    device::SimulatedHandOptions options;
    options.rate_Hz = rate_Hz;
    options.deviceDamping_Ns_per_mm = options.preset.mechanics.damping_Ns_per_mm;
    options.friction_N = options.preset.mechanics.friction_N;
    options.resolution_mm = options.preset.mechanics.resolution_mm;
    options.delayTicks = 1;
    return std::make_unique<device::SimulatedHand>(std::move(script).value(), options);
}

Result<std::unique_ptr<device::HapticDevice>> makeDevice(device::PluginHost& host, const std::string& id,
                                                         double rate_Hz)
{
    if (id == "simulated") {
        return simulatedDevice(rate_Hz);
    }
    std::string names = "simulated";
    for (const device::PluginEntry& entry : host.plugins()) {
        if (entry.status.isOk()) {
            if (entry.info.id == id) {
                return host.make(id);
            }
            names += ", " + entry.info.id;
        }
    }
    return Status(StatusCode::BadCommandLine, PALPATE_TEXT("--check: found \"%1\", expected one of %2"), id, names);
}

/// Polls the test until its end, and shows instructions and progress.
void follow(servo::SelfTestRun& test)
{
    using namespace std::chrono_literals;
    ProgressLine progress;
    std::string shown;
    while (test.poll()) {
        const std::string line = servo::instruction(test.step()).english();
        if (line != shown && !line.empty()) {
            print("%s\n", line.c_str());
            std::fflush(stdout);
            shown = line;
        }
        progress.show(test.progress(), "testing");
        if (s_isInterrupted.load()) {
            test.cancel();
        }
        std::this_thread::sleep_for(50ms);
    }
}

} // namespace

int checkDevice(const std::vector<std::filesystem::path>& pluginFolders, const CheckOptions& options)
{
    constexpr double kSlowest_Hz = 250.0, kFastest_Hz = 4000.0;
    const auto rate = numberOption("--rate", options.rate, {.least = kSlowest_Hz, .most = kFastest_Hz});
    if (!rate.isOk()) {
        return report(rate.status());
    }
    if (const Status status = checkPluginFolders(pluginFolders); !status.isOk()) {
        return report(status);
    }
    const auto host = findPlugins(pluginFolders);
    auto made = makeDevice(*host, options.device, rate.value());
    if (!made.isOk()) {
        return report(made.status());
    }
    std::error_code error;
    std::filesystem::create_directories(options.out, error);
    if (!std::filesystem::is_directory(options.out)) {
        return report(Status(StatusCode::BadCommandLine, PALPATE_TEXT("--out: %1 cannot be made: %2"), options.out,
                             core::systemError(error.value())));
    }
    const std::unique_ptr<device::HapticDevice> device = std::move(made).value();
    servo::SelfTestRun test; // destroyed before the device
    const Interruptible interruptible;
    if (const Status status = test.start(*device, {.rate_Hz = rate.value()}); !status.isOk()) {
        return report(status);
    }
    follow(test);
    const servo::SelfTestResult result = test.finish();
    const std::vector<core::Message> missing = servo::unmeasured(result);
    if (result.isFailed()) { // nothing to judge the device by
        for (const core::Message& line : missing) {
            printError(line);
        }
        if (const std::string why = device->report().text; !why.empty()) {
            printError(PALPATE_TEXT("the device reports: %1"), why);
        }
        return kFailed;
    }
    for (const core::Message& line : study::selfTestLines(result)) {
        print("%s\n", line.english().c_str());
    }
    if (const Status status = study::writeSelfTest(options.out, result); !status.isOk()) {
        return report(status);
    }
    print("%s\n", (options.out / "selftest.html").string().c_str());
    if (const std::string command = study::predictionCommand(result); !command.empty()) {
        print("compare with: %s\n", command.c_str());
    }
    return missing.empty() ? int{kDone} : reportLosses(missing);
}

} // namespace palpate::app
