// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes.h"

namespace palpate::fuzz {

namespace nii {

std::vector<std::string> seeds()
{
    std::vector<std::string> seeds = volumeSeeds(".nii");
    for (std::string& packed : volumeSeeds(".nii.gz")) {
        seeds.push_back(std::move(packed));
    }
    return seeds;
}

void tryInput(std::string_view bytes)
{
    tryVolume(bytes, bytes.starts_with("\x1f\x8b") ? "a.nii.gz" : "a.nii");
}

} // namespace nii

extern const Target kNii{"nii", 200, nii::seeds, nii::tryInput};

} // namespace palpate::fuzz
