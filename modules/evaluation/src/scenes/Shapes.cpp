// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/Shapes.h"

#include <cmath>
#include <numbers>

namespace palpate::evaluation::shapes {

namespace {

std::uint32_t addVertex(TriangleMesh& mesh, const Vec3& p)
{
    mesh.vertices.push_back(p);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

void addTriangle(TriangleMesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c)
{
    mesh.triangles.push_back({addVertex(mesh, a), addVertex(mesh, b), addVertex(mesh, c)});
}

/// Adds a quad with corners counter-clockwise seen from the front.
void addQuad(TriangleMesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    addTriangle(mesh, a, b, c);
    addTriangle(mesh, a, c, d);
}

std::vector<double> evenly(double low, double high, int n)
{
    std::vector<double> values;
    for (int i = 0; i <= n; ++i) {
        values.push_back(i == n ? high : low + (high - low) * i / n);
    }
    return values;
}

/// Adds the six faces of a box, subdivided at the given coordinates.
TriangleMesh cutBox(const std::vector<double>& xs, const std::vector<double>& ys, const std::vector<double>& zs)
{
    TriangleMesh mesh;
    const std::array<const std::vector<double>*, 3> cuts{&xs, &ys, &zs};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const bool isHigh : {false, true}) {
            for (std::size_t i = 0; i + 1 < cuts[u]->size(); ++i) {
                for (std::size_t j = 0; j + 1 < cuts[v]->size(); ++j) {
                    const auto at = [&](std::size_t a, std::size_t b) {
                        Vec3 p;
                        p[static_cast<Eigen::Index>(axis)] = isHigh ? cuts[axis]->back() : cuts[axis]->front();
                        p[static_cast<Eigen::Index>(u)] = (*cuts[u])[a];
                        p[static_cast<Eigen::Index>(v)] = (*cuts[v])[b];
                        return p;
                    };
                    if (isHigh) {
                        addQuad(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
                    } else {
                        addQuad(mesh, at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
                    }
                }
            }
        }
    }
    return mesh;
}

} // namespace

TriangleMesh box(const Vec3& low, const Vec3& high, int n)
{
    return cutBox(evenly(low.x(), high.x(), n), evenly(low.y(), high.y(), n), evenly(low.z(), high.z(), n));
}

TriangleMesh bumpySphere(int n, double radius_mm, double bump)
{
    // Subdivides an icosahedron rather than an octahedron, because the triangles are more uniform.
    const double g = std::numbers::phi;
    TriangleMesh mesh;
    std::vector<Vec3> corners;
    for (const double s : {-1.0, 1.0}) {
        for (const double t : {-g, g}) {
            corners.insert(corners.end(), {Vec3(0, s, t), Vec3(s, t, 0), Vec3(t, 0, s)});
        }
    }
    const auto project = [&](const Vec3& p) {
        // Faces compute shared vertices in different orders; rounding makes the results bit-identical.
        const Vec3 u = (p.normalized() * 0x1p36).array().round() * 0x1p-36;
        return Vec3(radius_mm * (1.0 + bump * std::sin(20 * u.x()) * std::sin(20 * u.y()) * std::sin(20 * u.z())) * u);
    };
    const auto areNeighbours = [](const Vec3& p, const Vec3& q) { return std::abs((p - q).norm() - 2.0) < 1e-9; };
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (std::size_t j = i + 1; j < corners.size(); ++j) {
            for (std::size_t k = j + 1; k < corners.size(); ++k) {
                Vec3 a = corners[i], b = corners[j], c = corners[k];
                if (!areNeighbours(a, b) || !areNeighbours(b, c) || !areNeighbours(c, a)) {
                    continue;
                }
                if ((b - a).cross(c - a).dot(a) < 0.0) {
                    std::swap(b, c);
                }
                const auto at = [&](int row, int column) {
                    return project(a * (n - row - column) + b * row + c * column);
                };
                for (int row = 0; row < n; ++row) {
                    for (int column = 0; row + column < n; ++column) {
                        addTriangle(mesh, at(row, column), at(row + 1, column), at(row, column + 1));
                        if (row + column + 2 <= n) {
                            addTriangle(mesh, at(row + 1, column), at(row + 1, column + 1), at(row, column + 1));
                        }
                    }
                }
            }
        }
    }
    return mesh;
}

TriangleMesh prism(const std::vector<Eigen::Vector2d>& profile, double halfLength_mm, int ny)
{
    TriangleMesh mesh;
    const std::vector<double> ys = evenly(-halfLength_mm, halfLength_mm, ny);
    const auto at = [&](std::size_t i, double y) {
        const Eigen::Vector2d& p = profile[i % profile.size()];
        return Vec3(p.x(), y, p.y());
    };
    for (std::size_t i = 0; i < profile.size(); ++i) {
        for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
            addQuad(mesh, at(i, ys[j]), at(i, ys[j + 1]), at(i + 1, ys[j + 1]), at(i + 1, ys[j]));
        }
        if (i > 0 && i + 1 < profile.size()) {
            addTriangle(mesh, at(0, ys.front()), at(i, ys.front()), at(i + 1, ys.front()));
            addTriangle(mesh, at(0, ys.back()), at(i + 1, ys.back()), at(i, ys.back()));
        }
    }
    return mesh;
}

