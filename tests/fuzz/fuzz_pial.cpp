// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes.h"
#include "OtherSurfaces.h"

namespace palpate::fuzz {

namespace pial {

std::vector<std::string> seeds()
{
    return {test::freeSurferBox(), test::freeSurferBox() + test::freeSurferVolume()};
}

void tryInput(std::string_view bytes)
{
    tryMesh(bytes, meshio::internal::kFreeSurferSurface, "lh.pial");
}

} // namespace pial

extern const Target kPial{"pial", 400, pial::seeds, pial::tryInput};

} // namespace palpate::fuzz
