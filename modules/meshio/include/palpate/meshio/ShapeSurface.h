// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/meshio/SceneFile.h"

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>
#include <palpate/geometry/Repair.h>
#include <palpate/geometry/Staircase.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace palpate::meshio {

/// Result of smoothing a surface.
struct PALPATE_EXPORT SurfaceSmoothing
{
    double most_mm = 0.0;          ///< largest vertex displacement [mm]
    double limit_mm = 0.0;         ///< displacement limit along the longest voxel edge [mm]
    double volumeBefore_mm3 = 0.0; ///< enclosed volume regardless of orientation; 0 for an open surface [mm3]
    double volumeAfter_mm3 = 0.0;
    double strength = 0.0;    ///< SceneStructure::smoothing
    bool isWithdrawn = false; ///< the surface is unchanged, because it would have lost more than half of its volume
    std::optional<core::Vec3> labelVoxel_mm{}; ///< voxel size of the label map; empty for a mesh

    /// "smoothed: vertices moved by at most 0.62 mm, volume +0.31 %", or for a label map "surface from a label map of
    /// 0.8 × 0.8 × 5 mm voxels, smoothed by 0.5: volume changed by -0.40 %, at most 0.31 mm from the voxel boundary".
    /// The distance is that of the vertices from their places before.
    [[nodiscard]] core::Message sentence() const;
};

/// Result of curving the facets of a surface.
struct PALPATE_EXPORT SurfaceCurving
{
    std::size_t before = 0;        ///< triangles
    std::size_t triangles = 0;     ///< triangles afterwards, also if it was refused
    std::size_t flatTriangles = 0; ///< of `before`, kept flat because their patches would fold
    bool isRefused = false;        ///< more triangles than geometry::PnOptions::mostTriangles: facets are used

    [[nodiscard]] core::Message message() const;
};

/// Result of closing holes.
struct PALPATE_EXPORT HoleClosing
{
    std::size_t holes = 0;
    double largest_mm = 0.0; ///< across the largest
    double area_mm2 = 0.0;   ///< of the new triangles

    [[nodiscard]] core::Message message() const;
};

/// A surface for display and haptics, and the data of the processing steps.
struct ShapedSurface
{
    std::shared_ptr<const geometry::RepairedMesh> surface;
    std::optional<geometry::Staircase> staircase; ///< of the input surface
    std::optional<HoleClosing> closing{};
    std::optional<SurfaceSmoothing> smoothing{};
    std::optional<SurfaceCurving> curving{};
};

/// @return sentences on voxel steps and smoothing; the sentence on smoothing also names the voxels of a label map
[[nodiscard]] PALPATE_EXPORT std::vector<core::Message>
shapeSentences(const std::optional<geometry::Staircase>& staircase, const std::optional<SurfaceSmoothing>& smoothing);

/// Applies the surface options of a description to a repaired surface: closes holes
/// (`closeHoles_mm`; geometry::withHolesClosed), turns inverted closed parts (`outwards`), smooths (`surface`,
/// `smoothing`) and curves the facets (`surface`, `crease_deg`; geometry::pnTriangles). Does not change the input, and
/// returns the input itself when no option applies.
///
/// Smoothing is VTK's windowed sinc filter with the settings of 3D Slicer's closed surfaces: 20 iterations, pass band
/// 10^(-4 smoothing), boundary edges kept. No vertex moves by more than half a voxel along a voxel edge, so that the
/// smoothed surface remains consistent with the mask; corners of voxel faces, which are farther from the true surface,
/// move by up to one voxel. Without a staircase the limit is half the mean edge length along each axis.
///
/// At the usual strength, masks of a ball of 30 mm in voxels of 1 x 1 x 3, 0.8 x 0.8 x 2.5 and 1 x 1 x 1 mm give, at a
/// depth of 5 mm, the force of the true ball within 10 % and the direction within 24°, from 18° off the poles on.
/// A structure that would lose more than half of its volume, as one of a few voxels, is left as it is.
/// @param asRead  from geometry::repair, world frame [mm]; not null
/// @param known   staircase of `asRead` from a label map or an earlier call; empty: it is detected
/// @par Source Taubin, Zhang, Golub: Optimal Surface Smoothing as Filter Design (1996).
/// @par Cost About 1 us per triangle and iteration with smoothing, otherwise a few milliseconds. Any thread.
[[nodiscard]] PALPATE_EXPORT ShapedSurface shapeSurface(std::shared_ptr<const geometry::RepairedMesh> asRead,
                                                        const SceneStructure& description,
                                                        const std::optional<geometry::Staircase>& known = {});

} // namespace palpate::meshio
