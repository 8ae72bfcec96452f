// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/device/Ease.h"
#include "palpate/device/HapticDevice.h"
#include "palpate/device/PlainCopy.h"

#include <palpate/core/Export.h>
#include <palpate/core/TripleBuffer.h>

namespace palpate::device {

/// Position and press of the pointer. Converted from a plain DeviceState, the HIP jumps to that position immediately.
struct PointerState : DeviceState ///< `p_D`: reference point of the depth; `buttons` bit 0: pressed
{
    PointerState() = default;
    PointerState(const DeviceState& state) // NOLINT(google-explicit-constructor): implicit by design
        : DeviceState(state)
    {
    }
    Vec3 d_D = Vec3::Zero();          ///< unit press direction, into the tissue
    double depth_mm = 0.0;            ///< target depth of a press
    double hover_mm = 0.0;            ///< distance in front of `p_D` at which a press starts and ends; 0: no lift-off
    double pressTime_s = 0.0;         ///< duration of a press and of a change between depths
    double easeThreshold_mm = 0.0;    ///< inward travel beyond this adds time, ...
    double pressSpeed_mm_per_s = 0.0; ///< ... at this speed; 0: no added time
    double liftTime_s = 0.0;
};

/// Mouse as a device ("mouse"): the window sets the HIP position. No force feedback (`actuatedAxes` is 0); the force is
/// stored for display. D is the world frame.
///
/// A resting pointer sends no events, so the age of its state is meaningless: while present, `read` stamps the state
/// with the tick time, and the state never counts as stale.
///
/// Presses are animated here, tick by tick, and not in the window, which may be busy rendering: an instantaneous press
/// would cause a force impulse. A press starts in front of the surface at its first tick; after lift-off the hand is
/// absent.
class PALPATE_EXPORT PointerDevice final : public HapticDevice
{
  public:
    /// Sets the pointer state; `time_ns` is ignored. To move elsewhere without dragging the god-object along, set an
    /// absent state for one tick in between. GUI thread only.
    void setState(const PointerState& state) noexcept PALPATE_NONBLOCKING { m_state.write(state); }
    /// Force of the newest tick [N]. GUI thread only.
    [[nodiscard]] Vec3 newestForce() noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] DeviceInfo info() const override;
    core::Status start() override;
    void stop() noexcept override;
    [[nodiscard]] DeviceState read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING override;
    void write(const Vec3& f_D) noexcept PALPATE_NONBLOCKING override;

  private:
    core::TripleBuffer<PlainCopy<PointerState>> m_state;                        // GUI -> servo
    core::TripleBuffer<PlainCopy<Vec3>> m_force{PlainCopy<Vec3>(Vec3::Zero())}; // servo -> GUI
    Ease m_depth;              ///< depth along `d_D` from `p_D` [mm]; servo thread only
    bool m_isHandHere = false; ///< presence in the previous tick
};

} // namespace palpate::device
