// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Game.h"

namespace palpate::adversary {

/// Plays one seed of the family with motion: structures that move, and hands at rest and in motion.
///
/// The checks: the rest position that the engine uses is the hand's, by formulas of our own. There a scene without
/// motion gives the same god-object bit for bit, and that one is judged as any other. Its force and position are taken
/// to the world by derivatives of our own. Beside that, in the world: no surface of moved nodes passes the god-object,
/// the force is the gradient of the stored energy, the power of the tissue its change in time, and a held motion rests.
void playMoving(std::uint64_t seed, std::int64_t ticks, Tally& tally);

} // namespace palpate::adversary
