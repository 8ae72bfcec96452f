// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Bench.h>

#include <palpate/core/Clock.h>
#include <palpate/device/PluginHost.h>
#include <palpate/haptics/HapticScene.h>

#include <QTemporaryDir>

#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <vector>

extern "C" void standin_makeTimeVirtual();

namespace palpate::test {

/// The bench of this process's emulated hardware, in a separate file. The first object in a process determines the
/// file.
class EmulatedBench
{
  public:
    EmulatedBench();
    /// Calls a function with the bench locked and advanced to the current time.
    void with(const std::function<void(standin::Bench&)>& act);
    /// Moves the hand through these targets [s from now, mm in frame D].
    void moveHand(const std::vector<standin::Knot>& path);
    [[nodiscard]] std::string file() const { return m_file; }
    /// Time since the arm was plugged in [s].
    [[nodiscard]] double now_s();

  private:
    QTemporaryDir m_folder;
    std::string m_file;
    standin::Bench* m_bench = nullptr;
};

/// Returns a host with the released plugins.
std::unique_ptr<device::PluginHost> shippingPlugins();

/// Returns a block with its top in the plane z = 0 and this stiffness.
std::shared_ptr<const haptics::HapticScene> blockScene(double stiffness_N_per_mm);

/// Sleeps, in virtual time if enabled.
void pass(double seconds);

} // namespace palpate::test
