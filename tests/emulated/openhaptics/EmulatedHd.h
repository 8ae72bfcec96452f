// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <HdBench.h>
#include <SharedDevices.h>

#include <QString>

#include <string>

extern "C" void standin_makeTimeVirtual();

namespace palpate::test {

/// Emulated devices of 3D Systems for this process, the configurations of the maker's setup program, and the user's
/// settings for the plugin.
class EmulatedHd : public SharedDevices<standin::HdBench>
{
  public:
    /// @param file  bench to share with another process; empty: a new one
    explicit EmulatedHd(const std::string& file = {});
    /// Makes all devices new, with one configured.
    void renew();
    /// Writes a configuration for each name and removes the others.
    void configureDevices(const std::vector<std::string>& names);

    /// Describes violations: a device driven beyond its limit or for more than 10 ms without a new force, a call
    /// without a frame, for another device or with a closed handle. Empty: all is well.
    [[nodiscard]] QString violation(double limit_N = 3.3);
};

} // namespace palpate::test
