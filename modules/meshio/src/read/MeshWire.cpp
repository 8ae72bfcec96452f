// SPDX-License-Identifier: BSD-3-Clause
#include "read/MeshWire.h"

#include "guard/PreScan.h"
#include "read/Wire.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Vec3;
using geometry::Triangle;

// After the head of a structure follow the vertices, the triangles and the array values.
static_assert(sizeof(Vec3) == 24 && sizeof(Triangle) == 12);

/// First number of a head.
enum class FrameKind : std::uint8_t
{
    Common,
    Structure,
    End
};

bool writeCommon(int descriptor, const MeshFile& file)
{
    WireHead head;
    head.put(FrameKind::Common);
    head.put(file.format);
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
    return head.write(descriptor);
}

bool writeMeshOf(int descriptor, MeshStructure& structure)
{
    const geometry::TriangleMesh mesh = std::move(structure.mesh);
    WireHead head;
    head.put(FrameKind::Structure);
    head.put(structure.name);
    head.put(std::uint8_t{structure.colour.has_value()});
    head.put(structure.colour.value_or(std::array<double, 3>{}));
    head.put(structure.opacity);
    head.put(std::uint64_t{mesh.vertices.size()});
    head.put(std::uint64_t{mesh.triangles.size()});
    head.put(std::uint64_t{mesh.arrays.size()});
    for (const geometry::MeshArray& array : mesh.arrays) {
        head.put(array.name);
        head.put(std::uint8_t{array.isPerTriangle});
    }
    return head.write(descriptor) && writeAll(descriptor, mesh.vertices.data(), mesh.vertices.size() * sizeof(Vec3)) &&
           writeAll(descriptor, mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle)) &&
           std::all_of(mesh.arrays.begin(), mesh.arrays.end(), [descriptor](const geometry::MeshArray& array) {
               return writeAll(descriptor, array.values.data(), array.values.size() * sizeof(float));
           });
}

} // namespace

bool writeStructure(int descriptor, MeshFile& file)
{
    return (file.structures.size() > 1 || writeCommon(descriptor, file)) &&
           writeMeshOf(descriptor, file.structures.back());
}

bool writeOutcome(int descriptor, Result<MeshFile> outcome, std::size_t written)
{
    WireHead end;
    end.put(FrameKind::End);
    end.put(outcome.status());
    if (!outcome.isOk()) {
        return end.write(descriptor);
    }
    MeshFile& file = outcome.value();
    if (written == 0 && !writeCommon(descriptor, file)) {
        return false;
    }
    for (std::size_t i = written; i < file.structures.size(); ++i) {
        if (!writeMeshOf(descriptor, file.structures[i])) {
            return false;
        }
    }
    end.put(file.loss);
    end.put(std::uint64_t{file.notes.size()});
    for (const core::Message& note : file.notes) {
        end.put(note);
    }
    end.put(std::uint64_t{file.structures.size()});
    return end.write(descriptor);
}

namespace {

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

} // namespace

OutcomeReader::OutcomeReader(int descriptor, const std::filesystem::path& path)
    : m_descriptor(descriptor)
    , m_name(path.filename().string())
{
    m_file.path = path;
}

core::Message OutcomeReader::takeCommon(WireHeadReader& head)
{
    m_file.format = head.text();
    const auto frame = head.take<std::uint8_t>();
    if (frame > static_cast<std::uint8_t>(FileFrame::Ras)) {
        return {PALPATE_TEXT("its frame is unknown")};
    }
    m_file.frame = static_cast<FileFrame>(frame);
    m_file.unit_mm = head.take<double>();
    if (!(m_file.unit_mm > 0.0) || !std::isfinite(m_file.unit_mm)) {
        return {PALPATE_TEXT("its unit is not positive and finite")};
    }
    if (!takeVoxels(head, m_file)) {
        return {PALPATE_TEXT("its voxels have no size or no axes")};
    }
    if (!head.isAtEnd() || m_isBegun) {
        return {PALPATE_TEXT("its counts do not match its size")};
    }
    m_isBegun = true;
    return {};
}

/// Reads the numbers of a structure. @return the error; empty if valid
core::Message OutcomeReader::moveMesh(const Counts& counts, geometry::TriangleMesh& mesh)
{
    if (!moveItems(m_descriptor, m_at, counts.vertices, mesh.vertices,
                   [](const Vec3& p) { return p.cwiseAbs().maxCoeff() <= kMostMm && p.allFinite(); })) {
        return {PALPATE_TEXT("a coordinate is not finite or is farther than 10 km from the origin")};
    }
    if (!moveItems(m_descriptor, m_at, counts.triangles, mesh.triangles, [&counts](const Triangle& t) {
            return t[0] < counts.vertices && t[1] < counts.vertices && t[2] < counts.vertices;
        })) {
        return {PALPATE_TEXT("a vertex index is out of range")};
    }
    for (geometry::MeshArray& array : mesh.arrays) {
        if (!moveItems(m_descriptor, m_at, array.isPerTriangle ? counts.triangles : counts.vertices, array.values,
                       [](float) { return true; })) {
            return {PALPATE_TEXT("an array is incomplete")};
        }
    }
    return {};
}

