// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace palpate::view {

/// A cube in the lower left of the view that turns with it and names the patient's sides: R L A P S I.
class OrientationCube
{
  public:
    OrientationCube();
    [[nodiscard]] vtkRenderer* renderer() const noexcept { return m_renderer; }
    /// @param main  the view's camera; @param size_px  of the whole window, device pixels
    void place(vtkCamera& main, const int size_px[2], double pixelRatio);

  private:
    vtkSmartPointer<vtkRenderer> m_renderer;
};

} // namespace palpate::view
