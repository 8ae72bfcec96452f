// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/ColourMap.h"

#include <palpate/core/Export.h>

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <span>

namespace palpate::view {

/// Colour of a band of distances: bright for the closest band, dark for the farthest. Readable with colour vision
/// deficiency, because the lightness decreases with each band.
/// @param band  < count
[[nodiscard]] PALPATE_EXPORT Colour marginColour(std::size_t band, std::size_t count);

/// Splits the triangles of a picture until no edge is longer than `edge_mm`, so that values at the points describe the
/// surface between them. Point data are interpolated. Coarser, if there would be more than `most` triangles.
/// @return the picture itself where nothing must be split
/// @par Thread Any
[[nodiscard]] PALPATE_EXPORT vtkSmartPointer<vtkPolyData> refinedPicture(vtkPolyData& picture, double edge_mm,
                                                                         std::size_t most = 200000);

/// Colours a picture by bands of distance. The actor must draw the bands: see `drawMarginBands`.
/// @param distance_mm  distance at each point of the picture [mm]
/// @param limits_mm  borders of the bands, ascending [mm]; a distance equal to a border belongs to the band above it
/// @par Thread Any
[[nodiscard]] PALPATE_EXPORT vtkSmartPointer<vtkPolyData>
marginColoured(vtkPolyData& picture, std::span<const float> distance_mm, std::span<const double> limits_mm);

/// Makes an actor draw the bands of a picture from `marginColoured` as steps with lines of constant width on screen
/// between them. No effect with other pictures. @par Thread The view's
PALPATE_EXPORT void drawMarginBands(vtkActor& actor, vtkPolyData& picture);

} // namespace palpate::view
