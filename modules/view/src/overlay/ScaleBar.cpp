// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/ScaleBar.h"

#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

namespace palpate::view {

namespace {

constexpr double kLongest = 12.5; // maximum length of the bar, in letters

} // namespace

double roundScaleLength(double longest_mm)
{
    if (!(longest_mm > 0.0) || !std::isfinite(longest_mm)) {
        return 1.0;
    }
    const double decade = std::pow(10.0, std::floor(std::log10(longest_mm)));
    for (const double step : {5.0, 2.0}) {
        if (step * decade <= longest_mm * (1.0 + 1e-12)) {
            return step * decade;
        }
    }
    return decade;
}

ScaleBar::ScaleBar()
    : m_bar(vtkSmartPointer<vtkActor2D>::New())
    , m_text(vtkSmartPointer<vtkTextActor>::New())
{
    vtkNew<vtkPoints> points;
    points->SetNumberOfPoints(12);
    vtkNew<vtkCellArray> faces;
    for (vtkIdType i = 0; i < 12; i += 4) { // bar and two end caps
        const vtkIdType quad[4] = {i, i + 1, i + 2, i + 3};
        faces->InsertNextCell(4, quad);
    }
    vtkNew<vtkPolyData> shape;
    shape->SetPoints(points);
    shape->SetPolys(faces);
    vtkNew<vtkCoordinate> pixels;
    pixels->SetCoordinateSystemToViewport();
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(shape);
    mapper->SetTransformCoordinate(pixels);
    m_bar->SetMapper(mapper);
    m_text->GetTextProperty()->SetJustificationToCentered();
    m_text->GetTextProperty()->SetVerticalJustificationToBottom();
    setColour({1.0, 1.0, 1.0});
}

void ScaleBar::addTo(vtkRenderer& renderer)
{
    renderer.AddActor2D(m_bar);
    renderer.AddActor2D(m_text);
}

void ScaleBar::setColour(const Colour& colour)
{
    m_bar->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    m_text->GetTextProperty()->SetColor(colour[0], colour[1], colour[2]);
}

void ScaleBar::place(const Vec3& focus_W, const ViewFrame& frame, int width_px, double below_px)
{
    const double pixel_mm = frame.mmPerPixel(focus_W);
    const double r = frame.pixelRatio;
    // Longer with a larger font, but at most half the width of the view.
    const double longest_px = std::min(kLongest * frame.text.size_px, 0.5 * width_px / r);
    const double length_mm = roundScaleLength(longest_px * pixel_mm);
    const double length_px = length_mm / pixel_mm;
    const double right = width_px - 20.0 * r;
    const double left = right - length_px * r;
    const double low = (18.0 + below_px) * r;
    const double boxes[3][4] = {{left, low, right, low + 2.0 * r},
                                {left, low, left + 2.0 * r, low + 7.0 * r},
                                {right - 2.0 * r, low, right, low + 7.0 * r}};
    auto* shape = vtkPolyDataMapper2D::SafeDownCast(m_bar->GetMapper())->GetInput();
    for (vtkIdType i = 0; i < 3; ++i) {
        shape->GetPoints()->SetPoint(4 * i, boxes[i][0], boxes[i][1], 0.0);
        shape->GetPoints()->SetPoint(4 * i + 1, boxes[i][2], boxes[i][1], 0.0);
        shape->GetPoints()->SetPoint(4 * i + 2, boxes[i][2], boxes[i][3], 0.0);
        shape->GetPoints()->SetPoint(4 * i + 3, boxes[i][0], boxes[i][3], 0.0);
    }
    shape->GetPoints()->Modified();
    shape->Modified();
    m_caption = shortText(length_mm, 6, frame.text.decimalPoint) + " mm";
    m_text->SetInput(m_caption.c_str());
    setFont(*m_text->GetTextProperty(), frame.text, TextUse::Usual, r);
    const double textLow = low + 9.0 * r;
    m_text->SetPosition(0.5 * (left + right), textLow);
    m_top = textLow + 1.4 * letterSize_px(frame.text, TextUse::Usual, r);
}

} // namespace palpate::view
