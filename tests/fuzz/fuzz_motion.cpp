// SPDX-License-Identifier: BSD-3-Clause
#include "Fuzz.h"

#include <palpate/session/MotionFile.h>

#include <cmath>

namespace palpate::fuzz {

namespace motion {

std::vector<std::string> seeds()
{
    return {
        "x,y,z\n1,2,3\n4,5,6\n",
        "time_s,z,y,x,extra\r\n0,1,2,3,a\r\n0.001,1.5,-2e-3,3,\"b\"\r\n\r\n",
        "\xef\xbb\xbfx,y,z\n0.1,0.2,0.3\n",
        "x,y\n1,2\n",
        "x,y,z,x\n1,2,3,4\n",
        "time_s,x,y,z\n0,0,0,0\n-1,0,0,0\n",
        "",
    };
}

void tryInput(std::string_view bytes)
{
    const auto motion = session::parseMotion(bytes, "m.csv");
    if (!motion.isOk()) {
        requireOneLine(motion.status(), "m.csv");
        return;
    }
    require(!motion.value().p_WH.empty(), "a motion has a sample");
    require(motion.value().dt_s > 0.0 && std::isfinite(motion.value().dt_s), "its period is positive");
    for (const core::Vec3& p : motion.value().p_WH) {
        require(p.allFinite(), "its samples are numbers");
    }
}

} // namespace motion

extern const Target kMotion{"motion", 2000, motion::seeds, motion::tryInput};

} // namespace palpate::fuzz
