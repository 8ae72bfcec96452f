// SPDX-License-Identifier: BSD-3-Clause
// Hard cases for contact geometry: edges, corners, grooves, thin walls and unequal tissues.
#include "cases/HardCaseRows.h"

#include "palpate/evaluation/Shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace palpate::evaluation {

namespace {

using geometry::TriangleMesh;

void addCreases(std::vector<HardCase>& rows)
{
    for (const double angle : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}) {
        for (const double side : {1.0, -1.0}) {
            rows.push_back(row(
                formatted("%s of planes %.0e rad apart", side > 0 ? "ridge" : "valley", angle),
                [=] { return shapes::crease(side * angle); },
                HandPath({-9, 2, 1})
                    .to({-9, 2, -5}, 0.1)
                    .to({9, -3, -5}, 0.03) // across the crease
                    .to({0, 3, -5}, 0.05)
                    .to({0, -9, -5}, 0.1) // exactly along the crease
                    .to({0.001, 9, -4}, 0.1)
                    .to({0, 9, 3}, 0.2)));
        }
    }
}

void addFans(std::vector<HardCase>& rows)
{
    for (const int n : {50, 1000}) {
        for (const double height : {8.0, -8.0}) {
            rows.push_back(row(
                formatted("fan of %d facets, %s apex", n, height > 0 ? "convex" : "concave"),
                [=] { return shapes::fan(n, height); },
                HandPath({1.3, 0.4, 10})
                    .to({0.3, 0.1, height - 3}, 0.1)
                    .to({-2, 1.1, height - 3}, 0.03)
                    .to({0, 0, height - 3}, 0.03) // exactly below the apex
                    .rest(50)
                    .to({4, -3, height - 4}, 0.05)
                    .to({-3, -4, height - 2}, 0.1)
                    .to({0, 0, height + 5}, 0.2)));
            // The exact solver tries each of a thousand facets and edges, so compare less often.
            rows.back().checkEvery = n > 100 ? 25 : 1;
            rows.back().mayReachBound = n > 100;
        }
    }
}

void addGrooves(std::vector<HardCase>& rows)
{
    for (const double degrees : {90.0, 30.0, 10.0, 1.0, 0.1}) {
        const double lip = 20.0 * std::tan(degrees * std::numbers::pi / 360.0);
        rows.push_back(row(
            formatted("V-groove of %g degrees, down one wall", degrees),
            [=] { return shapes::groove(degrees * std::numbers::pi / 180.0); },
            HandPath({0.9 * lip, -10, 21})
                .to({0.9 * lip, -10, 19.9}, 0.1)
                .to({0, -10, -5}, 0.1) // 5 mm past the bottom
                .to({0, 10, -5}, 0.1)  // along the bottom
                .to({0.7 * lip, 10.3, -4}, 0.1)
                .to({-0.6 * lip, -3, -3}, 0.1)
                .to({0, 0, 30}, 0.3)));
    }
}

void addPockets(std::vector<HardCase>& rows)
{
    rows.push_back(row(
        "corner of three planes from within",
        [] {
            TriangleMesh cavity = shapes::box({0, 0, 0}, {30, 30, 30}, 3);
            geometry::flip(cavity);
            return cavity;
        },
        HandPath({15, 15, 15})
            .to({-5, -3, -4}, 0.15)
            .to({6, -3, -4}, 0.1)
            .to({-2, 7, -4}, 0.1)
            .to({-3, -3, 8}, 0.1)
            .to({-4, -4, -4}, 0.1)
            .to({15, 15, 15}, 0.3)));
    for (const int n : {3, 4, 5, 8, 12}) {
        rows.push_back(row(
            formatted("pit of %d planes at one point", n), [n] { return shapes::fan(n, -9.0); },
            HandPath({0.7, 0.2, 2})
                .to({0.5, 0.1, -12}, 0.1)
                .to({-2.5, 1.5, -13}, 0.05)
                .to({2, -2, -12}, 0.05)
                .to({0, 0, -14}, 0.05)
                .rest(50)
                .to({1, 2, 4}, 0.1)));
    }
    rows.push_back(row(
        "saddle between two peaks",
        [] {
            // Four planes meet at one point, two concave and two convex.
            TriangleMesh mesh = shapes::plate({-10, 0, 10}, {-10, 0, 10}, 20.0);
            for (Vec3& v : mesh.vertices) {
                if (v.z() == 0.0 && v.x() * v.y() == 0.0) {
                    v.z() = 0.4 * (std::abs(v.x()) - std::abs(v.y()));
                }
            }
            return mesh;
        },
        HandPath({0.2, 0.3, 5})
            .to({0.1, 0.2, -3}, 0.1)
            .to({-1, 1, -3}, 0.02)
            .to({0, 0, -3}, 0.02)
            .to({6, 0.5, -4}, 0.05)
            .to({-5, -5, -4}, 0.05)
            .to({0, 0, 6}, 0.2)));
}

