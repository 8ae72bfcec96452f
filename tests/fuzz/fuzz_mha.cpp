// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes.h"
#include "Volumes.h"

namespace palpate::fuzz {

namespace mha {

std::vector<std::string> seeds()
{
    std::vector<std::string> seeds = volumeSeeds(".mha");
    for (std::string& labels : labelSeeds(".mha")) {
        seeds.push_back(std::move(labels));
    }
    for (std::string& field : fieldSeeds(".mha")) {
        seeds.push_back(std::move(field));
    }
    return seeds;
}

void tryInput(std::string_view bytes)
{
    tryVolume(bytes, "a.mha");
    tryMesh(bytes, meshio::internal::kMetaImage, "a.mha");
}

} // namespace mha

extern const Target kMha{"mha", 200, mha::seeds, mha::tryInput};

} // namespace palpate::fuzz
