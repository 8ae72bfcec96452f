// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "text/Fault.h"

#include <palpate/core/FileFrame.h>
#include <palpate/core/Types.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::meshio::internal {

/// Number type of the voxels in a file.
enum class VoxelType : std::uint8_t
{
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Float32,
    Float64,
};

[[nodiscard]] constexpr std::size_t bytesOf(VoxelType type) noexcept
{
    constexpr std::array<std::size_t, 10> kBytes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    return kBytes[static_cast<std::size_t>(type)];
}

/// Header of a volume: the place of its voxels in the file and in the patient. All counts are at least 1, their product
/// is at most kMostLayoutVoxels, and the axes do not lie in one plane.
struct VolumeLayout
{
    std::string format;                  ///< for users: "NRRD", "NIfTI", "MetaImage"
    std::array<std::uint32_t, 3> size{}; ///< voxels along each axis; the first changes fastest
    std::uint32_t layers = 1;            ///< numbers for each voxel, as of overlapping segments
    bool isInterleaved = false;          ///< the layers of a voxel are consecutive; otherwise one volume per layer
    VoxelType type = VoxelType::UInt8;
    bool isBigEndian = false;
    double slope = 1.0, intercept = 0.0; ///< a stored number v stands for slope v + intercept
    /// Columns: from a voxel to the next along each axis, in the axes of the file [mm].
    Eigen::Matrix3d steps = Eigen::Matrix3d::Identity();
    core::Vec3 origin = core::Vec3::Zero();            ///< centre of the first voxel, in the axes of the file [mm]
    core::FileFrame frame = core::FileFrame::Untagged; ///< axes of the file
    bool isPacked = false;                             ///< voxels compressed by zlib or gzip
    bool isWholePacked = false;                        ///< header and voxels are compressed together (`.nii.gz`)
    std::uint64_t offset = 0;                          ///< of the first voxel in each file, after unpacking [bytes]
    bool isAtEnd = false;                              ///< the voxels are the last bytes of each file, see `offset`
    std::vector<std::string> dataFiles{};              ///< files of the voxels beside the header; empty: the same file
    bool isVector = false;                             ///< the layers are marked as the components of a vector
    /// Columns: direction of each component of a vector, in the axes of the file. NaN if unreadable.
    Eigen::Matrix3d components = Eigen::Matrix3d::Identity();
    bool isStatedLabels = false;                ///< the file states that it is a label map
    std::map<std::string, std::string> pairs{}; ///< fields "key:=value" of an NRRD
    std::string labelTable{};                   ///< XML of a NIfTI extension with names of labels; or empty

    [[nodiscard]] std::uint64_t voxels() const noexcept { return std::uint64_t{size[0]} * size[1] * size[2] * layers; }
    /// @return edge lengths of a voxel [mm]
    [[nodiscard]] core::Vec3 voxel_mm() const { return steps.colwise().norm().transpose(); }
};

inline constexpr std::uint64_t kMostAlong = std::uint64_t{1} << 30;        ///< voxels along one axis
inline constexpr std::uint64_t kMostLayoutVoxels = std::uint64_t{1} << 30; ///< of all layers

[[nodiscard]] bool looksLikeNrrd(std::string_view bytes);
[[nodiscard]] bool looksLikeMetaImage(std::string_view bytes);
/// True also for a gzip file that contains a NIfTI file.
[[nodiscard]] bool looksLikeNifti(std::string_view bytes);

/// Parse the header of a file and check it.
/// @param bytes  the whole file
/// @param file   name for messages
[[nodiscard]] core::Result<VolumeLayout> nrrdLayout(std::string_view bytes, const std::string& file);
[[nodiscard]] core::Result<VolumeLayout> metaLayout(std::string_view bytes, const std::string& file);
[[nodiscard]] core::Result<VolumeLayout> niftiLayout(std::string_view bytes, const std::string& file);

/// Parses the header of a volume in any of these formats, which the content decides.
/// @param expected  for the error about another format
[[nodiscard]] core::Result<VolumeLayout> volumeLayout(std::string_view bytes, const std::string& file,
                                                      const core::Message& expected);

/// Checks counts and axes, which every format has.
[[nodiscard]] core::Status checkLayout(const VolumeLayout& layout, const std::string& file);

/// Checks that the axes are perpendicular, to 0.06 degrees.
[[nodiscard]] core::Status checkRightAngles(const VolumeLayout& layout, const std::string& file);

/// @return the numbers of a text, at most `most`; empty if a word is not a finite number
[[nodiscard]] std::vector<double> numbersIn(std::string_view text, std::size_t most);

} // namespace palpate::meshio::internal
