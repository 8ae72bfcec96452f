// SPDX-License-Identifier: BSD-3-Clause
#include "read/VolumeFile.h"

#include "guard/FileImage.h"
#include "guard/OpenFile.h"
#include "guard/VtiHeader.h"
#include "guard/VtkMessages.h"
#include "guard/VtkProgress.h"
#include "read/ImportServer.h"
#include "text/Fault.h"
#include "text/NumericLocale.h"
#include "voxels/VoxelReader.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <array>
#include <exception>
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

constexpr double kMostPacked = 1100.0; ///< bytes that zlib can make of one

Status oneNumber(std::uint64_t components, const std::string& file)
{
    return components == 1
               ? Status()
               : fault(StatusCode::BadFormat, file, {}, {PALPATE_TEXT("%1 components per voxel"), components},
                       {PALPATE_TEXT("one number for each voxel")});
}

/// @return the transform from LPS to voxel indices
/// @param frame  axes of the file
Result<Eigen::Affine3d> toVoxelFrom(const Eigen::Matrix3d& steps, const Vec3& origin, core::FileFrame frame,
                                    const std::string& file)
{
    Eigen::Affine3d toFile = Eigen::Affine3d::Identity();
    toFile.linear() = steps;
    toFile.translation() = origin;
    const Eigen::Affine3d toVoxel = Eigen::Affine3d(core::lpsRotation(frame) * toFile).inverse();
    if (!toVoxel.matrix().allFinite()) {
        return fault(StatusCode::BadFormat, file, {},
                     {PALPATE_TEXT("axes or spacings of its voxels that do not define positions")},
                     {PALPATE_TEXT("three directions that are not in one plane, and spacings other than 0")});
    }
    return toVoxel;
}

/// Checks an extent before VTK allocates memory for it. @param numbers  per voxel
Status checkExtent(const int* extent, std::uint64_t numbers, const std::filesystem::path& path)
{
    const std::string file = path.filename().string();
    double voxels = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double along = static_cast<double>(extent[2 * axis + 1]) - extent[2 * axis] + 1.0;
        if (!(along >= 1.0)) {
            return fault(StatusCode::OutOfRange, file, {}, {PALPATE_TEXT("an axis without a voxel")},
                         {PALPATE_TEXT("at least one along each axis")});
        }
        voxels *= along;
    }
    const std::uint64_t bytes = volumeBytes(path);
    if (voxels > static_cast<double>(kMostVoxels) ||
        voxels * static_cast<double>(std::max<std::uint64_t>(numbers, 1)) > static_cast<double>(bytes) * kMostPacked) {
        return fault(StatusCode::OutOfRange, file, {},
                     {PALPATE_TEXT("%1 voxels declared"), Count(static_cast<std::uint64_t>(std::min(voxels, 1e18)))},
                     {PALPATE_TEXT("as many as its %1 bytes can hold"), Count(bytes)});
    }
    return {};
}

/// Copies and validates what VTK has read.
Result<VoxelGrid> gridOf(vtkImageData& image, core::FileFrame frame, const std::string& file)
{
    VoxelGrid grid;
    vtkDataArray* values = image.GetPointData()->GetScalars();
    std::array<int, 6> extent{};
    image.GetExtent(extent.data());
    std::uint64_t voxels = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        grid.size[axis] = static_cast<std::uint32_t>(std::max(0, extent[2 * axis + 1] - extent[2 * axis] + 1));
        voxels = voxels > kMostVoxels ? voxels : voxels * grid.size[axis];
    }
    if (values != nullptr) {
        if (Status status = oneNumber(static_cast<std::uint64_t>(values->GetNumberOfComponents()), file);
            !status.isOk()) {
            return status;
        }
    }
    if (values == nullptr || voxels < 1 || voxels > kMostVoxels ||
        static_cast<std::uint64_t>(values->GetNumberOfTuples()) != voxels) {
        return fault(StatusCode::BadFormat, file, {},
                     values == nullptr ? core::Message(PALPATE_TEXT("no numbers"))
                                       : core::Message(PALPATE_TEXT("%1 numbers for %2 voxels"),
                                                       Count(values->GetNumberOfTuples()), Count(voxels)),
                     {PALPATE_TEXT("one number for each voxel")});
    }
    Eigen::Matrix3d directions;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            directions(row, column) = image.GetDirectionMatrix()->GetElement(row, column);
        }
    }
    const Eigen::Matrix3d steps = directions * Vec3(image.GetSpacing()).asDiagonal();
    const Vec3 first = Vec3(image.GetOrigin()) + steps * Vec3(extent[0], extent[2], extent[4]);
    const Result<Eigen::Affine3d> toVoxel = toVoxelFrom(steps, first, frame, file);
    if (!toVoxel.isOk()) {
        return toVoxel.status();
    }
    grid.toVoxel = toVoxel.value();
    grid.values.resize(voxels);
    switch (values->GetDataType()) {
        vtkTemplateMacro(std::transform(static_cast<const VTK_TT*>(values->GetVoidPointer(0)),
                                        static_cast<const VTK_TT*>(values->GetVoidPointer(0)) + voxels,
                                        grid.values.begin(), [](VTK_TT v) { return static_cast<float>(v); }));
    default:
        return fault(StatusCode::BadFormat, file, {}, {PALPATE_TEXT("voxels of a non-numeric type")},
                     {PALPATE_TEXT("one number for each voxel")});
    }
    return grid;
}

