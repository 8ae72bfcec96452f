// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes.h"

#include "../meshio/LabelFiles.h"
#include "read/VolumeFile.h"

#include <cstring>
#include <map>
#include <memory>
#include <new>
#include <sys/mman.h>
#include <unistd.h>

namespace palpate::fuzz {

namespace {

using meshio::internal::VoxelGrid;

void check(const VoxelGrid& grid)
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

bool isSame(const VoxelGrid& a, const VoxelGrid& b)
{
    return a.size == b.size && a.toVoxel.matrix() == b.toVoxel.matrix() && a.values.size() == b.values.size() &&
           std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(float)) == 0;
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

void tryVolume(std::string_view bytes, const char* name)
{
    // selected by name: the extension selects the format
    static std::map<std::string, std::unique_ptr<InputFile>> files;
    std::unique_ptr<InputFile>& file = files[name];
    if (file == nullptr) {
        file = std::make_unique<InputFile>(name);
    }
    file->set(bytes);
    try {
        const auto grid = meshio::internal::readVolumeHere(file->path(), core::FileFrame::Untagged, {});
        if (grid.isOk()) {
            check(grid.value());
        } else {
            requireOneLine(grid.status(), name);
        }
        const MemoryFile handed;
        require(meshio::internal::writeVolume(handed.descriptor(), grid), "an outcome can be handed over");
        const auto taken = meshio::internal::takeVolume(handed.descriptor(), file->path());
        require(taken.isOk() == grid.isOk(), "an outcome arrives as it was");
        require(!taken.isOk() || isSame(taken.value(), grid.value()), "a volume arrives as it was");
        require(taken.isOk() || taken.status().message() == grid.status().message(), "an error arrives as it was");
    } catch (const std::bad_alloc&) { // the caller reports the error in one line
    }
}

void tryHandedBack(std::string_view bytes)
{
    const MemoryFile handed;
    require(::write(handed.descriptor(), bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()),
            "there is memory for a small input");
    const auto taken = meshio::internal::takeVolume(handed.descriptor(), "a.mha");
    if (taken.isOk()) {
        check(taken.value());
    } else {
        require(taken.status().message().find('\n') == std::string::npos, "a refusal is one line");
    }
}

} // namespace palpate::fuzz
