// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes.h"

namespace palpate::fuzz {

namespace nrrd {

std::vector<std::string> seeds()
{
    return volumeSeeds(".nrrd");
}

void tryInput(std::string_view bytes)
{
    tryVolume(bytes, "a.nrrd");
}

} // namespace nrrd

extern const Target kNrrd{"nrrd", 200, nrrd::seeds, nrrd::tryInput};

} // namespace palpate::fuzz
