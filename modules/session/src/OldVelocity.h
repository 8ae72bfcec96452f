// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Recording.h"

#include <palpate/servo/TickRecord.h>

namespace palpate::session::internal {

/// The velocity that dampers had before recordings held it (version 4): the difference of two HIPs.
class OldVelocity
{
  public:
    explicit OldVelocity(const RecordingInfo& info)
        : m_p_WH(info.start.p_WH)
        , m_dt_s(info.dt_s)
        , m_isKnown(info.start.started != 0)
    {
    }

    /// Fills in that of a tick. @pre each tick is given, in order; where some are missing, the next one has kReset
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
    core::Vec3 m_p_WH; ///< of the tick before [mm]
    double m_dt_s;
    bool m_isKnown; ///< there was one
};

} // namespace palpate::session::internal
