// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/SurfaceIndex.h"

#include "SurfaceBuilder.h"

#include <palpate/core/Numbers.h>

namespace palpate::geometry {

SurfaceIndex SurfaceIndex::build(const RepairedMesh& repaired, unsigned threads)
{
    SurfaceIndex none;
    if (repaired.mesh.triangles.empty()) {
        none.m_bounds = repaired.mesh.bounds();
        return none;
    }
    if (const double half = 0.5 * repaired.mesh.bounds().sizes().maxCoeff(); !(half <= kLargest_mm)) {
        none.m_status = {core::StatusCode::OutOfRange,
                         PALPATE_TEXT("found a mesh of %1 mm from its centre to its side, expected at most %2 mm"),
                         core::shortNumber(half, 3), kLargest_mm};
        return none;
    }
    return SurfaceBuilder(repaired, threads).build();
}

std::size_t SurfaceIndex::byteSize() const noexcept
{
    return m_vertices.capacity() * sizeof(Vec3) + m_triangles.capacity() * sizeof(Triangle) +
           m_sources.capacity() * sizeof(std::uint32_t) + m_neighbours.capacity() * sizeof(Triangle) +
           m_parts.capacity() * sizeof(std::uint32_t) + m_hierarchy.byteSize();
}

} // namespace palpate::geometry
