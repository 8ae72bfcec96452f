// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/SelfTestResult.h"

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>

#include <memory>

namespace palpate::servo {

/// Runs a SelfTest on a thread with absolute deadlines, like ServoLoop. However the run ends - done, cancelled, a
/// fault, destruction, or `exit` - the last force that the device gets is zero. If the process is killed, the watchdog
/// of the device must act.
/// @par Thread One thread makes all calls; it polls about every 50 ms.
class PALPATE_EXPORT SelfTestRun
{
  public:
    SelfTestRun();
    ~SelfTestRun();
    SelfTestRun(const SelfTestRun&) = delete;
    SelfTestRun& operator=(const SelfTestRun&) = delete;

    /// Starts the device and the test.
    /// @param device  must outlive the run
    core::Status start(device::HapticDevice& device, const SelfTestOptions& options = {});
    /// Passes the delay that the driver measured to the test. @return false when the test has ended
    bool poll();
    [[nodiscard]] SelfTestStep step() const noexcept;
    [[nodiscard]] double progress() const noexcept;
    /// Ramps the force to zero and ends the test as Cancelled.
    void cancel() noexcept;
    /// Waits for the end, stops the device and evaluates the test. Call once, after `start` succeeded.
    [[nodiscard]] SelfTestResult finish();

  private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace palpate::servo
