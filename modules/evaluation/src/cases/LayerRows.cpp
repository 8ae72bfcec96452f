// SPDX-License-Identifier: BSD-3-Clause
// Hard cases with layers that are shown and hidden while an inner layer is pressed.
#include "cases/HardCaseRows.h"

#include "palpate/evaluation/Shapes.h"

namespace palpate::evaluation {

namespace {

/// Translates a mesh upwards.
geometry::TriangleMesh raised(geometry::TriangleMesh mesh, double by_mm)
{
    for (Vec3& v : mesh.vertices) {
        v.z() += by_mm;
    }
    return mesh;
}

} // namespace

void addLayerRows(std::vector<HardCase>& rows)
{
    const auto lump = [] { return raised(shapes::bumpySphere(8, 8.0, 0.02), 15.0); };
    const auto liver = [] { return shapes::bumpySphere(12, 30.0, 0.03); };
    rows.push_back(row("pressed lump, the liver around it hidden and shown", lump,
                       HandPath({0.1, 0.2, 40})
                           .to({0.1, 0.2, 20}, 0.2)
                           .rest(120)
                           .to({3, 2, 19}, 0.05)
                           .to({-4, -1, 18}, 0.05)
                           .to({-4, -1, 40}, 0.2)
                           .to({0, 0, 20}, 0.2)));
    rows.back().other = liver;
    rows.back().otherEvery = 37;
    rows.push_back(
        row("pressed liver, a lump in it hidden and shown", liver,
            HandPath({0.1, 0.2, 40}).to({0.1, 0.2, 20}, 0.2).rest(60).to({6, -5, 19}, 0.1).to({1, 1, 40}, 0.2)));
    rows.back().other = lump;
    rows.back().otherEvery = 29;
}

} // namespace palpate::evaluation
