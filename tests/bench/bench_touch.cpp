// SPDX-License-Identifier: BSD-3-Clause
// Times single servo ticks of the god-object (Palpator::step) and reports percentiles instead of means.
//
// bench_touch [--benchmark_filter=REGEX]
//
// PALPATE_BENCH_LARGE=1 in the environment adds slide and free on 10 M triangles, which need 2 GB to build.
//
// slide/T: a HIP 5 mm below a sphere of 50 mm radius with about T triangles, moving at 100 mm/s: one contact.
// cold/T: the same with the data flushed from the caches before each tick.
// free/T: the same path 5 mm above the surface: no contact.
// finger/T: the slide with a ball of 1 mm radius instead of a point.
// crowd/T: the slide on one of 300 spheres of T triangles each, 125 mm apart: the other spheres should cost nothing.
// bumpy/T: hills and hollows of 2.5 mm on that sphere at 400 mm/s: several constraints, many facets per tick.
// ballR/T: a ball of R mm, 2 mm deep in hills of 1 mm on that sphere, at 100 mm/s.
// tissue/W/R/T: the slide with a point (R 0) or a ball of R mm. W is plain, friction (slides), stuck (1 mm back and
// forth within the friction cone), law, map (of the stiffness), felt (buried lumps), both (buried lumps and a stiffness
// map), all (friction, law, maps of stiffness and damping), held (friction and buried lumps) or whole (all of the
// above).
// moving/W/T: the slide with a point in moving tissue, at the same rest positions. W is rest, pose (turning and
// shifting), breath (a ramp), frames (four lattices of 10 mm with a strain of 30 %) or free (the breath, 5 mm above).
// worst/N/R: a ball of R mm where the work bound ends a tick. N is fan (the apex of 10,000 facets), pile (a million
// triangles within 1e-9 mm) or crowd (300 intersecting spheres of 2,000 triangles).
//
// Columns: p50, p99, p99_9 and max in ns per tick, including about 25 ns for the clock; iterations, the mean number of
// attempted moves; limit, the fraction of ticks that ended at a bound; hash, over all god-objects: a changed hash means
// changed results. For comparable numbers pin the process to one core: taskset -c 1 bench_touch
//
// PALPATE_BENCH_TICKS=N in the environment sets N ticks for each row. count_instructions.sh in this folder counts the
// instructions of N ticks, which do not depend on the load of the machine.
#include "Motions.h"
#include "Shapes.h"

#include <palpate/core/Clock.h>
#include <palpate/haptics/Palpator.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace {

using namespace palpate;
using core::Vec3;

constexpr double kRadius_mm = 50.0;

/// Returns a scene with 20 n^2 triangles, indexed once and kept for the next benchmark.
const haptics::HapticScene& scene(int n, double bump, double fingertip_mm, int spheres)
{
    static std::map<std::tuple<int, double, double, int>, haptics::HapticScene> scenes;
    const auto key = std::tuple(n, bump, fingertip_mm, spheres);
    if (scenes.find(key) == scenes.end()) {
        scenes.clear(); // only one at a time: the largest needs nearly a gigabyte during the build
        const geometry::TriangleMesh mesh = test::bumpySphere(n, kRadius_mm, bump);
        std::vector<haptics::HapticStructure> structures;
        for (int i = 0; i < spheres; ++i) {
            const Vec3 at = 125.0 * Vec3(i % 7, i / 7 % 7, i / 49);
            const auto moved = [&at](const Vec3& p) { return Vec3(p + at); };
            structures.push_back({"sphere", test::indexed(test::transformed(mesh, moved)), {0.5, 0.0}, 0});
        }
        scenes.emplace(key, haptics::HapticScene(std::move(structures), fingertip_mm));
    }
    return scenes.at(key);
}

/// Evicts all cached data by writing and flushing more than any cache holds.
void flushCaches()
{
    static std::vector<char> larger(64 << 20);
    for (std::size_t i = 0; i < larger.size(); i += 64) {
        ++larger[i];
    }
    benchmark::ClobberMemory();
}

Vec3 direction(double arc)
{
    return Vec3(std::cos(arc) * std::cos(0.37 * arc), std::sin(arc) * std::cos(0.37 * arc), std::sin(0.37 * arc));
}

// count_instructions.sh counts the instructions of Palpator::step between these two functions.
extern "C" [[gnu::noinline]] void beginRow()
{
    benchmark::ClobberMemory();
}
extern "C" [[gnu::noinline]] void endRow()
{
    benchmark::ClobberMemory();
}

