// SPDX-License-Identifier: BSD-3-Clause
#include "RandomMesh.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <numbers>
#include <utility>

namespace palpate::adversary {

namespace {

using Point2 = std::array<double, 2>;

/// Returns all triangles of a mesh as one body.
RandomMesh asBody(TriangleMesh mesh)
{
    RandomMesh result;
    result.bodies.emplace_back();
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        result.bodies.back().push_back(i);
    }
    result.mesh = std::move(mesh);
    return result;
}

void append(RandomMesh& mesh, const RandomMesh& other)
{
    const auto vertex = static_cast<std::uint32_t>(mesh.mesh.vertices.size());
    const auto triangle = static_cast<std::uint32_t>(mesh.mesh.triangles.size());
    mesh.mesh.vertices.insert(mesh.mesh.vertices.end(), other.mesh.vertices.begin(), other.mesh.vertices.end());
    for (const Triangle& t : other.mesh.triangles) {
        mesh.mesh.triangles.push_back({t[0] + vertex, t[1] + vertex, t[2] + vertex});
    }
    for (std::vector<std::uint32_t> body : other.bodies) {
        for (std::uint32_t& i : body) {
            i += triangle;
        }
        mesh.bodies.push_back(std::move(body));
    }
}

/// Returns the surface of the cube from -1 to 1, each face split n × n; faces share their vertices. The number of
/// squares may differ by axis of the face normal: then the faces meet in T-junctions.
TriangleMesh cube(const std::array<int, 3>& n, Chance& chance)
{
    TriangleMesh mesh;
    std::map<std::array<double, 3>, std::uint32_t> numbers;
    const auto vertex = [&](const Vec3& p) {
        const auto [at, isNew] =
            numbers.try_emplace({p.x(), p.y(), p.z()}, static_cast<std::uint32_t>(mesh.vertices.size()));
        if (isNew) {
            mesh.vertices.push_back(p);
        }
        return at->second;
    };
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3, cuts = n[static_cast<std::size_t>(axis)];
        for (const double side : {-1.0, 1.0}) {
            const auto at = [&](int i, int j) {
                Vec3 p;
                p[axis] = side;
                p[u] = -1.0 + 2.0 * i / cuts;
                p[v] = -1.0 + 2.0 * j / cuts;
                return vertex(p);
            };
            for (int i = 0; i < cuts; ++i) {
                for (int j = 0; j < cuts; ++j) {
                    std::array<std::uint32_t, 4> q{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
                    if (side < 0.0) {
                        std::swap(q[1], q[3]);
                    }
                    const std::size_t first = chance.below(2);
                    mesh.triangles.push_back({q[first], q[first + 1], q[first + 2]});
                    mesh.triangles.push_back({q[first], q[first + 2], q[(first + 3) % 4]});
                }
            }
        }
    }
    return mesh;
}

TriangleMesh sphere(int n, Chance& chance, const std::function<double()>& radius)
{
    TriangleMesh mesh = cube({n, n, n}, chance);
    for (Vec3& v : mesh.vertices) {
        v = v.normalized() * radius();
    }
    return mesh;
}

TriangleMesh bumpySphere(Chance& chance)
{
    const double bump = chance.between(0.0, 0.25);
    return sphere(chance.whole(2, 5), chance, [&] { return 1.0 + bump * chance.between(-1, 1); });
}

TriangleMesh cuboid(const Vec3& low, const Vec3& high, int n, Chance& chance)
{
    TriangleMesh mesh = cube({n, n, n}, chance);
    for (Vec3& v : mesh.vertices) {
        for (int k = 0; k < 3; ++k) { // exact corners, so that walls can touch
            v[k] = v[k] == -1.0 ? low[k] : v[k] == 1.0 ? high[k] : low[k] + 0.5 * (v[k] + 1.0) * (high[k] - low[k]);
        }
    }
    return mesh;
}

/// Returns an upright prism on a counter-clockwise polygon that is star-shaped about `centre`.
TriangleMesh prism(const std::vector<Point2>& polygon, const Point2& centre, double bottom, double top, int floors)
{
    TriangleMesh mesh;
    const auto n = static_cast<std::uint32_t>(polygon.size());
    for (int floor = 0; floor <= floors; ++floor) {
        for (const Point2& p : polygon) {
            mesh.vertices.emplace_back(p[0], p[1], floor == floors ? top : bottom + (top - bottom) * floor / floors);
        }
    }
    const auto last = static_cast<std::uint32_t>(floors) * n, low = last + n, high = low + 1;
    mesh.vertices.emplace_back(centre[0], centre[1], bottom);
    mesh.vertices.emplace_back(centre[0], centre[1], top);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t next = (i + 1) % n;
        mesh.triangles.push_back({low, next, i});
        mesh.triangles.push_back({high, last + i, last + next});
        for (std::uint32_t f = 0; f < last; f += n) {
            mesh.triangles.push_back({f + i, f + next, f + n + next});
            mesh.triangles.push_back({f + i, f + n + next, f + n + i});
        }
    }
    return mesh;
}

