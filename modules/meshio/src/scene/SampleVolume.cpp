// SPDX-License-Identifier: BSD-3-Clause
#include "scene/SampleVolume.h"

#include "read/VolumeFile.h"

#include <palpate/core/Parallel.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;

/// Interpolates trilinearly. @return NaN outside the grid and next to unknown values
double valueAt(const VoxelGrid& grid, const Vec3& p_W)
{
    const Vec3 p = grid.toVoxel * p_W;
    for (int axis = 0; axis < 3; ++axis) {
        if (!(p[axis] >= 0.0 && p[axis] <= grid.size[static_cast<std::size_t>(axis)] - 1.0)) {
            return std::numeric_limits<double>::quiet_NaN();
        }
    }
    return grid.at(p);
}

/// Sample positions below a contact, each with an equal share of the press energy, in units of c = a/pi: z is the
/// depth, r the distance from the axis.
std::vector<Vec3> placesBelow()
{
    // In spherical coordinates about the point c above the surface, where the weight is z^2 / R^6 and z = R cos - c:
    // each sample is the centre of a cell of equal weight, computed by numerical bisection of the integrals.
    constexpr int kRings = 6, kTurns = 8, kDepths = 8;
    std::vector<Vec3> places;
    // Weight over all r at depth z: integral of 2 pi r w = 3 c z^2 / (z + c)^4, with the antiderivative (z / (z +
    // c))^3.
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
        return Status(StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"),
                      std::filesystem::path(mapping.file).filename());
    };
    if (isStopped()) {
        return cancelled();
    }
    std::function<bool(double)> progress;
    if (keepGoing) {
        progress = [&keepGoing](double) { return keepGoing(); };
    }
    const Result<VoxelGrid> read = readVolume(mapping.file, frame, progress);
    if (!read.isOk()) {
        return read.status();
    }
    const VoxelGrid& volume = read.value();
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
                const double value = valueAt(volume, p + c_mm * (place.x() * u + place.y() * v - place.z() * n));
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