/// @return number of ticks in a row: `usual`, or the number from the environment
int ticksOf(int usual)
{
    const char* asked = std::getenv("PALPATE_BENCH_TICKS");
    return asked != nullptr ? std::max(1, std::atoi(asked)) : usual;
}

/// Measured times and results of a row; create at the start of the ticks.
class Ticks
{
  public:
    Ticks() { beginRow(); }
    void step(benchmark::State& state, haptics::Palpator& palpator, const Vec3& hip, double time_s = 0.0)
    {
        const std::int64_t start = core::monotonicNow_ns();
        const haptics::TickResult tick = palpator.step(hip, 1e-3, nullptr, time_s);
        const std::int64_t end = core::monotonicNow_ns();
        m_ns.push_back(end - start);
        state.SetIterationTime(static_cast<double>(end - start) * 1e-9);
        for (int axis = 0; axis < 3; ++axis) {
            m_hash = m_hash * 0x9e3779b97f4a7c15ull + std::bit_cast<std::uint64_t>(tick.p_WG[axis]);
        }
        m_moves += tick.iterations;
        m_contacts += tick.constraints > 0 ? 1 : 0;
        m_limited += tick.status == haptics::TickStatus::IterationLimit ? 1 : 0;
    }
    void report(benchmark::State& state)
    {
        endRow();
        std::sort(m_ns.begin(), m_ns.end());
        const auto n = static_cast<double>(m_ns.size());
        const auto percentile = [&](double p) {
            return static_cast<double>(m_ns[std::min(m_ns.size() - 1, static_cast<std::size_t>(p * n))]);
        };
        state.counters["p50"] = percentile(0.5);
        state.counters["p99"] = percentile(0.99);
        state.counters["p99_9"] = percentile(0.999);
        state.counters["max"] = static_cast<double>(m_ns.back());
        state.counters["iterations"] = static_cast<double>(m_moves) / n;
        state.counters["contact"] = static_cast<double>(m_contacts) / n;
        state.counters["limit"] = static_cast<double>(m_limited) / n;
        state.counters["hash"] = static_cast<double>(m_hash >> 40);
    }

  private:
    std::vector<std::int64_t> m_ns;
    std::uint64_t m_hash = 0, m_moves = 0, m_contacts = 0, m_limited = 0;
};

void slide(benchmark::State& state, int n, double bump, double distance_mm, double speed_mm_s, bool isCold,
           double fingertip_mm, int spheres)
{
    const haptics::HapticScene& sphere = scene(n, bump, fingertip_mm, spheres);
    haptics::Palpator palpator;
    palpator.borrowScene(&sphere);
    double arc = 0.0;
    const double start_mm =
        10.0 + fingertip_mm;        // from outside: a ball placed nearer than its radius moves as a smaller one
    for (int i = 0; i < 300; ++i) { // approach
        const double share = std::min(1.0, i / 200.0);
        (void)palpator.step(direction(0.0) * (kRadius_mm + start_mm + (distance_mm - start_mm) * share), 1e-3);
    }
    Ticks ticks;
    for (auto _ : state) {
        arc += speed_mm_s * 1e-3 / kRadius_mm;
        const Vec3 hip = direction(arc) * (kRadius_mm + distance_mm);
        if (isCold) {
            flushCaches();
        }
        ticks.step(state, palpator, hip);
    }
    state.counters["triangles"] = sphere.structures()[0].surface->triangleCount();
    ticks.report(state);
}

void add(const char* name, int n, double bump, double distance_mm, double speed_mm_s, bool isCold, int ticks,
         double fingertip_mm = 0.0, int spheres = 1)
{
    benchmark::RegisterBenchmark(
        (std::string(name) + "/" + std::to_string(20 * n * n)).c_str(),
        [=](benchmark::State& state) { slide(state, n, bump, distance_mm, speed_mm_s, isCold, fingertip_mm, spheres); })
        ->Iterations(ticksOf(ticks))
        ->UseManualTime()
        ->Unit(benchmark::kNanosecond);
}

