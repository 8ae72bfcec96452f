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

/// The bench of this process's emulated hardware, in a file of its own. The first in a process decides.
class EmulatedBench
{
  public:
    EmulatedBench();
    /// Does something with the bench while it is held still, up to now.
    void with(const std::function<void(standin::Bench&)>& act);
    /// The hand goes through these targets [s from now, mm in frame D].
    void moveHand(const std::vector<standin::Knot>& path);
    [[nodiscard]] std::string file() const { return m_file; }
    /// Time since the arm was plugged in [s].
    [[nodiscard]] double now_s();

  private:
    QTemporaryDir m_folder;
    std::string m_file;
    standin::Bench* m_bench = nullptr;
};

/// The shipping plugins.
std::unique_ptr<device::PluginHost> shippingPlugins();

/// A block with the top in the plane z = 0 and this stiffness.
std::shared_ptr<const haptics::HapticScene> blockScene(double stiffness_N_per_mm);

/// Sleeps, in virtual time when that is on.
void pass(double seconds);

} // namespace palpate::test
