// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/TriangleMesh.h"

#include <utility>

namespace palpate::geometry {

Box TriangleMesh::bounds() const
{
    Box box;
    for (const Vec3& v : vertices) {
        box.extend(v);
    }
    return box;
}

void flip(TriangleMesh& mesh)
{
    for (Triangle& t : mesh.triangles) {
        std::swap(t[1], t[2]);
    }
}

} // namespace palpate::geometry
