// SPDX-License-Identifier: BSD-3-Clause
#include "read/MeshWire.h"

#include "guard/PreScan.h"
#include "read/Wire.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Vec3;
using geometry::Triangle;

// After the header follow, for each structure, the vertices, the triangles and the array values.
static_assert(sizeof(Vec3) == 24 && sizeof(Triangle) == 12);

WireHead headOf(const Result<MeshFile>& outcome)
{
    WireHead head;
    head.put(outcome.status());
    if (!outcome.isOk()) {
        return head;
    }
    const MeshFile& file = outcome.value();
    head.put(file.format);
    head.put(file.loss);
    head.put(static_cast<std::uint8_t>(file.frame));
    head.put(file.unit_mm);
    head.put(std::uint8_t{file.voxels.has_value()});
    const geometry::Staircase voxels = file.voxels.value_or(geometry::Staircase());
    for (int axis = 0; axis < 3; ++axis) {
        head.put(double{voxels.voxel_mm[axis]});
        for (int row = 0; row < 3; ++row) {
            head.put(double{voxels.axes(row, axis)});
        }
    }
    head.put(std::uint64_t{file.notes.size()});
    for (const core::Message& note : file.notes) {
        head.put(note);
    }
    head.put(std::uint64_t{file.structures.size()});
    for (const MeshStructure& structure : file.structures) {
        head.put(structure.name);
        head.put(std::uint8_t{structure.colour.has_value()});
        head.put(structure.colour.value_or(std::array<double, 3>{}));
        head.put(structure.opacity);
        head.put(std::uint64_t{structure.mesh.vertices.size()});
        head.put(std::uint64_t{structure.mesh.triangles.size()});
        head.put(std::uint64_t{structure.mesh.arrays.size()});
        for (const geometry::MeshArray& array : structure.mesh.arrays) {
            head.put(array.name);
            head.put(std::uint8_t{array.isPerTriangle});
        }
    }
    return head;
}

} // namespace

bool writeOutcome(int descriptor, Result<MeshFile> outcome)
{
    if (!headOf(outcome).write(descriptor)) {
        return false;
    }
    if (!outcome.isOk()) {
        return true;
    }
    for (MeshStructure& structure : outcome.value().structures) {
        const geometry::TriangleMesh mesh = std::move(structure.mesh);
        if (!writeAll(descriptor, mesh.vertices.data(), mesh.vertices.size() * sizeof(Vec3)) ||
            !writeAll(descriptor, mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle))) {
            return false;
        }
        for (const geometry::MeshArray& array : mesh.arrays) {
            if (!writeAll(descriptor, array.values.data(), array.values.size() * sizeof(float))) {
                return false;
            }
        }
    }
    return true;
}

namespace {

struct MeshCounts
{
    std::uint64_t vertices, triangles;
};

/// @return false for voxels without a size or with axes that are no unit vectors
bool takeVoxels(WireHeadReader& head, MeshFile& file)
{
    const bool hasVoxels = head.take<std::uint8_t>() != 0;
    geometry::Staircase voxels;
    voxels.isStated = true;
    for (int axis = 0; axis < 3; ++axis) {
        voxels.voxel_mm[axis] = head.take<double>();
        for (int row = 0; row < 3; ++row) {
            voxels.axes(row, axis) = head.take<double>();
        }
    }
    if (!hasVoxels) {
        return true;
    }
    file.voxels = voxels;
    constexpr double kMostOff = 0.01;
    return voxels.voxel_mm.minCoeff() > 0.0 && voxels.voxel_mm.allFinite() && voxels.axes.allFinite() &&
           ((voxels.axes.colwise().norm().array() - 1.0).abs() < kMostOff).all();
}

/// Reads the meshes of the structures, which are stored consecutively. @param at  offset of the first
/// @return the error; empty if valid
core::Message moveMeshes(int descriptor, std::uint64_t at, const std::vector<MeshCounts>& counts, MeshFile& file)
{
    for (std::size_t i = 0; i < counts.size(); ++i) {
        geometry::TriangleMesh& mesh = file.structures[i].mesh;
        if (!moveItems(descriptor, at, counts[i].vertices, mesh.vertices,
                       [](const Vec3& p) { return p.cwiseAbs().maxCoeff() <= kMostMm && p.allFinite(); })) {
            return {PALPATE_TEXT("a coordinate is not finite or is farther than 10 km from the origin")};
        }
        const std::uint64_t vertices = counts[i].vertices;
        if (!moveItems(descriptor, at, counts[i].triangles, mesh.triangles, [vertices](const Triangle& t) {
                return t[0] < vertices && t[1] < vertices && t[2] < vertices;
            })) {
            return {PALPATE_TEXT("a vertex index is out of range")};
        }
        for (geometry::MeshArray& array : mesh.arrays) {
            if (!moveItems(descriptor, at, array.isPerTriangle ? counts[i].triangles : counts[i].vertices, array.values,
                           [](float) { return true; })) {
                return {PALPATE_TEXT("an array is incomplete")};
            }
        }
    }
    return {};
}

} // namespace