/// Returns the sphere with the tissue of the named row.
haptics::HapticScene tissueScene(const std::string& what, int n, double fingertip_mm)
{
    haptics::HapticStructure on{"sphere", test::indexed(test::bumpySphere(n, kRadius_mm, 0.0)), {0.5, 0.0}, 0};
    if (what == "friction" || what == "stuck" || what == "all" || what == "held" || what == "whole") {
        on.tissue.friction_static = what == "stuck" ? 1.0 : 0.15;
        on.tissue.friction_dynamic = what == "stuck" ? 1.0 : 0.1;
    }
    if (what == "law" || what == "all" || what == "whole") {
        on.tissue.law = core::usualLaw(core::LawKind::Exponential);
    }
    const auto rising = [&on](double perMm) {
        auto corners = std::make_shared<std::vector<std::array<float, 3>>>(on.surface->triangleCount());
        for (std::uint32_t i = 0; i < corners->size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3& p = on.surface->vertex(on.surface->triangle(i)[k]);
                (*corners)[i][k] = static_cast<float>(1.0 + perMm * p.x());
            }
        }
        return corners;
    };
    if (what == "map" || what == "both" || what == "all" || what == "whole") {
        on.maps.stiffness.corners = rising(0.01);
    }
    if (what == "felt" || what == "both" || what == "held" || what == "whole") {
        for (std::size_t j = 0; j < on.maps.felt.size(); ++j) {
            on.maps.felt[j].corners = rising(0.002 * static_cast<double>(j));
        }
    }
    if (what == "all" || what == "whole") {
        on.maps.damping = {rising(0.01), 1e-3};
    }
    return haptics::HapticScene({std::move(on)}, fingertip_mm);
}

void addTissue(const std::string& what, double fingertip_mm)
{
    constexpr int kN = 32;
    const auto run = [=](benchmark::State& state) {
        const haptics::HapticScene scene = tissueScene(what, kN, fingertip_mm);
        haptics::Palpator palpator;
        palpator.borrowScene(&scene);
        const double deep = kRadius_mm + fingertip_mm - 5.0;
        for (int i = 0; i <= 100; ++i) { // approach
            (void)palpator.step(direction(0.0) * (deep + 0.1 * (100 - i)), 1e-3);
        }
        Ticks ticks;
        int i = 0;
        for (auto _ : state) {
            ++i;
            const double arc = what == "stuck" ? 0.5 / kRadius_mm * std::sin(0.2 * i) : 0.1 / kRadius_mm * i;
            ticks.step(state, palpator, direction(arc) * deep);
        }
        ticks.report(state);
    };
    benchmark::RegisterBenchmark(
        ("tissue/" + what + "/" + std::to_string(static_cast<int>(fingertip_mm)) + "/" + std::to_string(20 * kN * kN))
            .c_str(),
        run)
        ->Iterations(ticksOf(fingertip_mm > 0.0 ? 20'000 : 100'000))
        ->UseManualTime()
        ->Unit(benchmark::kNanosecond);
}

std::shared_ptr<const geometry::SurfaceMotion> motionOf(const std::string& what)
{
    const core::Box box(Vec3::Constant(-60), Vec3::Constant(60));
    if (what == "frames") {
        return test::randomMotion(box, 10.0, 4, 1);
    }
    if (what == "pose") {
        core::Transform pose = core::Transform::Identity();
        pose.rotate(Eigen::AngleAxisd(0.5, Vec3::UnitX()));
        pose.translation() = Vec3(0, 10, 20);
        return geometry::SurfaceMotion::poses({{0.0, core::Transform::Identity()}, {300.0, pose}}).value();
    }
    geometry::Breath breath;
    breath.amplitude_mm = Vec3(0, 3, 15);
    breath.still_W = Vec3(0, 0, -50);
    breath.full_W = Vec3(0, 0, 50);
    return what == "rest" ? nullptr : geometry::SurfaceMotion::breath(breath, box).value();
}

