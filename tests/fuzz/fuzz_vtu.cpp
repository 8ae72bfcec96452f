// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes.h"
#include "Samples.h"

namespace palpate::fuzz {

namespace vtu {

std::vector<std::string> seeds()
{
    return {
        test::asciiVtu(),
        test::asciiVtu("<CellData><DataArray type=\"UInt8\" Name=\"vtkGhostType\">32</DataArray></CellData>"),
        "<VTKFile type=\"UnstructuredGrid\" compressor=\"vtkZLibDataCompressor\"><UnstructuredGrid>"
        "<Piece NumberOfPoints=\"1\" NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
        "format=\"appended\" offset=\"0\"/></Points></Piece></UnstructuredGrid><AppendedData encoding=\"raw\">_"};
}

void tryInput(std::string_view bytes)
{
    tryMesh(bytes, meshio::internal::kVtu, "a.vtu");
}

} // namespace vtu

extern const Target kVtu{"vtu", 200, vtu::seeds, vtu::tryInput};

} // namespace palpate::fuzz
