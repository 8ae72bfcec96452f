// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/TriangleMesh.h"

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>

#include <cstddef>
#include <cstdint>

namespace palpate::geometry {

/// Largest coordinate of a mesh [mm]; the same limit as in mesh files.
inline constexpr double kMostCoordinate_mm = 1e7;

/// Error of a mesh from memory, one for each cause.
enum class MeshError : std::uint8_t
{
    None,
    NoTriangles,
    TooLarge,            ///< more vertices or triangles than 32-bit indices can address
    IndexOutOfRange,     ///< a triangle uses a vertex that does not exist
    NonFiniteCoordinate, ///< NaN or infinite
    CoordinateTooLarge,  ///< beyond kMostCoordinate_mm
    ArraySizeMismatch,   ///< an array has fewer or more values than vertices or triangles
};

/// First error of a mesh.
struct PALPATE_EXPORT MeshCheck
{
    MeshError error = MeshError::None;
    std::size_t element = 0; ///< index of the triangle, vertex or array
    double value = 0.0;      ///< value found: the vertex index, coordinate, or number of elements
    double expected = 0.0;   ///< number of vertices or elements, or the limit

    [[nodiscard]] bool isOk() const noexcept { return error == MeshError::None; }
    /// Error with a message that names the element, the value found and the value expected.
    [[nodiscard]] core::Status status() const;
};

/// Checks the preconditions of `repair`: at least one triangle, indices in range, finite coordinates within
/// kMostCoordinate_mm, and arrays of matching size.
/// @par Cost O(n). Any thread.
[[nodiscard]] PALPATE_EXPORT MeshCheck check(const TriangleMesh& mesh) noexcept;

} // namespace palpate::geometry
