// SPDX-License-Identifier: BSD-3-Clause
// touch_file FILE   reads a mesh file (STL, VTP, OBJ, PLY) and presses 2 mm into each structure from above, in
// the middle.
#include <palpate/geometry/Repair.h>
#include <palpate/haptics/Palpator.h>
#include <palpate/meshio/ImportServer.h>
#include <palpate/meshio/MeshFile.h>

#include <cstdio>

int main(int argc, char** argv)
{
    using namespace palpate;
    // Before any thread: files are then read in a child process, and a file that crashes the reader is an error here.
    const core::Status server = meshio::startImportServer();
    const auto file = meshio::readMesh(argc > 1 ? argv[1] : "");
    if (!server.isOk() || !file.isOk()) {
        std::fprintf(stderr, "%s\n", (server.isOk() ? file.status() : server).message().c_str());
        return 2;
    }
    for (const meshio::MeshStructure& structure : file.value().structures) {
        // Files keep their facing here, like in the program; Facing::Outward turns closed parts outwards.
        const geometry::RepairedMesh mesh = geometry::repair(structure.mesh, geometry::Facing::AsGiven);
        for (const palpate::core::Message& sentence : mesh.report.sentences()) {
            std::printf("%s: %s\n", structure.name.c_str(), sentence.english().c_str());
        }
        Eigen::AlignedBox3d box;
        for (const core::Vec3& p : mesh.mesh.vertices) {
            box.extend(p);
        }
        const auto surface = std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(mesh));
        const auto scene = haptics::HapticScene::make({{structure.name, surface, {0.5, 0.0}, 0}}); // 0.5 N/mm
        if (!scene.isOk()) {
            std::fprintf(stderr, "%s\n", scene.status().message().c_str());
            continue;
        }
        haptics::Palpator palpator;
        palpator.setScene(scene.value());
        core::Vec3 hip(box.center().x(), box.center().y(), box.max().z() + 1.0);
        haptics::TickResult touch;
        for (int into = 0; into < 40 && hip.z() > box.min().z();) { // 0.05 mm a tick of 1 ms, 40 ticks of touch
            touch = palpator.step(hip, 1e-3);
            into += touch.constraints > 0 ? 1 : 0;
            hip.z() -= 0.05;
        }
        std::printf("%s: %.2f N\n", structure.name.c_str(), touch.f_W.norm());
    }
    return 0;
}
