// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RandomScene.h"

#include <map>

namespace palpate::adversary {

constexpr std::int64_t kTicksOfSeed = 4000;

/// Sums over many seeds.
struct Tally
{
    std::int64_t ticks = 0, inContact = 0, atBound = 0, sheetTicks = 0, restTicks = 0, energyTicks = 0, restores = 0,
                 switches = 0;
    /// With motion: moved surfaces, ticks with everything held, and forces compared with derivatives.
    std::int64_t nodeTicks = 0, heldTicks = 0, derivedTicks = 0;
    std::int64_t failedSeeds = 0;
    std::map<std::string, std::int64_t> seedsByFault;
    std::vector<std::string> lines; ///< one per fault: seed, tick, description; the first of each kind in a seed
    std::int64_t printedFrom = 0, printedTo = -1; ///< range of ticks to print
    [[nodiscard]] std::string summary() const;
};

/// Plays one seed: a random scene, a random hand, checks in every tick.
void play(Family family, std::uint64_t seed, std::int64_t ticks, Tally& tally);

/// Plays seeds from `first` on until `ticks` are reached.
[[nodiscard]] Tally playMany(Family family, std::uint64_t first, std::int64_t ticks);

} // namespace palpate::adversary
