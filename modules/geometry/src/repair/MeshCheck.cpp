// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/MeshCheck.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::geometry {

using core::Count;
using core::Status;
using core::StatusCode;

Status MeshCheck::status() const
{
    const auto count = [](double number) { return Count(static_cast<std::uint64_t>(number)); };
    switch (error) {
    case MeshError::None:
        break;
    case MeshError::NoTriangles:
        return {StatusCode::Empty, PALPATE_TEXT("the mesh has no triangles, expected at least 1")};
    case MeshError::TooLarge:
        return {StatusCode::OutOfRange, PALPATE_TEXT("the mesh has %1 vertices or triangles, expected at most %2"),
                count(value), count(expected)};
    case MeshError::IndexOutOfRange:
        return {StatusCode::OutOfRange, PALPATE_TEXT("triangle %1 uses vertex %2, expected a number below %3"),
                Count(element), count(value), count(expected)};
    case MeshError::NonFiniteCoordinate:
        return {StatusCode::NonFinite, PALPATE_TEXT("vertex %1 has the coordinate %2, expected a finite number"),
                Count(element), value};
    case MeshError::CoordinateTooLarge:
        return {StatusCode::OutOfRange,
                PALPATE_TEXT("vertex %1 has the coordinate %2 mm, expected at most %3 mm; check the unit"),
                Count(element), value, expected};
    case MeshError::ArraySizeMismatch:
        return {StatusCode::Mismatch, PALPATE_TEXT("array %1 has %2 values, expected %3"), Count(element), count(value),
                count(expected)};
    }
    return {};
}

MeshCheck check(const TriangleMesh& mesh) noexcept
{
    constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max() - 1; // the largest index is kNoVertex
    const std::size_t vertices = mesh.vertices.size(), triangles = mesh.triangles.size();
    if (triangles == 0) {
        return {MeshError::NoTriangles};
    }
    if (const std::size_t larger = std::max(vertices, triangles); larger > kMost) {
        return {MeshError::TooLarge, 0, static_cast<double>(larger), static_cast<double>(kMost)};
    }
    for (std::size_t i = 0; i < triangles; ++i) {
        for (const std::uint32_t v : mesh.triangles[i]) {
            if (v >= vertices) {
                return {MeshError::IndexOutOfRange, i, static_cast<double>(v), static_cast<double>(vertices)};
            }
        }
    }
    for (std::size_t i = 0; i < vertices; ++i) {
        for (const double coordinate : mesh.vertices[i]) {
            if (!std::isfinite(coordinate)) {
                return {MeshError::NonFiniteCoordinate, i, coordinate};
            }
            if (std::abs(coordinate) > kMostCoordinate_mm) {
                return {MeshError::CoordinateTooLarge, i, coordinate, kMostCoordinate_mm};
            }
        }
    }
    for (std::size_t i = 0; i < mesh.arrays.size(); ++i) {
        const std::size_t expected = mesh.arrays[i].isPerTriangle ? triangles : vertices;
        if (mesh.arrays[i].values.size() != expected) {
            return {MeshError::ArraySizeMismatch, i, static_cast<double>(mesh.arrays[i].values.size()),
                    static_cast<double>(expected)};
        }
    }
    return {};
}

} // namespace palpate::geometry
