// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes.h"

namespace palpate::fuzz {

std::vector<std::string> seeds()
{
    return volumeSeeds(".nrrd");
}

void tryInput(std::string_view bytes)
{
    tryVolume(bytes, "a.nrrd");
}

} // namespace palpate::fuzz
