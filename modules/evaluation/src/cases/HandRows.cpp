// SPDX-License-Identifier: BSD-3-Clause
// Hard cases for transformed scenes and for hand and device behaviour.
#include "cases/HardCaseRows.h"

#include "palpate/evaluation/Shapes.h"

#include <limits>

namespace palpate::evaluation {

namespace {

constexpr double kRadius_mm = 40.0;

geometry::TriangleMesh bumpy()
{
    return shapes::bumpySphere(24, kRadius_mm, 0.04);
}

/// @param slowest,fastest  range of the speed [mm per tick]
std::function<std::function<Vec3()>()> wandering(double deepest_mm, double slowest, double fastest, std::uint64_t seed)
{
    return [=] {
        return [hand = std::make_shared<RandomHandPath>(kRadius_mm, deepest_mm, slowest, fastest, seed)] {
            return hand->next();
        };
    };
}

HardCase wanderingRow(std::string name, std::int64_t ticks, double slowest, double fastest, std::uint64_t seed)
{
    HardCase result;
    result.name = std::move(name);
    result.mesh = bumpy;
    result.motion = wandering(4.0, slowest, fastest, seed);
    result.ticks = ticks;
    return result;
}

} // namespace

void addTransformRows(std::vector<HardCase>& rows)
{
    // Tolerance of the results: 1e-9 of the scene, plus the precision of coordinates at that offset.
    const auto twinRow = [&rows](std::string name, std::function<Vec3(const Vec3&)> map, double scale, double offset) {
        HardCase c = wanderingRow(std::move(name), 3000, 0.05, 0.15, 21);
        c.twin = std::move(map);
        c.scale = scale;
        c.twinBound_mm = 1e-9 * 2.0 * kRadius_mm * scale + 32.0 * std::numeric_limits<double>::epsilon() * offset;
        rows.push_back(std::move(c));
    };
    const core::Quaternion turn = core::Quaternion(0.3, 0.5, -0.7, 0.2).normalized();
    twinRow(
        "the scene 1e6 mm away", [](const Vec3& p) { return Vec3(p + Vec3(1e6, -1e6, 1e6)); }, 1.0, 1e6);
    twinRow(
        "the scene scaled by 1e-3", [](const Vec3& p) { return Vec3(1e-3 * p); }, 1e-3, 0.0);
    twinRow(
        "the scene scaled by 1e3", [](const Vec3& p) { return Vec3(1e3 * p); }, 1e3, 0.0);
    twinRow(
        "the scene turned", [turn](const Vec3& p) { return Vec3(turn * p); }, 1.0, 0.0);
}

void addHandRows(std::vector<HardCase>& rows)
{
    {
        HardCase c = wanderingRow("device noise of 0.1 mm", 4000, 0.05, 0.15, 31);
        const auto smooth = c.motion;
        c.motion = [smooth] {
            return [next = smooth(), dice = std::make_shared<RandomSource>(32)] {
                return Vec3(next() + 0.1 * dice->normal3());
            };
        };
        rows.push_back(std::move(c));
    }
    {
        HardCase c = wanderingRow("teleports of 500 mm", 1500, 0.05, 0.15, 41);
        const auto smooth = c.motion;
        c.motion = [smooth] {
            return [next = smooth(), dice = std::make_shared<RandomSource>(42), tick = 0]() mutable {
                const Vec3 p = next();
                return ++tick % 50 < 2 ? Vec3(p + 500.0 * dice->normal3().normalized()) : p;
            };
        };
        rows.push_back(std::move(c));
    }
    {
        HardCase c = row("10 s of stillness in contact", bumpy,
                         HandPath({10, 20, 60}).to({6, 18, 30}, 0.2).rest(10000).to({10, 20, 60}, 0.5));
        c.checkEvery = 10;
        rows.push_back(std::move(c));
    }
    {
        HardCase c = wanderingRow("NaN and infinite input", 1500, 0.05, 0.15, 51);
        const auto smooth = c.motion;
        c.motion = [smooth] {
            return [next = smooth(), tick = 0]() mutable {
                Vec3 p = next();
                constexpr double kInfinity = std::numeric_limits<double>::infinity();
                if (++tick % 40 == 0) {
                    p[tick / 40 % 3] = tick % 80 == 0    ? std::numeric_limits<double>::quiet_NaN()
                                       : tick % 120 == 0 ? -kInfinity
                                                         : kInfinity;
                }
                return p;
            };
        };
        rows.push_back(std::move(c));
    }
    HardCase random = wanderingRow("1e5 ticks of random motion at 300 to 500 mm/s", 100000, 0.3, 0.5, 61);
    random.checkEvery = 2;
    rows.push_back(random);
    random.name = "1e7 ticks of random motion at 300 to 500 mm/s";
    random.ticks = 10000000;
    random.checkEvery = 50;
    random.isLong = true;
    rows.push_back(random);
}

} // namespace palpate::evaluation
