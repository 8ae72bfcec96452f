// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Realtime.h>
#include <palpate/core/Status.h>
#include <palpate/core/Types.h>

#include <cstddef>
#include <vector>

namespace palpate::device {

/// Target position of a hand at a given time.
struct HandTarget
{
    double time_s = 0.0;
    core::Vec3 p_W = core::Vec3::Zero(); ///< [mm]
};

/// Smooth path through targets: each coordinate is a cubic Hermite curve with continuous velocity that does not
/// overshoot between neighbouring targets. The velocity is zero at the first target, the last target and every turning
/// point.
/// @par Source Fritsch & Butland, SIAM J. Sci. Stat. Comput. 5 (1984), doi:10.1137/0905021 (weighted harmonic mean of
/// slopes).
class PALPATE_EXPORT HandScript
{
  public:
    HandScript() = default;
    /// @param targets  at least one; strictly ascending times; finite values
    static core::Result<HandScript> make(std::vector<HandTarget> targets);

    struct Motion
    {
        core::Vec3 p_W = core::Vec3::Zero(); ///< [mm]
        core::Vec3 v_W = core::Vec3::Zero(); ///< [mm/s]
    };
    /// Evaluates the path. Before the first and after the last target the position is constant.
    /// @par Real-time Wait-free; a binary search over the targets.
    [[nodiscard]] Motion at(double time_s) const noexcept PALPATE_NONBLOCKING;
    /// Time of the last target [s].
    [[nodiscard]] double end_s() const noexcept { return m_targets.empty() ? 0.0 : m_targets.back().time_s; }

  private:
    std::vector<HandTarget> m_targets;
    std::vector<core::Vec3> m_v_W; // velocity at each target [mm/s]
};

} // namespace palpate::device
