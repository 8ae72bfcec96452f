// SPDX-License-Identifier: BSD-3-Clause
#include "read/ReadMesh.h"

#include "palpate/meshio/MeshFormats.h"

#include "formats/Gzip.h"
#include "guard/PreScan.h"
#include "read/ImportServer.h"
#include "read/TriangleSoup.h"
#include "read/VtkRead.h"
#include "text/Encoding.h"
#include "text/Fault.h"
#include "text/FileStem.h"
#include "text/NumericLocale.h"

#include <cmath>
#include <exception>
#include <functional>
#include <new>
#include <optional>
#include <string>
#include <utility>

namespace palpate::meshio {

namespace internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

// Shares of the time, measured on VTP and STL files of a million triangles.
constexpr double kScanned = 0.3;
constexpr double kRead = 0.8;

/// Replaces a text in UTF-16 by the same text in UTF-8.
Status convertUtf16(FileImage& image, const std::string& file)
{
    std::optional<std::string> text = fromUtf16(image.bytes());
    if (!text) {
        return {};
    }
    if (const std::size_t data = text->find("<AppendedData"); data != std::string::npos) {
        const std::string_view tag = std::string_view(*text).substr(data, text->find('>', data) - data);
        if (tag.find("raw") != std::string_view::npos) {
            return fault(StatusCode::Unsupported, file, {},
                         {PALPATE_TEXT("the text is UTF-16, but the appended data are raw bytes")},
                         {PALPATE_TEXT("UTF-8")});
        }
    }
    dropXmlEncoding(*text);
    Result<FileImage> converted = FileImage::copy(*text, file);
    if (converted.isOk()) {
        image = std::move(converted).value();
    }
    return converted.status();
}

/// @return part of the progress from `from` to `to`; empty without progress
std::function<bool(double)> shareOf(const ReadOptions& options, double from, double to)
{
    if (!options.progress) {
        return {};
    }
    return [&options, from, to](double done) { return options.progress(from + (to - from) * done); };
}

/// Reads a mesh with VTK's reader after the checks of the format.
/// @param context  the unit is changed if the file states a scale
Result<TriangleSoup> readTriangles(const MeshFormat& format, FileImage& image, ScanContext& context,
                                   const ReadOptions& options, PreScan& scan)
{
    context.progress = shareOf(options, 0.0, kScanned);
    Result<PreScan> scanned = format.guard(image, context);
    if (!scanned.isOk()) {
        return scanned.status();
    }
    scan = std::move(scanned).value();
    if (scan.scale && *scan.scale != 1.0) {
        const bool isUsed = options.readsScale && options.unit_mm == 1.0;
        context.unit_mm = isUsed ? 1.0 / *scan.scale : options.unit_mm;
        scan.notes.push_back(
            isUsed ? core::Message(PALPATE_TEXT("SCALE=%1 in the header: a unit of the file is taken as %2 mm"),
                                   *scan.scale, context.unit_mm)
                   : core::Message(PALPATE_TEXT("SCALE=%1 in the header: not used, because the unit was given"),
                                   *scan.scale));
    }
    context.progress = shareOf(options, kScanned, kRead);
    Result<vtkSmartPointer<vtkPolyData>> data = readWithVtk(format, image, scan, context);
    if (!data.isOk()) {
        return data.status();
    }
    Result<TriangleSoup> soup = toTriangles(*data.value(), scan, context);
    data.value() = nullptr;
    return soup;
}

/// @return the voxels of a label map in LPS [mm]
std::optional<geometry::Staircase> voxelsOf(const PreScan& scan, const ScanContext& context)
{
    std::optional<geometry::Staircase> voxels = scan.voxels;
    if (voxels) {
        voxels->voxel_mm *= context.unit_mm;
        voxels->axes = core::lpsRotation(core::resolvedFrame(context.frame, scan.frame)) * voxels->axes;
    }
    return voxels;
}

/// Sets the data common to all structures of the file.
void describe(const PreScan& scan, const ScanContext& context, MeshFile& file)
{
    file.format = scan.format;
    file.frame = scan.frame;
    file.unit_mm = context.unit_mm;
    file.voxels = voxelsOf(scan, context);
}

} // namespace

