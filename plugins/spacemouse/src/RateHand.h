// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Puck.h"

#include <palpate/device/HapticDevice.h>

namespace palpate::spacemouse {

struct RateSettings
{
    double speed_mm_per_s = 60.0; ///< at full way
    double turn_rad_per_s = 1.0;
    double deadZone = 0.06;    ///< share of the way that counts as a resting hand; the rest begins at zero
    double staleAfter_s = 0.1; ///< a held puck reports every 8 or 16 ms; longer without one, it was let go or unplugged
    double reach_mm = 250.0;   ///< from the origin of D
};

/// Turns how a puck is held into a pose: a rate, integrated. Pure; time comes from the caller.
class RateHand
{
  public:
    explicit RateHand(const RateSettings& settings)
        : m_settings(settings)
    {
    }

    /// @param held_ns  when `held` was reported
    /// @return the pose at now_ns
    /// @par Real-time Wait-free.
    device::DeviceState advance(const Held& held, std::int64_t held_ns,
                                std::int64_t now_ns) noexcept PALPATE_NONBLOCKING;
    /// Makes the pose of now the origin, unturned. For one `advance` no hand is there: it comes anew.
    void recentre() noexcept PALPATE_NONBLOCKING;

  private:
    RateSettings m_settings;
    device::DeviceState m_state;
    std::int64_t m_now_ns = 0; // 0: before the first
    bool m_isNew = false;      // recentred, and not yet reported
};

} // namespace palpate::spacemouse