void addPlates(std::vector<HardCase>& rows)
{
    for (const double thickness : {0.5, 0.05, 1e-3, 0.0}) {
        const HandPath hit = HandPath({0.31, -1.7, 3.1})
                                 .to({0.31, -1.7, -5.1}, 2.0) // 2 m/s
                                 .rest(20)
                                 .to({4.0, 3.0, -5.0}, 0.3)
                                 .to({4.0, 3.0, 2.0}, 2.0)
                                 .to({3.9, 3.1, -8.0}, 2.0)
                                 .to({4, 3, 3}, 0.5);
        rows.push_back(row(
            formatted("plate of %g mm hit at 2 m/s", thickness),
            [thickness] {
                return thickness > 0.0 ? shapes::box({-20, -20, -thickness}, {20, 20, 0}, 7) : shapes::sheet(20.0, 7);
            },
            hit));
        if (thickness == 0.0) {
            rows.back().intrusion_mm = [](const Vec3& p) {
                return std::min(20.0 - std::max(std::abs(p.x()), std::abs(p.y())), -p.z());
            };
        }
    }
    rows.push_back(row(
        "open shell from below", [] { return shapes::sheet(20.0, 6); },
        HandPath({1, 2, -4}).to({1, 2, 3}, 0.2).to({-7, 9, 3}, 0.1).to({-7, 9, -2}, 0.2)));
    rows.back().intrusion_mm = [](const Vec3& p) { return p.z(); };
    rows.push_back(row(
        "inward-facing closed sphere",
        [] {
            TriangleMesh cavity = shapes::bumpySphere(12, 30.0, 0.03);
            geometry::flip(cavity);
            return cavity;
        },
        HandPath({0, 0, 0})
            .to({33, 4, 3}, 0.2)
            .to({25, 22, -7}, 0.1)
            .to({4, 33, -6}, 0.2)
            .to({-5, -20, 28}, 0.3)
            .to({0, 0, 0}, 0.3)));
}

void addExactWays(std::vector<HardCase>& rows)
{
    const auto cube = [] { return shapes::box({-10, -10, -10}, {10, 10, 10}, 4); };
    rows.push_back(row("exactly along mesh edges", cube,
                       HandPath({-8, 0, 13})
                           .to({-8, 0, 7}, 0.1)
                           .to({8, 0, 7}, 0.125) // along the edge line y = 0
                           .to({5, 0, 7}, 0.125)
                           .to({5, 8, 7}, 0.125) // along the edge line x = 5
                           .to({-5, -2, 7}, 0.125)
                           .to({0, 0, 7}, 0.1)
                           .to({10, 0, 7}, 0.125)
                           .to({10, 0, 14}, 0.5)));
    rows.push_back(row("exactly through vertices", cube,
                       HandPath({5, 5, 13})
                           .to({5, 5, 7}, 0.5)     // onto a vertex
                           .to({-5, -5, 7}, 0.125) // diagonally over further vertices
                           .to({0, 0, 7}, 0.125)
                           .to({14, 14, 14}, 0.5)
                           .to({8, 8, 8}, 0.125) // onto the corner of the cube
                           .rest(20)
                           .to({7, 9, 8}, 0.125)
                           .to({14, 14, 14}, 0.5)));
    rows.push_back(row("exactly in the plane of triangles", cube,
                       HandPath({-14, 1, 10})
                           .to({14, 1, 10}, 0.25) // in the plane of the top face
                           .to({14, 10, 10}, 0.25)
                           .to({-14, 10, 10}, 0.25) // along the border of the top face
                           .to({-14, 3, 10}, 0.25)
                           .to({0, 3, 9.5}, 0.1)
                           .to({0, 3, 10}, 0.1)
                           .to({5, 3, 10}, 0.1)
                           .to({5, 3, 12}, 0.1)));
    rows.push_back(row("round a convex edge and back", cube,
                       HandPath({8, 1, 12})
                           .to({8, 1, 9}, 0.1)
                           .to({9.5, 1, 5}, 0.3)
                           .to({5, 2, 9.5}, 0.3)
                           .to({9.9, 9.8, 9.7}, 0.1)
                           .to({9, 9, 9}, 0.01)
                           .to({8, 9.5, 9.6}, 0.02)
                           .to({14, 14, 14}, 0.5)));
}

/// Returns a box below the plane through the origin with normal `n`, which lies in the xz plane.
TriangleMesh slabBelow(const Vec3& n)
{
    TriangleMesh slab = shapes::box({-60, -30, -40}, {60, 30, 0});
    const Vec3 along(n.z(), 0.0, -n.x());
    for (Vec3& v : slab.vertices) {
        v = v.x() * along + v.y() * Vec3::UnitY() + v.z() * n;
    }
    return slab;
}

