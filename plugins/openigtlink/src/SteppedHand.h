// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/device/HapticDevice.h>

#include <cstdint>

namespace palpate::openigtlink {

/// Pose that was received, for the servo thread. A plain value.
struct Sample
{
    core::Vec3 p_D = core::Vec3::Zero(); ///< [mm]
    core::Quaternion q_D = core::Quaternion::Identity();
    std::int64_t time_ns = 0;     ///< monotonic time of arrival
    std::int64_t interval_ns = 0; ///< mean time between samples
    std::uint64_t number = 0;     ///< changes with each sample; 0: none yet
    std::uint64_t origin = 0;     ///< changes with the origin of D
    bool isPresent = false;
    bool isLost = false;
};

/// Turns samples at 20 to 100 Hz into a continuous motion at the servo rate: the hand goes to each sample in a straight
/// line, within the mean interval of the samples, and so lags by one interval. Otherwise each sample would be a step
/// of millimetres within one tick. No I/O and no clock: times are passed in.
/// @par Real-time Wait-free. Servo thread.
class SteppedHand
{
  public:
    /// @param staleAfter_s  age of a sample from which there is no hand
    explicit SteppedHand(double staleAfter_s) noexcept
        : m_staleAfter_ns(static_cast<std::int64_t>(staleAfter_s * 1e9))
    {
    }

    /// @return the state at `now_ns`. After a jump that no hand can make and after a change of the origin, the hand is
    /// absent for one call and then at the new place
    device::DeviceState advance(const Sample& newest, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING;
    /// True when the newest sample has been reached.
    [[nodiscard]] bool hasArrived() const noexcept { return m_hasArrived; }

  private:
    [[nodiscard]] double share(std::int64_t now_ns) const noexcept;

    std::int64_t m_staleAfter_ns;
    std::uint64_t m_number = 0;
    std::uint64_t m_origin = 0;
    bool m_isHere = false;
    bool m_hasArrived = false;
    core::Vec3 m_from_D = core::Vec3::Zero();
    core::Vec3 m_to_D = core::Vec3::Zero();
    core::Quaternion m_fromTurn = core::Quaternion::Identity();
    core::Quaternion m_toTurn = core::Quaternion::Identity();
    std::int64_t m_start_ns = 0;
    std::int64_t m_over_ns = 1;
};

} // namespace palpate::openigtlink
