// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/servo/SensorGrid.h"

#include <algorithm>
#include <cmath>

namespace palpate::servo {

namespace {

constexpr double kFinest_mm = 0.004;
constexpr double kCoarsest_mm = 0.5;
constexpr double kTolerance = 0.01; // share of a step: positions in files are rounded
constexpr double kLongest = 64.0;   // steps per tick; longer moves are jumps and are ignored

/// Euclid's algorithm with a tolerance. @return a common divisor; < kFinest_mm if there is no meaningful divisor
double commonStep(double a, double b) noexcept
{
    while (b >= kFinest_mm) {
        const double tolerance = kTolerance * b;
        double rest = std::fmod(a, b);
        if (rest <= tolerance || b - rest <= tolerance) {
            return b;
        }
        a = b;
        b = rest;
    }
    return b;
}

} // namespace

void SensorGrid::note(double move_mm) noexcept PALPATE_NONBLOCKING
{
    const double length = std::abs(move_mm);
    if (m_step_mm < 0.0 || !(length <= kLongest * (m_step_mm > 0.0 ? m_step_mm : kCoarsest_mm))) {
        return;
    }
    if (length > 0.0 && m_step_mm == 0.0) {
        m_step_mm = length;
    } else if (length > 0.0) {
        const double step = commonStep(std::max(length, m_step_mm), std::min(length, m_step_mm));
        if (step < (1.0 - kTolerance) * m_step_mm) {
            m_step_mm = step;
            m_evidence = 0;
        }
    }
    if (m_step_mm > 0.0 && m_step_mm < kFinest_mm) {
        m_step_mm = -1.0;
        m_evidence = 0;
        return;
    }
    if (m_step_mm > 0.0 && m_step_mm <= kCoarsest_mm && m_evidence < kEnough) {
        const auto steps = [this](double move) { return std::lround(move / m_step_mm); };
        const long before = steps(m_before[1]), off = steps(m_before[0]) - before, now = steps(move_mm);
        // One step more or less in a single tick, which the next tick drops or reverses.
        if (std::abs(off) == 1 && (now == before || now == before - off)) {
            ++m_evidence;
        }
    }
    m_before = {move_mm, m_before[0]};
}

bool SensorGrid::fits(double step_mm) const noexcept PALPATE_NONBLOCKING
{
    const double rest = std::remainder(std::max(0.0, m_step_mm), step_mm);
    return m_step_mm >= 0.0 && std::abs(rest) <= kTolerance * step_mm;
}

} // namespace palpate::servo
