// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/MeshReport.h"

namespace palpate::geometry {

bool MeshReport::isClean() const noexcept
{
    return mixedValues == 0 && zeroAreaTriangles == 0 && duplicateTriangles == 0 && inconsistentEdges == 0 &&
           reorientedTriangles == 0 && openEdges == 0 && nonManifoldEdges == 0 && openComponents == 0 &&
           insideOutComponents == 0;
}

std::vector<core::Message> MeshReport::sentences() const
{
    std::vector<core::Message> lines;
    const auto add = [&lines](std::size_t n, core::MessageText<> one, core::MessageText<core::Count> many) {
        if (n > 0) {
            lines.push_back(n == 1 ? core::Message(one) : core::Message(many, core::Count(n)));
        }
    };
    add(mixedValues,
        PALPATE_TEXT("1 value of arrays differed by more than 10 % from another at the same vertex: the mean is used"),
        PALPATE_TEXT(
            "%1 values of arrays differed by more than 10 % from another at the same vertex: the mean is used"));
    add(zeroAreaTriangles, PALPATE_TEXT("1 triangle without area left out"),
        PALPATE_TEXT("%1 triangles without area left out"));
    add(duplicateTriangles, PALPATE_TEXT("1 duplicate triangle left out"),
        PALPATE_TEXT("%1 duplicate triangles left out"));
    add(reorientedTriangles, PALPATE_TEXT("1 triangle turned round to face the same way as the rest"),
        PALPATE_TEXT("%1 triangles turned round to face the same way as the rest"));
    add(openEdges, PALPATE_TEXT("1 open edge: the surface has holes or a rim"),
        PALPATE_TEXT("%1 open edges: the surface has holes or a rim"));
    add(nonManifoldEdges, PALPATE_TEXT("1 edge shared by more than two triangles"),
        PALPATE_TEXT("%1 edges shared by more than two triangles"));
    add(nonOrientableComponents, PALPATE_TEXT("1 part without a consistent front"),
        PALPATE_TEXT("%1 parts without a consistent front"));
    add(openComponents, PALPATE_TEXT("1 part without an inside, touched from both sides"),
        PALPATE_TEXT("%1 parts without an inside, touched from both sides"));
    add(insideOutComponents,
        PALPATE_TEXT("1 closed part looks inside out: touched from within only, unless turned outwards"),
        PALPATE_TEXT("%1 closed parts look inside out: touched from within only, unless turned outwards"));
    return lines;
}

} // namespace palpate::geometry
