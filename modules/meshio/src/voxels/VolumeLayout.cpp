// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/VolumeLayout.h"

#include "text/TextScan.h"

#include <palpate/core/Numbers.h>

#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace palpate::meshio::internal {

using core::Message;
using core::Status;
using core::StatusCode;

std::vector<double> numbersIn(std::string_view text, std::size_t most)
{
    std::vector<double> numbers;
    for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text)) {
        const std::optional<double> number = wordToNumber(word);
        if (!number || !std::isfinite(*number) || numbers.size() == most) {
            return {};
        }
        numbers.push_back(*number);
    }
    return numbers;
}

Status checkLayout(const VolumeLayout& layout, const std::string& file)
{
    const Message header(PALPATE_TEXT("header"));
    std::uint64_t voxels = layout.layers;
    for (const std::uint32_t along : layout.size) {
        // Both factors are at most 2^32.
        voxels = voxels > kMostLayoutVoxels ? voxels : voxels * along;
    }
    if (voxels < 1 || voxels > kMostLayoutVoxels) {
        return fault(StatusCode::OutOfRange, file, header,
                     Message(PALPATE_TEXT("%1 × %2 × %3 voxels in %4 layers"), core::Count(layout.size[0]),
                             core::Count(layout.size[1]), core::Count(layout.size[2]), core::Count(layout.layers)),
                     Message(PALPATE_TEXT("1 to %1 voxels"), core::Count(kMostLayoutVoxels)));
    }
    constexpr double kShortest_mm = 1e-6, kLongest_mm = 1e6;
    const core::Vec3 edges_mm = layout.voxel_mm();
    const Message expected(PALPATE_TEXT("three perpendicular axes with a voxel size above 0"));
    if (!layout.steps.allFinite() || !layout.origin.allFinite() || !(edges_mm.minCoeff() >= kShortest_mm) ||
        !(edges_mm.maxCoeff() <= kLongest_mm)) {
        return fault(StatusCode::BadFormat, file, header,
                     Message(PALPATE_TEXT("voxels of %1 × %2 × %3 mm"), edges_mm.x(), edges_mm.y(), edges_mm.z()),
                     expected);
    }
    const Eigen::Matrix3d axes = layout.steps * edges_mm.cwiseInverse().asDiagonal();
    constexpr double kFlat = 1e-3, kMostSkew = 1e-3; // the latter is 0.06 degrees
    if (!(std::abs(axes.determinant()) > kFlat)) {
        return fault(StatusCode::BadFormat, file, header, Message(PALPATE_TEXT("axes that lie in one plane")),
                     expected);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const int next = (axis + 1) % 3;
        const double skew = std::abs(axes.col(axis).dot(axes.col(next)));
        if (skew > kMostSkew) {
            return fault(StatusCode::Unsupported, file, header,
                         Message(PALPATE_TEXT("axes %1 and %2 are sheared by %3°"), axis + 1, next + 1,
                                 core::shortNumber(std::asin(std::min(skew, 1.0)) * 180.0 / std::numbers::pi, 3)),
                         Message(PALPATE_TEXT("perpendicular axes: resample the volume first (3D Slicer: Resample "
                                              "Image)")));
        }
    }
    return {};
}

} // namespace palpate::meshio::internal
