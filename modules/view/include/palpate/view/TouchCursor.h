// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"
#include "palpate/view/ForceArrow.h"
#include "palpate/view/TouchLabels.h"

#include <palpate/core/Export.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>

namespace palpate::view {

/// State of one servo tick as shown by the cursor.
struct TouchState
{
    Vec3 p_WH = Vec3::Zero();  ///< HIP [mm]
    Vec3 p_WG = Vec3::Zero();  ///< god-object [mm]
    Vec3 n_W = Vec3::Zero();   ///< unit normal of the surface at the contact; zero: unknown
    Vec3 f_W = Vec3::Zero();   ///< force on the hand [N]
    double fingertip_mm = 0.0; ///< radius of the contact ball [mm], 0: a point
    /// Contact on the surface: the god-object of a ball is its centre. [mm]
    [[nodiscard]] Vec3 onSurface_W() const { return p_WG - fingertip_mm * n_W; }
    bool isInContact = false;
    bool isPresent = false;    ///< false: no hand; nothing is drawn
    bool hasCrosshair = false; ///< shows a crosshair, because the hand is moved by keys without a pointer
    bool bends = false;        ///< draws the tissue with a dent under the hand; false for rigid structures

    /// Disc on the surface within which friction holds the god-object, around its position without friction.
    struct FrictionDisc
    {
        Vec3 p_W = Vec3::Zero();  ///< [mm]
        Vec3 n_W = Vec3::UnitZ(); ///< unit normal of the surface
        double radius_mm = 0.0;   ///< 0: no friction disc
    };
    FrictionDisc friction{};

    /// God-object of a layer below the outermost layer.
    struct Inner
    {
        Vec3 p_WG = Vec3::Zero(); ///< [mm]
        Colour colour{};          ///< colour of the layer's structure
        double depth_mm = 0.0;    ///< penetration depth of the HIP below the god-object
    };
    static constexpr std::size_t kMostInner = 3;
    std::array<Inner, kMostInner> inner{};
    std::size_t innerCount = 0; ///< number of valid entries, outermost layer first
};

/// Touch cursor: the god-object as a ball on the surface with a contact disc, the HIP as a small ring, a line between
/// them labelled with the penetration depth in mm, and the force. God-objects of inner layers are discs in the
/// colours of their structures; from each disc on, the line has the disc's colour and a depth label. A faint disc
/// shows where friction holds. Sizes are in screen pixels, so the cursor is readable on a vessel as well as on a
/// whole body.
class PALPATE_EXPORT TouchCursor
{
  public:
    static constexpr double kBall_px = 12.0; ///< diameter
    static constexpr double kPatch_mm = 3.0; ///< radius of the contact disc of a point-like hand
    static constexpr double kSmallestPatch_px = 15.0, kLargestPatch_px = 40.0; ///< limits of that radius on screen

    TouchCursor();

    /// Adds the actors. @param solid  contains the tissue, which may hide the ball; @param overlay  drawn on top,
    /// same camera
    void addTo(vtkRenderer& solid, vtkRenderer& overlay);
    /// Sets the state for the next `place`. @param state  positions in the world frame
    void setState(const TouchState& state) { m_state = state; }
    [[nodiscard]] const TouchState& state() const noexcept { return m_state; }
    /// Draws ball and contact disc at the bottom of the dent where tissue bends; otherwise on the surface at rest.
    void setInDent(bool isOn) { m_drawsInDent = isOn; }
    /// Sets the force that maps to the brightest colour: the device's maximum. [N] > 0
    void setForceLimit(double force_N);

    /// Fits all parts to the view. Call before each frame.
    /// @param taken  boxes that labels avoid, logical pixels from the centre of the view
    void place(const ViewFrame& frame, const std::vector<Eigen::AlignedBox2d>& taken = {});

    /// Bounding box of the cursor, for the clipping range [mm]; empty when hidden.
    [[nodiscard]] core::Box bounds() const;
    /// Boxes around ball and HIP ring after `place`; empty without a hand. [logical px from the centre of the view]
    [[nodiscard]] std::vector<Eigen::AlignedBox2d> marks_px(const ViewFrame& frame) const;
    [[nodiscard]] Colour ballColour() const;
    [[nodiscard]] vtkActor* ball() const noexcept { return m_ball; }
    [[nodiscard]] vtkActor* hipRing() const noexcept { return m_hip; }
    [[nodiscard]] vtkActor* springLine() const noexcept { return m_spring.actor(); }
    [[nodiscard]] vtkActor* frictionDisc() const noexcept { return m_disc; }
    /// @param i  < TouchState::kMostInner
    [[nodiscard]] vtkActor* innerMark(std::size_t i) const noexcept { return m_inner[i].mark; }
    [[nodiscard]] vtkActor* contactDisc() const noexcept { return m_patch; }
    /// Part of the line inside an inner layer. @param i  < TouchState::kMostInner
    [[nodiscard]] vtkActor* innerLine(std::size_t i) const noexcept { return m_inner[i].line.actor(); }
    [[nodiscard]] vtkActor* crosshair(std::size_t i) const noexcept { return m_cross[i].actor(); } ///< i < 4
    [[nodiscard]] const ForceArrow& arrow() const noexcept { return m_arrow; }
    [[nodiscard]] const TouchLabels& labels() const noexcept { return m_labels; }

  private:
    void placeContact(const ViewFrame& frame, bool isTouching);
    void placeCrosshair(const ViewFrame& frame, bool isThere);
    [[nodiscard]] Vec3 dentOffset_W() const;
    void placeLabels(const ViewFrame& frame, bool isTouching, const std::vector<Eigen::AlignedBox2d>& others);
    [[nodiscard]] double patchRadius_mm(const ViewFrame& frame) const;
    void placeFriction(bool isTouching);
    void placeInner(const ViewFrame& frame, bool isTouching);

    vtkSmartPointer<vtkActor> m_ball;
    vtkSmartPointer<vtkActor> m_rim;
    vtkSmartPointer<vtkActor> m_outlineDark;
    vtkSmartPointer<vtkActor> m_outline;
    vtkSmartPointer<vtkActor> m_hipDark;
    vtkSmartPointer<vtkActor> m_hip;
    vtkSmartPointer<vtkActor> m_disc, m_discRim;                ///< friction
    vtkSmartPointer<vtkActor> m_patch, m_patchDark, m_patchRim; ///< contact
    double m_patch_mm = 0.0;                                    ///< radius of the contact disc as last drawn; 0: hidden
    BillboardLine m_springDark;
    BillboardLine m_spring;
    ForceArrow m_arrow;
    TouchLabels m_labels;
    std::array<BillboardLine, 4> m_crossDark, m_cross;
    /// Disc in the colour of its structure with a light and a dark edge, visible through covering tissue.
    struct InnerMark
    {
        vtkSmartPointer<vtkActor> dark, light, mark;
        BillboardLine line{3.6, {}}; ///< from the disc to the HIP
    };
    std::array<InnerMark, TouchState::kMostInner> m_inner;
    TouchState m_state;
    double m_limit_N = 10.0;
    bool m_drawsInDent = false;
};

} // namespace palpate::view
