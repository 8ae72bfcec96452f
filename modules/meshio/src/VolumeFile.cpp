// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFile.h"

#include "Fault.h"
#include "ImportServer.h"
#include "NumericLocale.h"
#include "OpenFile.h"
#include "TextScan.h"
#include "VtkMessages.h"
#include "VtkProgress.h"

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
#include <vtk_zlib.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <iterator>
#include <locale>
#include <map>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;

constexpr std::size_t kMostHeader = 65536; ///< of text [bytes]
constexpr double kMostPacked = 1100.0;     ///< bytes that zlib can make of one

/// The directions of a volume's axes that VTK's readers leave out, as its text header says them: MetaImage's
/// `TransformMatrix`, NRRD's `space directions` and `space`.
struct TextHeader
{
    Eigen::Matrix3d directions = Eigen::Matrix3d::Identity(); ///< a column each, unit, in the file's space
    bool isRas = false;                                       ///< the file's space; else LPS
    bool hasSpace = false;                                    ///< the file says it
    bool isPacked = false;                                    ///< its voxels are compressed
    bool isText = false;                                      ///< its voxels are written as text (NRRD)
    bool isPlain = true;    ///< no byte of it is 0, which VTK's readers take for its end, or look for an end behind
    int dimensions = 3;     ///< of MetaImage; 0: not said as one number
    bool isEnded = false;   ///< by what must stand there: an empty line, ElementDataFile
    std::uint64_t size = 0; ///< up to where its numbers can begin [bytes]
    std::string dataFile;   ///< of its voxels, as it says it; empty: this file
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
    constexpr std::size_t kMostLines = 400;
    const bool isMeta = path.extension() == ".mha" || path.extension() == ".mhd";
    TextHeader axes;
    std::ifstream in(path, std::ios::binary);
    std::string line;
    std::size_t read = 0;
    for (std::size_t i = 0; i < kMostLines && read < kMostHeader && std::getline(in, line);
         ++i, read += line.size() + 1) {
        if (line.empty() || line == "\r") {
            axes.isEnded = !in.eof();
            axes.size = read + line.size() + 1;
            break;
        }
        axes.isPlain = axes.isPlain && line.find('\0') == std::string::npos;
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
        if (const auto dimensions = valueAfter("NDims =")) {
            const std::string_view digits = trimmed(*dimensions);
            axes.dimensions = digits.size() == 1 && digits[0] >= '0' && digits[0] <= '9' ? digits[0] - '0' : 0;
        }
        const auto packed = valueAfter("CompressedData =");
        const auto encoding = valueAfter("encoding:");
        axes.isPacked = axes.isPacked || (packed && packed->find("True") != std::string::npos) ||
                        (encoding && encoding->find("raw") == std::string::npos);
        axes.isText = axes.isText || (encoding && encoding->find("raw") == std::string::npos &&
                                      encoding->find("gz") == std::string::npos);
        const auto element = isMeta ? valueAfter("ElementDataFile =") : std::nullopt;
        const auto data = element ? element : valueAfter("data file:");
        axes.dataFile = data ? std::string(trimmed(*data)) : axes.dataFile;
        if (element) {
            axes.isEnded = !in.eof();
            axes.size = read + line.size() + 1;
            break;
        }
    }
    if (axes.dataFile == "LOCAL") {
        axes.dataFile.clear();
    }
    return axes;
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

/// A volume as VTK has it.
struct Volume
{
    vtkSmartPointer<vtkImageData> image;
    Eigen::Affine3d toVoxel = Eigen::Affine3d::Identity(); ///< from LPS [mm] to the image's own coordinates
};

/// Turns a volume as its text header says, and one that says no axes as `frame` does.
/// @param header  there for MetaImage and NRRD
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

/// Where a VTI ends before its last tag, VTK leaves what is not there of appended numbers as the memory was.
bool isXmlEnded(const std::filesystem::path& path)
{
    constexpr std::streamoff kTail = 256;
    std::ifstream in(path, std::ios::binary | std::ios::ate);
    const std::streamoff size = in.tellg();
    in.seekg(std::max<std::streamoff>(0, size - kTail));
    const std::string tail{std::istreambuf_iterator<char>(in), {}};
    return trimmed(tail).ends_with("</VTKFile>");
}

/// The file of the voxels where it is one beside the header. @return empty where it is not: lists of files, patterns
std::filesystem::path dataFileOf(const std::filesystem::path& path, const TextHeader& header)
{
    std::error_code error;
    const std::filesystem::path file = path.parent_path() / header.dataFile;
    return !header.dataFile.empty() && std::filesystem::is_regular_file(file, error) ? file : std::filesystem::path();
}

/// What NRRD's reader trusts: it takes what is no number for 0, a field that comes twice for both, and the name of a
/// data file with numbers behind it for a pattern to print them with.
Status checkNrrd(const std::filesystem::path& path)
{
    const std::string file = path.filename().string();
    std::ifstream in(path, std::ios::binary);
    std::string line;
    std::map<std::string, std::string> fields;
    std::getline(in, line);
    for (std::size_t read = line.size(); read < kMostHeader && std::getline(in, line) && !line.empty() && line != "\r";
         read += line.size() + 1) {
        const std::size_t colon = line.find(": ");
        if (line[0] == '#' || colon == std::string::npos) {
            continue;
        }
        const std::string field = line.substr(0, colon);
        if (!fields.emplace(field, trimmed(std::string_view(line).substr(colon + 2))).second) {
            return fault(StatusCode::BadFormat, file, "header", inQuotes(field) + " twice", "each field once");
        }
        if (field == "sizes" && fields.count("dimension") == 0) {
            return fault(StatusCode::BadFormat, file, "header: sizes", "no dimension before them", "a dimension");
        }
    }
    const auto wordsOf = [&fields](const char* field) {
        std::istringstream words(fields[field]);
        return std::vector<std::string>(std::istream_iterator<std::string>(words), {});
    };
    if (fields["dimension"] != "3") {
        return fault(StatusCode::Unsupported, file, "header: dimension", inQuotes(fields["dimension"]), "3");
    }
    const std::vector<std::string> sizes = wordsOf("sizes");
    constexpr std::size_t kMostDigits = 9;
    if (sizes.size() != 3 || !std::all_of(sizes.begin(), sizes.end(), [](const std::string& size) {
            return size.size() <= kMostDigits && size.find_first_not_of("0123456789") == std::string::npos;
        })) {
        return fault(StatusCode::BadFormat, file, "header: sizes", inQuotes(fields["sizes"]), "three counts of voxels");
    }
    for (const char* field : {"data file", "datafile"}) {
        if (const auto words = wordsOf(field); words.size() > 1 && words.front() != "LIST") {
            return fault(StatusCode::Unsupported, file, std::string("header: ") + field, inQuotes(fields[field]),
                         "the name of one file");
        }
    }
    return {};
}

/// What NIfTI's reader trusts: it takes the number of a kind for a place in a table.
Status checkNifti(const std::filesystem::path& path)
{
    constexpr std::array<std::int16_t, 16> kKinds{2,   4,   8,    16,   32,   64,   128,  256,
                                                  512, 768, 1024, 1280, 1536, 1792, 2048, 2304};
    constexpr std::int32_t kFirst = 348, kSecond = 540; // bytes of the header: NIfTI-1, NIfTI-2
    const std::string file = path.filename().string();
    std::array<unsigned char, kSecond> head{};
    gzFile in = gzopen(path.c_str(), "rb"); // reads what is not packed as it is
    const int read = in == nullptr ? 0 : gzread(in, head.data(), static_cast<unsigned>(head.size()));
    if (in != nullptr) {
        (void)gzclose(in);
    }
    const auto numberAt = [&head](std::size_t at, std::size_t bytes, bool isSwapped) {
        std::int64_t number = 0;
        for (std::size_t i = 0; i < bytes; ++i) {
            number |= static_cast<std::int64_t>(head[at + (isSwapped ? bytes - 1 - i : i)]) << (8 * i);
        }
        return number;
    };
    const bool isSwapped = head[0] == 0;
    const std::int64_t size = numberAt(0, 4, isSwapped);
    if (read < kFirst || (size != kFirst && size != kSecond) || read < size) {
        return fault(StatusCode::BadFormat, file, "header", "no header of NIfTI", "348 or 540 bytes of it");
    }
    const auto kind = static_cast<std::int16_t>(numberAt(size == kFirst ? 70 : 12, 2, isSwapped));
    if (std::find(kKinds.begin(), kKinds.end(), kind) == kKinds.end()) {
        return fault(StatusCode::BadFormat, file, "header", "voxels of kind " + std::to_string(kind),
                     "one of NIfTI's kinds, as 16 for float");
    }
    const std::int64_t axes = numberAt(size == kFirst ? 40 : 16, size == kFirst ? 2 : 8, isSwapped);
    if (axes < 1 || axes > 7) {
        return fault(StatusCode::BadFormat, file, "header", std::to_string(axes) + " axes", "1 to 7");
    }
    return {};
}

/// What a header declares must be there before VTK asks for the memory.
Status checkHeld(const int* extent, double bytesOfOne, bool isPacked, const std::filesystem::path& path,
                 const std::optional<TextHeader>& header)
{
    const std::string file = path.filename().string();
    double voxels = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double along = static_cast<double>(extent[2 * axis + 1]) - extent[2 * axis] + 1.0;
        if (!(along >= 1.0)) {
            return fault(StatusCode::OutOfRange, file, "", "an axis without a voxel", "at least one along each axis");
        }
        voxels *= along;
    }
    constexpr std::uint64_t kNiftiHeader = 352; // the least
    const bool isElsewhere = header && !header->dataFile.empty() && dataFileOf(path, *header).empty();
    const bool isNifti = file.ends_with(".nii");
    const std::uint64_t head = isNifti ? kNiftiHeader : header && header->dataFile.empty() ? header->size : 0;
    const std::uint64_t all = volumeBytes(path);
    const auto bytes = static_cast<double>(all - std::min(all, head));
    if (voxels > static_cast<double>(kMostVoxels) ||
        (!isElsewhere && voxels * bytesOfOne > bytes * (isPacked ? kMostPacked : 1.0))) {
        return fault(StatusCode::OutOfRange, file, "",
                     counted(static_cast<std::uint64_t>(std::min(voxels, 1e18)), "voxel") + " declared",
                     "as many as its " + counted(static_cast<std::uint64_t>(bytes), "byte") + " can hold");
    }
    return {};
}

