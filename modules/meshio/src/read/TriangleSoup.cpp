// SPDX-License-Identifier: BSD-3-Clause
#include "read/TriangleSoup.h"

#include "guard/VtkMessages.h"
#include "text/Fault.h"

#include <palpate/core/TissueMapping.h>
#include <palpate/geometry/PolygonCutter.h>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using geometry::PolygonCutter;
using geometry::Triangle;

/// Reads the structure of each polygon from the array of a VTP file.
class StructureIds
{
  public:
    explicit StructureIds(vtkPolyData& data)
        : m_ids(data.GetCellData()->GetArray("StructureId"))
        , m_names(vtkStringArray::SafeDownCast(data.GetFieldData()->GetAbstractArray("StructureNames")))
        , m_colours(data.GetFieldData()->GetArray("StructureColours"))
    {
        const vtkIdType cells =
            data.GetNumberOfVerts() + data.GetNumberOfLines() + data.GetNumberOfPolys() + data.GetNumberOfStrips();
        if (m_ids != nullptr && (m_ids->GetNumberOfTuples() != cells || m_ids->GetNumberOfComponents() != 1)) {
            m_ids = nullptr;
        }
    }
    [[nodiscard]] bool isEmpty() const noexcept { return m_ids == nullptr; }

    std::uint32_t partOf(vtkIdType cell, TriangleSoup& soup)
    {
        const auto id = static_cast<std::int64_t>(m_ids->GetComponent(cell, 0));
        if (id == m_lastId && !soup.partNames.empty()) {
            return m_lastPart;
        }
        const auto [found, isNew] = m_parts.emplace(id, static_cast<std::uint32_t>(soup.partNames.size()));
        if (isNew) {
            const bool isNamed = m_names != nullptr && id >= 0 && id < m_names->GetNumberOfValues();
            std::string name = isNamed ? std::string(m_names->GetValue(id)) : std::string();
            soup.partNames.push_back(name.empty() ? "structure " + std::to_string(id) : std::move(name));
            soup.partColours.push_back(colourOf(id));
        }
        m_lastId = id;
        m_lastPart = found->second;
        return m_lastPart;
    }

  private:
    [[nodiscard]] std::optional<std::array<double, 3>> colourOf(std::int64_t id) const
    {
        if (m_colours == nullptr || m_colours->GetNumberOfComponents() != 3 || id < 0 ||
            id >= m_colours->GetNumberOfTuples()) {
            return std::nullopt;
        }
        std::array<double, 3> colour = {};
        m_colours->GetTuple(id, colour.data());
        const bool isColour = std::all_of(colour.begin(), colour.end(), [](double c) { return c >= 0.0 && c <= 1.0; });
        return isColour ? std::optional(colour) : std::nullopt;
    }

    vtkDataArray* m_ids;
    vtkStringArray* m_names;
    vtkDataArray* m_colours;
    std::unordered_map<std::int64_t, std::uint32_t> m_parts;
    std::int64_t m_lastId = 0;
    std::uint32_t m_lastPart = 0;
};

/// Checks the corners of a polygon or strip with at least three.
/// @param most  maximum number of corners of the cell
Status checkCorners(const vtkIdType* corners, vtkIdType count, vtkIdType most, vtkIdType points, std::uint64_t cell,
                    const ScanContext& context)
{
    const core::Message place(PALPATE_TEXT("polygon %1"), cell);
    if (count > most) {
        return fault(StatusCode::BadFormat, context.file, place, {PALPATE_TEXT("number of corners: %1"), Count(count)},
                     {PALPATE_TEXT("at most %1"), Count(most)});
    }
    for (vtkIdType k = 0; k < count; ++k) {
        if (corners[k] < 0 || corners[k] >= points) {
            return fault(StatusCode::OutOfRange, context.file, place, {PALPATE_TEXT("it uses point %1"), corners[k]},
                         {PALPATE_TEXT("%1 to %2"), 0, points - 1});
        }
    }
    return {};
}

std::vector<core::Vec3> takePoints(vtkPoints& points)
{
    const auto count = static_cast<std::size_t>(points.GetNumberOfPoints());
    std::vector<core::Vec3> out(count);
    if (auto* floats = vtkFloatArray::SafeDownCast(points.GetData()); floats != nullptr) {
        const float* p = floats->GetPointer(0);
        for (std::size_t i = 0; i < count; ++i) {
            out[i] = core::Vec3(p[3 * i], p[3 * i + 1], p[3 * i + 2]);
        }
        return out;
    }
    for (std::size_t i = 0; i < count; ++i) {
        points.GetPoint(static_cast<vtkIdType>(i), out[i].data());
    }
    return out;
}

