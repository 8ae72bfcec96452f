// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/PlaceRing.h"

#include "palpate/view/Billboard.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <cmath>
#include <numbers>

namespace palpate::view {

namespace {

constexpr int kCorners = 64;

/// Makes a flat ring between two radii. [mm]
vtkSmartPointer<vtkPolyData> ring(const core::Vec3& p_W, const core::Vec3& n_W, double inner_mm, double outer_mm)
{
    const core::Vec3 u = n_W.unitOrthogonal(), v = n_W.cross(u);
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> quads;
    for (vtkIdType i = 0; i < kCorners; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / kCorners;
        const core::Vec3 out = std::cos(angle) * u + std::sin(angle) * v;
        points->InsertNextPoint(core::Vec3(p_W + inner_mm * out).data());
        points->InsertNextPoint(core::Vec3(p_W + outer_mm * out).data());
        const vtkIdType next = 2 * ((i + 1) % kCorners);
        const vtkIdType quad[4] = {2 * i, 2 * i + 1, next + 1, next};
        quads->InsertNextCell(4, quad);
    }
    auto shape = vtkSmartPointer<vtkPolyData>::New();
    shape->SetPoints(points);
    shape->SetPolys(quads);
    return shape;
}

} // namespace

PlaceRing::PlaceRing(const Colour& colour)
{
    const std::array<Colour, 2> colours{kDarkRim, colour};
    for (std::size_t i = 0; i < m_rings.size(); ++i) {
        vtkNew<vtkPolyDataMapper> mapper;
        m_rings[i] = vtkSmartPointer<vtkActor>::New();
        m_rings[i]->SetMapper(mapper);
        m_rings[i]->PickableOff();
        m_rings[i]->VisibilityOff();
        m_rings[i]->GetProperty()->LightingOff();
        m_rings[i]->GetProperty()->SetColor(colours[i][0], colours[i][1], colours[i][2]);
    }
}

void PlaceRing::addTo(vtkRenderer& overlay)
{
    for (const auto& one : m_rings) {
        overlay.AddActor(one);
    }
}

void PlaceRing::show(const core::Vec3& p_W, const core::Vec3& n_W, double radius_mm, std::size_t structure)
{
    m_place_W = p_W;
    m_normal_W = n_W;
    m_radius_mm = radius_mm;
    m_structure = structure;
    moveTo(p_W, n_W);
    for (const auto& one : m_rings) {
        one->VisibilityOn();
    }
}

void PlaceRing::moveTo(const core::Vec3& p_W, const core::Vec3& n_W)
{
    constexpr double kOff = 0.02; // in radii: lifts the bright ring above the dark one
    constexpr std::array<std::array<double, 2>, 2> kRadii{{{0.94, 1.26}, {1.0, 1.2}}};
    for (std::size_t i = 0; i < m_rings.size(); ++i) {
        const core::Vec3 at = p_W + kOff * static_cast<double>(i) * m_radius_mm * n_W;
        vtkPolyDataMapper::SafeDownCast(m_rings[i]->GetMapper())
            ->SetInputData(ring(at, n_W, kRadii[i][0] * m_radius_mm, kRadii[i][1] * m_radius_mm));
    }
}

void PlaceRing::hide()
{
    for (const auto& one : m_rings) {
        one->VisibilityOff();
    }
}

bool PlaceRing::isShown() const
{
    return m_rings[0]->GetVisibility() != 0;
}

} // namespace palpate::view
