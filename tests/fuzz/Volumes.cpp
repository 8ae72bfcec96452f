// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes.h"

#include "../meshio/FieldFiles.h"
#include "read/FieldFile.h"
#include "read/VolumeFile.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace palpate::fuzz {

namespace {

using meshio::internal::FieldGrid;
using meshio::internal::VoxelGrid;

/// Checks what a volume and a field have in common.
template<class Grid>
void checkGrid(const Grid& grid)
{
    std::uint64_t voxels = 1;
    for (const std::uint32_t along : grid.size) {
        require(along > 0 && along <= meshio::internal::kMostVoxels, "each axis has voxels");
        voxels *= along;
        require(voxels <= meshio::internal::kMostVoxels, "there are no more than the most");
    }
    require(grid.values.size() == voxels, "a volume has a number for each voxel");
    require(grid.toVoxel.matrix().allFinite(), "each place has a voxel's number");
}

void check(const VoxelGrid& grid)
{
    checkGrid(grid);
}

void check(const FieldGrid& grid)
{
    checkGrid(grid);
    for (const std::array<float, 3>& u : grid.values) {
        require(std::isfinite(u[0]) && std::isfinite(u[1]) && std::isfinite(u[2]), "each displacement is finite");
    }
    require(grid.at(grid.toVoxel.inverse() * core::Vec3::Zero()).allFinite(), "a displacement is found at a voxel");
}

/// A memory file with the lifetime of this object.
class MemoryFile
{
  public:
    MemoryFile()
        : m_descriptor(::memfd_create("palpate-fuzz", MFD_CLOEXEC))
    {
        require(m_descriptor >= 0, "a memory file can be made");
    }
    ~MemoryFile() { ::close(m_descriptor); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    [[nodiscard]] int descriptor() const noexcept { return m_descriptor; }

  private:
    int m_descriptor;
};

template<class Grid>
bool isSame(const Grid& a, const Grid& b)
{
    return a.size == b.size && a.toVoxel.matrix() == b.toVoxel.matrix() && a.values.size() == b.values.size() &&
           std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(a.values[0])) == 0;
}

/// A file of this name with these bytes.
const InputFile& inputFile(std::string_view bytes, const char* name)
{
    // selected by name: the extension selects the format
    static std::map<std::string, std::unique_ptr<InputFile>> files;
    std::unique_ptr<InputFile>& file = files[name];
    if (file == nullptr) {
        file = std::make_unique<InputFile>(name);
    }
    file->set(bytes);
    return *file;
}

/// Reads a volume or a field in this process and passes the result on as the import process does.
template<class Read, class Write, class Take>
void tryGrid(const InputFile& file, const char* name, const Read& read, const Write& write, const Take& take)
{
    try {
        const auto grid = read(file.path(), core::FileFrame::Untagged, std::function<bool(double)>());
        if (grid.isOk()) {
            check(grid.value());
        } else {
            requireOneLine(grid.status(), name);
        }
        const MemoryFile handed;
        require(write(handed.descriptor(), grid), "an outcome can be handed over");
        const auto taken = take(handed.descriptor(), file.path());
        require(taken.isOk() == grid.isOk(), "an outcome arrives as it was");
        require(!taken.isOk() || isSame(taken.value(), grid.value()), "a grid arrives as it was");
        require(taken.isOk() || taken.status().message() == grid.status().message(), "an error arrives as it was");
    } catch (const std::bad_alloc&) { // the caller reports the error in one line
    }
}

/// Parses a possible reply of an import process.
template<class Take>
void tryReply(std::string_view bytes, const Take& take)
{
    const MemoryFile handed;
    require(::write(handed.descriptor(), bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()),
            "there is memory for a small input");
    const auto taken = take(handed.descriptor(), "a.mha");
    if (taken.isOk()) {
        check(taken.value());
    } else {
        require(taken.status().message().find('\n') == std::string::npos, "a refusal is one line");
    }
}

} // namespace

