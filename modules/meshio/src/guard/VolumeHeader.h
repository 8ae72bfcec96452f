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

/// Axis directions of a volume that VTK's readers ignore, from the text header: MetaImage's `TransformMatrix`, NRRD's
/// `space directions` and `space`.
struct TextHeader
{
    Eigen::Matrix3d directions = Eigen::Matrix3d::Identity(); ///< unit column vectors in the space of the file
    bool isRas = false;                                       ///< space of the file; otherwise LPS
    bool hasSpace = false;                                    ///< the file states the space
    bool isPacked = false;                                    ///< compressed voxels
    bool isText = false;     ///< voxels as text, or in an encoding that VTK cannot read
    bool isPlain = true;     ///< without zero bytes; VTK's NRRD reader takes a zero byte for the end of the header, and
                             ///< can then loop forever if the empty line is missing
    int dimensions = 3;      ///< of MetaImage; 0: not stated as a single number
    std::size_t longest = 0; ///< longest line [characters]
    bool isEnded = false;    ///< the required end is present: an empty line, ElementDataFile
    std::uint64_t size = 0;  ///< first possible offset of the numbers [bytes]
    bool isList = false;     ///< the header names one file per slice
    std::vector<std::string> dataFiles{}; ///< voxel files as named in the header; empty: this file
};

/// Parses a MetaImage or NRRD header. @return nothing for an unreadable direction
[[nodiscard]] std::optional<TextHeader> textHeader(const std::filesystem::path& path);

/// Checks the fields that the readers of MetaImage and NRRD trust.
/// @param header  of `path`
[[nodiscard]] core::Status checkTextHeader(const std::filesystem::path& path, const std::optional<TextHeader>& header);

/// Checks the fields that the NIfTI reader trusts: the reader uses type codes as table indices.
[[nodiscard]] core::Status checkNifti(const std::filesystem::path& path);

/// Checks the fields that the VTI reader trusts: the reader loops over the declared components of an array before
/// reading numbers, and accepts a short read of appended data (`vtkXMLDataParser::ReadUncompressedData`), which leaves
/// the missing numbers uninitialised. The check is that the file ends with the last tag.
/// @param most  limit on the numbers per voxel declared by all arrays together; below 2^32
/// @return the numbers per voxel
[[nodiscard]] core::Result<std::uint64_t> checkVti(const std::filesystem::path& source, std::uint64_t most);

} // namespace palpate::meshio::internal