/// MetaImage's reader takes what it can unpack for the whole and leaves the rest as the memory was.
Status checkUnpacks(const std::filesystem::path& path, const TextHeader& header, const int* extent, int bytesOfOne)
{
    const std::filesystem::path data = dataFileOf(path, header);
    if (!header.dataFile.empty() && data.empty()) {
        return {}; // lists of files: VTK's matter
    }
    std::uint64_t bytes = static_cast<std::uint64_t>(bytesOfOne);
    for (int axis = 0; axis < 3; ++axis) {
        bytes *= static_cast<std::uint64_t>(extent[2 * axis + 1] - extent[2 * axis] + 1);
    }
    std::ifstream in(data.empty() ? path : data, std::ios::binary);
    in.seekg(data.empty() ? static_cast<std::streamoff>(header.size) : 0);
    std::string packed(4, '\0'); // Qt wants the size in front, big-endian; it is no more than a first guess
    for (std::size_t i = 0; i < 4; ++i) {
        packed[i] = static_cast<char>((std::min<std::uint64_t>(bytes, 0x7fffffffU) >> (24 - 8 * i)) & 0xffU);
    }
    packed.append(std::istreambuf_iterator<char>(in), {});
    const auto unpacked = static_cast<std::uint64_t>(
        qUncompress(reinterpret_cast<const uchar*>(packed.data()), static_cast<qsizetype>(packed.size())).size());
    if (unpacked != bytes) {
        return fault(StatusCode::BadFormat, path.filename().string(), "",
                     unpacked == 0 ? "its compressed voxels are cut off or broken"
                                   : counted(unpacked, "byte") + " when unpacked",
                     counted(bytes, "byte") + " of voxels");
    }
    return {};
}

