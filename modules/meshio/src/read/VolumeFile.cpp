// SPDX-License-Identifier: BSD-3-Clause
#include "read/VolumeFile.h"

#include "guard/OpenFile.h"
#include "guard/VolumeHeader.h"
#include "guard/VtkMessages.h"
#include "guard/VtkProgress.h"
#include "read/ImportServer.h"
#include "text/Fault.h"
#include "text/NumericLocale.h"

#include <QByteArray>

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkImageReader2.h>
#include <vtkInformation.h>
#include <vtkMatrix4x4.h>
#include <vtkMetaImageReader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkNrrdReader.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <fstream>
#include <iterator>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;

constexpr double kMostPacked = 1100.0; ///< bytes that zlib can make of one

bool hasTextHeader(const std::filesystem::path& path)
{
    const std::string ending = path.extension().string();
    return ending == ".nrrd" || ending == ".nhdr" || ending == ".mha" || ending == ".mhd";
}

/// NIfTI files contain a matrix to RAS.
Eigen::Affine3d fromNifti(vtkNIFTIImageReader& reader)
{
    Eigen::Affine3d X = Eigen::Affine3d::Identity();
    vtkMatrix4x4* matrix = reader.GetSFormMatrix() != nullptr ? reader.GetSFormMatrix() : reader.GetQFormMatrix();
    if (matrix != nullptr) {
        Eigen::Matrix4d m;
        for (int row = 0; row < 4; ++row) {
            for (int column = 0; column < 4; ++column) {
                m(row, column) = matrix->GetElement(row, column);
            }
        }
        const Eigen::Vector4d toLps(-1.0, -1.0, 1.0, 1.0);
        m = toLps.asDiagonal() * m;
        Eigen::Affine3d toWorld(m);
        X.matrix() = toWorld.inverse().matrix();
    }
    return X;
}

/// A volume as read by VTK.
struct Volume
{
    vtkSmartPointer<vtkImageData> image;
    Eigen::Affine3d toVoxel = Eigen::Affine3d::Identity(); ///< from LPS [mm] to the image's own coordinates
};

/// Orients a volume by the axes in the text header, or by `frame` if the header contains none.
/// @param header  present for MetaImage and NRRD
void place(Volume& volume, const std::optional<TextHeader>& header, const std::string& file, core::FileFrame frame)
{
    const bool isNrrd = file.ends_with(".nrrd") || file.ends_with(".nhdr");
    if (isNrrd || file.ends_with(".mha") || file.ends_with(".mhd")) {
        const Vec3 origin(volume.image->GetOrigin());
        const Eigen::Matrix3d flip = header->isRas ? Vec3(-1, -1, 1).asDiagonal() : Vec3(1, 1, 1).asDiagonal();
        volume.toVoxel.linear() = header->directions.inverse() * flip;
        volume.toVoxel.translation() = origin - header->directions.inverse() * origin;
    }
    if (file.ends_with(".vti") || (isNrrd && !header->hasSpace)) {
        volume.toVoxel.rotate(core::lpsRotation(frame).transpose());
    }
}

Status oneNumber(int components, const std::string& file)
{
    return components == 1
               ? Status()
               : fault(StatusCode::BadFormat, file, {}, {PALPATE_TEXT("%1 components per voxel"), components},
                       {PALPATE_TEXT("one number for each voxel")});
}

/// The declared data must exist before VTK allocates the memory.
Status checkHeld(const int* extent, double bytesOfOne, bool isPacked, const std::filesystem::path& path,
                 const std::optional<TextHeader>& header)
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
    constexpr std::uint64_t kNiftiHeader = 352; // minimum
    const bool isNifti = file.ends_with(".nii");
    const std::uint64_t head = isNifti ? kNiftiHeader : header && header->dataFiles.empty() ? header->size : 0;
    const std::uint64_t all = volumeBytes(path);
    const auto bytes = static_cast<double>(all - std::min(all, head));
    if (voxels > static_cast<double>(kMostVoxels) || voxels * bytesOfOne > bytes * (isPacked ? kMostPacked : 1.0)) {
        return fault(StatusCode::OutOfRange, file, {},
                     {PALPATE_TEXT("%1 voxels declared"), Count(static_cast<std::uint64_t>(std::min(voxels, 1e18)))},
                     {PALPATE_TEXT("as many as its %1 bytes can hold"), Count(static_cast<std::uint64_t>(bytes))});
    }
    return {};
}

