// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/PlaceRing.h"

#include "palpate/view/Billboard.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <cmath>
#include <numbers>

namespace palpate::view {

PlaceRing::PlaceRing()
    : m_shape(vtkSmartPointer<vtkPolyData>::New())
{
    constexpr std::array<Colour, 2> kColours{kDarkRim, Colour{1.0, 0.35, 0.75}}; // no colour of the map
    constexpr std::array<float, 2> kWidths_px{7.0F, 3.5F};
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(m_shape);
        m_lines[i] = vtkSmartPointer<vtkActor>::New();
        m_lines[i]->SetMapper(mapper);
        m_lines[i]->PickableOff();
        m_lines[i]->VisibilityOff();
        m_lines[i]->GetProperty()->LightingOff();
        m_lines[i]->GetProperty()->SetLineWidth(kWidths_px[i]);
        m_lines[i]->GetProperty()->SetColor(kColours[i][0], kColours[i][1], kColours[i][2]);
    }
}

void PlaceRing::addTo(vtkRenderer& overlay)
{
    for (const auto& line : m_lines) {
        overlay.AddActor(line);
    }
}

void PlaceRing::show(const core::Vec3& p_W, const core::Vec3& n_W, double radius_mm)
{
    constexpr int kSides = 64;
    const core::Vec3 u = n_W.unitOrthogonal(), v = n_W.cross(u);
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell(kSides + 1);
    for (int i = 0; i < kSides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kSides;
        const core::Vec3 at = p_W + radius_mm * (std::cos(angle) * u + std::sin(angle) * v);
        lines->InsertCellPoint(points->InsertNextPoint(at.data()));
    }
    lines->InsertCellPoint(0);
    m_shape->SetPoints(points);
    m_shape->SetLines(lines);
    m_shape->Modified();
    for (const auto& line : m_lines) {
        line->VisibilityOn();
    }
}

void PlaceRing::hide()
{
    for (const auto& line : m_lines) {
        line->VisibilityOff();
    }
}

bool PlaceRing::isShown() const
{
    return m_lines[0]->GetVisibility() != 0;
}

} // namespace palpate::view
