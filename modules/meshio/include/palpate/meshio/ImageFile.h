// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/FileFrame.h>
#include <palpate/core/Status.h>
#include <palpate/geometry/VoxelVolume.h>

#include <filesystem>
#include <functional>

namespace palpate::meshio {

/// Reads an image volume, such as a CT (`.vti`, `.mha`, `.mhd`, `.nrrd`, `.nhdr`, `.nii`, `.nii.gz`; mm; NIfTI and RAS
/// volumes are converted to LPS), in a child process with an import server, otherwise in this process.
/// @param frame  axes for a file without a stated space (`.vti`, NRRD without `space`)
/// @param progress  progress callback (0 to 1); return false to cancel. Called on this thread. May be empty
/// @return on failure one line with the file, the found and the expected value
/// @par Thread Any.
[[nodiscard]] PALPATE_EXPORT core::Result<geometry::VoxelVolume>
readImage(const std::filesystem::path& path, core::FileFrame frame = core::FileFrame::Untagged,
          const std::function<bool(double)>& progress = {});

} // namespace palpate::meshio
