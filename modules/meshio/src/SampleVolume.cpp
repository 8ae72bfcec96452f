// SPDX-License-Identifier: BSD-3-Clause
#include "SampleVolume.h"

#include "Fault.h"
#include "NumericLocale.h"
#include "VtkMessages.h"

#include <palpate/core/Parallel.h>

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

#include <Eigen/Geometry>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;

constexpr std::uint64_t kMostVoxels = std::uint64_t{1} << 30;
constexpr double kMostPacked = 1100.0; ///< bytes that zlib can make of one

/// A volume of one number a voxel.
struct Volume
{
    vtkSmartPointer<vtkImageData> image;
    vtkDataArray* values = nullptr;
    Eigen::Affine3d toVoxel = Eigen::Affine3d::Identity(); ///< from LPS [mm] to the image's own coordinates

    /// Trilinear. @return NaN outside, and where a corner is not known
    [[nodiscard]] double at(const Vec3& p_W) const
    {
        const Vec3 p = toVoxel * p_W;
        std::array<int, 3> size{};
        image->GetDimensions(size.data());
        std::array<vtkIdType, 3> low{};
        Vec3 share;
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            const double place = (p[axis] - image->GetOrigin()[axis]) / image->GetSpacing()[axis];
            if (!(place >= 0.0 && place <= size[a] - 1)) {
                return std::numeric_limits<double>::quiet_NaN();
            }
            low[a] = std::min(static_cast<vtkIdType>(place), vtkIdType{std::max(0, size[a] - 2)});
            share[axis] = place - static_cast<double>(low[a]);
        }
        double sum = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
            double weight = 1.0;
            std::array<vtkIdType, 3> at = low;
            for (int axis = 0; axis < 3; ++axis) {
                const bool isUpper = ((corner >> axis) & 1) != 0;
                weight *= isUpper ? share[axis] : 1.0 - share[axis];
                at[static_cast<std::size_t>(axis)] += isUpper ? 1 : 0;
            }
            if (weight > 0.0) {
                sum += weight * values->GetComponent(at[0] + size[0] * (at[1] + size[1] * at[2]), 0);
            }
        }
        return sum;
    }
};

/// The directions of a volume's axes that VTK's readers leave out, as its text header says them: MetaImage's
/// `TransformMatrix`, NRRD's `space directions` and `space`.
struct TextHeader
{
    Eigen::Matrix3d directions = Eigen::Matrix3d::Identity(); ///< a column each, unit, in the file's space
    bool isRas = false;                                       ///< the file's space; else LPS
    bool hasSpace = false;                                    ///< the file says it
    bool isPacked = false;                                    ///< its voxels are compressed
};

std::optional<Eigen::Matrix3d> threeByThree(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    Eigen::Matrix3d m;
    for (int i = 0; i < 9; ++i) {
        if (!(in >> m(i % 3, i / 3))) {
            return std::nullopt;
        }
    }
    m.colwise().normalize();
    return std::abs(m.determinant()) > 1e-3 ? std::optional(m) : std::nullopt;
}

/// @return nothing where a direction is said that can't be read
std::optional<TextHeader> textHeader(const std::filesystem::path& path)
{
    constexpr std::size_t kMostHeader = 65536, kMostLines = 400;
    TextHeader axes;
    std::ifstream in(path, std::ios::binary);
    std::string line;
    std::size_t read = 0;
    for (std::size_t i = 0;
         i < kMostLines && read < kMostHeader && std::getline(in, line) && line != "" && line != "\r";
         ++i, read += line.size()) {
        const auto valueAfter = [&line](std::string_view key) {
            return line.rfind(key, 0) == 0 ? std::optional(line.substr(key.size())) : std::nullopt;
        };
        std::optional<std::string> directions = valueAfter("TransformMatrix =");
        directions = directions ? directions : valueAfter("space directions:");
        if (directions) {
            const auto matrix = threeByThree(*directions);
            if (!matrix) {
                return std::nullopt;
            }
            axes.directions = *matrix;
        }
        if (const auto space = valueAfter("space:")) {
            axes.hasSpace = true;
            axes.isRas =
                space->find("right-anterior-superior") != std::string::npos || space->find("RAS") != std::string::npos;
        }
        const auto packed = valueAfter("CompressedData =");
        const auto encoding = valueAfter("encoding:");
        axes.isPacked = axes.isPacked || (packed && packed->find("True") != std::string::npos) ||
                        (encoding && encoding->find("raw") == std::string::npos);
        if (line.rfind("ElementDataFile", 0) == 0) {
            break;
        }
    }
    return axes;
}

