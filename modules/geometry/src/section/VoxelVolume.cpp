// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/VoxelVolume.h"

#include <palpate/core/Parallel.h>

#include <algorithm>
#include <cmath>

namespace palpate::geometry {

namespace {

Vec3 lastVoxel(const VoxelVolume& volume)
{
    return {volume.size[0] - 1.0, volume.size[1] - 1.0, volume.size[2] - 1.0};
}

/// Part of a convex polygon with `distance` of at least 0.
template<class Distance>
std::vector<Eigen::Vector2d> keptPart(const std::vector<Eigen::Vector2d>& polygon, const Distance& distance)
{
    std::vector<Eigen::Vector2d> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double da = distance(a), db = distance(b);
        if (da >= 0.0) {
            kept.push_back(a);
        }
        if ((da >= 0.0) != (db >= 0.0)) {
            kept.emplace_back(a + da / (da - db) * (b - a));
        }
    }
    return kept;
}

} // namespace

double VoxelVolume::at(const Vec3& voxel) const
{
    std::array<std::size_t, 3> low{}, step{1, size[0], std::size_t{size[0]} * size[1]};
    Vec3 share;
    std::size_t first = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        low[a] = std::min(static_cast<std::size_t>(voxel[axis]), std::size_t{size[a] < 2 ? 0 : size[a] - 2});
        share[axis] = voxel[axis] - static_cast<double>(low[a]);
        first += low[a] * step[a];
    }
    double sum = 0.0;
    for (std::size_t corner = 0; corner < 8; ++corner) {
        double weight = 1.0;
        std::size_t place = first;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool isUpper = ((corner >> axis) & 1U) != 0;
            const double part = share[static_cast<Eigen::Index>(axis)];
            weight *= isUpper ? part : 1.0 - part;
            place += isUpper ? step[axis] : 0;
        }
        if (weight > 0.0) {
            sum += weight * double{values[place]};
        }
    }
    return sum;
}

std::optional<double> VoxelVolume::numberAt(const Vec3& p_W) const
{
    const Vec3 voxel = toVoxel * p_W, last = lastVoxel(*this);
    const bool isInside = (voxel.array() >= -0.5).all() && ((last - voxel).array() >= -0.5).all();
    return isInside ? std::optional(at(voxel.cwiseMax(0.0).cwiseMin(last))) : std::nullopt;
}

GreyWindow usualWindow(const VoxelVolume& volume)
{
    constexpr std::size_t kAsked = 1'000'000;
    std::vector<float> known;
    const std::size_t step = std::max<std::size_t>(1, volume.values.size() / kAsked);
    for (std::size_t i = 0; i < volume.values.size(); i += step) {
        if (std::isfinite(volume.values[i])) {
            known.push_back(volume.values[i]);
        }
    }
    if (known.empty()) {
        return {};
    }
    std::sort(known.begin(), known.end());
    // Air and padding have one number in a large part of the volume.
    const auto above = std::upper_bound(known.begin(), known.end(), known.front());
    const auto rest = static_cast<std::size_t>(known.end() - above);
    const std::size_t first = rest > known.size() / 20 ? known.size() - rest : 0;
    const auto percentile = [&](double share) {
        return double{known[first + static_cast<std::size_t>(share * static_cast<double>(known.size() - first - 1))]};
    };
    const double low = percentile(0.01), high = percentile(0.99);
    return {0.5 * (low + high), high > low ? high - low : 1.0};
}

std::vector<Eigen::Vector2d> cutOf(const VoxelVolume& volume, const SectionPlane& plane)
{
    const Vec3 start = volume.toVoxel * plane.p_W;
    const Vec3 u = volume.toVoxel.linear() * plane.u_W, v = volume.toVoxel.linear() * plane.v_W;
    // A square that covers every cut: its half side is the distance to the farthest corner of the volume.
    const Eigen::Affine3d toWorld = volume.toVoxel.inverse();
    double reach_mm = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 p;
        for (int axis = 0; axis < 3; ++axis) {
            p[axis] = ((corner >> axis) & 1) != 0 ? volume.size[static_cast<std::size_t>(axis)] - 0.5 : -0.5;
        }
        reach_mm = std::max(reach_mm, (toWorld * p - plane.p_W).norm());
    }
    std::vector<Eigen::Vector2d> outline{
        {-reach_mm, -reach_mm}, {reach_mm, -reach_mm}, {reach_mm, reach_mm}, {-reach_mm, reach_mm}};
    for (int axis = 0; axis < 3; ++axis) {
        const auto voxel = [&](const Eigen::Vector2d& q) { return start[axis] + q.x() * u[axis] + q.y() * v[axis]; };
        const double last = volume.size[static_cast<std::size_t>(axis)] - 0.5;
        outline = keptPart(outline, [&](const Eigen::Vector2d& q) { return voxel(q) + 0.5; });
        outline = keptPart(outline, [&](const Eigen::Vector2d& q) { return last - voxel(q); });
    }
    return outline.size() < 3 ? std::vector<Eigen::Vector2d>() : outline;
}

VolumeSlice sliceOf(const VoxelVolume& volume, const SectionPlane& plane, const GreyWindow& window, int most)
{
    VolumeSlice slice;
    slice.outline = cutOf(volume, plane);
    for (const Eigen::Vector2d& q : slice.outline) {
        slice.box.extend(q);
    }
    if (slice.outline.empty()) {
        return slice;
    }
    const Vec3 u = volume.toVoxel.linear() * plane.u_W, v = volume.toVoxel.linear() * plane.v_W;
    const auto pixels = [most](double voxels) { return std::clamp(static_cast<int>(std::ceil(voxels)), 2, most); };
    slice.columns = pixels(u.norm() * slice.box.sizes().x());
    slice.rows = pixels(v.norm() * slice.box.sizes().y());
    slice.greys.resize(static_cast<std::size_t>(slice.columns) * static_cast<std::size_t>(slice.rows));
    const Vec3 column = u * slice.box.sizes().x() / slice.columns, row = v * slice.box.sizes().y() / slice.rows;
    const Vec3 first = volume.toVoxel * plane.inWorld(slice.box.min()) + 0.5 * (column + row);
    const Vec3 last = lastVoxel(volume);
    const double black = window.level - 0.5 * window.width;
    core::parallelForBlocks(static_cast<std::size_t>(slice.rows), 16, [&](std::size_t y) {
        for (int x = 0; x < slice.columns; ++x) {
            const Vec3 voxel = first + static_cast<double>(y) * row + x * column;
            const double share = (volume.at(voxel.cwiseMax(0.0).cwiseMin(last)) - black) / window.width;
            slice.greys[y * static_cast<std::size_t>(slice.columns) + static_cast<std::size_t>(x)] =
                share > 0.0 ? static_cast<std::uint8_t>(std::lround(255.0 * std::min(share, 1.0))) : 0;
        }
    });
    return slice;
}

} // namespace palpate::geometry
