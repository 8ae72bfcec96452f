// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/Repair.h"

#include <palpate/core/Export.h>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace palpate::geometry {

/// How finely `pnTriangles` divides a surface.
struct PnOptions
{
    double crease_deg = 40.0;   ///< facets that meet at a larger angle stay apart: their edge is sharp [degree]
    double turn_deg = 0.5;      ///< largest angle between neighbouring pieces of a curved edge [degree]
    double sag_mm = 0.02;       ///< largest distance between a curved edge and its pieces [mm]
    double leastPiece_mm = 0.1; ///< no piece is shorter, whatever its angle: a hand at 25 mm/s passes it in 4 ms [mm]
    std::uint32_t mostPieces = 16; ///< of an edge
    /// If more triangles than this would result, an edge gets at most half of `mostPieces`.
    std::size_t manyTriangles = 2'000'000;
    std::size_t mostTriangles = 20'000'000;
};

/// Result of `pnTriangles`.
struct PnSurface
{
    std::optional<RepairedMesh> surface; ///< empty if no facet is curved, or more than `mostTriangles` would result
    std::size_t triangles = 0;           ///< after the division, also if it was refused
    std::size_t flatTriangles = 0;       ///< kept flat, because their patches would fold
    bool isRefused = false;              ///< more than PnOptions::mostTriangles
};

/// Replaces each facet by a cubic patch through its corners, perpendicular to the vertex normals (a PN triangle), and
/// divides the patches into triangles. A sphere, a cylinder or an organ of coarse facets is round again; sharp edges,
/// rims and flat parts stay as they are, and a surface without any curved facet is not changed.
///
/// A vertex normal is the mean over the facets around the vertex that are connected by edges of less than `crease_deg`,
/// with Max's weights, which are exact for the vertices of a sphere. Open, sharp and non-manifold edges stay straight.
/// A curved edge gets the number of pieces that its own two normals require; both facets of an edge share its pieces,
/// so that a closed surface stays closed. A facet stays flat if a vertex normal is more than 60° off its own or a piece
/// of it would face the other way.
///
/// Largest errors of an icosphere of 1,280 triangles (radius 1) at the usual options, 191,360 pieces: 6.6e-5 and 0.8°
/// (facets: 4.5e-3 and 5.5°); the patches themselves are 3.2e-5 off.
/// @param surface  result of `repair` [mm]
/// @pre 0 <= crease_deg <= 180, turn_deg, sag_mm, leastPiece_mm > 0, mostPieces >= 1
/// @par Source Vlachos, Peters, Boyd, Mitchell: Curved PN Triangles (I3D 2001); Max: Weights for Computing Vertex
/// Normals from Facet Normals (JGT 4, 1999).
/// @par Cost O(n log n), about 1 us per resulting triangle. Any thread. Deterministic.
[[nodiscard]] PALPATE_EXPORT PnSurface pnTriangles(const RepairedMesh& surface, const PnOptions& options = {});

} // namespace palpate::geometry
