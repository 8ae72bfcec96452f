// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/igtl/Wire.h"

#include <palpate/core/Status.h>

#include <array>
#include <cstdint>
#include <vector>

namespace palpate::igtl {

/// Surface of a POLYDATA, in the frame of the peer, by custom RAS in mm.
struct Surface
{
    std::vector<std::array<float, 3>> points;
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices of points
    std::uint32_t vertices = 0;                          ///< cells that are no surface and were left out
    std::uint32_t lines = 0;                             ///< likewise
};

/// Polygons become fans of triangles and strips single triangles; attributes are ignored. Every count, size and index
/// is compared with the content before memory is allocated, and every coordinate is finite and within
/// `kMaxCoordinate_mm`.
/// @return BadFormat with the place, or Empty without a triangle
[[nodiscard]] core::Result<Surface> decodeSurface(ByteView content);

/// @param surface  `vertices` and `lines` are not written
[[nodiscard]] Bytes encodeSurface(const Surface& surface);

} // namespace palpate::igtl
