// SPDX-License-Identifier: BSD-3-Clause
// Times frames of a turning view of a large scene, with all triangles and with coarse pictures (view/CoarseSurface.h).
// Needs a display; on a server: `xvfb-run -a bench_turning`.
//
// bench_turning [FILE]
//
// The structures of FILE, or twelve balls of 98,000 triangles each, 1000 x 700, 2° per frame. Each row: median frame
// [ms], and the processor time in it [ms], which counts all threads of a software renderer. Goal: 1.2 million
// triangles in 100 ms on two cores without a graphics card.
#include "Shapes.h"

#include <palpate/meshio/LoadScene.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/view/SceneView.h>
#include <palpate/view/SurfaceMesh.h>

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <thread>
#include <vector>

using namespace palpate;
using core::Vec3;

namespace {

double median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

view::ViewStructure structure(const geometry::RepairedMesh& surface)
{
    return {view::StructureActor(view::makeSurface(surface), view::Appearance(), true), study::indexed(surface)};
}

void turn(view::SceneView& scene, vtkRenderWindow& window, bool isCoarse)
{
    constexpr int kFrames = 20, kUntimed = 3; // the first frames upload the triangles
    std::vector<double> frame_ms, processor_ms;
    for (int i = -kUntimed; i < kFrames; ++i) {
        scene.camera().Azimuth(2.0);
        scene.setCoarse(isCoarse);
        if (isCoarse && i == -kUntimed) {
            std::this_thread::sleep_for(std::chrono::seconds(3)); // another thread makes the pictures
        }
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t processor = std::clock();
        scene.prepareFrame(1.0);
        window.Render();
        window.WaitForCompletion();
        if (i >= 0) {
            processor_ms.push_back(1e3 * static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC);
            frame_ms.push_back(
                std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
        }
    }
    std::printf("%-13s  %10.1f  %14.1f\n", isCoarse ? "coarse" : "all triangles", median(frame_ms),
                median(processor_ms));
}

} // namespace

int main(int argc, char** argv)
{
    std::vector<view::ViewStructure> structures;
    std::size_t triangles = 0;
    if (argc > 1) {
        const auto loaded = study::openScene(argv[1]);
        if (!loaded.isOk()) {
            std::fprintf(stderr, "%s\n", loaded.status().message().c_str());
            return 1;
        }
        for (const meshio::LoadedStructure& one : loaded.value().structures) {
            structures.push_back(structure(*one.surface));
            triangles += one.surface->mesh.triangles.size();
        }
    } else {
        const geometry::RepairedMesh ball = geometry::repair(test::sphere(70, 40.0));
        for (int i = 0; i < 12; ++i) {
            geometry::RepairedMesh one = ball;
            one.mesh = test::moved(one.mesh, Vec3(90.0 * (i % 4), 90.0 * (i / 4), 0.0));
            structures.push_back(structure(one));
            triangles += one.mesh.triangles.size();
        }
    }
    std::printf("%zu structures, %zu triangles\n               frame [ms]  processor [ms]\n", structures.size(),
                triangles);
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetSize(1000, 700);
    view::SceneView scene;
    scene.attach(*window);
    scene.setSmoothEdges(true);
    scene.setSortedTransparency(false);
    scene.setStructures(std::move(structures));
    scene.look(view::ViewFrom::Front);
    turn(scene, *window, false);
    turn(scene, *window, true);
    scene.detach();
    return 0;
}
