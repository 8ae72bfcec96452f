// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes.h"
#include "Volumes.h"

namespace palpate::fuzz {

namespace nrrd {

std::vector<std::string> seeds()
{
    std::vector<std::string> seeds = volumeSeeds(".nrrd");
    for (std::string& labels : labelSeeds(".nrrd")) {
        seeds.push_back(std::move(labels));
    }
    for (std::string& field : fieldSeeds(".nrrd")) {
        seeds.push_back(std::move(field));
    }
    return seeds;
}

void tryInput(std::string_view bytes)
{
    tryVolume(bytes, "a.nrrd");
    tryMesh(bytes, meshio::internal::kNrrd, "a.nrrd");
}

} // namespace nrrd

extern const Target kNrrd{"nrrd", 200, nrrd::seeds, nrrd::tryInput};

} // namespace palpate::fuzz
