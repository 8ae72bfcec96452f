// SPDX-License-Identifier: BSD-3-Clause
#include "HostileMeshes.h"
#include "Meshes.h"
#include "Samples.h"

namespace palpate::fuzz {

namespace stl {

std::vector<std::string> seeds()
{
    const std::array<float, 9> facet{0, 0, 0, 2.5F, 0, 0, 0, 1.5F, 0};
    return {test::binaryStl(1, {facet}),
            test::binaryStl(3, {3, facet}, "3D Slicer output. SPACE=RAS"),
            test::binaryStl(2, {facet}),
            test::binaryStl(0, {}),
            test::binaryStl(0, {facet}), // a count that was not filled in
            test::binaryStl(0xffffffff, {facet}),
            test::binaryStl(7, {facet, {0, 0, 0, 0, 1.5F, 0, 2.5F, 0, 0}}), // closed
            test::binaryStl(1, {facet}).append(20, '\0'),                   // filler behind
            test::binaryStl(1, {facet}, "COLOR=\xc8\x32\x32\xff"),          // of Magics
            "solid"};
}

void tryInput(std::string_view bytes)
{
    tryMesh(bytes, meshio::internal::kStl, "a.stl");
}

} // namespace stl

extern const Target kStl{"stl", 200, stl::seeds, stl::tryInput};

} // namespace palpate::fuzz
