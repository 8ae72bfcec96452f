// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/HardCases.h"
#include "scenes/HandPath.h"

#include <cstdio>

namespace palpate::evaluation {

// Each function appends the rows of one group.
void addMeshFaultRows(std::vector<HardCase>& rows); ///< zero-area, duplicate, flipped, slivers, cracks, fins, soup
void addContactRows(std::vector<HardCase>& rows);   ///< creases, fans, grooves, pockets, plates, edges, vertices
void addTransformRows(std::vector<HardCase>& rows); ///< translated, scaled and rotated scenes
void addHandRows(std::vector<HardCase>& rows);  ///< noise, teleports, stillness, invalid numbers, long random motion
void addTieRows(std::vector<HardCase>& rows);   ///< HIPs on vertices, on edges, in planes and within the skin
void addLayerRows(std::vector<HardCase>& rows); ///< surrounding layer that is alternately shown and hidden
void addFingertipRows(std::vector<HardCase>& rows); ///< existing cases with a spherical fingertip, and large spheres

/// @return a case that follows `path` on `mesh`
[[nodiscard]] HardCase row(std::string name, std::function<geometry::TriangleMesh()> mesh, const HandPath& path);

/// Formats like printf into a string.
template<class... Args>
[[nodiscard]] std::string formatted(const char* format, Args... args)
{
    char text[256];
    std::snprintf(text, sizeof text, format, args...);
    return text;
}

} // namespace palpate::evaluation
