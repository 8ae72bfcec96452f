// SPDX-License-Identifier: BSD-3-Clause
// Measures the regularity of the servo loop on an idle and on a loaded machine, with and without real-time priority.
//
// bench_jitter [SECONDS]
//
// Each case lasts SECONDS, by default 3. Cases: no load; a busy loop on each core; indexing meshes one after the other;
// writing a recording; all of these together. Each at 1, 2 and 4 kHz, in contact with a sphere. A row has the 50th,
// 99th and 99.9th percentile and the maximum of |period - nominal| in microseconds, overruns and skipped periods over
// all ticks. Without permission for real-time priority, the rows with priority are skipped, and the command that grants
// the permission is printed.
#include "Shapes.h"

#include <palpate/core/Clock.h>
#include <palpate/device/SimulatedHand.h>
#include <palpate/geometry/Repair.h>
#include <palpate/geometry/SurfaceIndex.h>
#include <palpate/servo/ServoLoop.h>
#include <palpate/session/Recorder.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace palpate;

enum Load : unsigned
{
    kNothing = 0,
    kBusy = 1,
    kIndexing = 2,
    kRecording = 4,
    kAll = kBusy | kIndexing | kRecording,
};

std::atomic<bool> g_isLoaded{false};

std::vector<std::thread> loadMachine(unsigned load, const geometry::RepairedMesh& mesh)
{
    std::vector<std::thread> threads;
    g_isLoaded.store(true);
    if ((load & kBusy) != 0) {
        for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i) {
            threads.emplace_back([] {
                volatile double x = 1.0;
                while (g_isLoaded.load(std::memory_order_relaxed)) {
                    x = x * 1.0000001 + 1e-9;
                }
            });
        }
    }
    if ((load & kIndexing) != 0) {
        threads.emplace_back([&mesh] {
            while (g_isLoaded.load(std::memory_order_relaxed)) {
                const auto index = geometry::SurfaceIndex::build(mesh);
                static_cast<void>(index);
            }
        });
    }
    return threads;
}

/// @return false if priority was requested and denied
bool run(const char* name, unsigned load, double rate_Hz, bool askRealtime, double seconds,
         const geometry::RepairedMesh& mesh, const std::shared_ptr<const haptics::HapticScene>& scene)
{
    std::vector<device::HandTarget> targets;
    for (int i = 0; i <= static_cast<int>(seconds * 2.0) + 4; ++i) {
        targets.push_back({0.5 * i, core::Vec3(i % 2 == 0 ? 3.0 : -3.0, 0.0, 29.0)});
    }
    device::SimulatedHandOptions held;
    held.rate_Hz = rate_Hz;
    auto script = device::HandScript::make(targets);
    if (!script.isOk()) {
        std::exit(1);
    }
    device::SimulatedHand hand(std::move(script).value(), held);
    servo::ServoLoop loop;
    static_cast<void>(loop.setScene(scene));
    servo::ServoOptions options;
    options.rate_Hz = rate_Hz;
    options.askRealtime = askRealtime;
    options.lockMemory = askRealtime;
    if (const core::Status status = loop.start(hand, options); !status.isOk()) {
        std::fprintf(stderr, "%s\n", status.message().c_str());
        std::exit(1);
    }
    if (askRealtime && !loop.realtime().items[1].isGranted) {
        for (const servo::RealtimeItem& item : loop.realtime().items) {
            if (!item.remedy.empty()) {
                std::printf("%s: %s\n  %s\n", item.name.english().c_str(), item.message.english().c_str(),
                            item.remedy.c_str());
            }
        }
        loop.stop();
        return false;
    }
    session::Recorder recorder(loop);
    const auto file = std::filesystem::temp_directory_path() / "bench_jitter.palpate";
    if ((load & kRecording) != 0) {
        session::RecordingInfo info;
        info.rate_Hz = rate_Hz;
        info.dt_s = 1.0 / rate_Hz;
        info.device = hand.info();
        if (const core::Status status = recorder.start(file, info, session::describeScene(1, *scene, {}));
            !status.isOk()) {
            std::fprintf(stderr, "%s\n", status.message().c_str());
            std::exit(1);
        }
    }
    std::vector<std::thread> threads = loadMachine(load, mesh);
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    g_isLoaded.store(false);
    for (std::thread& thread : threads) {
        thread.join();
    }
    if ((load & kRecording) != 0) {
        static_cast<void>(recorder.stop());
        std::filesystem::remove(file);
    }
    loop.stop();
    const servo::TimingReport timing = loop.timing();
    const auto us = [](std::int64_t ns) { return static_cast<double>(ns) * 1e-3; };
    std::printf("%-28s %-9s %5.0f Hz %9.1f %9.1f %9.1f %9.1f %8llu %8llu %8llu\n", name,
                askRealtime ? "priority" : "ordinary", rate_Hz, us(timing.periodError.p50_ns),
                us(timing.periodError.p99_ns), us(timing.periodError.p999_ns), us(timing.periodError.max_ns),
                static_cast<unsigned long long>(timing.overruns), static_cast<unsigned long long>(timing.skipped),
                static_cast<unsigned long long>(timing.ticks));
    std::fflush(stdout);
    return true;
}

} // namespace

int main(int argc, char** argv)
{
    const double seconds = argc > 1 ? std::atof(argv[1]) : 3.0;
    const geometry::RepairedMesh mesh = geometry::repair(test::sphere(128, 30.0));
    haptics::HapticStructure structure;
    structure.name = "sphere";
    structure.surface = std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(mesh));
    const auto scene = std::make_shared<const haptics::HapticScene>(std::vector<haptics::HapticStructure>{structure});
    const struct
    {
        const char* name;
        unsigned load;
    } loads[] = {{"nothing else", kNothing},
                 {"busy loop on each core", kBusy},
                 {"a mesh being indexed", kIndexing},
                 {"a recording being written", kRecording},
                 {"all of these", kAll}};
    std::printf("%u cores; |period - nominal| in us\n%-28s %-9s %8s %9s %9s %9s %9s %8s %8s %8s\n",
                std::thread::hardware_concurrency(), "load", "", "rate", "50 %", "99 %", "99.9 %", "most", "overruns",
                "left out", "ticks");
    for (const bool askRealtime : {false, true}) {
        for (const double rate : {1000.0, 2000.0, 4000.0}) {
            for (const auto& load : loads) {
                if (!run(load.name, load.load, rate, askRealtime, seconds, mesh, scene)) {
                    return 0; // no permission: measurement ends
                }
            }
        }
    }
    return 0;
}
