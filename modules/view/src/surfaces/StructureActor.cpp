// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/StructureActor.h"

#include "palpate/view/FeltColours.h"
#include "palpate/view/MarginColours.h"
#include "surfaces/ArrayShader.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace palpate::view {

namespace {

vtkSmartPointer<vtkFloatArray> pointsOf(vtkPolyData& surface)
{
    return vtkFloatArray::SafeDownCast(surface.GetPoints()->GetData());
}

vtkSmartPointer<vtkFloatArray> normalsOf(vtkPolyData& surface)
{
    return vtkFloatArray::SafeDownCast(surface.GetPointData()->GetNormals());
}

constexpr double kAmbient = 0.06, kHighlight = 0.30; // ambient share of the colour

} // namespace

StructureActor::StructureActor(vtkPolyData* surface, const Appearance& appearance, bool isClosed)
    : m_actor(vtkSmartPointer<vtkActor>::New())
    , m_coarse(vtkSmartPointer<vtkActor>::New())
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
    vtkNew<vtkPolyDataMapper> coarseMapper;
    coarseMapper->ScalarVisibilityOff();
    m_coarse->SetMapper(coarseMapper);
    m_coarse->SetProperty(look);
    // Without a property of back faces, whose dark triangles would speckle thin bones.
    m_coarse->PickableOff();
    setAppearance(appearance);
}

void StructureActor::setPicture(vtkPolyData* surface)
{
    auto* mapper = vtkPolyDataMapper::SafeDownCast(m_actor->GetMapper());
    m_rest = surface;
    m_drawn = nullptr;
    mapper->SetInputData(surface);
    if (m_moved.motion != nullptr && m_moved.points->GetNumberOfTuples() == surface->GetNumberOfPoints()) {
        showMoved(); // another colouring of the same surface
    } else {
        m_moved = {};
    }
    const bool hasColours =
        surface->GetPointData()->GetScalars() != nullptr || surface->GetCellData()->GetScalars() != nullptr;
    mapper->SetScalarVisibility(hasColours);
    m_hasColours = hasColours || surface->GetPointData()->GetNumberOfArrays() > 1; // arrays colour in a shader
    m_hasCoarse = m_hasCoarse && m_coarseOf == surface->GetPolys();
    showEither();
    mapper->SetColorModeToDirectScalars();
    removeArrayShader(*m_actor);
    drawPalpabilityContours(*m_actor, *surface);
    drawMarginBands(*m_actor, *surface);
}

void StructureActor::moveTo(std::shared_ptr<const geometry::SurfaceMotion> motion, double time_s)
{
    m_motion = motion != nullptr && motion->isMoving() ? std::move(motion) : nullptr;
    m_time_s = time_s;
}

/// Returns true if the picture is where `moveTo` wants it.
bool StructureActor::isInPlace() const
{
    if (m_motion == nullptr || m_moved.motion == nullptr) {
        return m_motion == m_moved.motion;
    }
    return m_motion->shape() == m_moved.motion->shape() && isSamePlace(m_motion->at(m_time_s), m_moved.moment);
}

bool StructureActor::follow()
{
    bool hasChanged = false;
    if (m_next.valid()) {
        if (m_next.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
            return false;
        }
        MovedSurface next = m_next.get();
        if (next.points->GetNumberOfTuples() == m_rest->GetNumberOfPoints()) { // else of a picture before
            m_moved = std::move(next);
            showMoved();
            hasChanged = true;
        }
    }
    if (isInPlace()) {
        return hasChanged;
    }
    if (m_motion == nullptr) {
        m_moved = {};
        m_drawn = nullptr;
        vtkPolyDataMapper::SafeDownCast(m_actor->GetMapper())->SetInputData(m_rest);
        return true;
    }
    if (m_rest->GetNumberOfPoints() > kMostAtOnce) {
        m_next =
            std::async(std::launch::async, movedSurface, m_motion, m_time_s, pointsOf(*m_rest), normalsOf(*m_rest));
        return hasChanged;
    }
    m_moved = movedSurface(m_motion, m_time_s, pointsOf(*m_rest), normalsOf(*m_rest));
    showMoved();
    return true;
}

void StructureActor::showMoved()
{
    if (m_drawn == nullptr) {
        m_drawn = vtkSmartPointer<vtkPolyData>::New();
        m_drawn->ShallowCopy(m_rest);
        m_drawn->SetPoints(vtkNew<vtkPoints>());
        vtkPolyDataMapper::SafeDownCast(m_actor->GetMapper())->SetInputData(m_drawn);
    }
    m_drawn->GetPoints()->SetData(m_moved.points);
    m_drawn->GetPointData()->SetNormals(m_moved.normals);
    m_drawn->Modified();
}

Vec3 StructureActor::restOf(const Vec3& p_W) const
{
    return m_motion == nullptr ? p_W : m_motion->toRest(m_motion->at(m_time_s), p_W, p_W).X;
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
    m_coarse->GetMapper()->SetClippingPlanes(planes);
}

void StructureActor::setCoarsePicture(vtkPolyData* coarse)
{
    vtkPolyDataMapper::SafeDownCast(m_coarse->GetMapper())->SetInputData(coarse);
    m_coarseOf = m_rest->GetPolys();
    m_hasCoarse = true;
}

void StructureActor::setCoarse(bool isOn)
{
    m_isCoarse = isOn;
    showEither();
}

/// Shows one of the two pictures.
void StructureActor::showEither()
{
    const bool isShown = m_appearance.isVisible && m_appearance.opacity > 0.0;
    const bool isCoarse = m_isCoarse && m_hasCoarse && !m_hasColours && !m_isBent && m_moved.motion == nullptr;
    m_actor->SetVisibility(isShown && !isCoarse);
    m_coarse->SetVisibility(isShown && isCoarse);
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
    showEither();
}

vtkPoints& StructureActor::points() const
{
    return *vtkPolyDataMapper::SafeDownCast(m_actor->GetMapper())->GetInput()->GetPoints();
}

} // namespace palpate::view
