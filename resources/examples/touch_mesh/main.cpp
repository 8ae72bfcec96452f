// SPDX-License-Identifier: BSD-3-Clause
// Presses 2 mm into a mesh that is in memory and prints the force on the hand.
#include <palpate/geometry/Repair.h>
#include <palpate/haptics/Palpator.h>

#include <cstdio>

int main()
{
    using namespace palpate;
    geometry::TriangleMesh plate; // 20 mm × 20 mm in z = 0, front side up [mm]
    plate.vertices = {{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}, {-10, 10, 0}};
    plate.triangles = {{0, 1, 2}, {0, 2, 3}};
    const auto repaired = geometry::surfaceOf(plate); // checked, welded, closed parts turned outwards
    if (!repaired.isOk()) {
        std::fprintf(stderr, "plate: %s\n", repaired.status().message().c_str());
        return 1;
    }
    for (const palpate::core::Message& sentence : repaired.value().report.sentences()) {
        std::printf("plate: %s\n", sentence.english().c_str());
    }

    haptics::HapticStructure structure;
    structure.name = "plate";
    structure.surface = std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(repaired.value()));
    structure.tissue.stiffness_N_per_mm = 0.5;
    const auto scene = haptics::HapticScene::make({structure});
    if (!scene.isOk()) {
        std::fprintf(stderr, "%s\n", scene.status().message().c_str());
        return 1;
    }

    haptics::Palpator palpator;
    palpator.setScene(scene.value());
    haptics::TickResult touch;
    for (int tick = 0; tick <= 20; ++tick) { // a servo tick is 1 ms: from 1 mm above to 2 mm below
        touch = palpator.step({3, 2, 1.0 - 0.15 * tick}, 1e-3);
    }
    std::printf("force %.3f %.3f %.3f N\n", touch.f_W.x(), touch.f_W.y(), touch.f_W.z());
    return 0;
}
