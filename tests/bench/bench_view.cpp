// SPDX-License-Identifier: BSD-3-Clause
// Times frames of the 3D view with and without findings (view/FindingMarkers.h). Needs a display; on a server:
// `xvfb-run -a bench_view`.
//
// bench_view [--rounds N] [FINDINGS …]
//
// A translucent organ of 81,920 triangles with two lumps of 20,480, 1280 x 800. The camera turns by 1° per frame, so
// that markers are placed and tested for occlusion again as during interaction. The numbers of findings (default 0, 10,
// 200 and 1000) alternate, 20 frames each, 15 rounds by default. Each row: median frame [ms], the part before
// rendering, and median, lowest and highest ratio to the first number's frames of the same round. Goal: 200 findings
// within 10 % of zero findings.
#include "Shapes.h"

#include <palpate/view/SceneView.h>
#include <palpate/view/SurfaceMesh.h>

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

using namespace palpate;
using core::Vec3;

namespace {

constexpr int kFrames = 20;
constexpr double kRadius_mm = 80.0;

view::ViewStructure ball(int n, double radius_mm, const Vec3& at, double opacity)
{
    const geometry::TriangleMesh mesh = test::moved(test::sphere(n, radius_mm), at);
    view::Appearance look;
    look.opacity = opacity;
    return {view::StructureActor(view::makeSurface(geometry::repair(mesh)), look, true), test::indexed(mesh)};
}

/// Returns positions spread over the organ's surface.
std::vector<view::FindingMark> marks(int count)
{
    std::vector<view::FindingMark> out;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count, around = 2.39996 * i; // golden angle
        const double r = std::sqrt(1.0 - z * z);
        view::FindingMark mark;
        mark.p_W = kRadius_mm * Vec3(r * std::cos(around), r * std::sin(around), z);
        mark.type = static_cast<core::FindingType>(i % 6);
        mark.number = static_cast<std::size_t>(i) + 1;
        out.push_back(mark);
    }
    return out;
}

double median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

/// Median times of a block of frames [ms].
struct Times
{
    double frame_ms = 0.0, prepare_ms = 0.0;
};

Times frames(view::SceneView& scene, vtkRenderWindow& window)
{
    using Clock = std::chrono::steady_clock;
    using Milliseconds = std::chrono::duration<double, std::milli>;
    std::vector<double> whole, prepare;
    for (int i = -3; i < kFrames; ++i) { // the first frames create the texture of the numbers
        scene.camera().Azimuth(1.0);
        const auto start = Clock::now();
        scene.prepareFrame(1.0);
        const auto prepared = Clock::now();
        window.Render();
        window.WaitForCompletion();
        if (i >= 0) {
            prepare.push_back(Milliseconds(prepared - start).count());
            whole.push_back(Milliseconds(Clock::now() - start).count());
        }
    }
    return {median(whole), median(prepare)};
}

} // namespace

int main(int argc, char** argv)
{
    std::vector<int> counts;
    int rounds = 15;
    for (int i = 1; i < argc; ++i) {
        if (std::string_view(argv[i]) == "--rounds" && i + 1 < argc) {
            rounds = std::max(1, std::atoi(argv[++i]));
        } else {
            counts.push_back(std::atoi(argv[i]));
        }
    }
    if (counts.empty()) {
        counts = {0, 10, 200, 1000};
    }
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetSize(1280, 800);
    view::SceneView scene;
    scene.attach(*window);
    std::vector<view::ViewStructure> structures;
    structures.push_back(ball(64, kRadius_mm, Vec3::Zero(), 0.5));
    structures.push_back(ball(32, 10.0, Vec3(30, 0, 0), 1.0));
    structures.push_back(ball(32, 6.0, Vec3(-30, 20, 10), 1.0));
    scene.setStructures(std::move(structures));
    scene.look(view::ViewFrom::Front);

    std::vector<std::vector<double>> whole(counts.size()), prepare(counts.size()), ratios(counts.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < counts.size(); ++i) {
            scene.findings().set(marks(counts[i]));
            const Times times = frames(scene, *window);
            whole[i].push_back(times.frame_ms);
            prepare[i].push_back(times.prepare_ms);
            ratios[i].push_back(whole[i].back() / whole[0].back());
        }
    }
    std::printf("findings  frame [ms]  of that prepared [ms]  ratio  lowest  highest\n");
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const auto [low, high] = std::minmax_element(ratios[i].begin(), ratios[i].end());
        std::printf("%8d  %10.2f  %21.3f  %5.3f  %6.3f  %7.3f\n", counts[i], median(whole[i]), median(prepare[i]),
                    median(ratios[i]), *low, *high);
    }
    scene.detach();
    return 0;
}
