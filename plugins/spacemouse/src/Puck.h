// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <cstdint>
#include <span>

namespace palpate::spacemouse {

/// How the puck is held: shares of its full way, -1 to 1, in a frame with x to the right, y away from the user, z up.
struct Held
{
    core::Vec3 shift = core::Vec3::Zero();
    core::Vec3 turn = core::Vec3::Zero(); ///< about these axes
    std::uint32_t buttons = 0;
};

/// Reads a 6-axis mouse's reports. Numbers are little-endian int16 within ±350; the device's y points to the user and
/// its z down. Report 1 of 7 bytes holds the shift, report 2 the turn; report 1 of 13 bytes holds both; report 3 the
/// buttons. What was read decides, never the model: no byte beyond the report's length is looked at.
class Puck
{
  public:
    /// @return false: a report of no known kind; what is held stays as it was
    bool take(std::span<const std::uint8_t> report) noexcept;
    [[nodiscard]] const Held& held() const noexcept { return m_held; }

  private:
    Held m_held;
};

} // namespace palpate::spacemouse
