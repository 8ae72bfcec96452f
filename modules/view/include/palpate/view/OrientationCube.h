// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"

#include <palpate/core/Export.h>

#include <vtkAnnotatedCubeActor.h>
#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <string>

namespace palpate::view {

/// Orientation cube in the lower left of the view. Faces are labelled R, L, A, P, S, I, each with a question mark
/// while the orientation of the meshes is not known for certain.
class PALPATE_EXPORT OrientationCube
{
  public:
    OrientationCube();
    [[nodiscard]] vtkRenderer* renderer() const noexcept { return m_renderer; }
    /// Sets the labels. @param isKnown  false: the orientation is not known and labels get a question mark, "A?"
    void setSidesKnown(bool isKnown);
    /// Label of the patient's left: "L" or "L?".
    [[nodiscard]] std::string left() const;
    /// Updates the cube. @param main  camera of the main view; @param size_px  size of the window, device pixels
    /// @param below_px  height of the window's bottom that something covers [logical px]
    void place(vtkCamera& main, const int size_px[2], const ViewFrame& frame, double below_px = 0.0);
    /// Upper edge as last placed. [logical px]
    [[nodiscard]] double top_px() const noexcept { return m_top_px; }

  private:
    vtkSmartPointer<vtkAnnotatedCubeActor> m_cube;
    vtkSmartPointer<vtkRenderer> m_renderer;
    double m_top_px = 0.0;
};

} // namespace palpate::view
