// SPDX-License-Identifier: BSD-3-Clause
#include "read/VolumeFile.h"

#include "formats/VtiVolume.h"
#include "guard/FileImage.h"
#include "guard/OpenFile.h"
#include "read/ImportServer.h"
#include "text/Fault.h"
#include "voxels/VoxelReader.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;

Status oneNumber(std::uint64_t components, const std::string& file)
{
    return components == 1
               ? Status()
               : fault(StatusCode::BadFormat, file, {}, {PALPATE_TEXT("%1 components per voxel"), components},
                       {PALPATE_TEXT("one number for each voxel")});
}

/// @param frame  axes of a file that does not state its own
/// @return the transform from LPS to voxel indices
Result<Eigen::Affine3d> toVoxelFrom(const VolumeLayout& layout, core::FileFrame frame, const std::string& file)
{
    Eigen::Affine3d toFile = Eigen::Affine3d::Identity();
    toFile.linear() = layout.steps;
    toFile.translation() = layout.origin;
    const Eigen::Matrix3d toLps = core::lpsRotation(layout.frame == core::FileFrame::Untagged ? frame : layout.frame);
    const Eigen::Affine3d toVoxel = Eigen::Affine3d(toLps * toFile).inverse();
    if (!toVoxel.matrix().allFinite()) {
        return fault(StatusCode::BadFormat, file, {PALPATE_TEXT("header")},
                     {PALPATE_TEXT("an origin that is too far away")}, {PALPATE_TEXT("positions in mm")});
    }
    return toVoxel;
}

/// Reads the voxels of any format but VTI.
Status takeVoxels(const VolumeLayout& layout, std::string_view bytes, const std::filesystem::path& path,
                  const std::function<bool(double)>& progress, std::vector<float>& values)
{
    if (Status status = oneNumber(layout.layers, path.filename().string()); !status.isOk()) {
        return status;
    }
    return readVoxels(layout, bytes, path, progress, [&values, &layout](std::span<const double> numbers) {
        values.reserve(layout.voxels()); // after the check that the file has so many
        std::transform(numbers.begin(), numbers.end(), std::back_inserter(values),
                       [](double number) { return static_cast<float>(number); });
        return true;
    });
}

} // namespace

std::uint64_t volumeBytes(const std::filesystem::path& path)
{
    const auto sizeOf = [](const std::filesystem::path& file) -> std::uint64_t {
        std::error_code error;
        const std::uintmax_t size = std::filesystem::file_size(file, error);
        return error ? 0 : size;
    };
    constexpr std::size_t kMostHeader = std::size_t{1} << 20; // [bytes]
    std::string head(std::min<std::uint64_t>(sizeOf(path), kMostHeader), '\0');
    std::ifstream in(path, std::ios::binary);
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(in.gcount()));
    std::uint64_t beside = 0;
    if (looksLikeNrrd(head) || looksLikeMetaImage(head)) {
        const Result<VolumeLayout> layout = volumeLayout(head, path.filename().string(), {});
        for (const std::string& name : layout.isOk() ? layout.value().dataFiles : std::vector<std::string>()) {
            beside += sizeOf(path.parent_path() / name);
        }
    }
    return beside > 0 ? beside : sizeOf(path);
}

Result<VoxelGrid> readVolumeHere(const std::filesystem::path& path, core::FileFrame frame,
                                 const std::function<bool(double)>& progress)
{
    const std::string file = path.filename().string();
    const Result<FileImage> image = FileImage::load(path);
    if (!image.isOk()) {
        return image.status();
    }
    const std::string_view bytes = image.value().bytes();
    VoxelGrid grid;
    VolumeLayout layout;
    if (looksLikeVti(bytes)) {
        Result<VtiVolume> volume = vtiVolume(bytes, file, progress);
        if (!volume.isOk()) {
            return volume.status();
        }
        layout = std::move(volume.value().layout);
        grid.values = std::move(volume.value().values);
    } else {
        Result<VolumeLayout> found =
            volumeLayout(bytes, file, {PALPATE_TEXT("a volume: .vti, .mha, .mhd, .nrrd, .nhdr, .nii or .nii.gz")});
        if (!found.isOk()) {
            return found.status();
        }
        layout = std::move(found).value();
        if (Status status = takeVoxels(layout, bytes, path, progress, grid.values); !status.isOk()) {
            return status;
        }
    }
    grid.size = layout.size;
    const Result<Eigen::Affine3d> toVoxel = toVoxelFrom(layout, frame, file);
    if (!toVoxel.isOk()) {
        return toVoxel.status();
    }
    grid.toVoxel = toVoxel.value();
    return grid;
}

Result<VoxelGrid> readVolume(const std::filesystem::path& path, core::FileFrame frame,
                             const std::function<bool(double)>& progress)
{
    const std::string file = path.filename().string();
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        return fault(StatusCode::NotFound, file, {}, {PALPATE_TEXT("no such file")}, {PALPATE_TEXT("a volume")});
    }
    if (!std::filesystem::is_regular_file(status)) {
        return fault(StatusCode::Unreadable, file, {},
                     std::filesystem::is_directory(status) ? core::Message(PALPATE_TEXT("is a folder"))
                                                           : core::Message(PALPATE_TEXT("is not a regular file")),
                     {PALPATE_TEXT("a volume")});
    }
    try {
        if (!hasImportServer()) {
            return readVolumeHere(path, frame, progress);
        }
        const Result<OpenFile> open = openFile(path);
        return open.isOk() ? readVolumeInChild(open.value(), path, frame, progress) : open.status();
    } catch (const std::bad_alloc&) {
        return fault(StatusCode::OutOfRange, file, {}, {PALPATE_TEXT("not enough memory to read it")},
                     {PALPATE_TEXT("a smaller volume, or more free memory")});
    }
}

} // namespace palpate::meshio::internal
