// SPDX-License-Identifier: BSD-3-Clause
// Label maps: volumes of whole numbers, each the number of a structure.
#include "formats/MeshFormat.h"
#include "labels/LabelNames.h"
#include "labels/LabelSurfaces.h"
#include "labels/LabelVolume.h"
#include "text/Encoding.h"
#include "text/FileStem.h"
#include "text/TextScan.h"
#include "voxels/VoxelReader.h"

#include <palpate/core/Numbers.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

namespace palpate::meshio::internal {

namespace {

using core::Message;
using core::Result;
using core::Status;
using core::StatusCode;

constexpr double kVoxelsRead = 0.5;   ///< share of the progress
constexpr std::size_t kFewVoxels = 8; ///< a structure of so few voxels has no reliable shape

struct NamedLabels
{
    LabelNames names;
    std::vector<core::Message> notes;
};

/// Finds names in the file, else beside it, else in the standard tables.
NamedLabels namesFor(const VolumeLayout& layout, const LabelVolume& volume, const std::filesystem::path& path)
{
    NamedLabels out;
    out.names = slicerNames(layout);
    if (out.names.empty() && !layout.labelTable.empty()) {
        out.names = niftiNames(layout.labelTable);
    }
    if (!out.names.empty()) {
        return out;
    }
    if (const auto beside = labelDescriptionBeside(path)) {
        const Result<FileImage> image = FileImage::load(*beside);
        if (image.isOk()) {
            out.names = itkSnapNames(image.value().bytes());
            out.notes.push_back({PALPATE_TEXT("names and colours from the ITK-SNAP label description %1"),
                                 inQuotes(beside->filename().string())});
            return out;
        }
    }
    if (auto table = standardTable(volume.labels, path.filename().string())) {
        out.names = std::move(table->names);
        out.notes.push_back(
            {PALPATE_TEXT("the file has no names: names by the numbers of %1, check them"), table->source});
    }
    return out;
}

/// @return for each label its name, all different
std::vector<LabelName> uniqueNames(const NamedLabels& named, const LabelVolume& volume, const std::string& file)
{
    std::vector<LabelName> out;
    std::set<std::string> used;
    const bool isLayered = volume.labels.front().layer != volume.labels.back().layer;
    for (const Label& label : volume.labels) {
        const auto found = named.names.find({label.layer, label.value});
        LabelName name = found == named.names.end() ? LabelName() : found->second;
        name.name = utf8Of(name.name);
        if (name.name.empty() || (volume.labels.size() == 1 && isPlaceholder(name.name))) {
            name.name = volume.labels.size() == 1 ? fileStem(file)
                        : isLayered
                            ? "label " + std::to_string(label.value) + " of layer " + std::to_string(label.layer + 1)
                            : "label " + std::to_string(label.value);
        }
        const std::string plain = name.name;
        for (int number = 2; !used.insert(name.name).second; ++number) {
            name.name = plain + " " + std::to_string(number);
        }
        out.push_back(std::move(name));
    }
    return out;
}

/// @return the first names, "a, b, …"
std::string listOf(const std::vector<std::string>& names)
{
    constexpr std::size_t kShown = 5;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kShown); ++i) {
        text.append(i == 0 ? "" : ", ").append(names[i]);
    }
    return names.size() > kShown ? text.append(", …") : text;
}

/// Notes names without voxels, and structures of a few voxels.
void noteLabels(const NamedLabels& named, const std::vector<LabelName>& names, const LabelVolume& volume,
                std::vector<core::Message>& notes)
{
    std::vector<std::string> small, empty;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (volume.labels[i].voxels <= kFewVoxels) {
            small.push_back(inQuotes(names[i].name));
        }
    }
    if (!small.empty()) {
        notes.push_back(
            {PALPATE_TEXT("structures of at most %1 voxels, whose shape is uncertain: %2"), kFewVoxels, listOf(small)});
    }
    if (named.names.size() > 2 * kMostLabels || named.notes.size() > 0) {
        return; // a table names more structures than a file has
    }
    for (const auto& [key, name] : named.names) {
        const bool isPresent =
            std::any_of(volume.labels.begin(), volume.labels.end(),
                        [&key = key](const Label& label) { return std::pair(label.layer, label.value) == key; });
        if (!isPresent && key.second != 0) {
            empty.push_back(inQuotes(name.name));
        }
    }
    if (!empty.empty()) {
        notes.push_back({PALPATE_TEXT("no voxels of %1"), listOf(empty)});
    }
}

