// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/Shapes.h"
#include "palpate/evaluation/Stability.h"

#include "stability/StabilityTrial.h"

#include <palpate/geometry/Repair.h>
#include <palpate/geometry/SurfaceIndex.h>
#include <palpate/haptics/ForceTable.h>
#include <palpate/haptics/Palpator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace palpate::evaluation::stability {

namespace {

haptics::HapticStructure structure(std::string name, const geometry::TriangleMesh& mesh)
{
    haptics::HapticStructure out;
    out.name = std::move(name);
    out.surface = std::make_shared<const geometry::SurfaceIndex>(
        geometry::SurfaceIndex::build(geometry::repair(mesh, geometry::Facing::AsGiven)));
    return out;
}

Shape single(std::string name, const geometry::TriangleMesh& mesh, const Hold& hold)
{
    Shape shape;
    shape.structures.push_back(structure(name, mesh));
    shape.share = {1.0};
    shape.holds = {hold};
    shape.name = std::move(name);
    return shape;
}

/// Returns true if a straight approach reaches the hold without starting inside another structure.
bool isReached(const Hold& hold, const haptics::HapticScene& scene)
{
    haptics::Palpator palpator;
    palpator.borrowScene(&scene);
    haptics::TickResult felt;
    for (double depth_mm = -kClearance_mm; depth_mm <= 1.0; depth_mm += 0.1) {
        felt = palpator.step(hold.p_W + depth_mm * hold.d_W, 0.001);
    }
    return felt.structure >= 0 && hold.d_W.allFinite();
}

/// Builds three slabs that meet at the origin.
geometry::TriangleMesh innerCorner()
{
    geometry::TriangleMesh mesh = shapes::box(Vec3(-20, -20, -20), Vec3(40, 40, 0));
    shapes::append(mesh, shapes::box(Vec3(-20, -20, -20), Vec3(0, 40, 40)));
    shapes::append(mesh, shapes::box(Vec3(-20, -20, -20), Vec3(40, 0, 40)));
    return mesh;
}

/// Stiff block embedded flush in a soft one: the border of a lump within one layer.
Shape lump()
{
    Shape shape;
    shape.name = "stiffness step at a lump";
    shape.structures.push_back(structure("soft", shapes::box(Vec3(-40, -40, -40), Vec3(0, 40, 0))));
    shape.structures.push_back(structure("lump", shapes::box(Vec3(0, -40, -40), Vec3(40, 40, 0))));
    shape.share = {0.2, 1.0};
    shape.holds = {{Vec3::Zero(), -Vec3::UnitZ(), Vec3(-5, 0, 0)}, {Vec3(0.1, 0, 0), -Vec3::UnitZ(), Vec3::Zero()}};
    return shape;
}

/// Soft cover over a block just below in the next layer: a press contacts both, and the stiffnesses add up. The cover
/// is thin, so that a light press reaches the block even through a stiff cover.
Shape cover()
{
    constexpr double kCover_mm = 0.2;
    Shape shape;
    shape.name = "two layers";
    shape.structures.push_back(structure("cover", shapes::box(Vec3(-30, -30, -30), Vec3(30, 30, 0))));
    shape.structures.push_back(structure("block", shapes::box(Vec3(-20, -20, -20), Vec3(20, 20, -kCover_mm))));
    shape.structures[1].layer = 1;
    shape.share = {0.5, 0.5};
    shape.holds = {{Vec3(0.3, 0.2, 0), -Vec3::UnitZ(), Vec3::Zero()},
                   {Vec3(20, 0.2, 0), -Vec3::UnitZ(), Vec3(5, 0, 0)}}; // from beside the block onto the block's border
    return shape;
}

/// Wall that is twice as stiff on one side; the press is on the 10 mm ramp of the map.
Shape mapStep()
{
    const geometry::RepairedMesh mesh =
        geometry::repair(shapes::box(Vec3(-30, -30, -30), Vec3(30, 30, 0), 6), geometry::Facing::AsGiven);
    haptics::HapticStructure wall;
    wall.name = "wall with a map";
    auto surface = std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(mesh));
    std::vector<float> values;
    for (const Vec3& v : mesh.mesh.vertices) {
        values.push_back(v.x() < 5.0 ? 0.5F : 1.0F);
    }
    wall.maps.stiffness = haptics::TissueMap::atVertices(*surface, mesh, values);
    wall.surface = std::move(surface);
    Shape shape;
    shape.name = "map with a step";
    shape.structures = {std::move(wall)};
    shape.share = {1.0};
    shape.holds = {{Vec3(5, 0.2, 0), -Vec3::UnitZ(), Vec3(-5, 0, 0)}, {Vec3(9, 0.2, 0), -Vec3::UnitZ(), {0, 0, 0}}};
    return shape;
}

Shape roughWall()
{
    Shape shape = single("wall with friction", shapes::box(Vec3(-30, -30, -30), Vec3(30, 30, 0)),
                         {Vec3(0.3, 0.2, 0), -Vec3::UnitZ(), {0, 0, 0}});
    shape.structures[0].tissue.friction_static = 0.4;
    shape.structures[0].tissue.friction_dynamic = 0.3;
    return shape;
}

using Corners = std::array<Vec3, 3>;

