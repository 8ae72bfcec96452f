// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Transport.h"

#include <algorithm>
#include <cmath>

namespace palpate::ui {

void Transport::setDuration(double duration_s)
{
    m_duration_s = std::max(0.0, duration_s);
    m_position_s = 0.0;
    m_isPlaying = false;
}

void Transport::play()
{
    if (m_duration_s <= 0.0) {
        return;
    }
    if (m_position_s >= m_duration_s) {
        m_position_s = 0.0;
    }
    m_isPlaying = true;
}

void Transport::seek(double position_s)
{
    m_position_s = std::isfinite(position_s) ? std::clamp(position_s, 0.0, m_duration_s) : m_position_s;
}

void Transport::setSpeed(double speed)
{
    m_speed = speed > 0.0 && std::isfinite(speed) ? speed : m_speed;
}

bool Transport::advance(double elapsed_s)
{
    if (!m_isPlaying || !(elapsed_s > 0.0)) {
        return false;
    }
    m_position_s += elapsed_s * m_speed;
    if (m_position_s < m_duration_s) {
        return false;
    }
    m_position_s = m_duration_s;
    m_isPlaying = false;
    return true;
}

} // namespace palpate::ui
