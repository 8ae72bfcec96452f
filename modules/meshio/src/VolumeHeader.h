// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate::meshio::internal {

/// The directions of a volume's axes that VTK's readers leave out, as its text header says them: MetaImage's
/// `TransformMatrix`, NRRD's `space directions` and `space`.
struct TextHeader
{
    Eigen::Matrix3d directions = Eigen::Matrix3d::Identity(); ///< a column each, unit, in the file's space
    bool isRas = false;                                       ///< the file's space; else LPS
    bool hasSpace = false;                                    ///< the file says it
    bool isPacked = false;                                    ///< its voxels are compressed
    bool isText = false;     ///< its voxels are written as text, or in what VTK can't read
    bool isPlain = true;     ///< no byte of it is 0, which VTK's readers take for its end, or look for an end behind
    int dimensions = 3;      ///< of MetaImage; 0: not said as one number
    std::size_t longest = 0; ///< of its lines [characters]
    bool isEnded = false;    ///< by what must stand there: an empty line, ElementDataFile
    std::uint64_t size = 0;  ///< up to where its numbers can begin [bytes]
    bool isList = false;     ///< it names a file for each slice
    std::vector<std::string> dataFiles{}; ///< of its voxels, as it names them; empty: this file
};

/// Of MetaImage or NRRD. @return nothing where a direction is said that can't be read
[[nodiscard]] std::optional<TextHeader> textHeader(const std::filesystem::path& path);

/// What the readers of MetaImage and NRRD trust.
/// @param header  of `path`
[[nodiscard]] core::Status checkTextHeader(const std::filesystem::path& path, const std::optional<TextHeader>& header);

/// What NIfTI's reader trusts: it takes the number of a kind for a place in a table.
[[nodiscard]] core::Status checkNifti(const std::filesystem::path& path);

/// What VTI's reader trusts: it walks over as many components as an array declares before it looks for numbers, and
/// where a file ends before its last tag it leaves what is not there of appended numbers as the memory was.
/// @param most  numbers that all its arrays together may declare, each as if for one voxel; below 2^32
/// @return those that it has for each voxel
[[nodiscard]] core::Result<std::uint64_t> checkVti(const std::filesystem::path& source, std::uint64_t most);

} // namespace palpate::meshio::internal
