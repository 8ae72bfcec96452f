// SPDX-License-Identifier: BSD-3-Clause
// Hard cases with ties: HIPs exactly on vertices, on edges and in planes of arbitrarily oriented meshes, and
// god-objects within the skin of one surface next to another. Such inputs occur with scripts, grids and CAD models.
#include "cases/HardCaseRows.h"

#include "palpate/evaluation/Shapes.h"
#include "palpate/evaluation/Surface.h"

#include <palpate/geometry/SurfaceIndex.h>

#include <array>

namespace palpate::evaluation {

namespace {

using geometry::TriangleMesh;

const core::Quaternion kTurn = core::Quaternion(0.4, -0.3, 0.6, 0.5).normalized();

std::function<TriangleMesh()> turned(const std::function<TriangleMesh()>& mesh)
{
    return [mesh] {
        TriangleMesh result = mesh();
        for (Vec3& v : result.vertices) {
            v = kTurn * v;
        }
        return result;
    };
}

/// Rotates a path exactly like the vertices of `turned`, so that equal points remain equal.
HandPath turned(const HandPath& path)
{
    HandPath result(kTurn * path.points().front());
    for (std::size_t i = 1; i < path.points().size(); ++i) {
        result.jump(kTurn * path.points()[i]);
    }
    return result;
}

/// Positive inside the closed mesh, except within 1e-8 mm of the surface. For bodies that are two-sided because of
/// attached open surfaces.
std::function<double(const Vec3&)> inside(const TriangleMesh& mesh)
{
    const auto surface = std::make_shared<const Surface>(geometry::repair(mesh, geometry::Facing::AsGiven));
    return [surface](const Vec3& p) {
        for (int i = 0; i < 7; ++i) {
            const Vec3 shift = i == 6 ? Vec3(Vec3::Zero()) : Vec3((i < 3 ? 1e-8 : -1e-8) * Vec3::Unit(i % 3));
            if (surface->winding(p + shift) <= 0) {
                return 0.0;
            }
        }
        return 1.0;
    };
}

TriangleMesh floorAndWall()
{
    TriangleMesh mesh = shapes::box({-10, -10, -10}, {10, 10, 0}, 4);
    shapes::append(mesh, shapes::box({1, -5, -1}, {9, 5, 5}));
    return mesh;
}

/// Starts just above the floor and just beside the wall, then moves far to the side and minimally below the floor.
void addFloorAndWall(std::vector<HardCase>& rows)
{
    const double skin =
        geometry::SurfaceIndex::build(geometry::repair(floorAndWall(), geometry::Facing::AsGiven)).skin_mm();
    const auto path = [skin](double x, double height) {
        HandPath result({x, 0, height + 1});
        for (const double skins : {1.001, 1.01, 1.05, 1.2, 1.4}) {
            for (const double deep : {1e-12, 2e-10, 1e-9, 1e-8, 1e-6, 1e-4}) {
                result.jump({x, 0, height + 1})
                    .jump({x, 0, height + skins * skin})
                    .jump({6, 0, height - deep})
                    .jump({x, 0, height + 1});
            }
        }
        return result;
    };
    rows.push_back(row("floor and wall, a skin above the floor", floorAndWall, path(0.9999, 0.0)));
    rows.push_back(row("floor and wall, ball of 0.5 mm a skin above the floor", floorAndWall, path(0.4, 0.5)));
    rows.back().fingertip_mm = 0.5;
}

TriangleMesh finnedSphere()
{
    TriangleMesh mesh = shapes::bumpySphere(4, 20.0, 0.05);
    for (const std::size_t i : {3u, 77u, 150u, 290u}) {
        const geometry::Triangle t = mesh.triangles[i];
        mesh.vertices.push_back(0.85 * (mesh.vertices[t[0]] + mesh.vertices[t[1]]));
        mesh.triangles.push_back({t[0], t[1], static_cast<std::uint32_t>(mesh.vertices.size() - 1)});
    }
    return mesh;
}

void addNoiseOnFins(std::vector<HardCase>& rows)
{
    RandomSource dice(71);
    HandPath path({0, 0, 50});
    for (int i = 0; i < 3000; ++i) {
        path.jump(15.0 * dice.normal3());
    }
    rows.push_back(row("white noise of 15 mm in a sphere with fins", finnedSphere, path));
    rows.back().intrusion_mm = inside(shapes::bumpySphere(4, 20.0, 0.05));
    rows.back().maxElsewhere_percent = 2.0; // around a fin there are two paths
}

TriangleMesh touchingBoxes(int left, int right)
{
    TriangleMesh mesh = shapes::box({-10, -10, -10}, {0, 10, 10}, left);
    shapes::append(mesh, shapes::box({0, -10, -10}, {10, 10, 10}, right));
    return mesh;
}

/// Path on a grid of the box's edge lines, 2 mm below the top, and from the sides.
HandPath alongEdges(const std::vector<double>& lines)
{
    HandPath path({lines[0], 0, 14});
    path.to({lines[0], 0, 8}, 0.5);
    for (const double line : lines) {
        path.to({line, -9, 8}, 0.5).to({line, 9, 8}, 0.1).to({-9, line, 8}, 0.5).to({9, line, 8}, 0.1);
    }
    path.to({lines[0], 1, 8}, 0.5).to({4, 4, 8}, 0.1).to({4, 4, 14}, 0.5);
    return path.jump({14, 0, 0}).to({8, 0, 0}, 0.5).to({8, 0, 9}, 0.1);
}

void addEdgeLines(std::vector<HardCase>& rows)
{
    const auto box = [] { return shapes::box({-10, -10, -10}, {10, 10, 10}, 4); };
    rows.push_back(row("along the edges of a box, turned", turned(box), turned(alongEdges({0.0, 5.0, -5.0}))));
    // With equal squares, the wall in between consists of triangles shared by both boxes: neither box is closed, and
    // the god-object must not enter either. With unequal squares each box is closed and checked as such. When rotated,
    // their edges at x = 0 differ in the last digit, and a HIP exactly in that crack has no unique correct result.
    for (const bool isEqual : {true, false}) {
        const std::function<TriangleMesh()> mesh = [isEqual] { return touchingBoxes(2, isEqual ? 2 : 3); };
        const std::string name =
            formatted("along the edges of touching boxes of %s squares", isEqual ? "equal" : "unequal");
        rows.push_back(row(name, mesh, alongEdges({0.0, 5.0, -5.0})));
        if (isEqual) {
            rows.back().intrusion_mm = [](const Vec3& p) { return 10.0 - p.cwiseAbs().maxCoeff() - 1e-8; };
        }
        const std::vector<double> lines = isEqual ? std::vector{0.0, 5.0, -5.0} : std::vector{5.0, -5.0};
        rows.push_back(row(name + ", turned", turned(mesh), turned(alongEdges(lines))));
        if (isEqual) {
            rows.back().intrusion_mm = [](const Vec3& p) {
                return 10.0 - (kTurn.conjugate() * p).cwiseAbs().maxCoeff() - 1e-8;
            };
        }
    }
}

/// Presses from above onto vertices, edge midpoints and facet centres of a 2 mm grid, and below.
HandPath ontoFeatures(const TriangleMesh& grid, double deep_mm)
{
    RandomSource dice(81);
    HandPath path({1, 1, 5});
    while (path.points().size() < 3000) {
        const geometry::Triangle& t =
            grid.triangles[static_cast<std::size_t>(dice.next() * 0.999 * static_cast<double>(grid.triangles.size()))];
        const Vec3 &a = grid.vertices[t[0]], &b = grid.vertices[t[1]], &c = grid.vertices[t[2]];
        if (std::max({a.head<2>().cwiseAbs().maxCoeff(), b.head<2>().cwiseAbs().maxCoeff(),
                      c.head<2>().cwiseAbs().maxCoeff()}) > 7.0) {
            continue; // away from the rim, around which the path to the other side is free
        }
        const double kind = dice.next();
        const Vec3 on = kind < 0.4 ? a : kind < 0.7 ? Vec3(0.5 * (a + b)) : Vec3((a + b + c) / 3.0);
        path.jump(on);
        if (dice.next() < 0.5) {
            path.jump(on - deep_mm * dice.next() * Vec3::UnitZ());
        }
        if (dice.next() < 0.2) {
            path.jump(on + 2.0 * Vec3::UnitZ());
        }
    }
    return path;
}

void addOpenGrids(std::vector<HardCase>& rows)
{
    const auto flat = [] { return shapes::sheet(10.0, 10); };
    const auto wavy = [] {
        TriangleMesh mesh = shapes::sheet(10.0, 10);
        for (Vec3& v : mesh.vertices) {
            v.z() = 0.5 * std::sin(1.3 * v.x()) * std::cos(1.7 * v.y());
        }
        return mesh;
    };
    // Region between the sheet and a floor that closes the path around: the same squares seen from above.
    const auto below = [](const TriangleMesh& sheet, double deep_mm) {
        TriangleMesh body = sheet;
        const auto count = static_cast<std::uint32_t>(body.vertices.size());
        TriangleMesh floor = sheet;
        for (Vec3& v : floor.vertices) {
            v.z() = -deep_mm;
        }
        geometry::flip(floor);
        shapes::append(body, floor);
        for (std::uint32_t i = 0; i < sheet.triangles.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = sheet.triangles[i][k], b = sheet.triangles[i][(k + 1) % 3];
                const Vec3 &p = sheet.vertices[a], &q = sheet.vertices[b];
                const bool isRim =
                    (std::abs(p.x()) == 10.0 && p.x() == q.x()) || (std::abs(p.y()) == 10.0 && p.y() == q.y());
                if (isRim) {
                    body.triangles.push_back({b, a, count + a});
                    body.triangles.push_back({b, count + a, count + b});
                }
            }
        }
        return body;
    };
    for (const bool isWavy : {false, true}) {
        const std::function<TriangleMesh()> mesh = isWavy ? std::function<TriangleMesh()>(wavy) : flat;
        const HandPath path = ontoFeatures(mesh(), 3.0);
        const TriangleMesh body = below(mesh(), 5.0);
        const std::string name =
            isWavy ? "onto the vertices and edges of a wavy sheet" : "onto the vertices and edges of a flat sheet";
        rows.push_back(row(name, mesh, path));
        rows.back().intrusion_mm = inside(body);
        rows.back().maxElsewhere_percent = isWavy ? 2.0 : 0.0; // from the top of a hill there are many paths
        rows.push_back(row(name + ", turned", turned(mesh), turned(path)));
        rows.back().intrusion_mm = inside(turned([body] { return body; })());
        rows.back().maxElsewhere_percent = isWavy ? 2.0 : 0.0;
    }
}

/// HIPs in the planes of far facets, of a touched facet, and in between.
void addPlanes(std::vector<HardCase>& rows)
{
    const auto mesh = [] {
        TriangleMesh two = shapes::sheet(1.0);
        for (const double x : {40.0, -40.0}) {
            TriangleMesh other = shapes::sheet(1.0);
            for (Vec3& v : other.vertices) {
                v.x() += x;
            }
            shapes::append(two, other);
        }
        shapes::append(two, shapes::box({-9, 10, -10}, {9, 20, 0}, 2)); // coplanar top
        return two;
    };
    RandomSource dice(91);
    HandPath path({10, 0, 3});
    for (int i = 0; i < 4000; ++i) {
        const double x = 45.0 * (2.0 * dice.next() - 1.0), y = 25.0 * (2.0 * dice.next() - 1.0);
        const double kind = dice.next();
        path.jump({x, y, kind < 0.7 ? 0.0 : kind < 0.8 ? 1e-9 * dice.normal() : 2.0 * dice.normal()});
    }
    // For a HIP in the plane of the box's top, approached from the side where the wall ends, rounding decides whether
    // the edge of the wall blocks the exact solver, whose straight move has no skin. In these ticks the exact solver
    // stays behind.
    rows.push_back(row("in the planes of far facets", mesh, path));
    rows.back().maxElsewhere_percent = 4.0;
    rows.push_back(row("in the planes of far facets, turned", turned(mesh), turned(path)));
    rows.back().maxElsewhere_percent = 4.0;
}

} // namespace

void addTieRows(std::vector<HardCase>& rows)
{
    addFloorAndWall(rows);
    addNoiseOnFins(rows);
    addEdgeLines(rows);
    addOpenGrids(rows);
    addPlanes(rows);
}

} // namespace palpate::evaluation
