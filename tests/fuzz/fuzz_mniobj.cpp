// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes.h"
#include "OtherSurfaces.h"

namespace palpate::fuzz {

namespace mniobj {

std::vector<std::string> seeds()
{
    return {test::mniBox(),
            "P 1 1 1 1 1 3\n0 0 0 1 0 0 0 1 0\n0 0 1 0 0 1 0 0 1\n2\n1 1 0 0 1 0 1 0 1\n2 5\n0 1 0 1 2\n"};
}

void tryInput(std::string_view bytes)
{
    tryMesh(bytes, meshio::internal::kMniObject, "a.obj");
}

} // namespace mniobj

extern const Target kMniObject{"mniobj", 400, mniobj::seeds, mniobj::tryInput};

} // namespace palpate::fuzz