/// Reads with VTK. @return `volume.image` stays null where VTK's reader does not take it for its own
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
            status = Status(StatusCode::Cancelled, file + ": reading was cancelled");
        }
    };
    const auto runImage = [&](vtkImageReader2& reader) {
        if (reader.CanReadFile(path.c_str()) == 0) {
            return;
        }
        reader.SetFileName(path.c_str());
        reader.UpdateInformation();
        const bool isPacked = file.ends_with(".gz") || (header && header->isPacked);
        status = checkHeld(reader.GetDataExtent(), vtkDataArray::GetDataTypeSize(reader.GetDataScalarType()), isPacked,
                           path, header);
        if (status.isOk() && header && header->isPacked && (file.ends_with(".mha") || file.ends_with(".mhd"))) {
            status = checkUnpacks(path, *header, reader.GetDataExtent(),
                                  vtkDataArray::GetDataTypeSize(reader.GetDataScalarType()) *
                                      reader.GetNumberOfScalarComponents());
        }
        if (status.isOk()) {
            run(reader);
        }
    };
    if (file.ends_with(".vti")) {
        vtkNew<vtkXMLImageDataReader> reader;
        reader->SetFileName(path.c_str());
        reader->UpdateInformation();
        const int* extent = reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
        if (extent != nullptr) {
            status = checkHeld(extent, 1.0, true, path, header);
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
        return fault(StatusCode::Unsupported, file, "", "a name of another kind",
                     "a volume: .vti, .mha, .mhd, .nrrd, .nhdr, .nii or .nii.gz");
    }
    return status;
}

