// SPDX-License-Identifier: BSD-3-Clause
#include <palpate/haptics/Palpator.h>

#include <cstdio>

/// Presses 2 mm into one triangle and prints the force on the hand.
int main()
{
    using namespace palpate;
    geometry::TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}};
    mesh.triangles = {{0, 1, 2}};
    auto surface =
        std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(geometry::repair(mesh)));

    haptics::HapticStructure structure;
    structure.name = "triangle";
    structure.surface = surface;
    structure.tissue.stiffness_N_per_mm = 0.5;
    const haptics::HapticScene scene({structure});

    haptics::Palpator palpator;
    palpator.borrowScene(&scene);
    haptics::TickResult touch;
    for (int tick = 0; tick <= 20; ++tick) {
        touch = palpator.step({2, 2, 1.0 - 0.15 * tick}, 1e-3);
    }
    std::printf("force %.3g %.3g %.3g N\n", touch.f_W.x(), touch.f_W.y(), touch.f_W.z());
    return 0;
}
