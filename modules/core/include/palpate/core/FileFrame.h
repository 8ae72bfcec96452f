// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace palpate::core {

/// Coordinate axes of a file. The world frame is LPS; every frame is related to LPS by a rotation, so the winding of
/// triangles is preserved.
enum class FileFrame : std::uint8_t
{
    Untagged, ///< unspecified, interpreted as LPS
    Lps,      ///< x to the patient's left, y to the back, z to the head (DICOM, ITK)
    Ras,      ///< x to the right, y to the front, z to the head (NIfTI, older models of 3D Slicer)
    YUp,      ///< x to the left, y to the head, z to the front (glTF 2.0, section 3.4; modelling programs)
};

/// Names in scene files, in recordings and on the command line; empty for `Untagged`.
inline constexpr std::array<std::string_view, 4> kFrameNames{"", "LPS", "RAS", "Y-up"};

/// @return name of the axes; "LPS" for `Untagged`
[[nodiscard]] constexpr std::string_view axesOf(FileFrame frame) noexcept
{
    return kFrameNames[frame == FileFrame::Untagged ? 1 : static_cast<std::size_t>(frame)];
}

/// @return frame of this name, or std::nullopt if unknown or empty
[[nodiscard]] constexpr std::optional<FileFrame> frameNamed(std::string_view name) noexcept
{
    for (std::size_t i = 1; i < kFrameNames.size(); ++i) {
        if (kFrameNames[i] == name) {
            return static_cast<FileFrame>(i);
        }
    }
    return std::nullopt;
}

/// @param chosen  choice of the user; overrides the tag
/// @param tag     frame stated by the file
[[nodiscard]] constexpr FileFrame resolvedFrame(FileFrame chosen, FileFrame tag) noexcept
{
    return chosen == FileFrame::Untagged ? tag : chosen;
}

/// Converts a point or direction from a file's frame to LPS. Exact.
[[nodiscard]] inline Vec3 toLps(FileFrame frame, const Vec3& p) noexcept
{
    switch (frame) {
    case FileFrame::Ras:
        return {-p.x(), -p.y(), p.z()};
    case FileFrame::YUp:
        return {p.x(), -p.z(), p.y()};
    case FileFrame::Untagged:
    case FileFrame::Lps:
        break;
    }
    return p;
}

/// Rotation matrix of `toLps`.
[[nodiscard]] inline Eigen::Matrix3d lpsRotation(FileFrame frame) noexcept
{
    Eigen::Matrix3d R;
    for (int axis = 0; axis < 3; ++axis) {
        R.col(axis) = toLps(frame, Vec3::Unit(axis));
    }
    return R;
}

} // namespace palpate::core
