// SPDX-License-Identifier: BSD-3-Clause
#include "TouchScenes.h"

#include <palpate/device/DevicePresets.h>
#include <palpate/geometry/Repair.h>
#include <palpate/geometry/SurfaceIndex.h>

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <utility>

namespace palpate::test {

using core::Vec3;

namespace {

geometry::TriangleMesh icosphere(double radius_mm, const Vec3& centre, int divisions)
{
    const double g = (1.0 + std::sqrt(5.0)) / 2.0;
    std::vector<Vec3> corners{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    std::vector<geometry::Triangle> triangles{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                              {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                              {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                              {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (int i = 0; i < divisions; ++i) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [entry, isNew] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(corners.size()));
            if (isNew) {
                corners.emplace_back((corners[a] + corners[b]) / 2.0);
            }
            return entry->second;
        };
        std::vector<geometry::Triangle> finer;
        for (const auto& [a, b, c] : triangles) {
            const std::uint32_t ab = middle(a, b);
            const std::uint32_t bc = middle(b, c);
            const std::uint32_t ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        triangles = std::move(finer);
        for (Vec3& corner : corners) {
            corner.normalize();
        }
    }
    geometry::TriangleMesh mesh;
    mesh.triangles = std::move(triangles);
    for (const Vec3& corner : corners) {
        mesh.vertices.emplace_back(centre + radius_mm * corner.normalized());
    }
    return mesh;
}

} // namespace

std::shared_ptr<const haptics::HapticScene> sphereScene(double radius_mm, double stiffness_N_per_mm,
                                                        double damping_Ns_per_mm, const Vec3& centre,
                                                        double fingertip_mm)
{
    haptics::HapticStructure structure;
    structure.name = "sphere";
    structure.surface = std::make_shared<const geometry::SurfaceIndex>(
        geometry::SurfaceIndex::build(geometry::repair(icosphere(radius_mm, centre, 4))));
    structure.tissue.stiffness_N_per_mm = stiffness_N_per_mm;
    structure.tissue.damping_Ns_per_mm = damping_Ns_per_mm;
    return std::make_shared<const haptics::HapticScene>(std::vector<haptics::HapticStructure>{structure}, fingertip_mm);
}

std::vector<Vec3> palpatingMotion(int ticks)
{
    std::vector<Vec3> motion;
    motion.reserve(static_cast<std::size_t>(ticks));
    for (int i = 0; i < ticks; ++i) {
        const double t = i / 1000.0;
        const double radius = 30.0 + 4.0 * std::cos(7.0 * t); // 4 mm above to 4 mm below the surface
        const double longitude = 2.3 * t;
        const double latitude = 0.9 * std::sin(1.7 * t);
        motion.emplace_back(radius * std::cos(latitude) * std::cos(longitude),
                            radius * std::cos(latitude) * std::sin(longitude), radius * std::sin(latitude));
    }
    return motion;
}

servo::GateLimits limitsOf(const char* preset)
{
    device::DeviceInfo info = device::deviceInfo(*device::findDevicePreset(preset));
    info.workspaceRadius_mm = 0.0;
    return servo::GateLimits::forDevice(info);
}

bool isSameTick(const servo::TickRecord& first, const servo::TickRecord& second) noexcept
{
    const haptics::TickResult& a = first.felt;
    const haptics::TickResult& b = second.felt;
    const auto isSame = [](const Vec3& u, const Vec3& v) {
        return std::memcmp(u.data(), v.data(), 3 * sizeof(double)) == 0;
    };
    return isSame(a.p_WG, b.p_WG) && isSame(a.n_W, b.n_W) && isSame(a.f_W, b.f_W) && a.structure == b.structure &&
           a.triangle == b.triangle && a.constraints == b.constraints && a.iterations == b.iterations;
}

} // namespace palpate::test
