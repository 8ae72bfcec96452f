// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/ImageSlice.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace palpate::view {

ImageSlice::ImageSlice()
    : m_actor(vtkSmartPointer<vtkActor>::New())
    , m_texture(vtkSmartPointer<vtkTexture>::New())
{
    vtkNew<vtkPolyDataMapper> mapper;
    m_actor->SetMapper(mapper);
    m_actor->SetTexture(m_texture);
    m_actor->GetProperty()->LightingOff();
    m_actor->PickableOff();
    m_actor->VisibilityOff();
    m_actor->ForceOpaqueOn();
    m_texture->InterpolateOn();
    m_texture->SetColorModeToDirectScalars();
}

void ImageSlice::addTo(vtkRenderer& solid)
{
    solid.AddActor(m_actor);
}

void ImageSlice::hide()
{
    m_actor->VisibilityOff();
}

bool ImageSlice::show(const geometry::SectionPlane& plane)
{
    const geometry::VolumeSlice slice =
        m_volume != nullptr ? geometry::sliceOf(*m_volume, plane, m_window) : geometry::VolumeSlice();
    m_actor->SetVisibility(!slice.outline.empty());
    if (slice.outline.empty()) {
        return false;
    }
    vtkNew<vtkImageData> picture;
    picture->SetDimensions(slice.columns, slice.rows, 1);
    picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* pixels = static_cast<unsigned char*>(picture->GetScalarPointer());
    for (const std::uint8_t grey : slice.greys) {
        pixels = std::fill_n(pixels, 3, grey);
    }
    m_texture->SetInputData(picture);
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> places;
    places->SetNumberOfComponents(2);
    std::vector<vtkIdType> corners;
    for (const Eigen::Vector2d& q : slice.outline) {
        corners.push_back(points->InsertNextPoint(plane.inWorld(q).data()));
        const Eigen::Vector2d share = (q - slice.box.min()).cwiseQuotient(slice.box.sizes());
        const std::array<float, 2> place{static_cast<float>(share.x()), static_cast<float>(share.y())};
        places->InsertNextTypedTuple(place.data());
    }
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
    vtkNew<vtkPolyData> shape;
    shape->SetPoints(points);
    shape->SetPolys(cells);
    shape->GetPointData()->SetTCoords(places);
    vtkPolyDataMapper::SafeDownCast(m_actor->GetMapper())->SetInputData(shape);
    return true;
}

} // namespace palpate::view
