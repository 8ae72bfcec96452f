// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/geometry/TriangleMesh.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace palpate::view {

/// A surface of a thumbnail.
struct ThumbnailSurface
{
    const geometry::TriangleMesh* mesh = nullptr; ///< in the world frame (LPS) [mm]
    std::array<double, 3> colour{};               ///< red, green, blue in 0 … 1
    double opacity = 1.0;                         ///< 0 … 1
};

/// Draws surfaces from obliquely in front as a small picture with a transparent background. Computed on the CPU,
/// without OpenGL and a display, because file managers draw thumbnails in a sandbox without either.
/// @param size_px  width and height, 1 … 2048
/// @return red, green, blue and alpha (not multiplied) of each pixel, rows from the top; all 0 without triangles
[[nodiscard]] PALPATE_EXPORT std::vector<std::uint8_t> drawThumbnail(std::span<const ThumbnailSurface> surfaces,
                                                                     int size_px);

} // namespace palpate::view
