// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"
#include "palpate/view/TouchCursor.h"

#include <palpate/core/Export.h>

#include <vtkActor.h>

namespace palpate::view {

/// Dent under the fingertip, for display only: all tissue bends with the dent, and a fine grid fixed to the tissue
/// shows the shape. Contact computation is not affected: the god-object stays on the surface at rest. The
/// displacement is the field of the bell-shaped pressure F c / (2 pi (r² + c²)^(3/2)) on an incompressible
/// half-space: Boussinesq's solution with the source moved up by c (Johnson, Contact Mechanics, 1985, chapter 3).
/// With R² = r² + (z + c)²,
///
/// u = d c (e / R + z S / R³),
///
/// where e points into the tissue, z is the depth below the surface and S is the vector from the source to the point.
/// On the surface, u = d c / sqrt(r² + c²) along e, without a tangential component. c = a / pi. Linear elasticity
/// folds the tissue below the surface when d > 27/8 c. From d = 3 c on, z in u is therefore multiplied by 3 c / d, so
/// that the descending surface pushes a lump ahead.
struct PALPATE_EXPORT Dimple
{
    static constexpr double kPointRadius_mm = 5.0; ///< a of a point-like hand: radius of a fingertip
    static constexpr double kRigid_N_per_mm = 2.0; ///< stiffer structures are drawn rigid, like bone
    static constexpr double kUnfolded = 3.0;       ///< depth up to which z is not reduced, in units of c
    /// Fade-out range, in units of a from the contact: full displacement up to `kFadeFrom`, zero beyond `kTo`.
    static constexpr double kFadeFrom = 6.0, kTo = 8.0;

    Vec3 p_W = Vec3::Zero();  ///< contact point on the surface at rest [mm]
    Vec3 n_W = Vec3::UnitZ(); ///< outward unit normal at `p_W`
    double depth_mm = 0.0;    ///< penetration depth d of the finger [mm]; 0: no dent
    double radius_mm = 0.0;   ///< contact radius a [mm]

    /// Makes the dent of a touch state.
    /// @return a dent of depth 0 without contact, without a normal, or when `state.bends` is false
    [[nodiscard]] static Dimple of(const TouchState& state);

    /// Displacement of tissue at rest position `rest_W`, before fading. [mm]
    /// @param rest_W  world frame [mm]; points above the surface are treated as on the surface
    [[nodiscard]] Vec3 displacement_W(const Vec3& rest_W) const;
    /// Returns whether any point inside `box` may move.
    [[nodiscard]] bool reaches(const core::Box& box) const;
};

/// Adds the dent to an actor's shaders; colours and lines stay. With software rendering a bent actor costs a tenth of
/// a frame, so only actors near the contact are bent.
/// @param actor  mapped by a vtkPolyDataMapper, with point normals and without a user matrix
PALPATE_EXPORT void startBending(vtkActor& actor);
PALPATE_EXPORT void stopBending(vtkActor& actor);

/// Updates the dent of an actor prepared by `startBending`. @param frame  view parameters of the next frame
PALPATE_EXPORT void bend(vtkActor& actor, const Dimple& dimple, const ViewFrame& frame);

} // namespace palpate::view
