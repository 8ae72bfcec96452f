// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/ImageFile.h"

#include "read/VolumeFile.h"

namespace palpate::meshio {

core::Result<geometry::VoxelVolume> readImage(const std::filesystem::path& path, core::FileFrame frame,
                                              const std::function<bool(double)>& progress)
{
    return internal::readVolume(path, frame, progress);
}

} // namespace palpate::meshio
