// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>

#include <cstdint>

namespace palpate::servo {

/// Reason why the force is off until the user re-arms.
enum class FaultKind : std::uint8_t
{
    None,
    NonFiniteInput, ///< the device returned a position that is NaN or infinite
    OutOfWorkspace, ///< positions far outside the reachable workspace of the device
    InputJump,      ///< position steps that are too large for a hand
    StaleInput,     ///< the device stopped sending new positions
    DeviceLost,     ///< the device reported a lost connection
    NonFiniteForce, ///< the model returned a force that is NaN or infinite
    OverrunRun,     ///< too many consecutive ticks missed their deadline
    LoopFailed,     ///< an exception ended the servo thread
};

/// @return the cause and the remedy for the user; empty for None
[[nodiscard]] PALPATE_EXPORT core::Message text(FaultKind kind);

/// A latched fault.
struct Fault
{
    FaultKind kind = FaultKind::None;
    std::int64_t tick = 0;    ///< tick that raised the fault
    std::int64_t time_ns = 0; ///< monotonic clock [ns]
};

} // namespace palpate::servo
