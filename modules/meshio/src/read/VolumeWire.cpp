// SPDX-License-Identifier: BSD-3-Clause
#include "read/VolumeFile.h"
#include "read/Wire.h"
#include "text/Fault.h"

#include <cmath>
#include <string>
#include <string_view>

namespace palpate::meshio::internal {

using core::Result;
using core::StatusCode;

// The values follow the head.

bool writeVolume(int descriptor, Result<VoxelGrid> outcome)
{
    WireHead head;
    head.put(outcome.status());
    if (!outcome.isOk()) {
        return head.write(descriptor);
    }
    const VoxelGrid& grid = outcome.value();
    head.put(grid.size);
    for (int i = 0; i < 12; ++i) {
        head.put(grid.toVoxel.matrix()(i / 4, i % 4));
    }
    return head.write(descriptor) && writeAll(descriptor, grid.values.data(), grid.values.size() * sizeof(float));
}

Result<VoxelGrid> takeVolume(int descriptor, const std::filesystem::path& path)
{
    const std::string name = path.filename().string();
    static constexpr std::string_view kExpected = "a checked volume";
    const auto nonsense = [&name](const char* what) {
        return fault(StatusCode::Internal, name, "", std::string("the import process handed back ") + what, kExpected);
    };
    const WireOutcome outcome = readHead(descriptor, name, kExpected);
    if (!outcome.status.isOk()) {
        return outcome.status;
    }
    WireHeadReader head(outcome.head);
    VoxelGrid grid;
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
        outcome.size - outcome.begin != voxels * sizeof(float)) {
        return nonsense("counts that do not fit its size");
    }
    if (!grid.toVoxel.matrix().allFinite()) {
        return nonsense("axes that are not numbers");
    }
    std::uint64_t at = outcome.begin;
    if (!moveItems(descriptor, at, voxels, grid.values, [](float) { return true; })) {
        return nonsense("half of its voxels");
    }
    return grid;
}

} // namespace palpate::meshio::internal
