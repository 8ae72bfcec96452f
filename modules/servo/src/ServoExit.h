// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

namespace palpate::servo {

/// From now on, a program that ends by `exit` or by returning from `main` while the loop runs first asks it to stop
/// and waits until its force is zero, at most 100 ms. A process that is killed outright (a signal, `_exit`, `abort`)
/// cannot: there the device's own watchdog must act.
/// @param isStopRequested,isRunning  of a loop; must live until `forgetAtExit`
void stopAtExit(std::atomic<bool>& isStopRequested, const std::atomic<bool>& isRunning);
void forgetAtExit(const std::atomic<bool>& isStopRequested) noexcept;

} // namespace palpate::servo