/// VTK's MetaImage reader accepts partially decompressed data and leaves the rest of the memory uninitialised.
Status checkUnpacks(const std::filesystem::path& path, const TextHeader& header, const int* extent, int bytesOfOne)
{
    std::uint64_t bytes = static_cast<std::uint64_t>(bytesOfOne);
    for (int axis = 0; axis < 3; ++axis) {
        bytes *= static_cast<std::uint64_t>(extent[2 * axis + 1] - extent[2 * axis] + 1);
    }
    const bool isHere = header.dataFiles.empty();
    std::ifstream in(isHere ? path : path.parent_path() / header.dataFiles.front(), std::ios::binary);
    in.seekg(isHere ? static_cast<std::streamoff>(header.size) : 0);
    std::string packed(4, '\0'); // Qt expects the size in front, big-endian, as an initial guess
    for (std::size_t i = 0; i < 4; ++i) {
        packed[i] = static_cast<char>((std::min<std::uint64_t>(bytes, 0x7fffffffU) >> (24 - 8 * i)) & 0xffU);
    }
    packed.append(std::istreambuf_iterator<char>(in), {});
    const auto unpacked = static_cast<std::uint64_t>(
        qUncompress(reinterpret_cast<const uchar*>(packed.data()), static_cast<qsizetype>(packed.size())).size());
    if (unpacked != bytes) {
        return fault(StatusCode::BadFormat, path.filename().string(), {},
                     unpacked == 0 ? core::Message(PALPATE_TEXT("its compressed voxels are cut off or broken"))
                                   : core::Message(PALPATE_TEXT("%1 bytes when unpacked"), Count(unpacked)),
                     {PALPATE_TEXT("%1 bytes of voxels"), Count(bytes)});
    }
    return {};
}

/// Reads with VTK. `volume.image` stays null if VTK's reader does not recognise the format
Status readWithVtk(const std::filesystem::path& path, const std::optional<TextHeader>& header,
                   const std::function<bool(double)>& progress, Volume& volume)
{
    const std::string file = path.filename().string();
    vtkNew<ProgressObserver> observer;
    observer->report = progress;
    Status status;
    const auto run = [&](auto& reader) {
        reader.AddObserver(vtkCommand::ProgressEvent, observer);
        reader.Update();
        volume.image = reader.GetOutput();
        if (observer->isCancelled) {
            status = Status(StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), file);
        }
    };
    const auto runImage = [&](vtkImageReader2& reader) {
        if (reader.CanReadFile(path.c_str()) == 0) {
            return;
        }
        reader.SetFileName(path.c_str());
        reader.UpdateInformation();
        const bool isPacked = file.ends_with(".gz") || (header && header->isPacked);
        status = oneNumber(reader.GetNumberOfScalarComponents(), file);
        status = !status.isOk()
                     ? status
                     : checkHeld(reader.GetDataExtent(), vtkDataArray::GetDataTypeSize(reader.GetDataScalarType()),
                                 isPacked, path, header);
        if (status.isOk() && header && header->isPacked && (file.ends_with(".mha") || file.ends_with(".mhd"))) {
            status = checkUnpacks(path, *header, reader.GetDataExtent(),
                                  vtkDataArray::GetDataTypeSize(reader.GetDataScalarType()));
        }
        if (status.isOk()) {
            run(reader);
        }
    };
    if (file.ends_with(".vti")) {
        const double most = std::min(kMostPacked * static_cast<double>(volumeBytes(path)), double{kMostVoxels});
        const Result<std::uint64_t> numbers = checkVti(path, static_cast<std::uint64_t>(most));
        if (!numbers.isOk()) {
            return numbers.status();
        }
        vtkNew<vtkXMLImageDataReader> reader;
        reader->SetFileName(path.c_str());
        reader->UpdateInformation();
        const int* extent = reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
        if (extent != nullptr) {
            status = checkHeld(extent, std::max(1.0, static_cast<double>(numbers.value())), true, path, header);
            if (status.isOk()) {
                run(*reader);
            }
        }
    } else if (file.ends_with(".nii") || file.ends_with(".nii.gz")) {
        vtkNew<vtkNIFTIImageReader> reader;
        runImage(*reader);
        volume.toVoxel = fromNifti(*reader);
    } else if (file.ends_with(".nrrd") || file.ends_with(".nhdr")) {
        vtkNew<vtkNrrdReader> reader;
        runImage(*reader);
    } else if (file.ends_with(".mha") || file.ends_with(".mhd")) {
        vtkNew<vtkMetaImageReader> reader;
        runImage(*reader);
    } else {
        return fault(StatusCode::Unsupported, file, {}, {PALPATE_TEXT("an unknown file extension")},
                     {PALPATE_TEXT("a volume: .vti, .mha, .mhd, .nrrd, .nhdr, .nii or .nii.gz")});
    }
    return status;
}

