// SPDX-License-Identifier: BSD-3-Clause
#include "HostileMeshes.h"
#include "Meshes.h"
#include "Samples.h"

namespace palpate::fuzz {

namespace vtp {

std::vector<std::string> seeds()
{
    const test::Folder folder; // binary, appended and compressed, as from the project's writer
    const std::vector<meshio::MeshStructure> structures{test::tetrahedron("a"), test::tetrahedron("b", {1, 2, 3})};
    require(meshio::writeMesh(folder.path("w.vtp"), structures).isOk(), "a mesh can be written");
    const auto named = [](const std::string& characters) {
        return test::asciiVtp("0 0 0 2.5 0 0 0 1.5 0", "0 1 2", "NumberOfPoints=\"3\" NumberOfPolys=\"1\"", "3",
                              "Polys",
                              "<FieldData><Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" "
                              "format=\"ascii\">" +
                                  characters + "</Array></FieldData>");
    };
    return {
        test::asciiVtp(),
        test::asciiVtp("0 0 0 2.5 0 0 0 1.5 0 1.#QNAN 1e999 nan", "0 1 2", "NumberOfPoints=\"4\" NumberOfPolys=\"1\""),
        test::fileBytes(folder.path("w.vtp")),
        test::asciiVtp("0 0 0 2.5 0 0 0 1.5 0 3 3 0", "0 1 2 3", "NumberOfPoints=\"4\" NumberOfStrips=\"1\"", "4",
                       "Strips"),
        // An empty piece, and a hidden cell of two.
        "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"0\"><Points/></Piece><Piece NumberOfPoints=\"4\" "
        "NumberOfPolys=\"2\"><CellData><DataArray type=\"UInt8\" Name=\"vtkGhostType\">0 32</DataArray></CellData>"
        "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0 nan 0 0</DataArray></Points>"
        "<Polys><DataArray type=\"Int64\" Name=\"connectivity\">0 1 2 0 1</DataArray>"
        "<DataArray type=\"Int64\" Name=\"offsets\">3 5</DataArray></Polys></Piece></PolyData></VTKFile>\n",
        named("76 80 83 0"), named("76 0 80 0")}; // VTK wrote the second string beyond the end of the array
}

void tryInput(std::string_view bytes)
{
    tryMesh(bytes, meshio::internal::kVtp, "a.vtp");
}

} // namespace vtp

extern const Target kVtp{"vtp", 200, vtp::seeds, vtp::tryInput};

} // namespace palpate::fuzz