std::vector<std::string> volumeSeeds(std::string_view ending)
{
    std::vector<std::string> seeds;
    for (const test::VolumeSample& sample : test::volumeSamples()) {
        if (sample.dataName.empty() && sample.name.ends_with(ending)) {
            seeds.push_back(sample.bytes);
        }
    }
    // Kinds that fuzzing found: declared layers, keys in other spellings, the end before other keys.
    if (ending == ".nii") {
        seeds.push_back(test::niftiWideHeader(std::int64_t{1} << 27, 1) + test::volumeNumbers());
    } else if (ending == ".mha") {
        seeds.push_back(test::metaHeader("MET_LONG_LONG", "LOCAL", "ElemenTNumberOfChannels = 3\n") +
                        test::volumeNumbers());
        seeds.push_back(test::metaHeader("MET_FLOAT", "LOCAL", "ElementDataFile = LOCAL\n") + test::volumeNumbers());
        seeds.push_back(test::metaHeader("MET_FLOAT", "LOCAL", "HeaderSize = -1\n") + test::volumeNumbers());
    } else if (ending == ".vti") {
        seeds.push_back(test::vtiText("1 2 3", "-1 2 0 0 7 7"));
    }
    return seeds;
}

std::vector<std::string> labelSeeds(std::string_view ending)
{
    test::LabelGrid grid;
    grid.size = {6, 5, 4};
    grid.steps = test::obliqueSteps(core::Vec3(1, 1, 2));
    grid.fill([](const core::Vec3& p) { return p.x() < 1.5 ? 0 : p.y() < 2.0 ? 1 : 2; });
    test::LabelGrid layered = grid;
    layered.layers = 2;
    layered.values.insert(layered.values.end(), grid.values.begin(), grid.values.end());
    const std::string bytes = test::labelNumbers<std::uint8_t>(grid);
    const std::string names = "Segment0_Name:=liver\nSegment0_LabelValue:=1\nSegment0_Color:=1 0 0.5\n";
    const std::string xml = "<CaretExtension><LabelTable><Label Key=\"1\" Red=\"1\"><![CDATA[spleen]]></Label>"
                            "</LabelTable></CaretExtension>";
    if (ending == ".nrrd") {
        return {test::labelNrrd(grid, "uchar", "raw", names) + bytes,
                test::labelNrrd(grid, "uchar", "gzip", names) + test::gzipped(bytes),
                test::labelNrrd(layered, "uchar", "raw", names, true, true) +
                    test::labelNumbers<std::uint8_t>(layered, false, true)};
    }
    if (ending == ".nii") {
        return {test::labelNifti(grid, 2, false, xml) + bytes,
                test::gzipped(test::labelNifti(grid, 4, true, xml) + test::labelNumbers<std::int16_t>(grid, true))};
    }
    return {test::labelMeta(grid, "MET_UCHAR") + bytes,
            test::labelMeta(grid, "MET_UCHAR", "CompressedData = True\n") + test::zlibbed(bytes)};
}

std::vector<std::string> fieldSeeds(std::string_view ending)
{
    test::FieldSample field;
    field.size = {4, 3, 2};
    field.u = [](const core::Vec3& p) { return core::Vec3(0.1 * p.x(), 0.02 * p.y(), 1.0); };
    std::vector<std::string> seeds;
    for (test::FieldFile& file : test::fieldFiles(field)) {
        if (file.name.ends_with(ending)) {
            seeds.push_back(std::move(file.bytes));
        }
    }
    return seeds;
}

void tryVolume(std::string_view bytes, const char* name)
{
    const InputFile& file = inputFile(bytes, name);
    tryGrid(file, name, meshio::internal::readVolumeHere, meshio::internal::writeVolume, meshio::internal::takeVolume);
    tryGrid(file, name, meshio::internal::readFieldHere, meshio::internal::writeField, meshio::internal::takeField);
}

void tryHandedBack(std::string_view bytes)
{
    tryReply(bytes, meshio::internal::takeVolume);
    tryReply(bytes, meshio::internal::takeField);
}

} // namespace palpate::fuzz
