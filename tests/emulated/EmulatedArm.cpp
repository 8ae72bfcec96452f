// SPDX-License-Identifier: BSD-3-Clause
#include "EmulatedArm.h"

#include "Shapes.h"

namespace palpate::test {

EmulatedBench::EmulatedBench()
    : m_file(m_folder.filePath(QStringLiteral("bench")).toStdString())
{
    setenv("PALPATE_STANDIN", m_file.c_str(), 1);
    setenv("XDG_CONFIG_HOME", m_folder.path().toUtf8().constData(), 1); // independent of the user's settings
    setenv("HOME", m_folder.path().toUtf8().constData(), 1);
    m_bench = standin::openBench(m_file.c_str());
}

void EmulatedBench::with(const std::function<void(standin::Bench&)>& act)
{
    standin::lockBench(*m_bench);
    standin::advance(*m_bench, core::monotonicNow_ns());
    act(*m_bench);
    standin::unlockBench(*m_bench);
}

double EmulatedBench::now_s()
{
    double now = 0.0;
    with([&](standin::Bench& b) { now = static_cast<double>(b.arm.sim_ns - b.arm.plugged_ns) * 1e-9; });
    return now;
}

void EmulatedBench::moveHand(const std::vector<standin::Knot>& path)
{
    const double begin_s = now_s();
    with([&](standin::Bench& b) {
        standin::Hand& hand = b.arm.hand;
        const double tremor_mm = std::exchange(hand.tremor_mm, 0.0);
        const standin::V3 here = standin::targetOf(b.arm, begin_s);
        hand.tremor_mm = tremor_mm;
        hand.knots = 0;
        hand.path[static_cast<std::size_t>(hand.knots++)] = {begin_s, here};
        for (const standin::Knot& knot : path) {
            hand.path[static_cast<std::size_t>(hand.knots++)] = {begin_s + knot.time_s, knot.p_mm};
        }
    });
}

std::unique_ptr<device::PluginHost> shippingPlugins()
{
    return std::make_unique<device::PluginHost>(std::vector<std::filesystem::path>{PALPATE_PLUGINS});
}

std::shared_ptr<const haptics::HapticScene> blockScene(double stiffness_N_per_mm)
{
    haptics::HapticStructure block;
    block.name = "block";
    block.surface = indexed(box(core::Vec3(-150, -150, -150), core::Vec3(150, 150, 0), 8));
    block.tissue.stiffness_N_per_mm = stiffness_N_per_mm;
    return std::make_shared<haptics::HapticScene>(std::vector{block});
}

void pass(double seconds)
{
    core::sleepUntil_ns(core::monotonicNow_ns() + static_cast<std::int64_t>(seconds * 1e9));
}

} // namespace palpate::test
