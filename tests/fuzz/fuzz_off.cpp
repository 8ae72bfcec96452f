// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes.h"
#include "OtherSurfaces.h"

namespace palpate::fuzz {

namespace off {

std::vector<std::string> seeds()
{
    return {test::offBox(), "COFF\n3 1\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n0 1 0 0 0 0 0\n3 0 1 2 0.5 0.5 0.5\n",
            "# a\nOFF 4 2 0\n0 0 0\n2 0 0\n2 2 0\nnan 0 0\n\n3 0 1 2 # b\n2 0 1\n"};
}

void tryInput(std::string_view bytes)
{
    tryMesh(bytes, meshio::internal::kOff, "a.off");
}

} // namespace off

extern const Target kOff{"off", 400, off::seeds, off::tryInput};

} // namespace palpate::fuzz
