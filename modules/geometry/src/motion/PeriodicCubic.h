// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace palpate::geometry::internal {

/// Periodic cubic through values at equal steps of a period, with central differences as slopes: the four steps around
/// a time, their weights, and the change of these weights per second.
/// @par Source Catmull & Rom, A class of local interpolating splines, in: Computer Aided Geometric Design (1974)
struct PeriodicCubic
{
    std::array<std::size_t, 4> step;
    std::array<double, 4> weight, slope;

    PeriodicCubic(double t, double period_s, std::size_t steps) noexcept
    {
        const double turns = t / period_s, count = static_cast<double>(steps);
        const double at = (turns - std::floor(turns)) * count; // 0 … count; count by rounding
        const auto cell = static_cast<std::size_t>(at) % steps;
        const double s = at - std::floor(at), perSecond = count / period_s;
        step = {(cell + steps - 1) % steps, cell, (cell + 1) % steps, (cell + 2) % steps};
        weight = {0.5 * s * (s * (2.0 - s) - 1.0), 0.5 * (s * s * (3.0 * s - 5.0) + 2.0),
                  0.5 * s * (1.0 + s * (4.0 - 3.0 * s)), 0.5 * s * s * (s - 1.0)};
        slope = {perSecond * (s * (2.0 - 1.5 * s) - 0.5), perSecond * s * (4.5 * s - 5.0),
                 perSecond * (0.5 + s * (4.0 - 4.5 * s)), perSecond * s * (1.5 * s - 1.0)};
    }
    [[nodiscard]] double value(const std::vector<double>& values) const noexcept { return sum(values, weight); }
    [[nodiscard]] double change(const std::vector<double>& values) const noexcept { return sum(values, slope); }

  private:
    [[nodiscard]] double sum(const std::vector<double>& values, const std::array<double, 4>& w) const noexcept
    {
        return w[0] * values[step[0]] + w[1] * values[step[1]] + w[2] * values[step[2]] + w[3] * values[step[3]];
    }
};

} // namespace palpate::geometry::internal
