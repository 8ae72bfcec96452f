// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/StructureActor.h"

#include "palpate/view/FeltColours.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>

namespace palpate::view {

namespace {

constexpr double kAmbient = 0.06, kHighlight = 0.30; // ambient share of the colour

} // namespace

StructureActor::StructureActor(vtkPolyData* surface, const Appearance& appearance, bool isClosed)
    : m_actor(vtkSmartPointer<vtkActor>::New())
    , m_isClosed(isClosed)
{
    vtkNew<vtkPolyDataMapper> mapper;
    m_actor->SetMapper(mapper);
    setPicture(surface);
    vtkProperty* look = m_actor->GetProperty();
    look->SetInterpolationToPhong();
    look->SetAmbient(kAmbient);
    look->SetDiffuse(0.92);
    look->SetSpecular(0.22);
    look->SetSpecularPower(22.0);
    vtkNew<vtkProperty> inside;
    m_actor->SetBackfaceProperty(inside);
    setAppearance(appearance);
}

void StructureActor::setPicture(vtkPolyData* surface)
{
    auto* mapper = vtkPolyDataMapper::SafeDownCast(m_actor->GetMapper());
    mapper->SetInputData(surface);
    const bool hasColours =
        surface->GetPointData()->GetScalars() != nullptr || surface->GetCellData()->GetScalars() != nullptr;
    mapper->SetScalarVisibility(hasColours);
    mapper->SetColorModeToDirectScalars();
    drawPalpabilityContours(*m_actor, *surface);
}

void StructureActor::bend(const Dimple& dimple, const ViewFrame& frame)
{
    const double* b = m_actor->GetMapper()->GetBounds();
    const bool isReached = dimple.reaches({Vec3(b[0], b[2], b[4]), Vec3(b[1], b[3], b[5])});
    if (isReached != m_isBent) {
        m_isBent = isReached;
        isReached ? startBending(*m_actor) : stopBending(*m_actor);
    }
    if (isReached) {
        view::bend(*m_actor, dimple, frame);
    }
}

void StructureActor::clip(vtkPlaneCollection* planes)
{
    m_actor->GetMapper()->SetClippingPlanes(planes);
}

void StructureActor::setHighlighted(bool isOn)
{
    const double ambient = isOn ? kHighlight : kAmbient;
    m_actor->GetProperty()->SetAmbient(ambient);
    m_actor->GetBackfaceProperty()->SetAmbient(ambient);
}

void StructureActor::setAppearance(const Appearance& appearance)
{
    m_appearance = appearance;
    m_appearance.opacity = std::clamp(appearance.opacity, 0.0, 1.0);
    Colour colour = m_appearance.colour;
    m_actor->GetProperty()->SetColor(colour.data());
    m_actor->GetProperty()->SetOpacity(m_appearance.opacity);
    m_actor->GetProperty()->SetBackfaceCulling(m_isClosed && m_appearance.opacity < 1.0);
    // Back faces are visible through the open end of a vessel: darker and without highlights, they read as the inner
    // side.
    vtkProperty* inside = m_actor->GetBackfaceProperty();
    inside->DeepCopy(m_actor->GetProperty());
    inside->SetSpecular(0.0);
    inside->SetColor(0.72 * colour[0], 0.72 * colour[1], 0.72 * colour[2]);
    m_actor->SetVisibility(m_appearance.isVisible && m_appearance.opacity > 0.0);
}

vtkPoints& StructureActor::points() const
{
    return *vtkPolyDataMapper::SafeDownCast(m_actor->GetMapper())->GetInput()->GetPoints();
}

} // namespace palpate::view
