// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/servo/MotionTrack.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::servo {

namespace {

/// 1 / n: avoids divisions in the loop over the window.
constexpr auto kInverse = [] {
    std::array<double, MotionTrack::kLongestSlope + 1> inverse{};
    for (std::size_t n = 1; n < inverse.size(); ++n) {
        inverse[n] = 1.0 / static_cast<double>(n);
    }
    return inverse;
}();

} // namespace

Vec3 MotionTrack::step(const Vec3& p) noexcept PALPATE_NONBLOCKING
{
    const Vec3 before = m_samples[m_newest];
    m_newest = (m_newest + 1) % m_samples.size();
    m_samples[m_newest] = p;
    m_window = 1.0;
    if (m_count == 0) {
        m_count = 1;
        m_place = p;
        return m_moved;
    }
    const Vec3 resolution_mm = resolutions(p - before);
    double most = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
        if (resolution_mm[axis] == 0.0) {
            m_slope[axis] = p[axis] - before[axis];
            m_moved[axis] = p[axis] - m_place[axis];
            m_place[axis] = p[axis];
            if (std::abs(m_moved[axis]) > most) {
                most = std::abs(m_moved[axis]);
                m_window = 1.0;
            }
            continue;
        }
        // Tolerance: samples are multiples of the step up to rounding, and a detected step is known to about 1 %.
        const double step_mm = resolution_mm[axis] * (m_resolution_mm > 0.0 ? 1.0 + 1e-6 : 1.02);
        // Bounds on the slope of a line through the newest sample within one step of all samples so far.
        double least = -std::numeric_limits<double>::infinity();
        double greatest = std::numeric_limits<double>::infinity();
        double way = 0.0, wayOfMove = 0.0; // moves over the last `ticks` and `window` ticks
        std::size_t ticks = 1, window = 1;
        for (std::size_t n = 1; n <= m_count; ++n) {
            const double past = m_samples[(m_newest + m_samples.size() - n) % m_samples.size()][axis];
            const double along = p[axis] - past;
            const auto span = static_cast<double>(n);
            if (along < least * span || along > greatest * span) {
                break;
            }
            way = along;
            ticks = n;
            if (n <= kLongest) {
                wayOfMove = along;
                window = n;
            }
            least = std::max(least, (along - step_mm) * kInverse[n]);
            greatest = std::min(greatest, (along + step_mm) * kInverse[n]);
        }
        m_slope[axis] = way / static_cast<double>(ticks);
        const double half = 0.5 * resolution_mm[axis];
        const double place =
            std::clamp(m_place[axis] + wayOfMove / static_cast<double>(window), p[axis] - half, p[axis] + half);
        m_moved[axis] = place - m_place[axis];
        m_place[axis] = place;
        if (std::abs(m_moved[axis]) > most) {
            most = std::abs(m_moved[axis]);
            m_window = static_cast<double>(window);
        }
    }
    m_count = std::min(m_count + 1, kLongestSlope);
    return m_moved;
}

/// Step of each axis; 0: exact. A step found on one axis is used for axes without a known step.
Vec3 MotionTrack::resolutions(const Vec3& moved) noexcept
{
    Vec3 found = Vec3::Constant(m_resolution_mm);
    if (m_resolution_mm > 0.0) {
        return found;
    }
    for (int axis = 0; axis < 3; ++axis) {
        SensorGrid& grid = m_grids[static_cast<std::size_t>(axis)];
        grid.note(moved[axis]);
        found[axis] = grid.step_mm();
    }
    const double coarsest_mm = found.maxCoeff();
    for (int axis = 0; axis < 3 && coarsest_mm > 0.0; ++axis) {
        if (found[axis] == 0.0 && m_grids[static_cast<std::size_t>(axis)].fits(coarsest_mm)) {
            found[axis] = coarsest_mm;
        }
    }
    return found;
}

void MotionTrack::reset() noexcept PALPATE_NONBLOCKING
{
    m_count = 0;
    m_window = 1.0;
    m_moved.setZero();
    m_slope.setZero();
}

} // namespace palpate::servo
