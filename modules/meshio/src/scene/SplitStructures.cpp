// SPDX-License-Identifier: BSD-3-Clause
#include "read/TriangleSoup.h"

#include "text/Encoding.h"
#include "text/Fault.h"
#include "text/FileStem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;
using geometry::Triangle;

/// Converts the points of the file to LPS and mm. The first invalid point that a triangle uses is an error; others are
/// left out and noted.
Result<std::vector<Vec3>> toWorld(const TriangleSoup& soup, FileFrame frame, const ScanContext& context, PreScan& scan)
{
    const std::vector<Vec3>& points = soup.mesh.vertices;
    std::vector<Vec3> out(points.size());
    std::vector<bool> isBad; // empty if all are valid
    for (std::size_t i = 0; i < points.size(); ++i) {
        out[i] = core::toLps(frame, points[i]) * context.unit_mm;
        if (!(out[i].cwiseAbs().maxCoeff() <= kMostMm) || !out[i].allFinite()) {
            isBad.resize(points.size(), false);
            isBad[i] = true;
        }
    }
    if (isBad.empty()) {
        return out;
    }
    for (const Triangle& triangle : soup.mesh.triangles) {
        for (const std::uint32_t i : triangle) {
            if (isBad[i]) {
                return fault(StatusCode::NonFinite, context.file, {PALPATE_TEXT("point %1"), i},
                             out[i].allFinite()
                                 ? core::Message(PALPATE_TEXT("it is farther than 10 km from the origin"))
                                 : core::Message(PALPATE_TEXT("its coordinates are not finite numbers")),
                             {PALPATE_TEXT("finite coordinates within 10 km")});
            }
        }
    }
    noteBadVertices(static_cast<std::uint64_t>(std::ranges::count(isBad, true)), scan);
    return out;
}

/// Makes the names different: of two solids "ascii", the second becomes "ascii 2". A scene refers to them by name.
void distinguish(std::vector<MeshStructure>& structures)
{
    std::set<std::string> used;
    for (const MeshStructure& structure : structures) {
        used.insert(structure.name);
    }
    std::set<std::string> seen;
    for (MeshStructure& structure : structures) {
        const std::string name = structure.name;
        for (int number = 2; !seen.insert(structure.name).second; ++number) {
            std::string next = name + " " + std::to_string(number);
            if (used.insert(next).second) {
                structure.name = std::move(next);
            }
        }
    }
}

bool hasArea(const std::vector<Vec3>& p, const std::vector<Triangle>& triangles)
{
    return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
        const Vec3 a = p[t[1]] - p[t[0]];
        const Vec3 b = p[t[2]] - p[t[0]];
        // Relative to the edge lengths: the cross product of parallel edges has a rounding residue.
        return a.cross(b).norm() > 1e-14 * a.norm() * b.norm();
    });
}

/// Adds the values of one vertex, or of one triangle, to a structure's arrays.
void takeValues(const std::vector<geometry::MeshArray>& from, bool isPerTriangle, std::uint32_t i,
                std::vector<geometry::MeshArray>& to)
{
    for (std::size_t k = 0; k < from.size(); ++k) {
        if (from[k].isPerTriangle == isPerTriangle) {
            to[k].values.push_back(from[k].values[i]);
        }
    }
}

} // namespace

Result<std::vector<MeshStructure>> separate(const TriangleSoup& soup, PreScan& scan, const ScanContext& context)
{
    const Result<std::vector<Vec3>> world =
        toWorld(soup, core::resolvedFrame(context.frame, scan.frame), context, scan);
    if (!world.isOk()) {
        return world.status();
    }
    const std::vector<Vec3>& points = world.value();
    const std::vector<Triangle>& triangles = soup.mesh.triangles;
    if (!hasArea(points, triangles)) {
        return fault(StatusCode::Empty, context.file, {},
                     {PALPATE_TEXT("all triangles have zero area (number of triangles: %1)"), Count(triangles.size())},
                     {PALPATE_TEXT("at least one with an area")});
    }

    // Triangles sorted by part; within a part in file order.
    const std::size_t parts = soup.partNames.size();
    std::vector<std::size_t> begin(parts + 1, 0);
    std::vector<std::uint32_t> order(triangles.size());
    if (soup.part.empty()) {
        begin[parts] = triangles.size();
        std::fill(begin.begin() + 1, begin.end(), triangles.size());
        std::iota(order.begin(), order.end(), 0U);
    } else {
        for (const std::uint32_t part : soup.part) {
            ++begin[part + 1];
        }
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            order[next[soup.part[i]]++] = static_cast<std::uint32_t>(i);
        }
    }

    constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> user(points.size(), kNobody); // the last part that used a vertex
    std::vector<std::uint32_t> place(points.size());         // index of the vertex in that part
    std::vector<MeshStructure> structures;
    for (std::uint32_t part = 0; part < parts; ++part) {
        if (begin[part] == begin[part + 1]) {
            continue;
        }
        MeshStructure& structure = structures.emplace_back();
        structure.name = utf8Of(soup.partNames[part]);
        if (part < soup.partColours.size()) {
            structure.colour = soup.partColours[part];
        }
        if (part < soup.partOpacities.size()) {
            structure.opacity = soup.partOpacities[part];
        }
        geometry::TriangleMesh& mesh = structure.mesh;
        mesh.triangles.reserve(begin[part + 1] - begin[part]);
        for (const geometry::MeshArray& array : soup.mesh.arrays) {
            mesh.arrays.push_back({utf8Of(array.name), array.isPerTriangle, {}});
        }
        for (std::size_t i = begin[part]; i < begin[part + 1]; ++i) {
            Triangle triangle = triangles[order[i]];
            for (std::uint32_t& corner : triangle) {
                if (user[corner] != part) {
                    user[corner] = part;
                    place[corner] = static_cast<std::uint32_t>(mesh.vertices.size());
                    mesh.vertices.push_back(points[corner]);
                    takeValues(soup.mesh.arrays, false, corner, mesh.arrays);
                }
                corner = place[corner];
            }
            mesh.triangles.push_back(triangle);
            takeValues(soup.mesh.arrays, true, order[i], mesh.arrays);
        }
    }
    return structures;
}

Result<std::vector<MeshStructure>> splitStructures(const TriangleSoup& soup, PreScan& scan, const ScanContext& context,
                                                   const std::string& fallbackName)
{
    Result<std::vector<MeshStructure>> structures = separate(soup, scan, context);
    if (!structures.isOk()) {
        return structures;
    }
    std::vector<MeshStructure>& all = structures.value();
    if (all.size() == 1 && isPlaceholder(all.front().name)) {
        all.front().name = fallbackName;
    }
    for (MeshStructure& structure : all) {
        if (structure.name.empty()) {
            structure.name = fallbackName;
        }
    }
    distinguish(all);
    return structures;
}

} // namespace palpate::meshio::internal
