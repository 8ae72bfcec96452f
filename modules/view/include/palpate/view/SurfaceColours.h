// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/ColourMap.h"

#include <palpate/geometry/MeshReport.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <span>

namespace palpate::view {

/// Of what the colours do not tell.
inline constexpr Colour kUnknownColour{0.88, 0.88, 0.88};

/// The colour of a number: cividis, lightened so that the shape of a surface still reads where it is dark.
/// @param t  0 … 1, clamped
[[nodiscard]] Colour surfaceColour(double t) noexcept;

/// The numbers at the ends of a colour map.
struct ColourRange
{
    double low = 0.0, high = 1.0;
    bool isLowCut = false, isHighCut = false; ///< some numbers lie beyond: they have the end's colour
    bool hasUnknown = false;                  ///< some are not known (NaN)
};

/// @return from the 2nd to the 98th percentile of the known numbers: a few wild ones do not take all the colours. Where
/// these are one number, from the least to the largest; {0, 1} without any number.
[[nodiscard]] ColourRange colourRange(std::span<const float> values);

/// Colours a picture by numbers, with `surfaceColour`; unknown ones are light grey.
/// @param picture  made of `surface` by `makeSurface`; its points and triangles are shared, not copied
/// @param values  one for each vertex of the surface, or each triangle; else the colours are left out
/// @return a picture with colours at its points or triangles. @par Cost O(triangles). @par Thread Any.
[[nodiscard]] vtkSmartPointer<vtkPolyData> coloured(vtkPolyData& picture, const geometry::RepairedMesh& surface,
                                                    std::span<const float> values, bool isPerTriangle,
                                                    const ColourRange& range);

} // namespace palpate::view
