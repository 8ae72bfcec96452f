// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Recording.h"

#include <palpate/servo/TickRecord.h>

namespace palpate::session::internal {

/// Reconstructs the damper velocity for recordings before version 4, which do not store velocities: the difference
/// quotient of consecutive HIPs.
class OldVelocity
{
  public:
    explicit OldVelocity(const RecordingInfo& info)
        : m_p_WH(info.start.p_WH)
        , m_dt_s(info.dt_s)
        , m_isKnown(info.start.started != 0)
    {
    }

    /// Sets the velocity of a tick. @pre called for each tick in order; the tick after a gap has kReset
    void fillIn(servo::TickRecord& tick)
    {
        if ((tick.flags & servo::kNoHand) != 0) {
            return;
        }
        m_isKnown = m_isKnown && (tick.flags & servo::kReset) == 0;
        tick.v_WH = m_isKnown ? core::Vec3((tick.p_WH - m_p_WH) / m_dt_s) : core::Vec3::Zero();
        m_p_WH = tick.p_WH;
        m_isKnown = true;
    }

  private:
    core::Vec3 m_p_WH; ///< HIP of the previous tick [mm]
    double m_dt_s;
    bool m_isKnown; ///< a previous HIP exists
};

} // namespace palpate::session::internal
