// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/FileFrame.h>
#include <palpate/core/Status.h>
#include <palpate/core/TissueMapping.h>
#include <palpate/geometry/Repair.h>

#include <functional>
#include <vector>

namespace palpate::meshio::internal {

/// Reads a volume (`.vti`, `.mha`, `.mhd`, `.nrrd`, `.nhdr`, `.nii`, `.nii.gz`; LPS, mm, NIfTI converted to LPS) and
/// computes the palpable value at each vertex of a surface: not the voxel at the surface, which is half air, but the
/// geometric mean of two means over the tissue below, weighted by the local fraction of the press's energy. A press on
/// a half-space of varying modulus responds between the harmonic and the arithmetic mean.
///
/// `w(r, z) = (6c/pi) z^2 / (r^2 + (z + c)^2)^3`, c = a/pi, for a contact of radius a = `contactRadius_mm`.
/// @return NaN where less than half of the weight falls on known values above 0
/// @par Source resources/docs/maps.md
/// @param frame  frame chosen for the surface mesh; also used for a volume file that states no space (`.vti`, NRRD
/// without `space`)
/// @param keepGoing  called periodically, on the calling thread; false cancels
[[nodiscard]] core::Result<std::vector<float>> sampleVolume(const core::TissueMapping& mapping,
                                                            const geometry::RepairedMesh& surface,
                                                            core::FileFrame frame = core::FileFrame::Untagged,
                                                            const std::function<bool()>& keepGoing = {});

} // namespace palpate::meshio::internal
