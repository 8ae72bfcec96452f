// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes.h"
#include "Volumes.h"

namespace palpate::fuzz {

namespace nii {

std::vector<std::string> seeds()
{
    std::vector<std::string> seeds = volumeSeeds(".nii");
    for (std::string& packed : volumeSeeds(".nii.gz")) {
        seeds.push_back(std::move(packed));
    }
    for (std::string& labels : labelSeeds(".nii")) {
        seeds.push_back(std::move(labels));
    }
    for (std::string& field : fieldSeeds(".nii")) {
        seeds.push_back(std::move(field));
    }
    return seeds;
}

void tryInput(std::string_view bytes)
{
    const char* const name = bytes.starts_with("\x1f\x8b") ? "a.nii.gz" : "a.nii";
    tryVolume(bytes, name);
    tryMesh(bytes, meshio::internal::kNifti, name);
}

} // namespace nii

extern const Target kNii{"nii", 200, nii::seeds, nii::tryInput};

} // namespace palpate::fuzz