/// Returns a disc with a wedge cut out: a crease that may be as narrow as a slit.
TriangleMesh notch(Chance& chance)
{
    const double half = chance.magnitude(1e-4, 0.4);
    std::vector<Point2> polygon;
    for (int i = 0; i <= 12; ++i) {
        const double a = half + (2.0 * std::numbers::pi - 2.0 * half) * i / 12.0;
        polygon.push_back({std::cos(a), std::sin(a)});
    }
    polygon.push_back({chance.between(0.0, 0.6), 0.0});
    return prism(polygon, {-0.3, 0.0}, 0.0, chance.between(0.2, 1.5), chance.whole(1, 3));
}

/// Returns a wheel with uneven sides, some of them extremely narrow.
TriangleMesh slivers(Chance& chance)
{
    std::vector<double> angles;
    const int n = chance.whole(6, 20);
    for (int i = 0; i < n; ++i) {
        angles.push_back(2.0 * std::numbers::pi * (i + chance.between(0.0, 0.5)) / n);
        if (chance.is(0.4)) {
            angles.push_back(angles.back() + chance.magnitude(1e-6, 1e-2));
        }
    }
    std::vector<Point2> polygon;
    double radius = 1.0;
    for (const double a : angles) {
        radius = chance.is(0.5) ? chance.between(0.4, 1.0) : radius;
        polygon.push_back({radius * std::cos(a), radius * std::sin(a)});
    }
    return prism(polygon, {0.0, 0.0}, 0.0, chance.between(0.1, 1.5), chance.whole(1, 2));
}

/// Returns a block with a wavy fan around the origin as its top.
TriangleMesh saddle(Chance& chance)
{
    const int n = chance.whole(4, 40), waves = chance.whole(1, 5);
    const double height = chance.between(0.05, 1.2), phase = chance.between(0.0, 6.0);
    std::vector<Point2> polygon;
    for (int i = 0; i < n; ++i) {
        const double a = 2.0 * std::numbers::pi * (i + chance.between(0.0, 0.7)) / n;
        polygon.push_back({std::cos(a), std::sin(a)});
    }
    TriangleMesh mesh = prism(polygon, {0.0, 0.0}, -2.0, 0.0, 1);
    for (int i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        mesh.vertices[static_cast<std::size_t>(n) + k].z() =
            height * std::sin(waves * std::atan2(polygon[k][1], polygon[k][0]) + phase);
    }
    return mesh;
}

RandomMesh overlapping(Chance& chance)
{
    RandomMesh result = asBody(bumpySphere(chance));
    TriangleMesh other =
        chance.is(0.5) ? bumpySphere(chance) : cuboid(Vec3::Constant(-0.7), Vec3::Constant(0.7), 2, chance);
    const Vec3 shift = chance.between(0.2, 1.4) * chance.direction();
    for (Vec3& v : other.vertices) {
        v += shift;
    }
    append(result, asBody(std::move(other)));
    return result;
}

RandomMesh shells(Chance& chance)
{
    RandomMesh result = asBody(sphere(4, chance, [&] { return chance.between(0.95, 1.05); }));
    const double share = chance.between(0.5, 0.85);
    TriangleMesh cavity = sphere(3, chance, [&] { return share * chance.between(0.95, 1.05); });
    geometry::flip(cavity);
    append(result, asBody(std::move(cavity)));
    result.isSolid = false;
    return result;
}

RandomMesh tangle(Chance& chance)
{
    TriangleMesh mesh = sphere(chance.whole(2, 3), chance, [] { return 1.0; });
    const double amount = chance.between(0.2, 0.6);
    for (Vec3& v : mesh.vertices) {
        v += amount * chance.noise();
    }
    RandomMesh result = asBody(std::move(mesh));
    result.isSolid = false;
    return result;
}

RandomMesh duplicates(Chance& chance)
{
    RandomMesh result = asBody(bumpySphere(chance));
    const std::size_t count = result.mesh.triangles.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Triangle t = result.mesh.triangles[i];
        if (chance.is(0.3)) {
            result.mesh.triangles.push_back(chance.is(0.5) ? Triangle{t[1], t[2], t[0]} : Triangle{t[1], t[0], t[2]});
        }
    }
    return result;
}

RandomMesh touchingBoxes(Chance& chance)
{
    const int n = chance.whole(1, 3);
    RandomMesh result = asBody(cuboid({-1, -1, -1}, {0, 1, 1}, n, chance));
    const double shift = chance.is(0.3) ? 0.25 : 0.0, top = chance.is(0.5) ? 1.0 : 0.5;
    append(result, asBody(cuboid({0, -1 + shift, -1}, {1, 1 + shift, top}, n, chance)));
    return result;
}

