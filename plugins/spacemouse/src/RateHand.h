// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Puck.h"

#include <palpate/device/HapticDevice.h>

namespace palpate::spacemouse {

struct RateSettings
{
    double speed_mm_per_s = 60.0; ///< at full deflection
    double turn_rad_per_s = 1.0;
    double deadZone = 0.06; ///< fraction of the deflection that counts as rest; beyond, the rate starts at zero
    /// A deflected puck reports every 8 or 16 ms; after this time without a report, the puck was released or
    /// unplugged.
    double staleAfter_s = 0.1;
    double reach_mm = 250.0; ///< limit of the distance from the origin of D
};

/// Integrates the puck's deflection, interpreted as a rate, to a pose. No I/O and no clock: times are passed in.
class RateHand
{
  public:
    explicit RateHand(const RateSettings& settings)
        : m_settings(settings)
    {
    }

    /// Integrates up to `now_ns`.
    /// @param held_ns  time at which `held` was reported
    /// @return the pose at `now_ns`
    /// @par Real-time Wait-free.
    device::DeviceState advance(const Held& held, std::int64_t held_ns,
                                std::int64_t now_ns) noexcept PALPATE_NONBLOCKING;
    /// Resets the pose to the origin without rotation. The next `advance` reports no hand; after
    /// that, the hand reappears.
    void recentre() noexcept PALPATE_NONBLOCKING;

  private:
    RateSettings m_settings;
    device::DeviceState m_state;
    std::int64_t m_now_ns = 0; // 0: before the first call
    bool m_isNew = false;      // recentred, not yet reported
};

} // namespace palpate::spacemouse
