// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/ColourMap.h"

#include <palpate/core/Export.h>
#include <palpate/geometry/Repair.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <span>

namespace palpate::view {

/// Colour of unknown values.
inline constexpr Colour kUnknownColour{0.88, 0.88, 0.88};

/// Maps a value to a colour: cividis, lightened so that shading remains visible on the dark end.
/// @param t  0 to 1, clamped
[[nodiscard]] PALPATE_EXPORT Colour surfaceColour(double t) noexcept;

/// Value range of a colour map.
struct ColourRange
{
    double low = 0.0, high = 1.0;
    bool isLowCut = false, isHighCut = false; ///< values beyond the range exist and are clamped to the end colours
    bool hasUnknown = false;                  ///< unknown values (NaN) exist
};

/// Computes the range of a colour map, robust against outliers.
/// @return the 2nd to the 98th percentile of the finite values; minimum to maximum where these percentiles are equal;
/// {0, 1} without finite values
[[nodiscard]] PALPATE_EXPORT ColourRange colourRange(std::span<const float> values);

/// Colours a picture with `surfaceColour`.
/// @param picture  made from `surface` by `makeSurface`; points and triangles are shared, not copied
/// @param values  one per vertex or one per triangle of the surface; with any other size the result has no colours
/// @param unknown  colour of unknown values (NaN)
/// @return a picture with colours at points or triangles
/// @par Cost O(triangles)
/// @par Thread Any
[[nodiscard]] PALPATE_EXPORT vtkSmartPointer<vtkPolyData>
coloured(vtkPolyData& picture, const geometry::RepairedMesh& surface, std::span<const float> values, bool isPerTriangle,
         const ColourRange& range, const Colour& unknown = kUnknownColour);
/// Same with a colour for each vertex of the surface.
[[nodiscard]] PALPATE_EXPORT vtkSmartPointer<vtkPolyData>
coloured(vtkPolyData& picture, const geometry::RepairedMesh& surface, std::span<const Colour> colours);

} // namespace palpate::view
