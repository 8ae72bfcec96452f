// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/device/HapticDevice.h"
#include "palpate/device/PlainCopy.h"

#include <palpate/core/TripleBuffer.h>

namespace palpate::device {

/// The mouse as a device, "mouse": the window says where the HIP is, nothing pushes back (`actuatedAxes` is 0) and the
/// force is kept to be shown. D is the world frame.
///
/// A pointer that stands still sends no events, so its age means nothing: while it is present, `read` stamps its state
/// with the time of the tick and it never counts as stale.
class PointerDevice final : public HapticDevice
{
  public:
    /// Says where the pointer is; `time_ns` is ignored. To move to another place without dragging the god-object
    /// there, be absent for a tick in between. GUI thread only.
    void setState(const DeviceState& state) noexcept PALPATE_NONBLOCKING { m_state.write(state); }
    /// The force of the newest tick [N]. GUI thread only.
    [[nodiscard]] Vec3 newestForce() noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] DeviceInfo info() const override;
    core::Status start() override;
    void stop() noexcept override;
    [[nodiscard]] DeviceState read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING override;
    void write(const Vec3& f_D) noexcept PALPATE_NONBLOCKING override;

  private:
    core::TripleBuffer<PlainCopy<DeviceState>> m_state;                         // GUI -> servo
    core::TripleBuffer<PlainCopy<Vec3>> m_force{PlainCopy<Vec3>(Vec3::Zero())}; // servo -> GUI
};

} // namespace palpate::device