void takeFieldData(vtkPolyData& data, PreScan& scan)
{
    auto* space = vtkStringArray::SafeDownCast(data.GetFieldData()->GetAbstractArray("SPACE"));
    if (space != nullptr && space->GetNumberOfValues() > 0) {
        noteSpace(std::string(space->GetValue(0)), scan);
    }
}

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// Converts a VTK number for storage: values outside the range of float become unknown.
float known(double value)
{
    return std::abs(value) <= double{std::numeric_limits<float>::max()} ? static_cast<float>(value) : kUnknown;
}

/// Takes over the single-component arrays that VTK has read.
/// @param cellOf  for each triangle, the index of the cell in VTK's cell data
void takeArrays(vtkPolyData& data, const PreScan& scan, const std::vector<std::uint32_t>& cellOf,
                std::vector<geometry::MeshArray>& out)
{
    const auto points = static_cast<std::size_t>(data.GetNumberOfPoints());
    // Written by the probe filters of VTK and 3D Slicer: 0 marks points outside the sampled data.
    vtkDataArray* valid = data.GetPointData()->GetArray("vtkValidPointMask");
    for (const std::string& name : scan.pointArrays) {
        vtkDataArray* array = data.GetPointData()->GetArray(name.c_str());
        if (array == nullptr || array == valid || array->GetNumberOfComponents() != 1 ||
            static_cast<std::size_t>(array->GetNumberOfTuples()) != points) {
            continue;
        }
        geometry::MeshArray& taken = out.emplace_back(geometry::MeshArray{name, false, {}});
        taken.values.reserve(points);
        for (std::size_t i = 0; i < points; ++i) {
            const auto at = static_cast<vtkIdType>(i);
            const bool isValid = valid == nullptr || valid->GetComponent(at, 0) != 0.0;
            taken.values.push_back(isValid ? known(array->GetComponent(at, 0)) : kUnknown);
        }
    }
    for (const std::string& name : scan.cellArrays) {
        vtkDataArray* array = data.GetCellData()->GetArray(name.c_str());
        if (array == nullptr || array->GetNumberOfComponents() != 1 ||
            array->GetNumberOfTuples() < data.GetNumberOfCells()) {
            continue;
        }
        geometry::MeshArray& taken = out.emplace_back(geometry::MeshArray{name, true, {}});
        taken.values.reserve(cellOf.size());
        for (const std::uint32_t cell : cellOf) {
            taken.values.push_back(known(array->GetComponent(static_cast<vtkIdType>(cell), 0)));
        }
    }
}

/// Cells that VTK marks as hidden, or as a copy of a cell of another piece (vtkDataSetAttributes::CellGhostTypes).
class GhostCells
{
  public:
    /// Takes VTK's arrays, so that they are not offered as numbers of the surface.
    GhostCells(vtkPolyData& data, PreScan& scan)
        : m_ofCell(arrayOf(*data.GetCellData(), data.GetNumberOfCells()))
        , m_ofPoint(arrayOf(*data.GetPointData(), data.GetNumberOfPoints()))
        , m_stated(scan.hiddenCells)
    {
        for (std::vector<std::string>* names : {&scan.cellArrays, &scan.pointArrays}) {
            std::erase(*names, vtkDataSetAttributes::GhostArrayName());
            std::erase(*names, "vtkGhostLevels"); // of VTK 6 and older; VTK's reader converts it
        }
    }
    /// @param cell  index in the cell data @return true for a cell that is not part of the surface
    bool isHidden(vtkIdType cell, const vtkIdType* corners, vtkIdType count)
    {
        constexpr unsigned kNotDrawn =
            vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::HIDDENCELL;
        const auto number = static_cast<std::size_t>(cell);
        const bool isHidden = (number < m_stated.size() && m_stated[number]) ||
                              (m_ofCell != nullptr && (m_ofCell->GetValue(cell) & kNotDrawn) != 0) ||
                              (m_ofPoint != nullptr && std::any_of(corners, corners + count, [this](vtkIdType point) {
                                   return (m_ofPoint->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT) != 0;
                               }));
        m_hidden += isHidden ? 1 : 0;
        return isHidden;
    }
    void note(PreScan& scan) const { noteHiddenCells(m_hidden, scan); }

  private:
    static vtkUnsignedCharArray* arrayOf(vtkDataSetAttributes& data, vtkIdType tuples)
    {
        auto* array = vtkUnsignedCharArray::SafeDownCast(data.GetArray(vtkDataSetAttributes::GhostArrayName()));
        return array != nullptr && array->GetNumberOfValues() == tuples ? array : nullptr;
    }

    vtkUnsignedCharArray* m_ofCell;
    vtkUnsignedCharArray* m_ofPoint;
    const std::vector<bool>& m_stated; ///< by the guard
    std::uint64_t m_hidden = 0;
};

