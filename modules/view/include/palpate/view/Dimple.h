// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/Billboard.h"
#include "palpate/view/TouchCursor.h"

#include <vtkActor.h>

namespace palpate::view {

/// The dent under the fingertip as it is drawn: all tissue bends with it, and a fine grid that belongs to the tissue
/// shows how. What is touched is not bent: the god-object stays on the surface as it was loaded.
///
/// Of a press with the bell-shaped pressure F c / (2 pi (r² + c²)^(3/2)) on an incompressible half-space (Boussinesq's
/// solution with its source moved up by c; Johnson, Contact Mechanics, 1985, chapter 3): with R² = r² + (z + c)²,
/// u = d c (e / R + z S / R³), where e points into the tissue, z is the depth below the surface and S leads from the
/// source to the point. On the surface that is d c / sqrt(r² + c²) straight in and nothing sideways. c = a / pi.
/// Beyond d = 27/8 c that folds below the surface, as linear elasticity does: from 3 c on, z counts in u as 3 c / d of
/// it, so that a lump is pushed ahead of the surface that comes down on it.
struct Dimple
{
    static constexpr double kPointRadius_mm = 5.0;      ///< a of a hand that is a point: a fingertip's
    static constexpr double kRigid_N_per_mm = 2.0;      ///< stiffer is drawn as bone is: not bent
    static constexpr double kUnfolded = 3.0;            ///< depth up to which z counts in full, in c
    static constexpr double kFadeFrom = 6.0, kTo = 8.0; ///< no tissue moves beyond `kTo` a from the contact

    Vec3 p_W = Vec3::Zero();  ///< contact on the surface at rest [mm]
    Vec3 n_W = Vec3::UnitZ(); ///< unit normal there, outwards
    double depth_mm = 0.0;    ///< d of the finger below it; 0: nothing is bent
    double radius_mm = 0.0;   ///< a

    /// @return nothing bent where there is no contact, no normal or `state.bends` is off
    [[nodiscard]] static Dimple of(const TouchState& state);

    /// How far tissue that lies at `rest_W` moves, without the fading. [mm]
    /// @param rest_W  world frame [mm]; above the surface it counts as on it
    [[nodiscard]] Vec3 displacement_W(const Vec3& rest_W) const;
    /// Whether anything in a box may move.
    [[nodiscard]] bool reaches(const core::Box& box) const;
};

/// Puts the dent into an actor's shaders, which keep its colours and lines: it costs a tenth of a frame where the
/// processor draws, so only while it is pressed near there.
/// @param actor  mapped by a vtkPolyDataMapper, with normals at its points and without a matrix of its own
void startBending(vtkActor& actor);
void stopBending(vtkActor& actor);

/// Draws an actor that has started to bend with this dent. @param frame  of the picture that follows
void bend(vtkActor& actor, const Dimple& dimple, const ViewFrame& frame);

} // namespace palpate::view
