// SPDX-License-Identifier: BSD-3-Clause
#include "MovingHand.h"

namespace palpate::adversary {

MovingHand::MovingHand(const MovingScene& scene, bool isExact, Chance& chance)
    : m_scene(scene)
    , m_hand(scene.rest, isExact, chance.bits())
    , m_chance(chance.bits())
{
}

Vec3 MovingHand::next(double t)
{
    const Vec3 X = m_hand.next();
    const auto placed = [&](double time) {
        const std::optional<RandomMotion>& motion = m_scene.groups[m_group].motion;
        return motion ? motion->toWorld(time, X) : X;
    };
    if (m_left-- <= 0) {
        m_left = m_chance.whole(50, 500);
        m_group = m_chance.below(m_scene.groups.size());
        m_mode = static_cast<Mode>(m_chance.below(3));
        if (!m_hasStarted) {
            m_hip = X;
        }
        if (m_mode == Mode::Still && m_chance.is(0.7)) {
            m_hip = placed(t + m_chance.between(0.0, 1e-3 * m_left)); // where a structure will come
        }
    }
    m_hasStarted = true;
    if (m_mode != Mode::Still) {
        m_hip = m_mode == Mode::WithTissue ? placed(t) : X;
    }
    return m_hip;
}

void MovingHand::rest(int ticks)
{
    m_mode = Mode::Still;
    m_left = ticks;
}

} // namespace palpate::adversary
