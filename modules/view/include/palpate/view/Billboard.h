// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/ColourMap.h"
#include "palpate/view/TextStyle.h"

#include <palpate/core/Export.h>
#include <palpate/core/Types.h>

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace palpate::view {

using core::Vec3;

/// Colour of the dark rim around shapes, which keeps them visible on bright tissue.
inline constexpr Colour kDarkRim{0.07, 0.08, 0.10};

/// View parameters for shapes of constant size on screen: camera axes and the size of a pixel at each depth.
struct PALPATE_EXPORT ViewFrame
{
    Vec3 eye_W = Vec3::Zero();
    Vec3 right_W = Vec3::UnitX();
    Vec3 up_W = Vec3::UnitY();
    Vec3 back_W = Vec3::UnitZ(); ///< towards the viewer
    double width_px = 1.0, height_px = 1.0;
    double scale = 1.0; ///< perspective: height of the view at distance 1; parallel: height of the view [mm]
    bool isParallel = false;
    double pixelRatio = 1.0; ///< device pixels per logical pixel
    TextStyle text{};

    /// Reads the camera and size of a renderer. @param pixelRatio  device pixels per logical pixel
    [[nodiscard]] static ViewFrame of(vtkRenderer& renderer, double pixelRatio);
    /// Size of a logical pixel at `p_W`. [mm]
    [[nodiscard]] double mmPerPixel(const Vec3& p_W) const;
    /// Projects a point: logical pixels from the centre of the view, x right, y up.
    [[nodiscard]] Eigen::Vector2d pixelOf(const Vec3& p_W) const;
    /// Unit vector from `p_W` towards the viewer's eye.
    [[nodiscard]] Vec3 towardsViewer(const Vec3& p_W) const;

    friend bool operator==(const ViewFrame&, const ViewFrame&) = default;
};

/// Turns an unlit flat shape to face the viewer at `p_W`. The shape is modelled in pixels: x right, y up, z to the
/// viewer.
PALPATE_EXPORT void placeBillboard(vtkActor& actor, const Vec3& p_W, const ViewFrame& frame);

/// Makes a flat ring for `placeBillboard`. @param lift_px  offset towards the viewer, which orders rings at one point
[[nodiscard]] PALPATE_EXPORT vtkSmartPointer<vtkActor> makeRing(double inner_px, double outer_px, const Colour& colour,
                                                                double lift_px);

/// Straight line of constant width on screen that faces the viewer.
class PALPATE_EXPORT BillboardLine
{
  public:
    BillboardLine(double width_px, const Colour& colour);
    void place(const Vec3& from_W, const Vec3& to_W, const ViewFrame& frame);
    [[nodiscard]] vtkActor* actor() const noexcept { return m_actor; }

  private:
    vtkSmartPointer<vtkActor> m_actor;
    double m_width_px;
};

/// Circle of constant line width on screen and variable radius that faces the viewer.
class PALPATE_EXPORT BillboardCircle
{
  public:
    BillboardCircle(double width_px, const Colour& colour);
    void place(const Vec3& p_W, double radius_px, const ViewFrame& frame);
    [[nodiscard]] vtkActor* actor() const noexcept { return m_actor; }

  private:
    vtkSmartPointer<vtkActor> m_actor;
    double m_width_px;
};

} // namespace palpate::view
