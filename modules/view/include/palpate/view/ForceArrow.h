// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"

#include <string>

namespace palpate::view {

/// The force on the hand. Seen from the side it is an arrow whose length is the force; as it turns to the viewer, where
/// an arrow is a dot, a circle about its start takes over, the wider the greater the force. Thickness on screen is
/// constant.
class ForceArrow
{
  public:
    static constexpr double kLength_mm_per_N = 8.0;
    static constexpr double kLongest = 0.3;     ///< of the view's height: a hard push must not leave the view
    static constexpr double kRadius = 0.4;      ///< of the arrow's length, beyond the ball
    static constexpr double kArrowOnly = 0.80;  ///< cosine to the line of sight below which it is an arrow (37°)
    static constexpr double kCircleOnly = 0.94; ///< above which it is a circle (20°)

    ForceArrow();

    /// @param solid  for the arrow, which surfaces may hide; @param overlay  for the circle, which nothing hides
    void addTo(vtkRenderer& solid, vtkRenderer& overlay);
    void setVisible(bool isVisible);
    /// @param gap_px  between `p_W` and the arrow's start, for the ball that sits there
    void place(const Vec3& p_W, const Vec3& f_W, const Colour& colour, double gap_px, const ViewFrame& frame);

    /// Length that the force has as an arrow [mm], and its value: "2.31 N".
    [[nodiscard]] double length_mm() const noexcept { return m_length_mm; }
    [[nodiscard]] const std::string& label() const noexcept { return m_label; }
    /// Where the arrow that was drawn last ends. [mm]
    [[nodiscard]] const Vec3& tip_W() const noexcept { return m_tip_W; }
    /// Of the circle drawn last, 0: none. [px]
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
