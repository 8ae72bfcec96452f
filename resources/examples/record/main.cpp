// SPDX-License-Identifier: BSD-3-Clause
// record FILE   records a simulated hand that presses into a plate, which becomes softer after half a second, and reads
// the recording again.
#include <palpate/device/SimulatedHand.h>
#include <palpate/geometry/Repair.h>
#include <palpate/session/LiveSession.h>
#include <palpate/session/RecordingReader.h>

#include <chrono>
#include <cstdio>
#include <thread>

using namespace palpate;

namespace {

int fail(const core::Status& status)
{
    std::fprintf(stderr, "%s\n", status.message().c_str());
    return 1;
}

} // namespace

int main(int argc, char** argv)
{
    const std::filesystem::path file = argc > 1 ? argv[1] : "plate.palpate";
    geometry::TriangleMesh plate; // [mm]
    plate.vertices = {{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}, {-10, 10, 0}};
    plate.triangles = {{0, 1, 2}, {0, 2, 3}};
    session::StructureSource source; // origin of a surface, for the recording
    source.embed = std::make_shared<const geometry::RepairedMesh>(geometry::repair(plate, geometry::Facing::Outward));
    haptics::HapticStructure structure;
    structure.name = "plate";
    structure.surface = std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(*source.embed));
    const auto scene = haptics::HapticScene::make({structure});

    const auto script = device::HandScript::make({{0.0, {0, 0, 1}}, {0.3, {0, 0, -2}}, {1.0, {0, 0, -2}}});
    device::SimulatedHand hand(script.value());
    session::LiveSession live;
    (void)live.setScene(scene.value(), {source}); // fails only while a recording runs
    if (const core::Status status = live.start(hand, {}); !status.isOk()) {
        return fail(status);
    }
    if (const core::Status status = live.startRecording(file, session::Embed::Yes); !status.isOk()) {
        return fail(status);
    }
    for (int i = 0; live.loop().isRunning() && !hand.isFinished(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        if (i == 25) { // an edit is a new scene, which shares the surface
            const auto softer = scene.value()->with(0, {0.2, 0.0});
            if (const core::Status status = live.setScene(softer.value(), {source}); !status.isOk()) {
                return fail(status);
            }
        }
        if (const auto fault = live.poll()) { // the force is off until `rearm`
            std::fprintf(stderr, "%s\n", fault->message.english().c_str());
            live.loop().rearm();
        }
    }
    if (const core::Status status = live.stopRecording(); !status.isOk()) {
        return fail(status);
    }

    const auto opened = session::RecordingReader::open(file);
    if (!opened.isOk()) {
        return fail(opened.status());
    }
    const session::RecordingReader& reader = *opened.value();
    std::printf("ticks %lld, scenes %zu, surfaces %zu\n", static_cast<long long>(reader.extent().ticks),
                reader.scenes().size(), reader.embeddedHashes().size());
    return 0;
}