bool endsWith(const std::string& name, std::string_view end)
{
    return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

/// NIfTI says a matrix of its own, to RAS.
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

/// Turns a volume as its text header says, and one that says no axes as `frame` does.
/// @param header  of MetaImage and NRRD; nothing where a direction is said that can't be read
Status place(Volume& volume, const std::optional<TextHeader>& header, const std::string& file, core::FileFrame frame)
{
    const bool isNrrd = endsWith(file, ".nrrd") || endsWith(file, ".nhdr");
    if (isNrrd || endsWith(file, ".mha") || endsWith(file, ".mhd")) {
        if (!header) {
            return fault(StatusCode::BadFormat, file, "", "directions of its axes that can't be read",
                         "three vectors that are not in a plane");
        }
        const Vec3 origin(volume.image->GetOrigin());
        const Eigen::Matrix3d flip = header->isRas ? Vec3(-1, -1, 1).asDiagonal() : Vec3(1, 1, 1).asDiagonal();
        volume.toVoxel.linear() = header->directions.inverse() * flip;
        volume.toVoxel.translation() = origin - header->directions.inverse() * origin;
    }
    if (endsWith(file, ".vti") || (isNrrd && !header->hasSpace)) {
        volume.toVoxel.rotate(core::lpsRotation(frame).transpose());
    }
    return {};
}

/// @param frame  of a file that says none
Result<Volume> readVolume(const std::filesystem::path& path, core::FileFrame frame)
{
    const std::string file = path.filename().string();
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        return fault(StatusCode::NotFound, file, "", "no such file", "a volume");
    }
    const NumericLocale locale;
    const VtkMessages messages;
    Volume volume;
    // What a header declares must be there before VTK asks for the memory.
    Status wrong;
    const std::optional<TextHeader> header = textHeader(path);
    const auto isHeld = [&](const int* extent, int bytesOfOne, bool isPacked) {
        double voxels = 1.0;
        for (int axis = 0; axis < 3; ++axis) {
            voxels *= static_cast<double>(extent[2 * axis + 1]) - extent[2 * axis] + 1.0;
        }
        const auto bytes = static_cast<double>(std::filesystem::file_size(path, error));
        const bool isElsewhere = endsWith(file, ".mhd") || endsWith(file, ".nhdr");
        if (voxels > static_cast<double>(kMostVoxels) ||
            (!isElsewhere && voxels * bytesOfOne > bytes * (isPacked ? kMostPacked : 1.0))) {
            wrong = fault(StatusCode::OutOfRange, file, "",
                          counted(static_cast<std::uint64_t>(std::min(voxels, 1e18)), "voxel") + " declared",
                          "as many as its " + counted(static_cast<std::uint64_t>(bytes), "byte") + " can hold");
        }
        return wrong.isOk();
    };
    const auto readWith = [&](vtkImageReader2& reader) {
        if (reader.CanReadFile(path.c_str()) == 0) {
            return;
        }
        reader.SetFileName(path.c_str());
        reader.UpdateInformation();
        const bool isPacked = endsWith(file, ".gz") || (header && header->isPacked);
        if (isHeld(reader.GetDataExtent(), vtkDataArray::GetDataTypeSize(reader.GetDataScalarType()), isPacked)) {
            reader.Update();
            volume.image = reader.GetOutput();
        }
    };
    if (endsWith(file, ".vti")) {
        vtkNew<vtkXMLImageDataReader> reader;
        reader->SetFileName(path.c_str());
        reader->UpdateInformation();
        const int* extent = reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
        if (extent != nullptr && isHeld(extent, 1, true)) {
            reader->Update();
            volume.image = reader->GetOutput();
        }
    } else if (endsWith(file, ".nii") || endsWith(file, ".nii.gz")) {
        vtkNew<vtkNIFTIImageReader> reader;
        readWith(*reader);
        volume.toVoxel = fromNifti(*reader);
    } else if (endsWith(file, ".nrrd") || endsWith(file, ".nhdr")) {
        vtkNew<vtkNrrdReader> reader;
        readWith(*reader);
    } else if (endsWith(file, ".mha") || endsWith(file, ".mhd")) {
        vtkNew<vtkMetaImageReader> reader;
        readWith(*reader);
    } else {
        return fault(StatusCode::Unsupported, file, "", "a name of another kind",
                     "a volume: .vti, .mha, .mhd, .nrrd, .nhdr, .nii or .nii.gz");
    }
    if (!wrong.isOk()) {
        return wrong;
    }
    if (!messages.firstError().empty() || volume.image == nullptr) {
        return fault(StatusCode::BadFormat, file, "", "VTK could not read it: " + messages.firstError(),
                     "a readable volume");
    }
    if (Status status = place(volume, header, file, frame); !status.isOk()) {
        return status;
    }
    volume.values = volume.image->GetPointData()->GetScalars();
    const vtkIdType points = volume.image->GetNumberOfPoints();
    if (volume.values == nullptr || volume.values->GetNumberOfComponents() != 1 ||
        volume.values->GetNumberOfTuples() != points || points < 1 ||
        static_cast<std::uint64_t>(points) > kMostVoxels) {
        return fault(StatusCode::BadFormat, file, "",
                     volume.values == nullptr
                         ? "no numbers"
                         : counted(static_cast<std::uint64_t>(volume.values->GetNumberOfComponents()), "component") +
                               " a voxel",
                     "one number for each voxel");
    }
    return volume;
}

