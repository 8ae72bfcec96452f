// SPDX-License-Identifier: BSD-3-Clause
// Plays single seeds of the adversary, as printed by a failing test.
//
// adversary FAMILY SEED [SEEDS [TICKS [FROM TO]]]
//
// FAMILY: closed, open, layers, balls, rough, roughballs, moving. Prints the ticks FROM … TO. Exit code 1 on a failure.
#include "Game.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

int main(int argc, char** argv)
{
    using namespace palpate::adversary;
    for (int f = 0; argc >= 3 && f < kFamilies; ++f) {
        const auto family = static_cast<Family>(f);
        if (std::strcmp(argv[1], nameOf(family)) != 0) {
            continue;
        }
        const std::uint64_t first = std::strtoull(argv[2], nullptr, 10);
        const std::uint64_t seeds = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
        const std::int64_t ticks = argc > 4 ? std::strtoll(argv[4], nullptr, 10) : kTicksOfSeed;
        Tally tally;
        tally.printedFrom = argc > 5 ? std::strtoll(argv[5], nullptr, 10) : 0;
        tally.printedTo = argc > 6 ? std::strtoll(argv[6], nullptr, 10) : -1;
        for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
            const std::size_t before = tally.lines.size();
            play(family, seed, ticks, tally);
            for (std::size_t i = before; i < tally.lines.size(); ++i) {
                std::printf("%s\n", tally.lines[i].c_str());
            }
        }
        std::printf("%s\n", tally.summary().c_str());
        return tally.failedSeeds > 0 ? 1 : 0;
    }
    std::fprintf(stderr,
                 "usage: adversary closed|open|layers|balls|rough|roughballs|moving SEED [SEEDS [TICKS [FROM TO]]]\n");
    return 2;
}