void addMoving(const std::string& what)
{
    constexpr int kN = 32;
    const auto run = [=](benchmark::State& state) {
        const auto motion = motionOf(what);
        haptics::HapticStructure on{"sphere", test::indexed(test::bumpySphere(kN, kRadius_mm, 0.0)), {0.5, 0.0}, 0};
        on.motion = motion;
        const haptics::HapticScene scene({std::move(on)});
        haptics::Palpator palpator;
        palpator.borrowScene(&scene);
        const double deep = kRadius_mm + (what == "free" ? 5.0 : -5.0);
        int i = -100;
        const auto hipAt = [&](const Vec3& X) {
            return motion == nullptr ? X : motion->toWorld(motion->at(1e-3 * i), X);
        };
        for (; i < 0; ++i) { // approach
            (void)palpator.step(hipAt(direction(0.0) * (deep - 0.1 * i)), 1e-3, nullptr, 1e-3 * i);
        }
        Ticks ticks;
        for (auto _ : state) {
            ++i;
            ticks.step(state, palpator, hipAt(direction(0.1 / kRadius_mm * i) * deep), 1e-3 * i);
        }
        ticks.report(state);
    };
    benchmark::RegisterBenchmark(("moving/" + what + "/" + std::to_string(20 * kN * kN)).c_str(), run)
        ->Iterations(ticksOf(100'000))
        ->UseManualTime()
        ->Unit(benchmark::kNanosecond);
}

geometry::TriangleMesh fanOf(std::uint32_t n)
{
    geometry::TriangleMesh fan;
    fan.vertices = {Vec3(0, 0, 5), Vec3(0, 0, -10)};
    for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 6.283185307179586 * i / n;
        fan.vertices.push_back(Vec3(20 * std::cos(angle), 20 * std::sin(angle), i % 2));
        const std::uint32_t next = (i + 1) % n;
        fan.triangles.push_back({0, 2 + i, 2 + next});
        fan.triangles.push_back({1, 2 + next, 2 + i});
    }
    return fan;
}

geometry::TriangleMesh pileOf(std::uint32_t n)
{
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal(0.0, 1e-9);
    geometry::TriangleMesh pile;
    for (std::uint32_t i = 0; i < n; ++i) {
        for (const Vec3& corner : {Vec3(-10, -10, 0), Vec3(10, -10, 0), Vec3(0, 10, 0)}) {
            pile.vertices.push_back(corner + Vec3(normal(random), normal(random), normal(random)));
        }
        pile.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return pile;
}

std::vector<haptics::HapticStructure> crowdOf(int n)
{
    std::mt19937_64 random(8);
    std::normal_distribution<double> normal;
    const geometry::TriangleMesh sphere = test::sphere(10, 8.0);
    std::vector<haptics::HapticStructure> structures;
    for (int i = 0; i < n; ++i) {
        const Vec3 at = 6.0 * Vec3(normal(random), normal(random), normal(random));
        const auto moved = [&at](const Vec3& p) { return Vec3(p + at); };
        structures.push_back({"sphere", test::indexed(test::transformed(sphere, moved)), {0.5, 0.0}, 0});
    }
    return structures;
}

/// @param name  fan, pile or crowd
void addWorst(const std::string& name, double fingertip_mm)
{
    const auto run = [=](benchmark::State& state) {
        std::vector<haptics::HapticStructure> structures;
        if (name == "crowd") {
            structures = crowdOf(300);
        } else {
            const geometry::TriangleMesh mesh = name == "fan" ? fanOf(10'000) : pileOf(1'000'000);
            structures.push_back({name, test::indexed(mesh), {0.5, 0.0}, 0});
        }
        const haptics::HapticScene worst(std::move(structures), fingertip_mm);
        haptics::Palpator palpator;
        palpator.borrowScene(&worst);
        Ticks ticks;
        int i = 0;
        for (auto _ : state) {
            const double arc = 0.003 * i, high = std::max(0.0, 60.0 - 0.3 * i);
            ++i;
            const double wide = name == "crowd" ? 14.0 : 2.0;
            ticks.step(state, palpator,
                       Vec3(wide * std::sin(arc), wide * std::sin(1.4 * arc), high + 2 * std::cos(1.2 * arc)));
        }
        ticks.report(state);
    };
    benchmark::RegisterBenchmark(("worst/" + name + "/" + std::to_string(static_cast<int>(fingertip_mm))).c_str(), run)
        ->Iterations(ticksOf(3'000))
        ->UseManualTime()
        ->Unit(benchmark::kNanosecond);
}

} // namespace

int main(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    for (const int n : {8, 32, 128, 256}) {
        add("slide", n, 0.0, -5.0, 100.0, false, 200'000);
        add("free", n, 0.0, 5.0, 100.0, false, 200'000);
    }
    add("cold", 256, 0.0, -5.0, 100.0, true, 300);
    add("bumpy", 128, 0.05, -5.0, 400.0, false, 100'000);
    add("finger", 128, 0.0, -5.0, 100.0, false, 50'000, 1.0);
    add("crowd", 32, 0.0, -5.0, 100.0, false, 200'000, 0.0, 300);
    for (const int radius : {1, 4, 8, 20}) {
        add(("ball" + std::to_string(radius)).c_str(), 81, 0.02, radius - 2.0, 100.0, false, 20'000, radius);
    }
    for (const double radius : {0.0, 4.0}) {
        for (const char* what : {"plain", "friction", "stuck", "law", "map", "felt", "both", "all", "held", "whole"}) {
            addTissue(what, radius);
        }
    }
    for (const char* what : {"rest", "pose", "breath", "frames", "free"}) {
        addMoving(what);
    }
    for (const char* name : {"fan", "pile", "crowd"}) {
        for (const double radius : {1.0, 4.0, 20.0}) {
            addWorst(name, radius);
        }
    }
    if (std::getenv("PALPATE_BENCH_LARGE") != nullptr) {
        add("slide", 708, 0.0, -5.0, 100.0, false, 200'000);
        add("free", 708, 0.0, 5.0, 100.0, false, 200'000);
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
