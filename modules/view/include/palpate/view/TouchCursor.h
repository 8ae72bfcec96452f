// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"
#include "palpate/view/ForceArrow.h"

namespace palpate::view {

/// What the cursor shows of one tick.
struct TouchState
{
    Vec3 p_WH = Vec3::Zero();  ///< HIP [mm]
    Vec3 p_WG = Vec3::Zero();  ///< god-object [mm]
    Vec3 f_W = Vec3::Zero();   ///< force on the hand [N]
    double fingertip_mm = 0.0; ///< radius of the ball that touches, 0 = a point
    bool isInContact = false;
    bool isPresent = false; ///< false: no hand, nothing is drawn
};

/// The hand in the view: the god-object as a ball on the surface, the HIP as a small ring, the spring between them and
/// the force. Sizes are of the screen, so it reads the same on a vessel and on a body.
class TouchCursor
{
  public:
    static constexpr double kBall_px = 12.0; ///< diameter

    TouchCursor();

    /// @param solid  holds the tissue, which may hide the ball; @param overlay  drawn over it, sharing its camera
    void addTo(vtkRenderer& solid, vtkRenderer& overlay);
    /// @param state  drawn from the next `place` on
    void setState(const TouchState& state) { m_state = state; }
    [[nodiscard]] const TouchState& state() const noexcept { return m_state; }
    /// The force that gets the brightest colour: what the device can give. [N] > 0
    void setForceLimit(double force_N);

    /// Fits everything to the view. Before each frame.
    void place(const ViewFrame& frame);

    /// Box of what is drawn, for the clipping range [mm]; empty when hidden.
    [[nodiscard]] core::Box bounds() const;
    [[nodiscard]] Colour ballColour() const;
    [[nodiscard]] vtkActor* ball() const noexcept { return m_ball; }
    [[nodiscard]] vtkActor* hipRing() const noexcept { return m_hip; }
    [[nodiscard]] vtkActor* springLine() const noexcept { return m_spring.actor(); }
    [[nodiscard]] const ForceArrow& arrow() const noexcept { return m_arrow; }

  private:
    vtkSmartPointer<vtkActor> m_ball;
    vtkSmartPointer<vtkActor> m_rim;
    vtkSmartPointer<vtkActor> m_outlineDark;
    vtkSmartPointer<vtkActor> m_outline;
    vtkSmartPointer<vtkActor> m_hipDark;
    vtkSmartPointer<vtkActor> m_hip;
    BillboardLine m_springDark;
    BillboardLine m_spring;
    ForceArrow m_arrow;
    TouchState m_state;
    double m_limit_N = 10.0;
};

} // namespace palpate::view