/// Takes the numbers out of what VTK has read, with all that may be wrong with them.
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
        return fault(StatusCode::BadFormat, file, "",
                     values == nullptr ? "no numbers"
                     : values->GetNumberOfComponents() != 1
                         ? counted(static_cast<std::uint64_t>(values->GetNumberOfComponents()), "component") +
                               " a voxel"
                         : counted(static_cast<std::uint64_t>(values->GetNumberOfTuples()), "number") + " for " +
                               counted(voxels, "voxel"),
                     "one number for each voxel");
    }
    const Vec3 origin(volume.image->GetOrigin()), spacing(volume.image->GetSpacing());
    const Eigen::Matrix3d linear = spacing.cwiseInverse().asDiagonal() * volume.toVoxel.linear();
    grid.toVoxel.linear() = linear;
    grid.toVoxel.translation() = spacing.cwiseInverse().cwiseProduct(volume.toVoxel.translation() - origin);
    if (!grid.toVoxel.matrix().allFinite() || !(std::abs(linear.determinant()) > 0.0)) {
        return fault(StatusCode::BadFormat, file, "", "axes or distances of its voxels that say no place",
                     "three directions that are not in a plane, and distances that are not 0");
    }
    grid.values.resize(voxels);
    switch (values->GetDataType()) {
        vtkTemplateMacro(std::transform(static_cast<const VTK_TT*>(values->GetVoidPointer(0)),
                                        static_cast<const VTK_TT*>(values->GetVoidPointer(0)) + voxels,
                                        grid.values.begin(), [](VTK_TT v) { return static_cast<float>(v); }));
    default:
        return fault(StatusCode::BadFormat, file, "", "voxels of a kind that is no number", "numbers");
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
    const std::optional<TextHeader> header = textHeader(path);
    const std::filesystem::path data = header ? dataFileOf(path, *header) : std::filesystem::path();
    return data.empty() ? sizeOf(path) : sizeOf(data);
}

Result<VoxelGrid> readVolumeHere(const std::filesystem::path& path, core::FileFrame frame,
                                 const std::function<bool(double)>& progress)
{
    const std::string file = path.filename().string();
    const NumericLocale locale;
    const VtkMessages messages;
    const std::optional<TextHeader> header = textHeader(path);
    const bool hasText =
        file.ends_with(".nrrd") || file.ends_with(".nhdr") || file.ends_with(".mha") || file.ends_with(".mhd");
    if (file.ends_with(".vti") && !isXmlEnded(path)) {
        return fault(StatusCode::BadFormat, file, "", "it does not end with its last tag", "`</VTKFile>` at the end");
    }
    if (hasText && !header) {
        return fault(StatusCode::BadFormat, file, "header", "directions of its axes that can't be read",
                     "three vectors that are not in a plane");
    }
    if (hasText && !header->isEnded) { // VTK's reader of NRRD looks for that end without one
        return fault(StatusCode::BadFormat, file, "header", "it does not end",
                     "a header that says where the voxels are");
    }
    if (hasText && !header->isPlain) {
        return fault(StatusCode::BadFormat, file, "header", "a byte of 0 in its text", "a header of text alone");
    }
    if (hasText && (header->dimensions < 1 || header->dimensions > 4)) { // MetaImage's reader counts them all
        return fault(StatusCode::BadFormat, file, "header: NDims",
                     header->dimensions == 0 ? "what is not one number"
                                             : counted(static_cast<std::uint64_t>(header->dimensions), "dimension"),
                     "1 to 4");
    }
    if (file.ends_with(".nii") || file.ends_with(".nii.gz")) {
        if (Status status = checkNifti(path); !status.isOk()) {
            return status;
        }
    }
    if (file.ends_with(".nrrd") || file.ends_with(".nhdr")) {
        if (Status status = checkNrrd(path); !status.isOk()) {
            return status;
        }
    }
    if (hasText && header->isText) { // VTK 9.1 gives back the memory as it was
        return fault(StatusCode::Unsupported, file, "header", "voxels in another encoding", "`raw` or `gzip`");
    }
    Volume volume;
    try {
        if (Status status = readWithVtk(path, header, progress, volume); !status.isOk()) {
            return status;
        }
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        return fault(StatusCode::BadFormat, file, "", std::string("VTK could not read it: ") + error.what(),
                     "a readable volume");
    }
    if (!messages.firstError().empty() || volume.image == nullptr) {
        return fault(StatusCode::BadFormat, file, "", "VTK could not read it: " + messages.firstError(),
                     "a readable volume");
    }
    place(volume, header, file, frame);
    return gridOf(volume, file);
}

Result<VoxelGrid> readVolume(const std::filesystem::path& path, core::FileFrame frame,
                             const std::function<bool(double)>& progress)
{
    const std::string file = path.filename().string();
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        return fault(StatusCode::NotFound, file, "", "no such file", "a volume");
    }
    try {
        if (!hasImportServer()) {
            return readVolumeHere(path, frame, progress);
        }
        const Result<OpenFile> open = openFile(path);
        return open.isOk() ? readVolumeInChild(open.value(), path, frame, progress) : open.status();
    } catch (const std::bad_alloc&) {
        return fault(StatusCode::OutOfRange, file, "", "not enough memory to read it", "a volume that fits");
    }
}

} // namespace palpate::meshio::internal
