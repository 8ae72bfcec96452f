// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"

#include <palpate/core/Export.h>

#include <vtkActor2D.h>
#include <vtkTextActor.h>

#include <string>

namespace palpate::view {

/// Length of a scale bar: the greatest 1, 2 or 5 times a power of ten that is at most `longest_mm`. [mm]
[[nodiscard]] PALPATE_EXPORT double roundScaleLength(double longest_mm);

/// Scale bar in the lower right of the view, labelled in mm. Exact at the depth of the camera's focal point.
class PALPATE_EXPORT ScaleBar
{
  public:
    ScaleBar();
    void addTo(vtkRenderer& renderer);
    /// Updates the bar. @param focus_W  point at which the length is exact [mm]
    /// @param below_px  height of the view's bottom that something covers [logical px]
    void place(const Vec3& focus_W, const ViewFrame& frame, int width_px, double below_px = 0.0);
    /// Upper edge after `place`. [device px above the lower edge of the view]
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
