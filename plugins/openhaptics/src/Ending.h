// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace palpate::openhaptics {

/// Zero force at the end of the process. The library offers no watchdog that a program could set, so that a process
/// which ends while its scheduler runs would leave the last force to the device. While armed, exit() and the signals
/// that end a process (Ctrl+C, a crash, the end of the session; not SIGKILL, which no program sees) first wait for two
/// callbacks of the scheduler that have driven zero, at most 5 ms; then the previous handler or the default follows.
namespace ending {

/// Installs the handlers, unless they are installed. Not in the servo thread.
void arm();
/// Restores the previous handlers where no other part of the program has installed its own meanwhile.
void disarm();

/// The process is ending: drive zero.
/// @par Real-time Wait-free.
[[nodiscard]] bool isNear() noexcept;
/// A callback has driven zero in all devices since `isNear`.
/// @par Real-time Wait-free.
void noteZero() noexcept;

} // namespace ending

} // namespace palpate::openhaptics
