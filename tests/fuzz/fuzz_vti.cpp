// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes.h"

namespace palpate::fuzz {

namespace vti {

std::vector<std::string> seeds()
{
    return volumeSeeds(".vti");
}

void tryInput(std::string_view bytes)
{
    tryVolume(bytes, "a.vti");
}

} // namespace vti

extern const Target kVti{"vti", 200, vti::seeds, vti::tryInput};

} // namespace palpate::fuzz
