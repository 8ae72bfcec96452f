// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/MeshFile.h"

#include "AtomicFile.h"
#include "Fault.h"
#include "NumericLocale.h"
#include "TextScan.h"
#include "VtkMessages.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

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

/// Points, triangles, `StructureId`, `StructureNames`, `StructureColours` where there are some, and `SPACE`.
void fill(vtkPolyData& data, std::span<const MeshStructure> structures)
{
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> polys;
    vtkNew<vtkIntArray> ids;
    ids->SetName("StructureId");
    vtkNew<vtkStringArray> names;
    names->SetName("StructureNames");
    vtkNew<vtkDoubleArray> colours;
    colours->SetName("StructureColours"); // a negative red: none
    colours->SetNumberOfComponents(3);
    bool hasColours = false;
    for (std::size_t s = 0; s < structures.size(); ++s) {
        const MeshStructure& structure = structures[s];
        const vtkIdType first = points->GetNumberOfPoints();
        for (const Vec3& p : structure.mesh.vertices) {
            points->InsertNextPoint(p.data());
        }
        for (const Triangle& t : structure.mesh.triangles) {
            const std::array<vtkIdType, 3> corners{first + t[0], first + t[1], first + t[2]};
            polys->InsertNextCell(3, corners.data());
            ids->InsertNextValue(static_cast<int>(s));
        }
        names->InsertNextValue(structure.name);
        colours->InsertNextTuple(structure.colour.value_or(std::array<double, 3>{-1.0, 0.0, 0.0}).data());
        hasColours = hasColours || structure.colour.has_value();
    }
    data.SetPoints(points);
    data.SetPolys(polys);
    data.GetCellData()->AddArray(ids);
    data.GetFieldData()->AddArray(names);
    if (hasColours) {
        data.GetFieldData()->AddArray(colours);
    }
    vtkNew<vtkStringArray> space;
    space->SetName("SPACE");
    space->InsertNextValue("LPS");
    data.GetFieldData()->AddArray(space);
}

Result<std::string> vtpBytes(std::span<const MeshStructure> structures, const std::string& file)
{
    const NumericLocale locale;
    const VtkMessages messages;
    vtkNew<vtkPolyData> data;
    fill(*data, structures);
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(data);
    writer->SetHeaderTypeToUInt64();
    writer->EncodeAppendedDataOff();
    writer->WriteToOutputStringOn();
    if (writer->Write() == 0 || !messages.firstError().empty()) {
        return fault(StatusCode::Internal, file, "", "VTK could not write it: " + messages.firstError(), "");
    }
    return writer->GetOutputString();
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
        return fault(StatusCode::Empty, file, "", counted(triangles, "triangle") + " to write",
                     "1 to " + grouped(std::numeric_limits<std::uint32_t>::max()));
    }
    for (const MeshStructure& structure : structures) {
        for (const Triangle& t : structure.mesh.triangles) {
            if (std::max({t[0], t[1], t[2]}) >= structure.mesh.vertices.size()) {
                return fault(StatusCode::OutOfRange, file, inQuotes(structure.name), "a triangle without its vertices",
                             "indices below " + grouped(structure.mesh.vertices.size()));
            }
        }
    }
    const std::string extension = path.extension().string();
    if (sameWord(extension, ".vtp")) {
        const Result<std::string> bytes = vtpBytes(structures, file);
        return bytes.isOk() ? writeAtomically(path, bytes.value()) : bytes.status();
    }
    if (sameWord(extension, ".stl")) {
        return writeAtomically(path, stlBytes(structures));
    }
    return fault(StatusCode::BadCommandLine, file, "", "the extension " + inQuotes(extension), "\".vtp\" or \".stl\"");
}

} // namespace palpate::meshio
