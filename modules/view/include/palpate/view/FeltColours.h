// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/TriangleMesh.h>

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <span>

namespace palpate::view {

/// What a map of what can be felt shows at each vertex of a surface.
struct FeltColours
{
    std::span<const float> change_percent;     ///< how much otherwise it feels than the organ alone, >= 0
    std::span<const std::uint8_t> isNotJudged; ///< not 0: hatched, never coloured
    double greatest_percent = 28.0;            ///< has the last colour of `surfaceColour`; 0 has the first
};

/// Colours a picture by what can be felt. Its actor draws lines at 7, 14 and 28 % and the hatch: see `drawFeltLines`.
/// @param picture  made of `mesh` by `makeSurface`; its points and triangles are shared, not copied
/// @param colours  with one entry a vertex of the mesh
/// @par Cost O(triangles). @par Thread Any.
[[nodiscard]] vtkSmartPointer<vtkPolyData> feltColoured(vtkPolyData& picture, const geometry::TriangleMesh& mesh,
                                                        const FeltColours& colours);

/// Lets an actor draw the lines and the hatch of a picture that `feltColoured` made; takes them from it with any other
/// picture. Lines are of even width on screen. @par Thread The view's.
void drawFeltLines(vtkActor& actor, vtkPolyData& picture);

} // namespace palpate::view
