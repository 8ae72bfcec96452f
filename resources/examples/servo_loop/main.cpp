// SPDX-License-Identifier: BSD-3-Clause
// Runs the servo thread at 1 kHz: a simulated hand presses 2 mm into a plate within half a second. Prints the largest
// force.
#include <palpate/device/SimulatedHand.h>
#include <palpate/geometry/Repair.h>
#include <palpate/servo/ServoLoop.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

int main()
{
    using namespace palpate;
    geometry::TriangleMesh plate; // [mm]
    plate.vertices = {{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}, {-10, 10, 0}};
    plate.triangles = {{0, 1, 2}, {0, 2, 3}};
    const geometry::RepairedMesh repaired = geometry::repair(plate, geometry::Facing::Outward);
    for (const palpate::core::Message& sentence : repaired.report.sentences()) {
        std::printf("plate: %s\n", sentence.english().c_str());
    }
    haptics::HapticStructure structure;
    structure.name = "plate";
    structure.surface = std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(repaired));
    const auto scene = haptics::HapticScene::make({structure});

    const auto script = device::HandScript::make({{0.0, {0, 0, 1}}, {0.5, {0, 0, -2}}, {1.0, {0, 0, -2}}});
    device::SimulatedHand hand(script.value()); // a real device comes from device::PluginHost
    servo::ServoLoop loop;
    loop.setScene(scene.value());
    loop.startRecording(); // keeps each tick until taken below
    if (const core::Status status = loop.start(hand); !status.isOk()) {
        std::fprintf(stderr, "%s\n", status.message().c_str());
        return 1;
    }
    while (loop.isRunning() && !hand.isFinished()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        // A fault switches the force off until `rearm`: with a device, ask the user before.
        if (const servo::FaultReport fault = loop.fault(); fault.isFaulted()) {
            std::fprintf(stderr, "%s\n", fault.message.english().c_str());
            loop.rearm();
        }
    }
    loop.stop();
    servo::TickRecord record;
    double most_N = 0.0;
    while (loop.popTick(record)) {
        most_N = std::max(most_N, record.fSent_W.norm());
    }
    std::printf("ticks %lld, largest force %.2f N\n", static_cast<long long>(record.tick + 1), most_N);
    return 0;
}
