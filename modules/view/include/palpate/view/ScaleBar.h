// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"

#include <vtkActor2D.h>
#include <vtkTextActor.h>

#include <string>

namespace palpate::view {

/// Length of a scale bar: 1, 2 or 5 times a power of ten, the longest that is no longer than `longest_mm`. [mm]
[[nodiscard]] double roundScaleLength(double longest_mm);

/// A bar in the lower right of the view with its length in mm, true at the depth of the camera's focus.
class ScaleBar
{
  public:
    ScaleBar();
    void addTo(vtkRenderer& renderer);
    /// @param focus_W  where the bar's length holds
    void place(const Vec3& focus_W, const ViewFrame& frame, int width_px);
    /// Where it ends after `place`. [device px above the view's lower edge]
    [[nodiscard]] double top() const noexcept { return m_top; }
    [[nodiscard]] const std::string& text() const noexcept { return m_caption; }
    void setColour(const Colour& colour);

  private:
    vtkSmartPointer<vtkActor2D> m_bar;
    vtkSmartPointer<vtkTextActor> m_text;
    std::string m_caption;
    double m_top = 0.0;
};

} // namespace palpate::view
