// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Game.h"
#include "LayerJudge.h"

#include <set>

namespace palpate::adversary {

/// Adds the faults of one seed to the tally, with the command that repeats the seed: the first of each kind.
class FaultLog
{
  public:
    FaultLog(Family family, std::uint64_t seed, Tally& tally)
        : m_family(family)
        , m_seed(seed)
        , m_tally(tally)
    {
    }
    /// @param scene  description of the scene
    void add(const Fault& fault, std::int64_t tick, const Vec3& hip, const std::string& scene);
    [[nodiscard]] bool isEmpty() const { return m_known.empty(); }

  private:
    Family m_family;
    std::uint64_t m_seed;
    Tally& m_tally;
    std::set<std::string> m_known;
};

/// Returns the seed of the random numbers of a game. A new family does not change the seeds of the others.
[[nodiscard]] std::uint64_t firstOf(Family family, std::uint64_t seed);

} // namespace palpate::adversary
