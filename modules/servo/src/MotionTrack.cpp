// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/servo/MotionTrack.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::servo {

Vec3 MotionTrack::step(const Vec3& p) noexcept PALPATE_NONBLOCKING
{
    m_newest = (m_newest + 1) % m_samples.size();
    m_samples[m_newest] = p;
    m_window = 1.0;
    if (m_count == 0) {
        m_count = 1;
        m_place = p;
        return Vec3::Zero();
    }
    constexpr double kRounding = 1.0 + 1e-6; // places are multiples of the step only to rounding
    const double step_mm = kRounding * m_resolution_mm;
    Vec3 moved;
    double most = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
        // Slopes of lines through the newest sample that pass all samples so far.
        double least = -std::numeric_limits<double>::infinity();
        double greatest = std::numeric_limits<double>::infinity();
        double slope = 0.0;
        double window = 1.0;
        for (std::size_t n = 1; n <= m_count; ++n) {
            const double past = m_samples[(m_newest + m_samples.size() - n) % m_samples.size()][axis];
            const double ticks = static_cast<double>(n);
            const double way = p[axis] - past;
            if (way < least * ticks || way > greatest * ticks) {
                break;
            }
            slope = way / ticks;
            window = ticks;
            least = std::max(least, (way - step_mm) / ticks);
            greatest = std::min(greatest, (way + step_mm) / ticks);
        }
        const double half = 0.5 * m_resolution_mm;
        const double place = std::clamp(m_place[axis] + slope, p[axis] - half, p[axis] + half);
        moved[axis] = place - m_place[axis];
        m_place[axis] = place;
        if (std::abs(moved[axis]) > most) {
            most = std::abs(moved[axis]);
            m_window = window;
        }
    }
    m_count = std::min(m_count + 1, kLongest);
    return moved;
}

} // namespace palpate::servo