/// Reads a `.vti` file with VTK.
Result<VoxelGrid> readVti(const std::filesystem::path& path, core::FileFrame frame,
                          const std::function<bool(double)>& progress)
{
    const std::string file = path.filename().string();
    const NumericLocale locale;
    const VtkMessages messages;
    const auto unreadable = [&file](std::string_view reason) {
        return fault(StatusCode::BadFormat, file, {}, {PALPATE_TEXT("VTK could not read it: %1"), reason},
                     {PALPATE_TEXT("a readable volume")});
    };
    const double most = std::min(kMostPacked * static_cast<double>(volumeBytes(path)), double{kMostVoxels});
    const Result<std::uint64_t> numbers = checkVti(path, static_cast<std::uint64_t>(most));
    if (!numbers.isOk()) {
        return numbers.status();
    }
    vtkNew<vtkXMLImageDataReader> reader;
    vtkNew<ProgressObserver> observer;
    observer->report = progress;
    reader->AddObserver(vtkCommand::ProgressEvent, observer);
    try {
        reader->SetFileName(path.c_str());
        reader->UpdateInformation();
        const int* extent = reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
        if (extent == nullptr) {
            return unreadable(messages.firstError());
        }
        if (Status status = checkExtent(extent, numbers.value(), path); !status.isOk()) {
            return status;
        }
        reader->Update();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        return unreadable(error.what());
    }
    if (observer->isCancelled) {
        return Status(StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), file);
    }
    return messages.firstError().empty() ? gridOf(*reader->GetOutput(), frame, file)
                                         : Result<VoxelGrid>(unreadable(messages.firstError()));
}

/// Reads any other format with the parsers of label maps.
Result<VoxelGrid> readVoxelFile(const std::filesystem::path& path, core::FileFrame frame,
                                const std::function<bool(double)>& progress)
{
    const std::string file = path.filename().string();
    const Result<FileImage> image = FileImage::load(path);
    if (!image.isOk()) {
        return image.status();
    }
    const Result<VolumeLayout> found = volumeLayout(
        image.value().bytes(), file, {PALPATE_TEXT("a volume: .vti, .mha, .mhd, .nrrd, .nhdr, .nii or .nii.gz")});
    if (!found.isOk()) {
        return found.status();
    }
    const VolumeLayout& layout = found.value();
    if (Status status = oneNumber(layout.layers, file); !status.isOk()) {
        return status;
    }
    const Result<Eigen::Affine3d> toVoxel = toVoxelFrom(
        layout.steps, layout.origin, layout.frame == core::FileFrame::Untagged ? frame : layout.frame, file);
    if (!toVoxel.isOk()) {
        return toVoxel.status();
    }
    VoxelGrid grid;
    grid.size = layout.size;
    grid.toVoxel = toVoxel.value();
    const auto take = [&grid, &layout](std::span<const double> numbers) {
        grid.values.reserve(layout.voxels()); // after the check that the file has so many
        std::transform(numbers.begin(), numbers.end(), std::back_inserter(grid.values),
                       [](double number) { return static_cast<float>(number); });
        return true;
    };
    if (Status status = readVoxels(layout, image.value().bytes(), path, progress, take); !status.isOk()) {
        return status;
    }
    return grid;
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
    return path.extension() == ".vti" ? readVti(path, frame, progress) : readVoxelFile(path, frame, progress);
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
