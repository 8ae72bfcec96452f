// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes.h"
#include "OtherSurfaces.h"

namespace palpate::fuzz {

namespace gii {

std::vector<std::string> seeds()
{
    return {test::giftiBox(test::Gifti::Ascii), test::giftiBox(test::Gifti::Base64),
            test::giftiBox(test::Gifti::Packed)};
}

void tryInput(std::string_view bytes)
{
    tryMesh(bytes, meshio::internal::kGifti, "a.gii");
}

} // namespace gii

extern const Target kGii{"gii", 400, gii::seeds, gii::tryInput};

} // namespace palpate::fuzz
