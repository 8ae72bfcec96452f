// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace palpate::servo {

/// Why the force was taken away until the user re-arms.
enum class FaultKind : std::uint8_t
{
    None,
    NonFiniteInput, ///< the device gave a position that is not a number
    OutOfWorkspace, ///< positions far outside what the device can reach
    InputJump,      ///< positions that no hand can have moved to
    StaleInput,     ///< the device stopped giving new positions
    DeviceLost,     ///< the device said that it no longer answers
    NonFiniteForce, ///< the model gave a force that is not a number
    OverrunRun,     ///< too many ticks in a row ended after their deadline
    LoopFailed,     ///< the servo thread ended by an exception
};

/// @return one line for a person: what happened and what to do; static storage.
[[nodiscard]] const char* text(FaultKind kind) noexcept;

/// A latched fault.
struct Fault
{
    FaultKind kind = FaultKind::None;
    std::int64_t tick = 0;    ///< in which it was raised
    std::int64_t time_ns = 0; ///< monotonic
};

} // namespace palpate::servo