TriangleMesh groove(double opening_rad, double height_mm, double halfLength_mm)
{
    const double h = height_mm, lip = h * std::tan(opening_rad / 2.0), side = lip + h;
    return prism({{0, -h}, {side, -h}, {side, h}, {lip, h}, {0, 0}, {-lip, h}, {-side, h}, {-side, -h}}, halfLength_mm,
                 4);
}

TriangleMesh crease(double angle_rad, double halfWidth_mm)
{
    const double w = halfWidth_mm, fall = w * std::tan(angle_rad / 2.0), bottom = -w - std::abs(fall);
    return prism({{0, bottom}, {w, bottom}, {w, -fall}, {0, 0}, {-w, -fall}, {-w, bottom}}, w, 3);
}

TriangleMesh fan(int n, double height_mm, double radius_mm)
{
    TriangleMesh mesh;
    const double bottom = -std::abs(height_mm) - radius_mm;
    const Vec3 apex(0, 0, height_mm), nadir(0, 0, bottom);
    const auto rim = [&](int i, double r, double z) {
        const double a = 2.0 * std::numbers::pi * (i % n) / n;
        return Vec3(r * std::cos(a), r * std::sin(a), z);
    };
    const double outer = 2.0 * radius_mm;
    for (int i = 0; i < n; ++i) {
        addTriangle(mesh, apex, rim(i, radius_mm, 0), rim(i + 1, radius_mm, 0));
        addQuad(mesh, rim(i, radius_mm, 0), rim(i, outer, 0), rim(i + 1, outer, 0), rim(i + 1, radius_mm, 0));
        addQuad(mesh, rim(i, outer, 0), rim(i, outer, bottom), rim(i + 1, outer, bottom), rim(i + 1, outer, 0));
        addTriangle(mesh, nadir, rim(i + 1, outer, bottom), rim(i, outer, bottom));
    }
    return mesh;
}

TriangleMesh plate(const std::vector<double>& xs, const std::vector<double>& ys, double thickness_mm)
{
    return cutBox(xs, ys, {-thickness_mm, 0.0});
}

TriangleMesh sheet(double halfSize_mm, int n)
{
    TriangleMesh mesh;
    const std::vector<double> cuts = evenly(-halfSize_mm, halfSize_mm, n);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        for (std::size_t j = 0; j + 1 < cuts.size(); ++j) {
            addQuad(mesh, Vec3(cuts[i], cuts[j], 0), Vec3(cuts[i + 1], cuts[j], 0), Vec3(cuts[i + 1], cuts[j + 1], 0),
                    Vec3(cuts[i], cuts[j + 1], 0));
        }
    }
    return mesh;
}

void append(TriangleMesh& mesh, const TriangleMesh& other)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const geometry::Triangle& t : other.triangles) {
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
}

TriangleMesh soup(const TriangleMesh& mesh)
{
    TriangleMesh result;
    for (const geometry::Triangle& t : mesh.triangles) {
        addTriangle(result, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
    }
    return result;
}

} // namespace palpate::evaluation::shapes
