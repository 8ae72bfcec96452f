// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes.h"

namespace palpate::fuzz {

namespace mha {

std::vector<std::string> seeds()
{
    return volumeSeeds(".mha");
}

void tryInput(std::string_view bytes)
{
    tryVolume(bytes, "a.mha");
}

} // namespace mha

extern const Target kMha{"mha", 200, mha::seeds, mha::tryInput};

} // namespace palpate::fuzz
