// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/MeshReport.h"

#include <palpate/core/Text.h>

namespace palpate::geometry {

namespace {

/// Formats a count with its noun, e.g. "52,114 triangles".
std::string counted(std::size_t n, const char* one, const char* many)
{
    return core::grouped(n) + ' ' + (n == 1 ? one : many);
}

} // namespace

bool MeshReport::isClean() const noexcept
{
    return mixedValues == 0 && zeroAreaTriangles == 0 && duplicateTriangles == 0 && inconsistentEdges == 0 &&
           reorientedTriangles == 0 && openEdges == 0 && nonManifoldEdges == 0 && openComponents == 0 &&
           insideOutComponents == 0 && turnedComponents == 0;
}

std::vector<std::string> MeshReport::sentences() const
{
    std::vector<std::string> lines;
    const auto say = [&lines](std::size_t n, const char* one, const char* many, const char* rest) {
        if (n > 0) {
            lines.push_back(counted(n, one, many) + rest);
        }
    };
    say(mixedValues, "value", "values",
        " of arrays differed by more than 10 % from another at the same vertex: the mean is used");
    say(zeroAreaTriangles, "triangle", "triangles", " without area left out");
    say(duplicateTriangles, "duplicate triangle", "duplicate triangles", " left out");
    say(reorientedTriangles, "triangle", "triangles", " turned round to face the same way as the rest");
    say(openEdges, "open edge", "open edges", ": the surface has holes or a rim");
    say(nonManifoldEdges, "edge", "edges", " shared by more than two triangles");
    say(nonOrientableComponents, "part", "parts", " without a consistent front");
    say(openComponents, "part", "parts", " without an inside, touched from both sides");
    say(insideOutComponents, "closed part looks", "closed parts look",
        " inside out: touched from within only, unless turned outwards");
    say(turnedComponents, "closed part was", "closed parts were", " inside out and turned to face outwards");
    return lines;
}

} // namespace palpate::geometry