Corners corners(const geometry::SurfaceIndex& surface, std::uint32_t triangle)
{
    const geometry::Triangle t = surface.triangle(triangle);
    return {surface.vertex(t[0]), surface.vertex(t[1]), surface.vertex(t[2])};
}

/// Gradient over a triangle of the values at its corners [1/mm]; 0 for zero-area triangles.
double steepness(const Corners& at, const std::array<float, 3>& values)
{
    const Vec3 first = at[1] - at[0], second = at[2] - at[0], normal = first.cross(second);
    const Vec3 along = (values[1] - values[0]) * second.cross(normal) + (values[2] - values[0]) * normal.cross(first);
    return normal.squaredNorm() > 0.0 ? along.norm() / normal.squaredNorm() : 0.0;
}

/// Triangles of a structure to press: a few regular ones, plus those with the largest value and the largest gradient
/// of a stiffness map or of a map of buried lumps.
std::vector<std::uint32_t> pressedTriangles(const haptics::HapticStructure& one)
{
    constexpr std::uint32_t kUsual = 4;
    std::vector<std::uint32_t> pressed;
    if (one.surface == nullptr || one.surface->triangleCount() == 0) {
        return pressed;
    }
    const auto count = static_cast<std::uint32_t>(one.surface->triangleCount());
    const std::uint32_t usual = std::min(kUsual, count);
    for (std::uint32_t i = 0; i < usual; ++i) {
        pressed.push_back(i * (count / usual));
    }
    for (const haptics::TissueMap* map : {&one.maps.stiffness, &one.maps.felt.back()}) {
        if (map->isEmpty()) {
            continue;
        }
        const std::vector<std::array<float, 3>>& values = *map->corners;
        std::uint32_t stiffest = 0, steepest = 0;
        for (std::uint32_t i = 1; i < count; ++i) {
            const auto sum = [&values](std::uint32_t of) { return values[of][0] + values[of][1] + values[of][2]; };
            stiffest = sum(i) > sum(stiffest) ? i : stiffest;
            const auto changes = [&](std::uint32_t of) { return steepness(corners(*one.surface, of), values[of]); };
            steepest = changes(i) > changes(steepest) ? i : steepest;
        }
        pressed.insert(pressed.end(), {stiffest, steepest});
    }
    return pressed;
}

/// Largest stiffening factor of the maps [1]. Buried lumps count with the factor of a light press: on a surface stiff
/// enough to oscillate, the few newtons of a hand do not press deeper.
double stiffening(const haptics::TissueMaps& maps)
{
    double most = maps.stiffness.isEmpty() ? 1.0 : maps.stiffness.greatest();
    if (maps.hasFelt()) {
        static_assert(haptics::kFeltPress_mm[1] == 2.0);
        most *= std::max(maps.felt[0].greatest(), maps.felt[1].greatest());
    }
    return most;
}

} // namespace

std::vector<Shape> standardShapes()
{
    constexpr double kGroove = 10.0 * std::numbers::pi / 180.0;
    std::vector<Shape> out;
    out.push_back(single("wall", shapes::box(Vec3(-30, -30, -30), Vec3(30, 30, 0)),
                         {Vec3(0.3, 0.2, 0), -Vec3::UnitZ(), {0, 0, 0}}));
    out.push_back(single("inner corner", innerCorner(), {Vec3::Zero(), Vec3(-1, -1, -1).normalized(), {0, 0, 0}}));
    out.push_back(single("edge", shapes::box(Vec3(-30, -30, -30), Vec3(0, 30, 0)),
                         {Vec3::Zero(), Vec3(-1, 0, -1).normalized(), {0, 0, 0}}));
    out.push_back(single("10° groove", shapes::groove(kGroove), {Vec3::Zero(), -Vec3::UnitZ(), {0, 0, 0}}));
    out.push_back(lump());
    const Vec3 n = Vec3(0.3, 0.4, 0.87).normalized();
    out.push_back(single("fine sphere", shapes::bumpySphere(128, 30.0, 0.0), {30.0 * n, -n, {0, 0, 0}}));
    out.push_back(cover());
    out.push_back(mapStep());
    out.push_back(roughWall());
    return out;
}

Shape shapeOf(std::string name, const haptics::HapticScene& scene)
{
    Shape shape;
    shape.name = std::move(name);
    shape.structures = scene.structures();
    double& stiffest_N_per_mm = shape.own_N_per_mm;
    for (const haptics::HapticStructure& one : shape.structures) {
        if (one.surface != nullptr) {
            stiffest_N_per_mm = std::max(stiffest_N_per_mm, haptics::maxStiffness(one.tissue) * stiffening(one.maps));
        }
    }
    for (const haptics::HapticStructure& one : shape.structures) {
        // Layers in contact together are stiffer still.
        shape.share.push_back(stiffest_N_per_mm > 0.0 ? haptics::maxStiffness(one.tissue) / stiffest_N_per_mm : 1.0);
        for (const std::uint32_t triangle : pressedTriangles(one)) {
            const Corners at = corners(*one.surface, triangle);
            const Hold hold{(at[0] + at[1] + at[2]) / 3.0, -(at[1] - at[0]).cross(at[2] - at[0]).normalized(),
                            Vec3::Zero()};
            if (isReached(hold, scene)) {
                shape.holds.push_back(hold);
            }
        }
    }
    return shape;
}

} // namespace palpate::evaluation::stability
