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

namespace {

/// @return unit column vectors
Eigen::Matrix3d axesOf(const VolumeLayout& layout)
{
    return layout.steps * layout.voxel_mm().cwiseInverse().asDiagonal();
}

} // namespace

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

core::Result<VolumeLayout> volumeLayout(std::string_view bytes, const std::string& file, const Message& expected)
{
    return looksLikeNrrd(bytes)        ? nrrdLayout(bytes, file)
           : looksLikeMetaImage(bytes) ? metaLayout(bytes, file)
           : looksLikeNifti(bytes)
               ? niftiLayout(bytes, file)
               : core::Result<VolumeLayout>(fault(StatusCode::Unsupported, file, Message(),
                                                  Message(PALPATE_TEXT("an unknown format")), expected));
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
        const core::Count across(layout.size[0]), along(layout.size[1]), up(layout.size[2]);
        return fault(StatusCode::OutOfRange, file, header,
                     layout.layers == 1 ? Message(PALPATE_TEXT("%1 × %2 × %3 voxels"), across, along, up)
                                        : Message(PALPATE_TEXT("%1 × %2 × %3 voxels with %4 numbers each"), across,
                                                  along, up, core::Count(layout.layers)),
                     Message(PALPATE_TEXT("1 to %1 voxels"), core::Count(kMostLayoutVoxels)));
    }
    constexpr double kShortest_mm = 1e-6, kLongest_mm = 1e6;
    const core::Vec3 edges_mm = layout.voxel_mm();
    const Message expected(PALPATE_TEXT("three axes that are not in one plane, with a voxel size above 0"));
    if (!layout.origin.allFinite()) {
        return fault(StatusCode::BadFormat, file, header, Message(PALPATE_TEXT("an origin that is not finite")),
                     Message(PALPATE_TEXT("positions in mm")));
    }
    if (!layout.steps.allFinite() || !(edges_mm.minCoeff() >= kShortest_mm) || !(edges_mm.maxCoeff() <= kLongest_mm)) {
        return fault(StatusCode::BadFormat, file, header,
                     Message(PALPATE_TEXT("voxels of %1 × %2 × %3 mm"), edges_mm.x(), edges_mm.y(), edges_mm.z()),
                     expected);
    }
    constexpr double kFlat = 1e-3;
    if (!(std::abs(axesOf(layout).determinant()) > kFlat)) {
        return fault(StatusCode::BadFormat, file, header, Message(PALPATE_TEXT("axes that lie in one plane")),
                     expected);
    }
    return {};
}

Status checkRightAngles(const VolumeLayout& layout, const std::string& file)
{
    const Eigen::Matrix3d axes = axesOf(layout);
    constexpr double kMostSkew = 1e-3; // 0.06 degrees
    for (int axis = 0; axis < 3; ++axis) {
        const int next = (axis + 1) % 3;
        const double skew = std::abs(axes.col(axis).dot(axes.col(next)));
        if (skew > kMostSkew) {
            return fault(StatusCode::Unsupported, file, Message(PALPATE_TEXT("header")),
                         Message(PALPATE_TEXT("axes %1 and %2 are sheared by %3°"), axis + 1, next + 1,
                                 core::shortNumber(std::asin(std::min(skew, 1.0)) * 180.0 / std::numbers::pi, 3)),
                         Message(PALPATE_TEXT("perpendicular axes: resample the volume first (3D Slicer: Resample "
                                              "Image)")));
        }
    }
    return {};
}

} // namespace palpate::meshio::internal
