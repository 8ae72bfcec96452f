// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"

#include <vtkBillboardTextActor3D.h>

#include <string>

namespace palpate::view {

/// The force on the hand as an arrow: its length is the force, its thickness on screen constant, its value beside the
/// tip.
class ForceArrow
{
  public:
    static constexpr double kLength_mm_per_N = 8.0;
    static constexpr double kLongest = 0.3; ///< of the view's height: a hard push must not leave the view

    ForceArrow();
    ~ForceArrow();
    ForceArrow(const ForceArrow&) = delete;
    ForceArrow& operator=(const ForceArrow&) = delete;

    /// @param solid  for the arrow, which surfaces may hide; @param overlay  for the value, which nothing hides
    void addTo(vtkRenderer& solid, vtkRenderer& overlay);
    void setVisible(bool isVisible);
    /// @param gap_px  between `p_W` and the arrow's start, for the ball that sits there
    void place(const Vec3& p_W, const Vec3& f_W, const Colour& colour, double gap_px, const ViewFrame& frame);

    /// Length drawn last [mm], and the value's text: "2.31 N".
    [[nodiscard]] double length_mm() const noexcept { return m_length_mm; }
    [[nodiscard]] std::string label() const;

  private:
    vtkSmartPointer<vtkActor> m_shaft;
    vtkSmartPointer<vtkActor> m_head;
    vtkSmartPointer<vtkBillboardTextActor3D> m_label;
    double m_length_mm = 0.0;
};

} // namespace palpate::view