RandomMesh fins(Chance& chance)
{
    RandomMesh result = asBody(bumpySphere(chance));
    TriangleMesh& mesh = result.mesh;
    const std::size_t count = mesh.triangles.size();
    for (int i = chance.whole(1, 4); i > 0; --i) {
        const Triangle t = mesh.triangles[chance.below(count)];
        mesh.vertices.push_back(0.8 * (mesh.vertices[t[0]] + mesh.vertices[t[1]]));
        mesh.triangles.push_back({t[0], t[1], static_cast<std::uint32_t>(mesh.vertices.size() - 1)});
    }
    return result;
}

RandomMesh sheet(Chance& chance)
{
    RandomMesh result;
    TriangleMesh& mesh = result.mesh;
    const int n = chance.whole(3, 10);
    const double waves = chance.is(0.3) ? 0.0 : chance.between(0.0, 0.3);
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            mesh.vertices.emplace_back(-1.0 + 2.0 * i / n, -1.0 + 2.0 * j / n, waves * chance.between(-1, 1));
        }
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const auto a = static_cast<std::uint32_t>(j * (n + 1) + i), b = a + 1;
            const auto d = a + static_cast<std::uint32_t>(n) + 1, c = d + 1;
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    }
    return result;
}

RandomMesh holedSphere(Chance& chance)
{
    RandomMesh result;
    result.mesh = bumpySphere(chance);
    result.mesh.triangles.resize(result.mesh.triangles.size() - static_cast<std::size_t>(chance.whole(1, 6)));
    return result;
}

RandomMesh soup(Chance& chance)
{
    RandomMesh result;
    const int count = chance.whole(20, 70);
    for (int i = 0; i < count; ++i) {
        const Vec3 middle = chance.inCube();
        const auto first = static_cast<std::uint32_t>(result.mesh.vertices.size());
        for (int k = 0; k < 3; ++k) {
            result.mesh.vertices.push_back(middle + chance.between(0.05, 0.7) * chance.direction());
        }
        result.mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return result;
}

RandomMesh unnamedMesh(MeshKind kind, Chance& chance)
{
    switch (kind) {
    case MeshKind::Box:
        return asBody(cuboid(Vec3::Constant(-1), Vec3::Constant(1), chance.whole(1, 5), chance));
    case MeshKind::BumpySphere:
        return asBody(bumpySphere(chance));
    case MeshKind::SpikySphere:
        return asBody(sphere(chance.whole(2, 4), chance,
                             [&] { return chance.is(0.15) ? chance.between(1.3, 3.0) : chance.between(0.8, 1.2); }));
    case MeshKind::ThinPlate:
        return asBody(cuboid({-1, -1, 0}, {1, 1, chance.magnitude(1e-6, 0.1)}, chance.whole(1, 4), chance));
    case MeshKind::LShape:
        return asBody(prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, {0.5, 0.5}, 0.0, chance.between(0.1, 2.0),
                            chance.whole(1, 3)));
    case MeshKind::Notch:
        return asBody(notch(chance));
    case MeshKind::Slivers:
        return asBody(slivers(chance));
    case MeshKind::Saddle:
        return asBody(saddle(chance));
    case MeshKind::Overlapping:
        return overlapping(chance);
    case MeshKind::Shells:
        return shells(chance);
    case MeshKind::Tangle:
        return tangle(chance);
    case MeshKind::Duplicates:
        return duplicates(chance);
    case MeshKind::TouchingBoxes:
        return touchingBoxes(chance);
    case MeshKind::Fins:
        return fins(chance);
    case MeshKind::Sheet:
        return sheet(chance);
    case MeshKind::HoledSphere:
        return holedSphere(chance);
    case MeshKind::TJunctions:
        return asBody(cube({chance.whole(1, 4), chance.whole(1, 4), chance.whole(1, 4)}, chance));
    case MeshKind::Soup:
        break;
    }
    return soup(chance);
}

} // namespace

RandomMesh randomMesh(MeshKind kind, Chance& chance)
{
    static constexpr std::array<const char*, kMeshKinds> kNames{
        "box",    "bumpy sphere", "spiky sphere", "thin plate", "L",          "notch",          "slivers",
        "saddle", "overlapping",  "shells",       "tangle",     "duplicates", "touching boxes", "fins",
        "sheet",  "holed sphere", "T-junctions",  "soup"};
    RandomMesh result = unnamedMesh(kind, chance);
    result.name = kNames[static_cast<std::size_t>(kind)];
    return result;
}

} // namespace palpate::adversary
