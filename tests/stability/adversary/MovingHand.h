// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MovingScene.h"
#include "RandomHand.h"

namespace palpate::adversary {

/// The random hand in a moving scene: with the tissue of a group, in the world, at rest in the world, or at rest where
/// a structure will come.
class MovingHand
{
  public:
    MovingHand(const MovingScene& scene, bool isExact, Chance& chance);
    [[nodiscard]] Vec3 next(double t);
    [[nodiscard]] bool isStill() const { return m_mode == Mode::Still; }
    /// Rests at the last place for a number of ticks.
    void rest(int ticks);

  private:
    enum class Mode
    {
        WithTissue,
        InWorld,
        Still,
    };
    const MovingScene& m_scene;
    RandomHand m_hand;
    Chance m_chance;
    Mode m_mode = Mode::InWorld;
    int m_left = 0;
    bool m_hasStarted = false;
    std::size_t m_group = 0;
    Vec3 m_hip = Vec3::Zero();
};

} // namespace palpate::adversary
