// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"

#include <vtkAnnotatedCubeActor.h>
#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <string>

namespace palpate::view {

/// A cube in the lower left of the view that turns with it and names the patient's sides: R L A P S I, each with a
/// question mark while it is not known whether they are right.
class OrientationCube
{
  public:
    OrientationCube();
    [[nodiscard]] vtkRenderer* renderer() const noexcept { return m_renderer; }
    /// @param isKnown  false: the meshes do not say how they lie, "A?"
    void setSidesKnown(bool isKnown);
    /// The patient's left as the cube names it: "L" or "L?".
    [[nodiscard]] std::string left() const;
    /// @param main  the view's camera; @param size_px  of the whole window, device pixels
    void place(vtkCamera& main, const int size_px[2], const ViewFrame& frame);
    /// Where it ends above, as placed last. [logical px]
    [[nodiscard]] double top_px() const noexcept { return m_top_px; }

  private:
    vtkSmartPointer<vtkAnnotatedCubeActor> m_cube;
    vtkSmartPointer<vtkRenderer> m_renderer;
    double m_top_px = 0.0;
};

} // namespace palpate::view
