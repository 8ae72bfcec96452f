// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/geometry/TriangleMesh.h>

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <span>

namespace palpate::view {

/// Palpability map of a surface: values at each vertex.
struct FeltColours
{
    std::span<const float> change_percent;     ///< difference in feel from the organ alone [%], >= 0
    std::span<const std::uint8_t> isNotJudged; ///< non-zero: not evaluated; drawn hatched instead of coloured
    double greatest_percent = 28.0; ///< value that maps to the last colour of `surfaceColour`; 0 maps to the first
};

/// Colours a picture by palpability. The actor must draw the lines at 7, 14 and 28 % and the hatching: see
/// `drawPalpabilityContours`.
/// @param picture  made from `mesh` by `makeSurface`; points and triangles are shared, not copied
/// @param colours  one entry per vertex of the mesh
/// @par Cost O(triangles)
/// @par Thread Any
[[nodiscard]] PALPATE_EXPORT vtkSmartPointer<vtkPolyData>
palpabilityColoured(vtkPolyData& picture, const geometry::TriangleMesh& mesh, const FeltColours& colours);

/// Makes an actor draw the contour lines and hatching of a picture from `palpabilityColoured`. No effect
/// with other pictures. Lines have constant width on screen. @par Thread The view's.
PALPATE_EXPORT void drawPalpabilityContours(vtkActor& actor, vtkPolyData& picture);

} // namespace palpate::view