/// Copies and validates the numbers that VTK has read.
Result<VoxelGrid> gridOf(const Volume& volume, const std::string& file)
{
    VoxelGrid grid;
    vtkDataArray* values = volume.image->GetPointData()->GetScalars();
    std::array<int, 3> size{};
    volume.image->GetDimensions(size.data());
    std::uint64_t voxels = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        grid.size[axis] = static_cast<std::uint32_t>(std::max(0, size[axis]));
        voxels = voxels > kMostVoxels ? voxels : voxels * grid.size[axis];
    }
    if (values == nullptr || values->GetNumberOfComponents() != 1 || voxels < 1 || voxels > kMostVoxels ||
        static_cast<std::uint64_t>(values->GetNumberOfTuples()) != voxels) {
        return fault(StatusCode::BadFormat, file, {},
                     values == nullptr ? core::Message(PALPATE_TEXT("no numbers"))
                     : values->GetNumberOfComponents() != 1
                         ? core::Message(PALPATE_TEXT("%1 components per voxel"), values->GetNumberOfComponents())
                         : core::Message(PALPATE_TEXT("%1 numbers for %2 voxels"), Count(values->GetNumberOfTuples()),
                                         Count(voxels)),
                     {PALPATE_TEXT("one number for each voxel")});
    }
    const Vec3 origin(volume.image->GetOrigin()), spacing(volume.image->GetSpacing());
    const Eigen::Matrix3d linear = spacing.cwiseInverse().asDiagonal() * volume.toVoxel.linear();
    grid.toVoxel.linear() = linear;
    grid.toVoxel.translation() = spacing.cwiseInverse().cwiseProduct(volume.toVoxel.translation() - origin);
    if (!grid.toVoxel.matrix().allFinite() || !(std::abs(linear.determinant()) > 0.0)) {
        return fault(StatusCode::BadFormat, file, {},
                     {PALPATE_TEXT("axes or spacings of its voxels that do not define positions")},
                     {PALPATE_TEXT("three directions that are not in one plane, and spacings other than 0")});
    }
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

} // namespace

std::uint64_t volumeBytes(const std::filesystem::path& path)
{
    const auto sizeOf = [](const std::filesystem::path& file) -> std::uint64_t {
        std::error_code error;
        const std::uintmax_t size = std::filesystem::file_size(file, error);
        return error ? 0 : size;
    };
    const std::optional<TextHeader> header = hasTextHeader(path) ? textHeader(path) : std::nullopt;
    if (!header || header->dataFiles.empty()) {
        return sizeOf(path);
    }
    std::uint64_t all = 0;
    for (const std::string& name : header->dataFiles) {
        all += sizeOf(path.parent_path() / name);
    }
    return all;
}

Result<VoxelGrid> readVolumeHere(const std::filesystem::path& path, core::FileFrame frame,
                                 const std::function<bool(double)>& progress)
{
    const std::string file = path.filename().string();
    const NumericLocale locale;
    const VtkMessages messages;
    const bool hasText = hasTextHeader(path);
    const std::optional<TextHeader> header = hasText ? textHeader(path) : std::nullopt;
    const bool isNifti = file.ends_with(".nii") || file.ends_with(".nii.gz");
    if (Status status = hasText   ? checkTextHeader(path, header)
                        : isNifti ? checkNifti(path)
                                  : Status();
        !status.isOk()) {
        return status;
    }
    const auto unreadable = [&file](std::string_view reason) {
        return fault(StatusCode::BadFormat, file, {}, {PALPATE_TEXT("VTK could not read it: %1"), reason},
                     {PALPATE_TEXT("a readable volume")});
    };
    Volume volume;
    try {
        if (Status status = readWithVtk(path, header, progress, volume); !status.isOk()) {
            return status;
        }
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        return unreadable(error.what());
    }
    if (!messages.firstError().empty() || volume.image == nullptr) {
        return unreadable(messages.firstError());
    }
    place(volume, header, file, frame);
    return gridOf(volume, file);
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
