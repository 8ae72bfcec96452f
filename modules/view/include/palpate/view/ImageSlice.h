// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/geometry/VoxelVolume.h>

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <memory>

namespace palpate::view {

/// Slice of an image, such as a CT, in the plane of a section.
/// @par Thread The view's.
class PALPATE_EXPORT ImageSlice
{
  public:
    ImageSlice();
    /// Adds the actor. @param solid  contains the tissue; must outlive this
    void addTo(vtkRenderer& solid);
    /// @param volume  null: no image
    void setVolume(std::shared_ptr<const geometry::VoxelVolume> volume) { m_volume = std::move(volume); }
    void setWindow(const geometry::GreyWindow& window) { m_window = window; }
    [[nodiscard]] const geometry::VoxelVolume* volume() const noexcept { return m_volume.get(); }
    /// Draws the slice. @return false without an image, or if the plane misses the image
    bool show(const geometry::SectionPlane& plane);
    void hide();
    [[nodiscard]] bool isShown() const { return m_actor->GetVisibility() != 0; }

  private:
    std::shared_ptr<const geometry::VoxelVolume> m_volume;
    geometry::GreyWindow m_window;
    vtkSmartPointer<vtkActor> m_actor;
    vtkSmartPointer<vtkTexture> m_texture;
};

} // namespace palpate::view
