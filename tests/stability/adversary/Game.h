// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RandomScene.h"

#include <map>

namespace palpate::adversary {

constexpr std::int64_t kTicksOfSeed = 4000;

/// Totals over many seeds.
struct Tally
{
    std::int64_t ticks = 0, inContact = 0, atBound = 0, sheetTicks = 0, restTicks = 0, energyTicks = 0, restores = 0,
                 switches = 0;
    std::int64_t failedSeeds = 0;
    std::map<std::string, std::int64_t> seedsByFault;
    std::vector<std::string> lines;               ///< one per fault: seed, tick, kind; the first of each kind in a seed
    std::int64_t printedFrom = 0, printedTo = -1; ///< ticks that are printed as they go
    [[nodiscard]] std::string summary() const;
};

/// Plays one seed: a random scene, a random hand, every tick judged.
void play(Family family, std::uint64_t seed, std::int64_t ticks, Tally& tally);

/// Plays so many seeds as make up `ticks`, from `first` on.
[[nodiscard]] Tally playMany(Family family, std::uint64_t first, std::int64_t ticks);

} // namespace palpate::adversary
