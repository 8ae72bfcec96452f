// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/geometry/TriangleMesh.h>

#include <string>

namespace palpate::session {

/// Identifies a geometry by SHA-256 over the counts, the bits of the vertex coordinates and the indices (64 hex
/// digits). Two geometries have the same hash exactly when every tick computed on them gives the same bits. Pass the
/// repaired mesh in the world frame.
/// @par Cost about 4 ns per byte. Any thread.
[[nodiscard]] PALPATE_EXPORT std::string geometryHash(const geometry::TriangleMesh& mesh);

} // namespace palpate::session
