// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/meshio/SceneFile.h"

#include <palpate/geometry/MeshReport.h>
#include <palpate/geometry/Staircase.h>

#include <memory>
#include <optional>
#include <string>

namespace palpate::meshio {

/// What smoothing did to a surface.
struct SurfaceSmoothing
{
    double most_mm = 0.0;          ///< farthest that a vertex moved [mm]
    double limit_mm = 0.0;         ///< farthest that one may move, along the voxel's longest edge [mm]
    double volumeBefore_mm3 = 0.0; ///< enclosed, whichever way the normals point; 0 for an open surface [mm3]
    double volumeAfter_mm3 = 0.0;

    /// "smoothed: vertices moved by at most 0.62 mm, volume +0.31 %"
    [[nodiscard]] std::string sentence() const;
};

/// A surface as it is drawn and felt, and what led to it.
struct ShapedSurface
{
    std::shared_ptr<const geometry::RepairedMesh> surface;
    std::optional<geometry::Staircase> staircase; ///< of the surface that was given
    std::optional<SurfaceSmoothing> smoothing;
};

/// Makes of a repaired surface what its description asks for: closed parts that are inside out are turned
/// (`outwards`), and the surface is smoothed (`surface`, `smoothing`). The surface that was given is not changed, and
/// is itself returned where nothing is asked for.
///
/// Smoothing is VTK's windowed sinc filter with the settings of 3D Slicer's closed surfaces: 20 iterations, pass band
/// 10^(-4 smoothing), rims kept. No vertex moves by more than half a voxel along an edge of the voxels, so that the
/// smoothed surface is one that the same mask could stand for; the corners of voxel faces, which are farther from it,
/// by a whole one. Without a staircase the limit is half the mean length of an edge along each axis.
///
/// With the usual strength, masks of a ball of 30 mm in voxels of 1 x 1 x 3, 0.8 x 0.8 x 2.5 and 1 x 1 x 1 mm give a
/// hand 5 mm deep the force of the true ball within 10 %, and its direction within 24°, from 18° off the poles on.
/// @param asRead  from geometry::repair, world frame [mm]; not null
/// @par Source Taubin, Zhang, Golub: Optimal Surface Smoothing as Filter Design (1996).
/// @par Cost About 1 us a triangle and iteration where the surface is smoothed, else a few milliseconds. Any thread.
[[nodiscard]] ShapedSurface shapeSurface(std::shared_ptr<const geometry::RepairedMesh> asRead,
                                         const SceneStructure& description);

} // namespace palpate::meshio
