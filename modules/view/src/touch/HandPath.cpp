// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/HandPath.h"

#include "palpate/view/ColourMap.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <cstddef>

namespace palpate::view {

namespace {

constexpr double kFreeWidth_px = 1.5, kTouchingWidth_px = 3.5;
constexpr Colour kFreeColour{0.80, 0.85, 0.90}, kTouchingColour{0.90, 0.62, 0.00};

vtkSmartPointer<vtkActor> makePathActor(const Colour& colour, double width_px)
{
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(vtkSmartPointer<vtkPolyData>::New());
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->PickableOff();
    actor->VisibilityOff();
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    actor->GetProperty()->SetLineWidth(static_cast<float>(width_px));
    return actor;
}

} // namespace

HandPath::HandPath()
    : m_free(makePathActor(kFreeColour, kFreeWidth_px))
    , m_touching(makePathActor(kTouchingColour, kTouchingWidth_px))
{
}

void HandPath::addTo(vtkRenderer& renderer)
{
    renderer.AddActor(m_free);
    renderer.AddActor(m_touching);
}

void HandPath::set(const std::vector<PathPoint>& points)
{
    vtkNew<vtkPoints> places;
    places->SetDataTypeToDouble();
    vtkNew<vtkCellArray> free, touching;
    m_box.setEmpty();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto at = static_cast<vtkIdType>(i);
        places->InsertNextPoint(points[i].p_W.data());
        m_box.extend(points[i].p_W);
        if (i > 0 && points[i].isContinued) {
            const vtkIdType line[2] = {at - 1, at};
            (points[i].isTouching ? touching : free)->InsertNextCell(2, line);
        }
    }
    const auto show = [&places](vtkActor& actor, vtkCellArray* lines) {
        vtkNew<vtkPolyData> shape;
        shape->SetPoints(places);
        shape->SetLines(lines);
        vtkPolyDataMapper::SafeDownCast(actor.GetMapper())->SetInputData(shape);
        actor.SetVisibility(lines->GetNumberOfCells() > 0 ? 1 : 0);
    };
    show(*m_free, free);
    show(*m_touching, touching);
}

} // namespace palpate::view
