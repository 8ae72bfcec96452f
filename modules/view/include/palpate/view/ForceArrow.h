// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"

#include <palpate/core/Export.h>

#include <string>

namespace palpate::view {

/// Force on the hand. Seen from the side, the force is an arrow of proportional length. Seen end-on, where an arrow
/// shrinks to a dot, a circle around the start replaces the arrow; the radius grows with the force. Line widths are
/// constant on screen.
class PALPATE_EXPORT ForceArrow
{
  public:
    static constexpr double kLength_mm_per_N = 8.0;
    static constexpr double kLongest = 0.3; ///< in view heights, so that a strong force does not leave the view
    static constexpr double kRadius = 0.4;  ///< circle radius per arrow length, added to the radius of the ball
    static constexpr double kArrowOnly =
        0.80; ///< cosine of the angle to the line of sight below which only the arrow is shown (37°)
    static constexpr double kCircleOnly = 0.94; ///< cosine above which only the circle is shown (20°)

    ForceArrow();

    /// Adds the actors. @param solid  for the arrow, which tissue may hide; @param overlay  for the circle, always
    /// visible
    void addTo(vtkRenderer& solid, vtkRenderer& overlay);
    void setVisible(bool isVisible);
    /// Draws the force `f_W` [N] at `p_W`. @param gap_px  between `p_W` and the start of the arrow, to clear the ball
    void place(const Vec3& p_W, const Vec3& f_W, const Colour& colour, double gap_px, const ViewFrame& frame);

    /// Length of the arrow [mm], and the force as text: "2.31 N".
    [[nodiscard]] double length_mm() const noexcept { return m_length_mm; }
    [[nodiscard]] const std::string& label() const noexcept { return m_label; }
    /// Tip of the arrow as last drawn. [mm]
    [[nodiscard]] const Vec3& tip_W() const noexcept { return m_tip_W; }
    /// Radius of the circle as last drawn; 0: hidden. [px]
    [[nodiscard]] double radius_px() const noexcept { return m_radius_px; }
    [[nodiscard]] vtkActor* circle() const noexcept { return m_circle.actor(); }
    [[nodiscard]] vtkActor* shaft() const noexcept { return m_shaft; }

  private:
    vtkSmartPointer<vtkActor> m_shaft;
    vtkSmartPointer<vtkActor> m_head;
    BillboardCircle m_circleDark;
    BillboardCircle m_circle;
    std::string m_label;
    Vec3 m_tip_W = Vec3::Zero();
    double m_length_mm = 0.0;
    double m_radius_px = 0.0;
};

} // namespace palpate::view
