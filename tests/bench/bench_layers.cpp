// SPDX-License-Identifier: BSD-3-Clause
// Times the search for enclosing structures (study/Layers.h), which the window runs on opening files.
//
// bench_layers [STRUCTURES …]
//
// A row for each number of structures (default 30, 100 and 300): a body of 20,480 triangles, ten organs of 5,120
// inside, and lumps of 320 in the organs. Median of five rounds [ms], and the number of enclosed structures. Goal: 300
// structures in less than 500 ms.
#include "Shapes.h"

#include <palpate/study/HapticCopy.h>
#include <palpate/study/Layers.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <vector>

using namespace palpate;
using core::Vec3;

namespace {

struct Part
{
    std::shared_ptr<const geometry::RepairedMesh> surface;
    std::shared_ptr<const geometry::SurfaceIndex> index;
};

Part ball(int n, double radius_mm, const Vec3& at)
{
    Part part;
    part.surface =
        std::make_shared<const geometry::RepairedMesh>(geometry::repair(test::moved(test::sphere(n, radius_mm), at)));
    part.index = study::indexed(*part.surface);
    return part;
}

Vec3 onRing(double radius_mm, int i, int of)
{
    return radius_mm * Vec3(std::sin(6.2832 * i / of), std::cos(6.2832 * i / of), 0.0);
}

std::vector<Part> body(int structures)
{
    constexpr int kOrgans = 10;
    std::vector<Part> parts{ball(32, 200.0, Vec3::Zero())};
    for (int i = 0; i < kOrgans; ++i) {
        parts.push_back(ball(16, 30.0, onRing(140.0, i, kOrgans)));
    }
    for (int i = 0; static_cast<int>(parts.size()) < structures; ++i) {
        parts.push_back(ball(4, 2.0, onRing(140.0, i % kOrgans, kOrgans) + onRing(20.0, i / kOrgans, 30)));
    }
    return parts;
}

void measure(int structures)
{
    const std::vector<Part> parts = body(structures);
    std::vector<study::LayeredSurface> surfaces;
    for (const Part& part : parts) {
        surfaces.push_back({part.surface.get(), part.index.get()});
    }
    std::vector<double> times;
    std::ptrdiff_t below = 0;
    for (int round = 0; round < 5; ++round) {
        const auto start = std::chrono::steady_clock::now();
        const study::Layering found = study::layering(surfaces);
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
        below = std::count_if(found.structures.begin(), found.structures.end(),
                              [](const auto& one) { return one.layer > 0; });
    }
    std::sort(times.begin(), times.end());
    std::printf("%10zu %14.1f %10td\n", parts.size(), times[times.size() / 2], below);
}

} // namespace

int main(int argc, char** argv)
{
    std::vector<int> numbers;
    for (int i = 1; i < argc; ++i) {
        if (!std::string_view(argv[i]).starts_with("--")) { // options of a smoke test are ignored
            numbers.push_back(std::max(1, std::atoi(argv[i])));
        }
    }
    if (numbers.empty()) {
        numbers = {30, 100, 300};
    }
    std::printf("%10s %14s %10s\n", "structures", "ms", "below");
    for (const int structures : numbers) {
        measure(structures);
    }
    return 0;
}
