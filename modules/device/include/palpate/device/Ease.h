// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Realtime.h>

#include <algorithm>
#include <cstdint>

namespace palpate::device {

/// Smooth transition of a scalar to a target: starts with the current speed, arrives at rest after a given time, and
/// never overshoots. Depends only on the tick time, so identical ticks give bit-identical values.
/// @par Source Monotone cubic with bounded slopes: Fritsch & Carlson (1980), doi:10.1137/0717021.
/// @par Real-time Wait-free.
class Ease
{
  public:
    /// Sets the value immediately, at rest.
    void rest(double at) noexcept PALPATE_NONBLOCKING
    {
        m_from = m_to = at;
        m_way = 0.0;
        m_over_s = 0.0;
    }
    /// @param over_s  duration of the transition, at least 0
    void aim(double to, double over_s, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING
    {
        const double from = at(now_ns);
        const double u = share(now_ns);
        const double speed =
            m_over_s > 0.0 ? (m_way * (1.0 - u) * (1.0 - 3.0 * u) + (m_to - m_from) * 6.0 * u * (1.0 - u)) / m_over_s
                           : 0.0;
        const double steepest = 3.0 * (to - from); // above three times the mean slope, a cubic overshoots
        m_way = std::clamp(speed * over_s, std::min(0.0, steepest), std::max(0.0, steepest));
        m_from = from;
        m_to = to;
        m_over_s = over_s;
        m_start_ns = now_ns;
    }
    [[nodiscard]] double at(std::int64_t now_ns) const noexcept PALPATE_NONBLOCKING
    {
        const double u = share(now_ns);
        if (u >= 1.0) {
            return m_to;
        }
        return m_from + m_way * u * (1.0 - u) * (1.0 - u) + (m_to - m_from) * u * u * (3.0 - 2.0 * u);
    }
    [[nodiscard]] double target() const noexcept PALPATE_NONBLOCKING { return m_to; }
    [[nodiscard]] bool isThere(std::int64_t now_ns) const noexcept PALPATE_NONBLOCKING { return share(now_ns) >= 1.0; }

  private:
    /// Elapsed fraction of the transition time, 0 to 1.
    [[nodiscard]] double share(std::int64_t now_ns) const noexcept PALPATE_NONBLOCKING
    {
        const double since_s = 1e-9 * static_cast<double>(now_ns - m_start_ns);
        return since_s < m_over_s ? std::max(0.0, since_s / m_over_s) : 1.0;
    }

    double m_from = 0.0, m_to = 0.0;
    double m_way = 0.0; ///< initial speed times the transition time
    double m_over_s = 0.0;
    std::int64_t m_start_ns = 0;
};

} // namespace palpate::device
