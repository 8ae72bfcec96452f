// SPDX-License-Identifier: BSD-3-Clause
#include "guard/VtkMessages.h"
#include "palpate/meshio/VtpFile.h"
#include "text/NumericLocale.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <array>

namespace palpate::meshio {

namespace {

template<class Array, class Number>
vtkSmartPointer<Array> arrayOf(const Number* numbers, std::size_t tuples, int components)
{
    auto made = vtkSmartPointer<Array>::New();
    made->SetNumberOfComponents(components);
    made->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
    std::copy_n(numbers, tuples * static_cast<std::size_t>(components), made->GetPointer(0));
    return made;
}

vtkSmartPointer<vtkDataArray> arrayOf(const std::vector<double>& values)
{
    return arrayOf<vtkDoubleArray>(values.data(), values.size(), 1);
}

vtkSmartPointer<vtkDataArray> arrayOf(const std::vector<std::int32_t>& values)
{
    return arrayOf<vtkIntArray>(values.data(), values.size(), 1);
}

vtkSmartPointer<vtkDataArray> arrayOf(const std::vector<core::Vec3>& values)
{
    return arrayOf<vtkDoubleArray>(values.empty() ? nullptr : values.front().data(), values.size(), 3);
}

void add(vtkFieldData& to, const VtpArray& array)
{
    const auto made = std::visit([](const auto& values) { return arrayOf(values); }, array.values);
    made->SetName(array.name.c_str());
    to.AddArray(made);
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
    vtkNew<vtkPoints> points;
    points->SetData(arrayOf(content.points));
    data.SetPoints(points);
    vtkNew<vtkCellArray> vertices;
    vtkNew<vtkCellArray> lines;
    vtkIdType first = 0;
    for (const std::size_t end : content.lineEnds) {
        const auto count = static_cast<vtkIdType>(end) - first;
        if (count > 0) {
            vtkCellArray& cells = count == 1 ? *vertices : *lines; // VTK crashes on lines with a single point
            cells.InsertNextCell(static_cast<int>(count));
            for (; first < static_cast<vtkIdType>(end); ++first) {
                cells.InsertCellPoint(first);
            }
        }
    }
    data.SetVerts(vertices);
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
    if (!content.structureColours.empty()) {
        add(*data.GetFieldData(), {"StructureColours", content.structureColours});
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
        return core::Status(core::StatusCode::Internal, PALPATE_TEXT("VTK could not write it: %1"),
                            messages.firstError());
    }
    return writer->GetOutputString();
}

} // namespace palpate::meshio