/// Crease between two structures of different stiffness with the given opening, and a closed path that goes in along
/// one, around the crease and out along the other. For the bounds see resources/docs/god-object.md, "Several
/// structures in one contact": with theta the angle between the normals, the slope of the force over the HIP
/// displacement is at most k_max or, for theta below 90 degrees, k1 + (k2 - k1) / sin theta. For theta below 90
/// degrees, the work over the path is (k2 - k1) / tan theta times the area enclosed behind both planes, which is less
/// than the total area enclosed; otherwise zero.
HardCase unequalCrease(double opening_deg, double stiffness_N_per_mm, bool isBack)
{
    constexpr double kOwn_N_per_mm = 0.5, kDepth_mm = 5.0, kStep_mm = 0.05;
    const double theta = (180.0 - opening_deg) * std::numbers::pi / 180.0;
    const auto direction = [](double angle) { return Vec3(std::sin(angle), 0.0, std::cos(angle)); };
    const Vec3 above(0.0, 0.7, 0.0);
    // Far enough out that a sphere of 4 mm also starts in front of both planes.
    const Vec3 start = above + 8.0 / std::sin(opening_deg * std::numbers::pi / 360.0) * Vec3::UnitZ();
    std::vector<Vec3> corners;
    for (int i = 0; i <= 8; ++i) {
        corners.push_back(above - kDepth_mm * direction((i / 8.0 - 0.5) * theta));
    }
    if (isBack) {
        std::reverse(corners.begin(), corners.end());
    }
    HandPath path(start);
    double area_mm2 = 0.0;
    Vec3 last = start;
    corners.push_back(start);
    for (const Vec3& corner : corners) {
        path.to(corner, kStep_mm);
        area_mm2 += 0.5 * (last - start).cross(corner - start).norm();
        last = corner;
    }
    HardCase crease = row(
        formatted("crease of %g degrees between 0.5 and %g N/mm%s", opening_deg, stiffness_N_per_mm,
                  isBack ? ", back" : ""),
        [=] { return slabBelow(direction(-0.5 * theta)); }, path);
    crease.beside = [=] { return slabBelow(direction(0.5 * theta)); };
    crease.neighbourStiffness_N_per_mm = stiffness_N_per_mm;
    const double most = std::max(kOwn_N_per_mm, stiffness_N_per_mm),
                 more = std::abs(stiffness_N_per_mm - kOwn_N_per_mm);
    const bool isWide = opening_deg > 90.0;
    crease.maxSlope_N_per_mm = isWide ? most - more + more / std::sin(theta) : most;
    // Where the slope of the force changes, the mean over a tick is off by up to an eighth of the slope times the
    // squared step. The path has fewer than eight such places.
    crease.maxWork_mJ = most * kStep_mm * kStep_mm + (isWide ? more / std::tan(theta) * area_mm2 : 0.0);
    return crease;
}

void addUnequalCreases(std::vector<HardCase>& rows)
{
    for (const double opening_deg : {20.0, 60.0, 90.0, 120.0, 150.0}) {
        for (const double stiffness_N_per_mm : {0.05, 5.0}) {
            rows.push_back(unequalCrease(opening_deg, stiffness_N_per_mm, false));
            rows.push_back(unequalCrease(opening_deg, stiffness_N_per_mm, true));
        }
    }
}

/// Repeats some of the cases with friction.
void addRough(std::vector<HardCase>& rows)
{
    const std::size_t count = rows.size();
    for (const double mu : {0.3, 1.0}) {
        for (const char* name : {"round a convex edge and back", "corner of three planes from within",
                                 "fan of 1000 facets, convex apex", "fan of 1000 facets, concave apex",
                                 "V-groove of 90 degrees, down one wall", "V-groove of 10 degrees, down one wall"}) {
            for (std::size_t i = 0; i < count; ++i) {
                if (rows[i].name == name) {
                    HardCase rough = rows[i];
                    rough.name += formatted(", friction %g", mu);
                    rough.friction = mu;
                    if (rough.name.find("concave apex") != std::string::npos) {
                        // A thousand facets meet here, the choice among them is not unique, and friction sums over all
                        // constraining facets: one or two of about thirty checked ticks may rest elsewhere.
                        rough.maxElsewhere_percent = 10.0;
                    }
                    rows.push_back(std::move(rough));
                }
            }
        }
    }
}

} // namespace

void addContactRows(std::vector<HardCase>& rows)
{
    addCreases(rows);
    addFans(rows);
    addGrooves(rows);
    addPockets(rows);
    addPlates(rows);
    addExactWays(rows);
    addUnequalCreases(rows);
    addRough(rows);
}

} // namespace palpate::evaluation
