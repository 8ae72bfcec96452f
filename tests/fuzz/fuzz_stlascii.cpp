// SPDX-License-Identifier: BSD-3-Clause
#include "HostileMeshes.h"
#include "Meshes.h"
#include "Samples.h"

namespace palpate::fuzz {

namespace stlascii {

std::vector<std::string> seeds()
{
    return {
        test::asciiStl(),
        test::asciiStl("3D Slicer output. SPACE=RAS"),
        test::asciiStl() + test::asciiStl("vein", "0 9 0"),
        test::asciiStl("a", "1e999 -0 nan"),
        std::string("solid a\nfacet ").append(40, '\xf2') +
            "\nouter loop\nvertex 0 0 0\nvertex 2.5 0 0\nvertex 0 1.5 0\n"
            "endloop\nendfacet\nendsolid\n",     // VTK took this for a binary file
        std::string(6, '\v') + test::asciiStl(), // these, too
        std::string(6, '\v') + "\n" + test::asciiStl(),
        "# x\nfacet normal 0 0 1\nouter loop vertex 0 0 0 vertex 2.5 0 0\nvertex 0 1.5 0 endloop endfacet end facet",
        std::string("f\0a\0c\0e\0t\0 \0o\0u\0t\0e\0r\0", 22),
        "solidA\n# x\nfacet\nouterloop\nvertex 0 0 0\rvertex 2.5 0 0\rvertex 0 1.5 0\nend loop\nend facet\nsolid A\n"
        "end solidA\n\x1a"};
}

void tryInput(std::string_view bytes)
{
    tryMesh(bytes, meshio::internal::kStl, "a.stl");
}

} // namespace stlascii

extern const Target kStlAscii{"stlascii", 200, stlascii::seeds, stlascii::tryInput};

} // namespace palpate::fuzz
