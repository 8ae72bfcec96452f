// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"
#include "palpate/view/ForceArrow.h"
#include "palpate/view/TouchLabels.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>

namespace palpate::view {

/// What the cursor shows of one tick.
struct TouchState
{
    Vec3 p_WH = Vec3::Zero();  ///< HIP [mm]
    Vec3 p_WG = Vec3::Zero();  ///< god-object [mm]
    Vec3 n_W = Vec3::Zero();   ///< unit normal of the surface at the contact; zero: not known
    Vec3 f_W = Vec3::Zero();   ///< force on the hand [N]
    double fingertip_mm = 0.0; ///< radius of the ball that touches, 0 = a point
    bool isInContact = false;
    bool isPresent = false;    ///< false: no hand, nothing is drawn
    bool hasCrosshair = false; ///< the hand is moved by keys: no pointer shows where it is
    bool bends = false;        ///< the tissue is drawn with a dent under the hand: it is none of bone's kind

    /// Where friction holds the god-object: a disc about where it would stand without.
    struct FrictionDisc
    {
        Vec3 p_W = Vec3::Zero();  ///< [mm]
        Vec3 n_W = Vec3::UnitZ(); ///< unit normal of the surface
        double radius_mm = 0.0;   ///< 0: none
    };
    FrictionDisc friction{};

    /// A god-object that a layer below the outermost one holds.
    struct Inner
    {
        Vec3 p_WG = Vec3::Zero(); ///< [mm]
        Colour colour{};          ///< of its structure
        double depth_mm = 0.0;    ///< of the HIP below it
    };
    static constexpr std::size_t kMostInner = 3;
    std::array<Inner, kMostInner> inner{};
    std::size_t innerCount = 0; ///< how many of them are valid, the outermost first
};

/// The hand in the view: the god-object as a ball on the surface in a disc that lies on it, the HIP as a small ring,
/// the way from one to the other as a line with its millimetres, and the force. God-objects of inner layers are discs
/// in their structures' colours, from which the line goes on in that colour, with its millimetres too; a faint disc
/// shows where friction holds. Sizes are of the screen, so it reads the same on a vessel and on a body.
class TouchCursor
{
  public:
    static constexpr double kBall_px = 12.0; ///< diameter
    static constexpr double kPatch_mm = 3.0; ///< radius of the disc on the surface about a point, …
    static constexpr double kSmallestPatch_px = 15.0, kLargestPatch_px = 40.0; ///< … on screen between these

    TouchCursor();

    /// @param solid  holds the tissue, which may hide the ball; @param overlay  drawn over it, sharing its camera
    void addTo(vtkRenderer& solid, vtkRenderer& overlay);
    /// @param state  drawn from the next `place` on
    void setState(const TouchState& state) { m_state = state; }
    [[nodiscard]] const TouchState& state() const noexcept { return m_state; }
    /// Draws ball and contact disc at the bottom of the dent, where the tissue bends; else on the surface at rest.
    void setInDent(bool isOn) { m_isInDent = isOn; }
    /// The force that gets the brightest colour: what the device can give. [N] > 0
    void setForceLimit(double force_N);

    /// Fits everything to the view. Before each frame.
    /// @param taken  what its labels stay clear of, logical pixels from the view's middle; empty: nothing
    void place(const ViewFrame& frame, const Eigen::AlignedBox2d& taken = {});

    /// Box of what is drawn, for the clipping range [mm]; empty when hidden.
    [[nodiscard]] core::Box bounds() const;
    /// Boxes about ball and ring, after `place`; none when no hand is drawn. [logical px from the view's middle]
    [[nodiscard]] std::vector<Eigen::AlignedBox2d> marks_px(const ViewFrame& frame) const;
    [[nodiscard]] Colour ballColour() const;
    [[nodiscard]] vtkActor* ball() const noexcept { return m_ball; }
    [[nodiscard]] vtkActor* hipRing() const noexcept { return m_hip; }
    [[nodiscard]] vtkActor* springLine() const noexcept { return m_spring.actor(); }
    [[nodiscard]] vtkActor* frictionDisc() const noexcept { return m_disc; }
    /// @param i  < TouchState::kMostInner
    [[nodiscard]] vtkActor* innerMark(std::size_t i) const noexcept { return m_inner[i].mark; }
    [[nodiscard]] vtkActor* contactDisc() const noexcept { return m_patch; }
    /// The part of the line that lies in an inner layer. @param i  < TouchState::kMostInner
    [[nodiscard]] vtkActor* innerLine(std::size_t i) const noexcept { return m_inner[i].line.actor(); }
    [[nodiscard]] vtkActor* crosshair(std::size_t i) const noexcept { return m_cross[i].actor(); } ///< i < 4
    [[nodiscard]] const ForceArrow& arrow() const noexcept { return m_arrow; }
    [[nodiscard]] const TouchLabels& labels() const noexcept { return m_labels; }

  private:
    void placeContact(const ViewFrame& frame, bool isTouching);
    void placeCrosshair(const ViewFrame& frame, bool isThere);
    [[nodiscard]] Vec3 sunk_W() const;
    void placeLabels(const ViewFrame& frame, bool isTouching, const Eigen::AlignedBox2d& legend);
    [[nodiscard]] double patchRadius_mm(const ViewFrame& frame) const;
    void placeFriction(bool isTouching);
    void placeInner(const ViewFrame& frame, bool isTouching);

    vtkSmartPointer<vtkActor> m_ball;
    vtkSmartPointer<vtkActor> m_rim;
    vtkSmartPointer<vtkActor> m_outlineDark;
    vtkSmartPointer<vtkActor> m_outline;
    vtkSmartPointer<vtkActor> m_hipDark;
    vtkSmartPointer<vtkActor> m_hip;
    vtkSmartPointer<vtkActor> m_disc, m_discRim;                ///< of friction
    vtkSmartPointer<vtkActor> m_patch, m_patchDark, m_patchRim; ///< of the contact
    double m_patch_mm = 0.0;                                    ///< its radius as drawn last, 0: none
    BillboardLine m_springDark;
    BillboardLine m_spring;
    ForceArrow m_arrow;
    TouchLabels m_labels;
    std::array<BillboardLine, 4> m_crossDark, m_cross;
    /// A disc in its structure's colour with a light and a dark edge: seen through what covers it.
    struct InnerMark
    {
        vtkSmartPointer<vtkActor> dark, light, mark;
        BillboardLine line{3.6, {}}; ///< from it to the HIP
    };
    std::array<InnerMark, TouchState::kMostInner> m_inner;
    TouchState m_state;
    double m_limit_N = 10.0;
    bool m_isInDent = false;
};

} // namespace palpate::view
