// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <cstdint>
#include <span>

namespace palpate::spacemouse {

/// Deflection of the puck: -1 to 1 of full deflection per axis, in a frame with x right, y away from the user, z up.
struct Held
{
    core::Vec3 shift = core::Vec3::Zero();
    core::Vec3 turn = core::Vec3::Zero(); ///< about these axes
    std::uint32_t buttons = 0;
};

/// Decodes reports of a 6-axis mouse. Numbers are little-endian int16 within ±350; the device's y points to the user
/// and z down. Report 1 with 7 bytes holds the translation and report 2 the rotation; report 1 with 13 bytes holds
/// both; report 3 holds the buttons. The layout follows from the report alone, not from the model. No byte beyond the
/// report's length is read.
class Puck
{
  public:
    /// Decodes one report. @return false: unknown type of report; the state does not change
    bool take(std::span<const std::uint8_t> report) noexcept;
    [[nodiscard]] const Held& held() const noexcept { return m_held; }

  private:
    Held m_held;
};

} // namespace palpate::spacemouse
