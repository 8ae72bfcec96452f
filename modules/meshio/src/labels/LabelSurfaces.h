// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "labels/LabelVolume.h"

#include <palpate/core/Status.h>
#include <palpate/geometry/TriangleMesh.h>

#include <cstddef>
#include <cstdint>
#include <functional>

namespace palpate::meshio::internal {

/// Surface of a label.
struct LabelSurface
{
    geometry::TriangleMesh mesh;
    std::uint64_t enclosedVoxels = 0; ///< of other labels that the surface contains
};

/// Extracts one closed surface per label, halfway between its voxels and the others, also at the border of the volume.
/// A label also gets the voxels of other labels that it encloses, for example a tumour in an organ: the voxels of the
/// tumour are cut out of the organ's in a label map, and a surface with that cavity would not contain the tumour. A
/// cavity that contains background stays one.
///
/// Only the bounding box of a label is contoured, so that the work follows the size of the structures.
/// @param layout    of the volume, for the place of the voxels
/// @param take  receives the surface of each label, in the order of the labels, each as soon as it and those before it
/// are ready: in the axes of the file [mm], the normals outwards whatever the handedness of the axes. On the calling
/// thread; an error ends the work
/// @param progress  callback (0 to 1) on the calling thread; false cancels. May be empty
/// @return the error of `take`; false if cancelled
/// @par Source Schroeder, Maynard, Geveci: Flying Edges (2015); vtkDiscreteFlyingEdges3D, as in 3D Slicer
/// @par Cost About 10 ns per voxel of all bounding boxes. Uses all cores.
[[nodiscard]] core::Result<bool> labelSurfaces(const LabelVolume& volume, const VolumeLayout& layout,
                                               const std::function<core::Status(std::size_t, LabelSurface)>& take,
                                               const std::function<bool(double)>& progress);

} // namespace palpate::meshio::internal
