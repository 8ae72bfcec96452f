// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <DhdBench.h>

#include <SharedDevices.h>

#include <QString>

#include <string>

extern "C" void standin_makeTimeVirtual();

namespace palpate::test {

/// Emulated devices of Force Dimension for this process, and the user's settings for the plugin.
class EmulatedDhd : public SharedDevices<standin::DhdBench>
{
  public:
    /// @param file  bench to share with another process; empty: a new one
    explicit EmulatedDhd(const std::string& file = {});
    /// Makes all devices new, with two omega.3 of which one is on the bus.
    void renew();

    /// Describes violations: a device driven beyond its limit or for more than 10 ms without a new force, a call that
    /// names no open device. Empty: all is well.
    [[nodiscard]] QString violation(double limit_N = 12.0);
};

} // namespace palpate::test
