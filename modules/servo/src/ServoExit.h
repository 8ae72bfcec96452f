// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

namespace palpate::servo {

/// Registers a loop to be stopped at program exit. A program that ends by `exit` or by returning from `main` while the
/// loop runs requests a stop and waits at most 100 ms for zero force. A process that ends by a signal, `_exit` or
/// `abort` cannot do this: the watchdog of the device must act.
/// @param isStopRequested,isRunning  of a loop; must live until `forgetAtExit`
void stopAtExit(std::atomic<bool>& isStopRequested, const std::atomic<bool>& isRunning);
void forgetAtExit(const std::atomic<bool>& isStopRequested) noexcept;

} // namespace palpate::servo
