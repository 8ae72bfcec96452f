// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes.h"
#include "Samples.h"

namespace palpate::fuzz {

namespace vtk {

std::vector<std::string> seeds()
{
    return {test::asciiVtk(),
            test::binaryVtk(),
            test::asciiVtk("POINTS 4 double\n0 0 0 1 0 0 0 1.5 0 1 1.5 0\nMETADATA\nINFORMATION 0\n\n",
                           "VERTICES 1 2\n1 0\nTRIANGLE_STRIPS 1 5\n4 0 1 2 3\nCELL_DATA 2\nSCALARS a int\n"),
            test::asciiVtk("FIELD f 2\na 1 2 string\nx y\nz\nb 2 1 int\n1 2\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n",
                           "LINES 2 2\nOFFSETS int\n0 2\nCONNECTIVITY int\n0 1\n"
                           "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n0 1 2\n",
                           "SPACE=RAS", "5.1"),
            test::asciiGrid(),
            test::asciiGrid("10\n8\n")};
}

void tryInput(std::string_view bytes)
{
    tryMesh(bytes, meshio::internal::kLegacyVtk, "a.vtk");
}

} // namespace vtk

extern const Target kVtk{"vtk", 200, vtk::seeds, vtk::tryInput};

} // namespace palpate::fuzz
