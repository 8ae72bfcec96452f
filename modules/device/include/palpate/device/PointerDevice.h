// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/device/Ease.h"
#include "palpate/device/HapticDevice.h"
#include "palpate/device/PlainCopy.h"

#include <palpate/core/TripleBuffer.h>

namespace palpate::device {

/// Where a pointer is and how it presses. As a DeviceState alone it is where that says, at once.
struct PointerState : DeviceState ///< `p_D`: what the depth is counted from; `buttons` bit 0: it presses
{
    PointerState() = default;
    PointerState(const DeviceState& state) // NOLINT(google-explicit-constructor): it is one
        : DeviceState(state)
    {
    }
    Vec3 d_D = Vec3::Zero();      ///< unit, the way in
    double depth_mm = 0.0;        ///< how far in a press goes
    double hover_mm = 0.0;        ///< how far in front of `p_D` it begins and ends; 0: it never lifts off
    double pressTime_s = 0.0;     ///< a press goes in over this time, and from one depth to another
    double gentle_mm = 0.0;       ///< a longer way than this takes longer, …
    double deeper_mm_per_s = 0.0; ///< … at this speed on average; 0: it doesn't
    double liftTime_s = 0.0;
};

/// The mouse as a device, "mouse": the window says where the HIP is, nothing pushes back (`actuatedAxes` is 0) and the
/// force is kept to be shown. D is the world frame.
///
/// A pointer that stands still sends no events, so its age means nothing: while it is present, `read` stamps its state
/// with the time of the tick and it never counts as stale.
///
/// It is here that a press goes in, tick by tick, and not in the window, which may be busy with a picture: a hand that
/// was there all at once would knock. A press begins in front of the surface at its first tick; lifted off, the hand is
/// gone.
class PointerDevice final : public HapticDevice
{
  public:
    /// Says where the pointer is; `time_ns` is ignored. To move to another place without dragging the god-object
    /// there, be absent for a tick in between. GUI thread only.
    void setState(const PointerState& state) noexcept PALPATE_NONBLOCKING { m_state.write(state); }
    /// The force of the newest tick [N]. GUI thread only.
    [[nodiscard]] Vec3 newestForce() noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] DeviceInfo info() const override;
    core::Status start() override;
    void stop() noexcept override;
    [[nodiscard]] DeviceState read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING override;
    void write(const Vec3& f_D) noexcept PALPATE_NONBLOCKING override;

  private:
    core::TripleBuffer<PlainCopy<PointerState>> m_state;                        // GUI -> servo
    core::TripleBuffer<PlainCopy<Vec3>> m_force{PlainCopy<Vec3>(Vec3::Zero())}; // servo -> GUI
    Ease m_depth;              ///< along `d_D` from `p_D` [mm]; servo thread only
    bool m_isHandHere = false; ///< at the tick before
};

} // namespace palpate::device
