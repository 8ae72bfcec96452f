// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/device/HapticDevice.h"

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate::device {

/// Result for one direction of the guided check of axes.
enum class AxisVerdict : std::uint8_t
{
    Pending,
    Follows,
    Mirrored, ///< the device moves against the direction
    Swapped,  ///< the device moves along another axis
    Oblique,  ///< the device moves between two axes
    Unmoved,  ///< no motion within the time
};

/// One direction: what was asked for, and what the device showed.
struct AxisResult
{
    AxisVerdict verdict = AxisVerdict::Pending;
    Vec3 asked_U = Vec3::Zero();  ///< unit direction in the user frame U
    Vec3 moved_mm = Vec3::Zero(); ///< measured way in U
};

/// Guided check whether the axes of a device follow the user: move the handle to your right, away from you, up. The
/// check uses positions only and sends no force.
///
/// A direction is complete when the handle has moved by `way_mm` from the place where it rested and rests again for
/// 0.3 s. It follows if the way is within 40 degrees of the direction that was asked for.
/// @par Thread Any one thread; call `follow` every 5 to 50 ms.
class PALPATE_EXPORT AxisCheck
{
  public:
    static constexpr std::size_t kDirections = 3;
    /// Largest time for one direction [s].
    static constexpr double kLongest_s = 20.0;

    explicit AxisCheck(const DeviceInfo& info);

    /// Processes the newest state of the device.
    void follow(const DeviceState& state, double time_s);
    [[nodiscard]] bool isDone() const noexcept { return m_next >= kDirections; }
    /// Direction that is asked for, from 0; kDirections when done.
    [[nodiscard]] std::size_t current() const noexcept { return m_next; }
    [[nodiscard]] const std::array<AxisResult, kDirections>& results() const noexcept { return m_results; }
    [[nodiscard]] double way_mm() const noexcept { return m_way_mm; }
    /// All directions follow.
    [[nodiscard]] bool isRight() const noexcept;
    /// The measured directions form a left-handed frame: the device mirrors the motion, and no turn of its base helps.
    [[nodiscard]] bool isMirrored() const noexcept;

    /// Instruction for the current direction, empty when done.
    [[nodiscard]] core::Message instruction() const;
    /// Statement about one direction, empty while pending.
    [[nodiscard]] core::Message statement(std::size_t direction) const;
    /// What to do, empty if all directions follow or the check is not done.
    [[nodiscard]] core::Message remedy() const;

  private:
    void finish(const Vec3& moved_mm, bool hasMoved);

    core::Quaternion m_q_UD;
    std::string m_device;
    double m_way_mm = 40.0;
    std::array<AxisResult, kDirections> m_results;
    std::size_t m_next = 0;
    bool m_hasStart = false;
    Vec3 m_start_D = Vec3::Zero();
    double m_began_s = 0.0;
    Vec3 m_rest_D = Vec3::Zero(); ///< place around which the handle rests
    double m_restSince_s = 0.0;
    bool m_isResting = false;
};

} // namespace palpate::device
