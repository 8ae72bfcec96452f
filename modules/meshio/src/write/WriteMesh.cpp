// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/MeshFile.h"

#include "palpate/meshio/VtpFile.h"
#include "text/Fault.h"
#include "text/TextScan.h"

#include <palpate/core/AtomicFile.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

namespace palpate::meshio {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;
using geometry::Triangle;
using namespace internal;

std::uint64_t triangleCount(std::span<const MeshStructure> structures)
{
    std::uint64_t count = 0;
    for (const MeshStructure& structure : structures) {
        count += structure.mesh.triangles.size();
    }
    return count;
}

/// Merges all structures; the cell array `StructureId` contains the index of the structure.
VtpFile merged(std::span<const MeshStructure> structures)
{
    VtpFile out;
    std::vector<std::int32_t> ids;
    bool hasColours = false;
    for (const MeshStructure& structure : structures) {
        const auto first = static_cast<std::uint32_t>(out.points.size());
        out.points.insert(out.points.end(), structure.mesh.vertices.begin(), structure.mesh.vertices.end());
        for (const Triangle& t : structure.mesh.triangles) {
            out.triangles.push_back({first + t[0], first + t[1], first + t[2]});
            ids.push_back(static_cast<std::int32_t>(out.structureNames.size()));
        }
        out.structureNames.push_back(structure.name);
        const auto colour = structure.colour.value_or(std::array<double, 3>{-1.0, 0.0, 0.0}); // negative red: no colour
        out.structureColours.emplace_back(colour[0], colour[1], colour[2]);
        hasColours = hasColours || structure.colour.has_value();
    }
    out.cellArrays = {{"StructureId", std::move(ids)}};
    if (!hasColours) {
        out.structureColours.clear();
    }
    return out;
}

std::string stlBytes(std::span<const MeshStructure> structures)
{
    constexpr std::size_t kHeader = 80;
    std::string bytes = "Palpate. SPACE=LPS, mm";
    bytes.resize(kHeader, ' ');
    const auto append = [&bytes](const auto& value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    append(static_cast<std::uint32_t>(triangleCount(structures)));
    for (const MeshStructure& structure : structures) {
        for (const Triangle& t : structure.mesh.triangles) {
            const std::vector<Vec3>& p = structure.mesh.vertices;
            const Vec3 normal = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).normalized();
            for (const Vec3& row : {normal, p[t[0]], p[t[1]], p[t[2]]}) {
                append(std::array<float, 3>{static_cast<float>(row.x()), static_cast<float>(row.y()),
                                            static_cast<float>(row.z())});
            }
            append(std::uint16_t{0});
        }
    }
    return bytes;
}

} // namespace

core::Status writeMesh(const std::filesystem::path& path, std::span<const MeshStructure> structures)
{
    const std::string file = path.filename().string();
    const std::uint64_t triangles = triangleCount(structures);
    if (triangles == 0 || triangles > std::numeric_limits<std::uint32_t>::max()) {
        return fault(StatusCode::Empty, file, {}, {PALPATE_TEXT("number of triangles to write: %1"), Count(triangles)},
                     {PALPATE_TEXT("%1 to %2"), 1, Count(std::numeric_limits<std::uint32_t>::max())});
    }
    for (const MeshStructure& structure : structures) {
        for (const Triangle& t : structure.mesh.triangles) {
            if (std::max({t[0], t[1], t[2]}) >= structure.mesh.vertices.size()) {
                return fault(StatusCode::OutOfRange, file, {PALPATE_TEXT("structure %1"), inQuotes(structure.name)},
                             {PALPATE_TEXT("a triangle with a missing vertex")},
                             {PALPATE_TEXT("indices below %1"), Count(structure.mesh.vertices.size())});
            }
        }
    }
    const std::string extension = path.extension().string();
    if (sameWord(extension, ".vtp")) {
        const Result<std::string> bytes = vtpBytes(merged(structures));
        return bytes.isOk() ? core::writeAtomically(path, bytes.value(), core::AtomicFile::Onto::File)
                            : bytes.status().at(file);
    }
    if (sameWord(extension, ".stl")) {
        return core::writeAtomically(path, stlBytes(structures), core::AtomicFile::Onto::File);
    }
    return fault(StatusCode::BadCommandLine, file, {}, {PALPATE_TEXT("the extension %1"), inQuotes(extension)},
                 {PALPATE_TEXT("%1 or %2"), "\".vtp\"", "\".stl\""});
}

} // namespace palpate::meshio
