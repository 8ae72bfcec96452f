// SPDX-License-Identifier: BSD-3-Clause
// Draws live touch into a render window of the program's own, without Qt's widgets: a simulated hand presses 2 mm into
// a plate. Prints the force in the last frame.
#include <palpate/device/SimulatedHand.h>
#include <palpate/geometry/Repair.h>
#include <palpate/servo/ServoLoop.h>
#include <palpate/view/SceneView.h>
#include <palpate/view/StateOf.h>
#include <palpate/view/SurfaceMesh.h>

#include <vtkNew.h>

#include <chrono>
#include <cstdio>
#include <thread>
#include <utility>
#include <vector>

int main()
{
    using namespace palpate;
    geometry::TriangleMesh plate; // [mm]
    plate.vertices = {{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}, {-10, 10, 0}};
    plate.triangles = {{0, 1, 2}, {0, 2, 3}};
    const geometry::RepairedMesh repaired = geometry::repair(plate, geometry::Facing::Outward);
    const auto surface = std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(repaired));
    const auto scene = haptics::HapticScene::make({{"plate", surface, {0.5, 0.0}, 0}});

    vtkNew<vtkRenderWindow> window; // or that of a QVTKOpenGLNativeWidget
    window->SetSize(600, 400);
    view::SceneView view;
    view.attach(*window);
    std::vector<view::ViewStructure> shown;
    shown.push_back({view::StructureActor(view::makeSurface(repaired)), surface});
    view.setStructures(std::move(shown));
    view.fitAll();

    const auto script = device::HandScript::make({{0.0, {0, 0, 1}}, {0.5, {0, 0, -2}}, {1.0, {0, 0, -2}}});
    device::SimulatedHand hand(script.value());
    servo::ServoLoop loop;
    loop.setScene(scene.value());
    if (const core::Status status = loop.start(hand); !status.isOk()) {
        std::fprintf(stderr, "%s\n", status.message().c_str());
        return 1;
    }
    const auto draw = [&] {
        servo::TickRecord tick;
        if (loop.fetchSnapshot(tick)) {
            view.cursor().setState(view::stateOf(tick, scene.value()->fingertip_mm()));
            view.prepareFrame(1.0);
            window->Render();
        }
    };
    while (loop.isRunning() && !hand.isFinished()) {
        draw();
        std::this_thread::sleep_for(std::chrono::milliseconds(16)); // a timer in a program with events
    }
    loop.stop();
    draw(); // the last tick
    std::printf("%.2f N\n", view.cursor().state().f_W.norm());
    return 0;
}