/// Places below a contact, of equal share of a press's energy, in units of c = a/pi: z down, r across.
std::vector<Vec3> placesBelow()
{
    // In spherical coordinates about the point c above the surface, where the weight is z^2 / R^6 and z = R cos - c:
    // each is the middle of a cell of equal weight, found by halving its integrals by number.
    constexpr int kRings = 6, kTurns = 8, kDepths = 8;
    std::vector<Vec3> places;
    // Weight over all r at depth z: integral of 2 pi r w = 3 c z^2 / (z + c)^4, whose integral is (z / (z + c))^3.
    for (int i = 0; i < kDepths; ++i) {
        const double share = std::cbrt((i + 0.5) / kDepths);
        const double z = share / (1.0 - share); // in c
        for (int j = 0; j < kRings; ++j) {
            // At one depth the weight within r is 1 - ((z + 1)^2 / (r^2 + (z + 1)^2))^2.
            const double within = (j + 0.5) / kRings;
            const double r = (z + 1.0) * std::sqrt(1.0 / std::sqrt(1.0 - within) - 1.0);
            for (int k = 0; k < kTurns; ++k) {
                const double turn = 2.0 * std::numbers::pi * (k + 0.5 * (i + j)) / kTurns;
                places.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
            }
        }
    }
    return places;
}

std::vector<Vec3> normalsOf(const geometry::TriangleMesh& mesh)
{
    std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
    for (const geometry::Triangle& t : mesh.triangles) {
        const Vec3 n = (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
        for (const std::uint32_t corner : t) {
            normals[corner] += n;
        }
    }
    for (Vec3& n : normals) {
        n.normalize();
    }
    return normals;
}

} // namespace

Result<std::vector<float>> sampleVolume(const core::TissueMapping& mapping, const geometry::RepairedMesh& surface,
                                        core::FileFrame frame, const std::function<bool()>& keepGoing)
{
    const auto isStopped = [&keepGoing] { return keepGoing && !keepGoing(); };
    const auto cancelled = [&mapping] {
        return Status(StatusCode::Cancelled,
                      std::filesystem::path(mapping.file).filename().string() + ": reading was cancelled");
    };
    if (isStopped()) {
        return cancelled();
    }
    const Result<Volume> read = readVolume(mapping.file, frame);
    if (!read.isOk()) {
        return read.status();
    }
    const Volume& volume = read.value();
    const std::vector<Vec3> places = placesBelow();
    const std::vector<Vec3> normals = normalsOf(surface.mesh);
    const double c_mm = mapping.contactRadius_mm / std::numbers::pi;
    std::vector<float> felt(surface.mesh.vertices.size());
    constexpr std::size_t kBlock = 1024;
    std::atomic<bool> isCancelled{isStopped()};
    core::parallelFor((felt.size() + kBlock - 1) / kBlock, [&](std::size_t block, unsigned thread) {
        if (isCancelled || (thread == 0 && isStopped())) {
            isCancelled = true;
            return;
        }
        for (std::size_t i = block * kBlock; i < std::min(felt.size(), (block + 1) * kBlock); ++i) {
            const Vec3 &p = surface.mesh.vertices[i], &n = normals[i];
            const Vec3 u = n.unitOrthogonal(), v = n.cross(u);
            double sum = 0.0, inverse = 0.0;
            std::size_t known = 0;
            for (const Vec3& place : places) {
                const double value = volume.at(p + c_mm * (place.x() * u + place.y() * v - place.z() * n));
                if (value > 0.0 && std::isfinite(value)) {
                    sum += value;
                    inverse += 1.0 / value;
                    ++known;
                }
            }
            felt[i] = 2 * known < places.size() ? std::numeric_limits<float>::quiet_NaN()
                                                : static_cast<float>(std::sqrt(sum / inverse));
        }
    });
    if (isCancelled) {
        return cancelled();
    }
    return felt;
}

} // namespace palpate::meshio::internal
