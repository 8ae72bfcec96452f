// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace palpate::evaluation {

using core::Vec3;

/// Uniform random numbers, identical on all standard libraries: upper bits of a 64-bit linear congruential generator.
/// @par Source Multiplier: Knuth, MMIX.
class RandomSource
{
  public:
    explicit RandomSource(std::uint64_t seed)
        : m_state(seed * 0x9e3779b97f4a7c15ull + 1)
    {
        (void)next();
        (void)next();
    }
    /// Uniform in 0 to 1.
    double next()
    {
        m_state = m_state * 6364136223846793005ull + 1442695040888963407ull;
        return static_cast<double>((m_state ^ m_state >> 29) >> 11 & 0xfffffffffffffull) * 0x1p-52;
    }
    /// Approximately normal with variance 1: sum of twelve uniform numbers.
    double normal()
    {
        double sum = -6.0;
        for (int i = 0; i < 12; ++i) {
            sum += next();
        }
        return sum;
    }
    Vec3 normal3()
    {
        const double x = normal(), y = normal();
        return {x, y, normal()};
    }

  private:
    std::uint64_t m_state;
};

/// HIP path made of straight segments.
class HandPath
{
  public:
    explicit HandPath(const Vec3& start) { m_points.push_back(start); }
    /// Appends a straight segment to `end` with at most `speed_mm` per tick and at least one tick.
    HandPath& to(const Vec3& end, double speed_mm)
    {
        const Vec3 from = m_points.back();
        const double count = std::max(1.0, std::ceil((end - from).norm() / speed_mm - 1e-9));
        for (double i = 1; i <= count; ++i) {
            m_points.push_back(i == count ? end : Vec3(from + (end - from) * (i / count)));
        }
        return *this;
    }
    HandPath& rest(int ticks)
    {
        m_points.insert(m_points.end(), static_cast<std::size_t>(ticks), m_points.back());
        return *this;
    }
    HandPath& jump(const Vec3& end)
    {
        m_points.push_back(end);
        return *this;
    }
    /// Adds noise to the whole path so far. @param sigma_mm  standard deviation per coordinate
    HandPath& noise(double sigma_mm, std::uint64_t seed)
    {
        RandomSource dice(seed);
        for (Vec3& p : m_points) {
            p += sigma_mm * dice.normal3();
        }
        return *this;
    }
    [[nodiscard]] const std::vector<Vec3>& points() const noexcept { return m_points; }

  private:
    std::vector<Vec3> m_points;
};

/// Smooth random motion below a surface around the origin, with a random direction and varying depth.
class RandomHandPath
{
  public:
    /// @param slowest_mm,fastest_mm  range of the speed per tick
    RandomHandPath(double radius_mm, double deepest_mm, double slowest_mm, double fastest_mm, std::uint64_t seed)
        : m_dice(seed)
        , m_radius_mm(radius_mm)
        , m_deepest_mm(deepest_mm)
        , m_slowest_mm(slowest_mm)
        , m_fastest_mm(fastest_mm)
    {
    }
    Vec3 next()
    {
        const double t = static_cast<double>(m_tick++);
        m_turn += 0.02 * (0.1 * m_dice.normal() - m_turn);
        m_heading = Eigen::AngleAxisd(m_turn, m_at) * m_heading;
        const double share = 0.5 + 0.5 * std::sin(3.1e-3 * t);
        const double step = (m_slowest_mm + (m_fastest_mm - m_slowest_mm) * share) / m_radius_mm;
        const Vec3 axis = m_at.cross(m_heading).normalized();
        m_at = (Eigen::AngleAxisd(step, axis) * m_at).normalized();
        m_heading = axis.cross(m_at).normalized();
        const double depth = t < 200.0 ? -m_deepest_mm * (1.0 - t / 100.0)
                                       : m_deepest_mm * (0.55 + 0.45 * std::cos(2.3e-3 * (t - 200.0)));
        return m_at * (m_radius_mm - depth);
    }

  private:
    RandomSource m_dice;
    double m_radius_mm, m_deepest_mm, m_slowest_mm, m_fastest_mm;
    Vec3 m_at = Vec3(0.48, 0.6, 0.64);
    Vec3 m_heading = Vec3(0.8, -0.64, 0.0).normalized();
    double m_turn = 0.0;
    std::int64_t m_tick = 0;
};

} // namespace palpate::evaluation