template<Result<VolumeLayout> (*kLayout)(std::string_view bytes, const std::string& file)>
Result<TriangleSoup> readLabels(const FileImage& image, const ScanContext& context, PreScan& scan)
{
    const std::string& file = context.file;
    const Result<VolumeLayout> layout = kLayout(image.bytes(), file);
    if (!layout.isOk()) {
        return layout.status();
    }
    if (Status status = checkRightAngles(layout.value(), file); !status.isOk()) {
        return status;
    }
    const auto share = [&context](double from, double to) -> std::function<bool(double)> {
        return [&context, from, to](double done) {
            return !context.progress || context.progress(from + (to - from) * done);
        };
    };
    LabelCollector collector(layout.value());
    const Status read = readVoxels(layout.value(), image.bytes(), context.path, share(0.0, kVoxelsRead),
                                   [&collector](std::span<const double> numbers) { return collector.take(numbers); });
    if (!read.isOk()) {
        return read;
    }
    const Result<LabelVolume> volume = std::move(collector).finish(file);
    if (!volume.isOk()) {
        return volume.status();
    }
    NamedLabels named = namesFor(layout.value(), volume.value(), context.path);
    const std::vector<LabelName> names = uniqueNames(named, volume.value(), file);
    scan.format = layout.value().format + " label map";
    scan.frame = layout.value().frame;
    scan.notes = named.notes;
    noteLabels(named, names, volume.value(), scan.notes);
    scan.voxels = geometry::Staircase{};
    scan.voxels->voxel_mm = layout.value().voxel_mm();
    scan.voxels->axes = layout.value().steps * layout.value().voxel_mm().cwiseInverse().asDiagonal();
    scan.voxels->isStated = true;
    const auto take = [&](std::size_t i, LabelSurface surface) {
        if (surface.enclosedVoxels > 0) {
            scan.notes.push_back({PALPATE_TEXT("%1 includes what it encloses, %2 voxels of other labels"),
                                  inQuotes(names[i].name), core::Count(surface.enclosedVoxels)});
        }
        TriangleSoup one;
        one.mesh = std::move(surface.mesh);
        one.partNames = {names[i].name};
        one.partColours = {names[i].colour};
        return context.takeStructure(one);
    };
    const Result<bool> isDone = labelSurfaces(volume.value(), layout.value(), take, share(kVoxelsRead, 1.0));
    if (!isDone.isOk()) {
        return isDone.status();
    }
    return isDone.value()
               ? Result<TriangleSoup>(TriangleSoup())
               : Result<TriangleSoup>(Status(StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), file));
}

constexpr std::array<std::string_view, 2> kNrrdExtensions{".nrrd", ".nhdr"};
constexpr std::array<std::string_view, 2> kNiftiExtensions{".nii", ".nii.gz"};
constexpr std::array<std::string_view, 2> kMetaExtensions{".mha", ".mhd"};

} // namespace

const MeshFormat kNrrd{"NRRD", kNrrdExtensions, true, looksLikeNrrd, nullptr, nullptr, readLabels<nrrdLayout>, true};
const MeshFormat kNifti{"NIfTI", kNiftiExtensions,        true, looksLikeNifti, nullptr,
                        nullptr, readLabels<niftiLayout>, true};
const MeshFormat kMetaImage{"MetaImage", kMetaExtensions,        true, looksLikeMetaImage, nullptr,
                            nullptr,     readLabels<metaLayout>, true};

} // namespace palpate::meshio::internal