/// Omits arrays beyond the maximum per mesh.
/// @param areOfPoints  of the points, otherwise of the polygons
void bound(std::vector<std::string>& names, bool areOfPoints, PreScan& scan)
{
    // Arrays with a known meaning come first.
    std::stable_partition(names.begin(), names.end(), [](const std::string& name) {
        return std::any_of(core::kKnownMaps.begin(), core::kKnownMaps.end(),
                           [&](const core::KnownMap& map) { return map.array == name; });
    });
    if (names.size() > kMostArrays) {
        const std::size_t more = names.size() - kMostArrays;
        scan.notes.push_back(
            areOfPoints
                ? core::Message(PALPATE_TEXT("at most %1 arrays of the points are used; number of arrays left out: %2"),
                                kMostArrays, more)
                : core::Message(
                      PALPATE_TEXT("at most %1 arrays of the polygons are used; number of arrays left out: %2"),
                      kMostArrays, more));
        names.resize(kMostArrays);
    }
}

} // namespace

Result<TriangleSoup> toTriangles(vtkPolyData& data, PreScan& scan, const ScanContext& context)
{
    const VtkMessages messages;
    TriangleSoup soup;
    takeFieldData(data, scan);
    soup.mesh.vertices = scan.exactPoints.empty() ? takePoints(*data.GetPoints()) : std::move(scan.exactPoints);
    soup.partNames = scan.partNames;
    soup.partColours = scan.partColours;
    soup.partOpacities = scan.partOpacities;
    std::vector<Triangle>& triangles = soup.mesh.triangles;
    triangles.reserve(scan.cells);

    StructureIds ids(data);
    const bool hasParts = !ids.isEmpty() || scan.partNames.size() > 1;
    const vtkIdType points = data.GetNumberOfPoints();
    const vtkIdType firstCell = data.GetNumberOfVerts() + data.GetNumberOfLines();
    PolygonCutter cutter;
    GhostCells ghosts(data, scan);
    std::uint64_t thinFaces = 0;
    std::vector<std::uint32_t> polygon;
    bound(scan.pointArrays, true, scan);
    bound(scan.cellArrays, false, scan);
    std::vector<std::uint32_t> cellOf; // for each triangle
    std::uint64_t cell = 0;            // over polygons, then strips
    for (vtkCellArray* cells : {data.GetPolys(), data.GetStrips()}) {
        const bool isStrip = cells == data.GetStrips();
        const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
        for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell(), ++cell) {
            vtkIdType count = 0;
            const vtkIdType* corners = nullptr;
            iterator->GetCurrentCell(count, corners);
            const vtkIdType most =
                isStrip ? std::numeric_limits<std::int32_t>::max() : vtkIdType{PolygonCutter::kMostCorners};
            if (count < 3) {
                ++thinFaces;
                continue;
            }
            if (Status status = checkCorners(corners, count, most, points, cell, context); !status.isOk()) {
                return status;
            }
            if (ghosts.isHidden(firstCell + static_cast<vtkIdType>(cell), corners, count)) {
                continue;
            }
            if (isStrip) {
                for (vtkIdType k = 0; k + 2 < count; ++k) { // the winding alternates along a strip
                    const vtkIdType odd = k % 2;
                    triangles.push_back({static_cast<std::uint32_t>(corners[k]),
                                         static_cast<std::uint32_t>(corners[k + 1 + odd]),
                                         static_cast<std::uint32_t>(corners[k + 2 - odd])});
                }
            } else if (count == 3) {
                triangles.push_back({static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[1]),
                                     static_cast<std::uint32_t>(corners[2])});
            } else {
                polygon.assign(corners, corners + count);
                cutter.cut(soup.mesh.vertices, polygon, triangles);
            }
            if (!scan.cellArrays.empty()) {
                cellOf.resize(triangles.size(),
                              static_cast<std::uint32_t>(firstCell) + static_cast<std::uint32_t>(cell));
            }
            if (hasParts) {
                const std::uint32_t part =
                    ids.isEmpty() ? scan.partOfCell[cell] : ids.partOf(firstCell + static_cast<vtkIdType>(cell), soup);
                soup.part.resize(triangles.size(), part);
            }
        }
    }
    noteCrossing(cutter.crossing(), scan);
    noteThinFaces(thinFaces, scan);
    ghosts.note(scan);
    if (triangles.empty()) {
        return fault(StatusCode::Empty, context.file, {}, {PALPATE_TEXT("0 faces")},
                     {PALPATE_TEXT("at least one face")});
    }
    takeArrays(data, scan, cellOf, soup.mesh.arrays);
    if (soup.partNames.empty()) {
        soup.partNames.emplace_back();
    }
    return soup;
}

} // namespace palpate::meshio::internal