Result<MeshFile> readOutcome(int descriptor, const std::filesystem::path& path)
{
    const std::string name = path.filename().string();
    const auto invalid = [&name](const core::Message& what) { return wireFault(name, what); };
    const WireOutcome outcome = readHead(descriptor, name);
    if (!outcome.status.isOk()) {
        return outcome.status;
    }
    WireHeadReader head(outcome.head);
    const std::uint64_t size = outcome.size;
    MeshFile file;
    file.path = path;
    file.format = head.text();
    file.loss = head.message();
    const auto frame = head.take<std::uint8_t>();
    if (frame > static_cast<std::uint8_t>(FileFrame::Ras)) {
        return invalid({PALPATE_TEXT("its frame is unknown")});
    }
    file.frame = static_cast<FileFrame>(frame);
    file.unit_mm = head.take<double>();
    if (!(file.unit_mm > 0.0) || !std::isfinite(file.unit_mm)) {
        return invalid({PALPATE_TEXT("its unit is not positive and finite")});
    }
    if (!takeVoxels(head, file)) {
        return invalid({PALPATE_TEXT("its voxels have no size or no axes")});
    }
    for (auto notes = head.take<std::uint64_t>(); notes > 0 && head.isGood(); --notes) {
        file.notes.push_back(head.message());
    }
    std::vector<MeshCounts> counts;
    std::uint64_t end = outcome.begin;
    for (auto structures = head.take<std::uint64_t>(); structures > 0 && head.isGood(); --structures) {
        MeshStructure& structure = file.structures.emplace_back();
        structure.name = head.text();
        const bool hasColour = head.take<std::uint8_t>() != 0;
        const auto colour = head.take<std::array<double, 3>>();
        if (hasColour) {
            if (!std::all_of(colour.begin(), colour.end(), [](double c) { return c >= 0.0 && c <= 1.0; })) {
                return invalid({PALPATE_TEXT("a colour is out of range")});
            }
            structure.colour = colour;
        }
        structure.opacity = head.take<double>();
        if (!(structure.opacity >= 0.0 && structure.opacity <= 1.0)) {
            return invalid({PALPATE_TEXT("an opacity is out of range")});
        }
        MeshCounts& c = counts.emplace_back();
        c.vertices = head.take<std::uint64_t>();
        c.triangles = head.take<std::uint64_t>();
        std::uint64_t ofVertex = sizeof(Vec3), ofTriangle = sizeof(Triangle); // bytes of one
        for (auto arrays = head.take<std::uint64_t>(); arrays > 0 && head.isGood(); --arrays) {
            geometry::MeshArray& array = structure.mesh.arrays.emplace_back();
            array.name = head.text();
            array.isPerTriangle = head.take<std::uint8_t>() != 0;
            (array.isPerTriangle ? ofTriangle : ofVertex) += sizeof(float);
        }
        if (structure.mesh.arrays.size() > 2 * kMostArrays || c.vertices > size || c.triangles > size ||
            c.triangles == 0 || c.vertices * ofVertex + c.triangles * ofTriangle > size - end) {
            return invalid({PALPATE_TEXT("a count is out of range")});
        }
        end += c.vertices * ofVertex + c.triangles * ofTriangle;
    }
    if (!head.isAtEnd() || file.structures.empty() || end != size) {
        return invalid({PALPATE_TEXT("its counts do not match its size")});
    }
    if (const core::Message wrong = moveMeshes(descriptor, outcome.begin, counts, file); !wrong.isEmpty()) {
        return invalid(wrong);
    }
    return file;
}

} // namespace palpate::meshio::internal