/// @param begin  offset of the numbers @param size  of the memory file [bytes]
core::Message OutcomeReader::takeStructure(WireHeadReader& head, std::uint64_t begin, std::uint64_t size)
{
    MeshStructure structure;
    structure.name = head.text();
    const bool hasColour = head.take<std::uint8_t>() != 0;
    const auto colour = head.take<std::array<double, 3>>();
    if (hasColour) {
        if (!std::all_of(colour.begin(), colour.end(), [](double c) { return c >= 0.0 && c <= 1.0; })) {
            return {PALPATE_TEXT("a colour is out of range")};
        }
        structure.colour = colour;
    }
    structure.opacity = head.take<double>();
    if (!(structure.opacity >= 0.0 && structure.opacity <= 1.0)) {
        return {PALPATE_TEXT("an opacity is out of range")};
    }
    Counts counts{};
    counts.vertices = head.take<std::uint64_t>();
    counts.triangles = head.take<std::uint64_t>();
    std::uint64_t ofVertex = sizeof(Vec3), ofTriangle = sizeof(Triangle); // bytes of one
    const auto arrays = head.take<std::uint64_t>();
    if (arrays > 2 * kMostArrays) {
        return {PALPATE_TEXT("a count is out of range")};
    }
    for (std::uint64_t i = 0; i < arrays; ++i) {
        geometry::MeshArray& array = structure.mesh.arrays.emplace_back();
        array.name = head.text();
        array.isPerTriangle = head.take<std::uint8_t>() != 0;
        (array.isPerTriangle ? ofTriangle : ofVertex) += sizeof(float);
    }
    if (counts.vertices > size || counts.triangles > size || counts.triangles == 0 ||
        counts.vertices * ofVertex + counts.triangles * ofTriangle > size - begin) {
        return {PALPATE_TEXT("a count is out of range")};
    }
    if (!head.isAtEnd() || !m_isBegun) {
        return {PALPATE_TEXT("its counts do not match its size")};
    }
    m_at = begin;
    core::Message wrong = moveMesh(counts, structure.mesh);
    if (wrong.isEmpty()) {
        m_file.structures.push_back(std::move(structure));
    }
    return wrong;
}

/// @param isLast  nothing follows
core::Status OutcomeReader::takeEnd(WireHeadReader& head, bool isLast)
{
    if (core::Status status = head.status(m_name); !status.isOk()) {
        return status;
    }
    m_file.loss = head.message();
    for (auto notes = head.take<std::uint64_t>(); notes > 0 && head.isGood(); --notes) {
        m_file.notes.push_back(head.message());
    }
    const auto structures = head.take<std::uint64_t>();
    if (!head.isAtEnd() || m_file.structures.empty() || structures != m_file.structures.size() || !isLast) {
        return wireFault(m_name, {PALPATE_TEXT("its counts do not match its size")});
    }
    return {};
}

/// Reads one frame.
void OutcomeReader::readNext()
{
    Result<WireFrame> frame = readFrame(m_descriptor, m_at, m_name);
    if (!frame.isOk()) {
        m_status = frame.status();
        m_isEnded = true;
        return;
    }
    const WireFrame& next = frame.value();
    WireHeadReader head(next.head);
    core::Message wrong;
    switch (head.take<FrameKind>()) {
    case FrameKind::Common:
        m_at = next.begin;
        wrong = takeCommon(head);
        break;
    case FrameKind::Structure:
        wrong = takeStructure(head, next.begin, next.size);
        break;
    case FrameKind::End:
        m_status = takeEnd(head, next.begin == next.size);
        m_isEnded = true;
        break;
    default:
        wrong = {PALPATE_TEXT("its header is incomplete")};
    }
    if (!wrong.isEmpty()) {
        m_status = wireFault(m_name, wrong);
        m_isEnded = true;
    }
}

bool OutcomeReader::readStructure()
{
    const std::size_t before = m_file.structures.size();
    while (m_file.structures.size() == before && !m_isEnded) {
        readNext();
    }
    return m_file.structures.size() > before;
}

Result<MeshFile> OutcomeReader::finish() &&
{
    while (!m_isEnded) {
        readNext();
    }
    return m_status.isOk() ? Result<MeshFile>(std::move(m_file)) : Result<MeshFile>(m_status);
}

Result<MeshFile> readOutcome(int descriptor, const std::filesystem::path& path)
{
    return OutcomeReader(descriptor, path).finish();
}

} // namespace palpate::meshio::internal
