// SPDX-License-Identifier: BSD-3-Clause
// Hard cases with defective meshes.
#include "cases/HardCaseRows.h"

#include "palpate/evaluation/Shapes.h"

#include <cmath>

namespace palpate::evaluation {

namespace {

using geometry::TriangleMesh;

std::function<std::function<Vec3()>()> wandering(double radius_mm, double deepest_mm, double slowest, double fastest,
                                                 std::uint64_t seed)
{
    return [=] {
        return [hand = std::make_shared<RandomHandPath>(radius_mm, deepest_mm, slowest, fastest, seed)] {
            return hand->next();
        };
    };
}

HardCase wanderingRow(std::string name, std::function<TriangleMesh()> mesh, std::int64_t ticks)
{
    HardCase result;
    result.name = std::move(name);
    result.mesh = std::move(mesh);
    result.motion = wandering(40.0, 4.0, 0.1, 0.3, 11);
    result.ticks = ticks;
    return result;
}

TriangleMesh bumpySoup()
{
    return shapes::soup(shapes::bumpySphere(14, 40.0, 0.03));
}

/// Presses at several places of a plate at z = 0 with a half size of 10, then drags across the plate and lifts off.
HandPath acrossPlate(double depth_mm)
{
    return HandPath({-8, -7.3, 2})
        .to({-8, -7.3, -depth_mm}, 0.05)
        .to({8.1, 6.9, -depth_mm}, 0.1)
        .to({-0.37, -0.21, -depth_mm}, 0.1)
        .to({0.31, 8.3, -depth_mm}, 0.02)
        .to({0.3, 8.3, 3}, 0.2);
}

/// Returns the depth below the plane z = 0 inside the square.
std::function<double(const Vec3&)> belowSquare(double halfSize_mm, double floor_mm)
{
    return [=](const Vec3& p) {
        const double inside = halfSize_mm - std::max(std::abs(p.x()), std::abs(p.y()));
        return std::min({inside, -p.z(), p.z() - floor_mm});
    };
}

/// Plate whose halves share an edge that only the right half subdivides.
TriangleMesh tJunctions()
{
    TriangleMesh mesh = shapes::plate({-10, 0}, {-10, 10}, 6.0);
    shapes::append(mesh, shapes::plate({0, 10}, {-10, -3, 1.7, 10}, 6.0));
    // Remove the walls between the halves to leave one plate with a seam.
    std::erase_if(mesh.triangles, [&mesh](const geometry::Triangle& t) {
        return mesh.vertices[t[0]].x() == 0 && mesh.vertices[t[1]].x() == 0 && mesh.vertices[t[2]].x() == 0;
    });
    return mesh;
}

} // namespace

void addMeshFaultRows(std::vector<HardCase>& rows)
{
    rows.push_back(wanderingRow(
        "zero-area triangles on a bumpy sphere",
        [] {
            TriangleMesh mesh = bumpySoup();
            const std::size_t n = mesh.triangles.size();
            for (std::size_t i = 0; i < n; i += 3) {
                const geometry::Triangle t = mesh.triangles[i];
                mesh.triangles.push_back({t[0], t[1], t[1]});
                mesh.vertices.push_back(0.5 * (mesh.vertices[t[0]] + mesh.vertices[t[1]]));
                mesh.triangles.push_back({t[0], t[1], static_cast<std::uint32_t>(mesh.vertices.size() - 1)});
            }
            return mesh;
        },
        4000));
    rows.push_back(wanderingRow(
        "duplicated triangles, some turned round",
        [] {
            TriangleMesh mesh = bumpySoup();
            const std::size_t n = mesh.triangles.size();
            for (std::size_t i = 0; i < n; ++i) {
                const geometry::Triangle t = mesh.triangles[i];
                if (i % 3 == 0) {
                    mesh.triangles.push_back({t[1], t[2], t[0]});
                } else if (i % 3 == 1) {
                    mesh.triangles.push_back({t[1], t[0], t[2]});
                }
            }
            return mesh;
        },
        4000));
    rows.push_back(wanderingRow(
        "flipped triangles",
        [] {
            TriangleMesh mesh = bumpySoup();
            for (std::size_t i = 0; i < mesh.triangles.size(); i += 7) {
                std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
            }
            return mesh;
        },
        4000));
    rows.push_back(wanderingRow("unwelded soup", bumpySoup, 4000));
    for (const double aspect : {1e3, 1e4, 1e5, 1e6}) {
        rows.push_back(row(
            formatted("sliver strips, aspect %.0e", aspect),
            [aspect] {
                const double w = 20.0 / aspect;
                return shapes::plate({-10, -w, 0, w, 2 * w, 3, 3 + w, 10}, {-10, 10}, 6.0);
            },
            acrossPlate(3.0)));
        rows.push_back(row(
            formatted("needles off a diagonal, aspect %.0e", aspect),
            [aspect] {
                TriangleMesh mesh = shapes::plate({-10, 10}, {-10, 10}, 6.0);
                // Replaces the top's diagonal by two needles around a vertex close to the diagonal.
                std::erase_if(mesh.triangles, [&mesh](const geometry::Triangle& t) {
                    return mesh.vertices[t[0]].z() == 0 && mesh.vertices[t[1]].z() == 0 && mesh.vertices[t[2]].z() == 0;
                });
                const double off = 28.0 / aspect;
                const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
                for (const Vec3& v :
                     {Vec3(-10, -10, 0), Vec3(10, -10, 0), Vec3(10, 10, 0), Vec3(-10, 10, 0), Vec3(off, -off, 0)}) {
                    mesh.vertices.push_back(v);
                }
                for (const auto& t : {geometry::Triangle{0, 1, 4}, geometry::Triangle{1, 2, 4},
                                      geometry::Triangle{0, 4, 2}, geometry::Triangle{0, 2, 3}}) {
                    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
                }
                return mesh;
            },
            acrossPlate(3.0)));
    }
    rows.push_back(row(
        "collinear corners on an edge",
        [] {
            // T-junction filled with triangles of exactly zero area.
            TriangleMesh mesh = tJunctions();
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            for (const double y : {-10.0, -3.0, 1.7, 10.0}) {
                mesh.vertices.emplace_back(0, y, 0);
            }
            mesh.triangles.push_back({first, first + 1, first + 3});
            mesh.triangles.push_back({first + 1, first + 2, first + 3});
            return mesh;
        },
        acrossPlate(3.0)));
    rows.back().intrusion_mm = belowSquare(10.0, -6.0);
    rows.push_back(row("T-junctions", tJunctions, acrossPlate(3.0)));
    rows.back().intrusion_mm = belowSquare(10.0, -6.0);
    rows.push_back(row(
        "crack of 1e-6 mm between closed halves",
        [] {
            TriangleMesh mesh = shapes::plate({-10, -1e-6}, {-10, 1, 10}, 6.0);
            shapes::append(mesh, shapes::plate({0, 10}, {-10, -2, 10}, 6.0));
            return mesh;
        },
        acrossPlate(3.0)));
    rows.push_back(row(
        "crack of 1e-6 mm in an open shell",
        [] {
            TriangleMesh mesh = shapes::plate({-10, -1e-6}, {-10, 1, 10}, 6.0);
            shapes::append(mesh, shapes::plate({0, 10}, {-10, -2, 10}, 6.0));
            std::erase_if(mesh.triangles, [&mesh](const geometry::Triangle& t) {
                const Vec3 m = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
                return std::abs(m.x()) < 1e-5;
            });
            return mesh;
        },
        acrossPlate(3.0)));
    rows.back().intrusion_mm = belowSquare(10.0, -6.0);
    rows.push_back(row(
        "non-manifold fin on a box",
        [] {
            TriangleMesh mesh = shapes::plate({-10, 0, 10}, {-10, 10}, 6.0);
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            for (const Vec3& v : {Vec3(0, -10, 0), Vec3(0, 10, 0), Vec3(0, 10, 5), Vec3(0, -10, 5)}) {
                mesh.vertices.push_back(v);
            }
            mesh.triangles.push_back({first, first + 1, first + 2});
            mesh.triangles.push_back({first, first + 2, first + 3});
            return mesh;
        },
        HandPath({-5, 0.3, 3})
            .to({-5, 0.3, -2}, 0.05)
            .to({4, 0.7, -2}, 0.05) // into the corner between fin and box
            .to({4, 3, 3}, 0.05)    // up along the fin
            .to({4, 3, 7}, 0.1)     // over the fin
            .to({-4, -3, -1}, 0.05) // against the other side of the fin
            .to({-4, -3, 4}, 0.1)));
    rows.back().intrusion_mm = belowSquare(10.0, -6.0);
    rows.push_back(row(
        "self-crossing shells",
        [] {
            TriangleMesh mesh = shapes::box({-10, -10, -10}, {10, 10, 10}, 3);
            shapes::append(mesh, shapes::box({-4, -4, 3}, {16, 5, 17}, 2));
            return mesh;
        },
        HandPath({-6, 1, 14})
            .to({-6, 1, 7}, 0.1)
            .to({2, 1, 7}, 0.05) // into the corner where the boxes intersect
            .to({2, -7, 6}, 0.05)
            .to({12, -3, 6}, 0.05)
            .to({12, 0, 4}, 0.05)
            .to({12, 0, -9}, 0.1)
            .to({20, 0, 0}, 0.1)));
}

} // namespace palpate::evaluation
