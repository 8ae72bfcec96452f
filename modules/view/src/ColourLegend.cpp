// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/ColourLegend.h"

#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstdio>

namespace palpate::view {

namespace {

constexpr int kColourRows = 10; // of colours; between them it is even
constexpr double kBarLeft_px = 20.0, kBarWidth_px = 16.0, kBarHeight_px = 160.0;
constexpr double kBarLow_px = 150.0; // above the orientation cube and what grey means
constexpr double kGreyLow_px = 122.0, kGreyHeight_px = 16.0, kBeside_px = 8.0;

/// A column of quads, coloured at its rows' ends.
vtkSmartPointer<vtkActor2D> makeColumn(int rows, const vtkSmartPointer<vtkUnsignedCharArray>& colours)
{
    vtkNew<vtkPoints> points;
    points->SetNumberOfPoints(2 * rows);
    vtkNew<vtkCellArray> quads;
    for (vtkIdType row = 0; row + 1 < rows; ++row) {
        const vtkIdType quad[4] = {2 * row, 2 * row + 1, 2 * row + 3, 2 * row + 2};
        quads->InsertNextCell(4, quad);
    }
    vtkNew<vtkPolyData> shape;
    shape->SetPoints(points);
    shape->SetPolys(quads);
    shape->GetPointData()->SetScalars(colours);
    vtkNew<vtkCoordinate> pixels;
    pixels->SetCoordinateSystemToViewport();
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(shape);
    mapper->SetTransformCoordinate(pixels);
    auto actor = vtkSmartPointer<vtkActor2D>::New();
    actor->SetMapper(mapper);
    actor->VisibilityOff();
    return actor;
}

void placeColumn(vtkActor2D& column, int rows, double low_px, double height_px, double ratio)
{
    auto* shape = vtkPolyDataMapper2D::SafeDownCast(column.GetMapper())->GetInput();
    for (vtkIdType row = 0; row < rows; ++row) {
        const double y = ratio * (low_px + height_px * static_cast<double>(row) / (rows - 1));
        shape->GetPoints()->SetPoint(2 * row, ratio * kBarLeft_px, y, 0.0);
        shape->GetPoints()->SetPoint(2 * row + 1, ratio * (kBarLeft_px + kBarWidth_px), y, 0.0);
    }
    shape->GetPoints()->Modified();
    shape->Modified();
}

vtkSmartPointer<vtkUnsignedCharArray> colourRows(int rows, Colour (*colourAt)(double))
{
    auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colours->SetNumberOfComponents(3);
    for (int row = 0; row < rows; ++row) {
        const Colour colour = colourAt(static_cast<double>(row) / (rows - 1));
        for (int side = 0; side < 2; ++side) {
            colours->InsertNextTuple3(std::round(255.0 * colour[0]), std::round(255.0 * colour[1]),
                                      std::round(255.0 * colour[2]));
        }
    }
    return colours;
}

std::string number(double value, const char* before)
{
    char text[48];
    std::snprintf(text, sizeof text, "%s%.3g", before, value);
    return text;
}

} // namespace

ColourLegend::ColourLegend()
    : m_bar(makeColumn(kColourRows, colourRows(kColourRows, [](double t) { return surfaceColour(t); })))
    , m_grey(makeColumn(2, colourRows(2, [](double) { return kUnknownColour; })))
{
    for (auto& text : m_texts) {
        text = vtkSmartPointer<vtkTextActor>::New();
        text->GetTextProperty()->SetVerticalJustificationToCentered();
        text->VisibilityOff();
    }
    m_texts[0]->GetTextProperty()->SetVerticalJustificationToBottom();
    setColour({1.0, 1.0, 1.0});
}

void ColourLegend::addTo(vtkRenderer& renderer)
{
    renderer.AddActor2D(m_bar);
    renderer.AddActor2D(m_grey);
    for (const auto& text : m_texts) {
        renderer.AddActor2D(text);
    }
}

void ColourLegend::show(const Content& content)
{
    const ColourRange& range = content.range;
    const bool isOne = !(range.high > range.low);
    m_texts[0]->SetInput(content.title.c_str());
    m_texts[1]->SetInput(isOne ? "" : number(range.high, range.isHighCut ? "\u2265 " : "").c_str());
    m_texts[2]->SetInput(number(0.5 * (range.low + range.high), "").c_str());
    m_texts[3]->SetInput(isOne ? "" : number(range.low, range.isLowCut ? "\u2264 " : "").c_str());
    m_texts[4]->SetInput(content.unknown.c_str());
    m_hasUnknown = range.hasUnknown;
    m_bar->VisibilityOn();
    m_grey->SetVisibility(m_hasUnknown);
    for (const auto& text : m_texts) {
        text->VisibilityOn();
    }
    m_texts[4]->SetVisibility(m_hasUnknown);
}

void ColourLegend::hide()
{
    m_bar->VisibilityOff();
    m_grey->VisibilityOff();
    for (const auto& text : m_texts) {
        text->VisibilityOff();
    }
}

std::array<std::string, 5> ColourLegend::texts() const
{
    std::array<std::string, 5> texts;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        texts[i] = m_texts[i]->GetVisibility() != 0 && m_texts[i]->GetInput() != nullptr ? m_texts[i]->GetInput() : "";
    }
    return texts;
}

void ColourLegend::place(double pixelRatio)
{
    const double r = pixelRatio;
    placeColumn(*m_bar, kColourRows, kBarLow_px, kBarHeight_px, r);
    placeColumn(*m_grey, 2, kGreyLow_px, kGreyHeight_px, r);
    const double beside = r * (kBarLeft_px + kBarWidth_px + kBeside_px);
    m_texts[0]->SetPosition(r * kBarLeft_px, r * (kBarLow_px + kBarHeight_px + 12.0));
    m_texts[1]->SetPosition(beside, r * (kBarLow_px + kBarHeight_px));
    m_texts[2]->SetPosition(beside, r * (kBarLow_px + 0.5 * kBarHeight_px));
    m_texts[3]->SetPosition(beside, r * kBarLow_px);
    m_texts[4]->SetPosition(beside, r * (kGreyLow_px + 0.5 * kGreyHeight_px));
    for (const auto& text : m_texts) {
        text->GetTextProperty()->SetFontSize(static_cast<int>(14.0 * r));
    }
}

void ColourLegend::setColour(const Colour& colour)
{
    for (const auto& text : m_texts) {
        text->GetTextProperty()->SetColor(colour[0], colour[1], colour[2]);
    }
}

} // namespace palpate::view
