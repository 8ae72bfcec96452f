// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/FileFrame.h>
#include <palpate/core/Message.h>
#include <palpate/core/Status.h>
#include <palpate/core/Types.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::meshio::internal {

/// A mesh file that a multi-block file or a scene of 3D Slicer names, and what the scene says about it.
struct Block
{
    std::filesystem::path file;                    ///< absolute
    std::string name;                              ///< empty: by the mesh file
    std::optional<std::array<double, 3>> colour{}; ///< red, green, blue in 0 … 1
    double opacity = 1.0;                          ///< 0 … 1
    bool isVisible = true;
    double unit_mm = 1.0;                               ///< scale of the transform
    core::FileFrame frame = core::FileFrame::Untagged;  ///< of the coordinates, if stated
    core::Transform X_WM = core::Transform::Identity(); ///< mesh (mm) to world, in LPS
};

/// Files that another file names.
struct Blocks
{
    std::vector<Block> blocks;
    std::vector<core::Message> losses; ///< one line each: what the scene has and is not opened
};

/// @return true for a file that only names other files: a multi-block data set of VTK (.vtm), a collection of
/// ParaView (.pvd), partitioned data sets (.vtpd, .vtpc), or a scene of 3D Slicer (.mrml).
[[nodiscard]] bool isBlockFile(const std::filesystem::path& path);

/// @return a path of Windows with the separators of this system
[[nodiscard]] std::string withSlashes(std::string path);

/// Reads the names of the mesh files, also of files that other such files name, and numbers equal names. A file in
/// another folder tree, a collection of several time steps, more than 4 MiB (64 MiB for a scene of 3D Slicer) and
/// broken XML are errors.
[[nodiscard]] core::Result<Blocks> readBlocks(const std::filesystem::path& path);

/// Reads the models and segmentations of a scene of 3D Slicer: name, colour, opacity, visibility, and the transforms
/// above them if these keep all angles. A model without a file, or under another transform, is a loss.
/// @param bytes  of the file
/// @par Source vtkMRMLModelNode, vtkMRMLModelStorageNode, vtkMRMLLinearTransformNode of 3D Slicer 5
[[nodiscard]] core::Result<Blocks> readMrml(std::string_view bytes, const std::filesystem::path& path);

} // namespace palpate::meshio::internal