Result<MeshFile> decodeMesh(FileImage image, const std::filesystem::path& path, const ReadOptions& options)
{
    if (isGzip(image.bytes()) && !hasLabelMapExtension(path) && !kStl.looksLike(image.bytes())) {
        Result<FileImage> unpacked = unpackGzip(image.bytes(), utf8Of(path.filename().string()));
        if (!unpacked.isOk()) {
            return unpacked.status();
        }
        image = std::move(unpacked).value();
    }
    ScanContext context;
    context.file = utf8Of(path.filename().string());
    context.unit_mm = options.unit_mm;
    context.isPartial = options.isPartial;
    context.frame = options.frame;
    context.path = path;
    context.progress = options.progress;
    if (Status status = convertUtf16(image, context.file); !status.isOk()) {
        return status;
    }
    const Result<const MeshFormat*> format = formatOf(image.bytes(), path);
    if (!format.isOk()) {
        return format.status();
    }
    PreScan scan;
    MeshFile file;
    file.path = path;
    context.takeStructure = [&](const TriangleSoup& one) {
        describe(scan, context, file);
        Result<std::vector<MeshStructure>> made = separate(one, scan, context);
        if (made.isOk()) {
            file.structures.push_back(std::move(made).value().front());
            if (options.structureRead) {
                options.structureRead(file);
            }
        }
        return made.status();
    };
    Result<TriangleSoup> soup = format.value()->surfaces != nullptr
                                    ? format.value()->surfaces(image, context, scan)
                                    : readTriangles(*format.value(), image, context, options, scan);
    if (!soup.isOk()) {
        return soup.status();
    }
    if (!format.value()->isLabelMap) {
        Result<std::vector<MeshStructure>> structures =
            splitStructures(soup.value(), scan, context, utf8Of(fileStem(path)));
        if (!structures.isOk()) {
            return structures.status();
        }
        file.structures = std::move(structures).value();
        describe(scan, context, file);
    }
    if (options.progress && !options.progress(1.0)) {
        return Status(StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), context.file);
    }
    file.notes = std::move(scan.notes);
    if (!scan.loss.isEmpty()) {
        file.loss = core::Message(PALPATE_TEXT("%1: %2"), context.file, scan.loss);
    }
    return file;
}

Result<MeshFile> readHere(const std::filesystem::path& path, const ReadOptions& options)
{
    Result<FileImage> image = FileImage::load(path);
    return image.isOk() ? decodeMesh(std::move(image).value(), path, options) : image.status();
}

} // namespace internal

core::Result<MeshFile> readMesh(const std::filesystem::path& path, const ReadOptions& options)
{
    const std::string name = path.filename().string();
    if (!(options.unit_mm > 0.0) || !std::isfinite(options.unit_mm)) {
        return internal::fault(core::StatusCode::BadCommandLine, name, {PALPATE_TEXT("unit")},
                               {PALPATE_TEXT("found %1"), options.unit_mm},
                               {PALPATE_TEXT("a positive number of millimetres per unit of the file")});
    }
    try {
        if (!internal::hasImportServer()) {
            ReadOptions here = options;
            here.structureRead = {}; // would delay the next structures
            return internal::readHere(path, here);
        }
        const core::Result<internal::OpenFile> file = internal::openFile(path);
        return file.isOk() ? internal::readInChild(file.value(), path, options) : file.status();
    } catch (const std::bad_alloc&) {
        return internal::fault(core::StatusCode::OutOfRange, name, {}, {PALPATE_TEXT("not enough memory to read it")},
                               {PALPATE_TEXT("a smaller file, or more free memory")});
    }
}

} // namespace palpate::meshio
