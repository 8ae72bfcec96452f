// SPDX-License-Identifier: BSD-3-Clause
#include "read/FieldFile.h"
#include "read/VolumeFile.h"
#include "read/Wire.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace palpate::meshio::internal {

using core::Result;

namespace {

// The values follow the head.

template<class Grid>
bool writeGrid(int descriptor, const Result<Grid>& outcome)
{
    WireHead head;
    head.put(outcome.status());
    if (!outcome.isOk()) {
        return head.write(descriptor);
    }
    const Grid& grid = outcome.value();
    head.put(grid.size);
    for (int i = 0; i < 12; ++i) {
        head.put(grid.toVoxel.matrix()(i / 4, i % 4));
    }
    return head.write(descriptor) &&
           writeAll(descriptor, grid.values.data(), grid.values.size() * sizeof(grid.values[0]));
}

/// @param isGood  checks a value
template<class Grid, class Check>
Result<Grid> takeGrid(int descriptor, const std::filesystem::path& path, Check isGood)
{
    const std::string name = path.filename().string();
    const auto invalid = [&name](const core::Message& what) { return wireFault(name, what); };
    const Result<WireFrame> frame = readFrame(descriptor, 0, name);
    if (!frame.isOk()) {
        return frame.status();
    }
    WireHeadReader head(frame.value().head);
    if (core::Status status = head.status(name); !status.isOk()) {
        return status;
    }
    Grid grid;
    grid.size = head.take<std::array<std::uint32_t, 3>>();
    for (int i = 0; i < 12; ++i) {
        grid.toVoxel.matrix()(i / 4, i % 4) = head.take<double>();
    }
    std::uint64_t voxels = 1;
    for (const std::uint32_t along : grid.size) {
        // Both factors are at most kMostVoxels, 2^30, so the product fits 64 bits.
        voxels = along > kMostVoxels || voxels > kMostVoxels ? 0 : voxels * along;
    }
    if (!head.isAtEnd() || voxels == 0 || voxels > kMostVoxels ||
        frame.value().size - frame.value().begin != voxels * sizeof(grid.values[0])) {
        return invalid({PALPATE_TEXT("its counts do not match its size")});
    }
    if (!grid.toVoxel.matrix().allFinite()) {
        return invalid({PALPATE_TEXT("its axes are not finite numbers")});
    }
    std::uint64_t at = frame.value().begin;
    if (!moveItems(descriptor, at, voxels, grid.values, isGood)) {
        return invalid({PALPATE_TEXT("its voxels are incomplete")});
    }
    return grid;
}

} // namespace

bool writeVolume(int descriptor, Result<VoxelGrid> outcome)
{
    return writeGrid(descriptor, outcome);
}

Result<VoxelGrid> takeVolume(int descriptor, const std::filesystem::path& path)
{
    return takeGrid<VoxelGrid>(descriptor, path, [](float) { return true; });
}

bool writeField(int descriptor, Result<FieldGrid> outcome)
{
    return writeGrid(descriptor, outcome);
}

Result<FieldGrid> takeField(int descriptor, const std::filesystem::path& path)
{
    return takeGrid<FieldGrid>(descriptor, path, [](const std::array<float, 3>& u) {
        return std::all_of(u.begin(), u.end(), [](float number) { return std::isfinite(number); });
    });
}

} // namespace palpate::meshio::internal
