// SPDX-License-Identifier: BSD-3-Clause
#include "NumericLocale.h"
#include "VtkMessages.h"
#include "palpate/meshio/VtpFile.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <array>

namespace palpate::meshio {

namespace {

void copy(const std::vector<core::Vec3>& from, vtkDoubleArray& to)
{
    to.SetNumberOfComponents(3);
    to.SetNumberOfTuples(static_cast<vtkIdType>(from.size()));
    for (std::size_t i = 0; i < from.size(); ++i) {
        to.SetTypedTuple(static_cast<vtkIdType>(i), from[i].data());
    }
}

void copy(const std::vector<double>& from, vtkDoubleArray& to)
{
    to.SetNumberOfValues(static_cast<vtkIdType>(from.size()));
    std::copy(from.begin(), from.end(), to.GetPointer(0));
}

void copy(const std::vector<std::int32_t>& from, vtkIntArray& to)
{
    to.SetNumberOfValues(static_cast<vtkIdType>(from.size()));
    std::copy(from.begin(), from.end(), to.GetPointer(0));
}

void add(vtkFieldData& to, const VtpArray& array)
{
    std::visit(
        [&]<class Value>(const std::vector<Value>& values) {
            vtkNew<std::conditional_t<std::is_same_v<Value, std::int32_t>, vtkIntArray, vtkDoubleArray>> made;
            made->SetName(array.name.c_str());
            copy(values, *made);
            to.AddArray(made);
        },
        array.values);
}

void addTexts(vtkFieldData& to, const char* name, const std::vector<std::string>& texts)
{
    vtkNew<vtkStringArray> made;
    made->SetName(name);
    for (const std::string& text : texts) {
        made->InsertNextValue(text);
    }
    to.AddArray(made);
}

void fill(vtkPolyData& data, const VtpFile& content)
{
    vtkNew<vtkDoubleArray> coordinates;
    copy(content.points, *coordinates);
    vtkNew<vtkPoints> points;
    points->SetData(coordinates);
    data.SetPoints(points);
    vtkNew<vtkCellArray> lines;
    vtkIdType first = 0;
    for (const std::size_t end : content.lineEnds) {
        lines->InsertNextCell(static_cast<int>(end - static_cast<std::size_t>(first)));
        for (; first < static_cast<vtkIdType>(end); ++first) {
            lines->InsertCellPoint(first);
        }
    }
    data.SetLines(lines);
    vtkNew<vtkCellArray> polys;
    for (const geometry::Triangle& t : content.triangles) {
        const std::array<vtkIdType, 3> corners{t[0], t[1], t[2]};
        polys->InsertNextCell(3, corners.data());
    }
    data.SetPolys(polys);
    for (const VtpArray& array : content.pointArrays) {
        add(*data.GetPointData(), array);
    }
    if (!content.pointArrays.empty()) {
        data.GetPointData()->SetActiveScalars(content.pointArrays.front().name.c_str());
    }
    for (const VtpArray& array : content.cellArrays) {
        add(*data.GetCellData(), array);
    }
    if (!content.structureNames.empty()) {
        addTexts(*data.GetFieldData(), "StructureNames", content.structureNames);
    }
    addTexts(*data.GetFieldData(), "SPACE", {"LPS"});
}

} // namespace

core::Result<std::string> vtpBytes(const VtpFile& content)
{
    const internal::NumericLocale locale;
    const internal::VtkMessages messages;
    vtkNew<vtkPolyData> data;
    fill(*data, content);
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(data);
    writer->SetHeaderTypeToUInt64();
    writer->EncodeAppendedDataOff();
    writer->WriteToOutputStringOn();
    if (writer->Write() == 0 || !messages.firstError().empty()) {
        return core::Status(core::StatusCode::Internal, "VTK could not write it: " + messages.firstError());
    }
    return writer->GetOutputString();
}

} // namespace palpate::meshio
