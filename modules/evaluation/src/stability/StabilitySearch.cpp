// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/Stability.h"

#include <palpate/servo/PassivityController.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace palpate::evaluation::stability {

namespace {

constexpr double kSoftest_N_per_mm = 0.05;
constexpr double kStep = 1.25;
constexpr double kPrecision = 1.04;
constexpr double kSoftTissue_N_per_mm = 0.3;

SweepPoint pointOf(double x, const Shape& wall, Setup setup)
{
    SweepPoint point;
    point.x = x;
    setup.isControlled = false;
    point.without_N_per_mm = largestStiffness(wall, setup);
    setup.isControlled = true;
    point.with_N_per_mm = largestStiffness(wall, setup);
    point.passive_N_per_mm = servo::passiveStiffness_N_per_mm(setup.preset.mechanics.damping_Ns_per_mm,
                                                              setup.tissueDamping_Ns_per_mm, 1.0 / setup.rate_Hz);
    point.held_N_per_mm =
        servo::heldStiffness_N_per_mm(device::deviceInfo(setup.preset), setup.rate_Hz, true, setup.delayTicks);
    return point;
}

/// Runs `measured` and reports the overall progress.
class Progress
{
  public:
    Progress(const Options& options, std::size_t steps)
        : m_options(options)
        , m_steps(static_cast<double>(steps))
    {
    }
    void next(const std::string& what)
    {
        if (m_options.progress) {
            m_options.progress(m_done / m_steps, what);
        }
        m_done += 1.0;
    }

  private:
    const Options& m_options;
    double m_steps;
    double m_done = 0.0;
};

std::vector<Sweep> sweepsOf(const device::DevicePreset& preset, const Shape& wall, const Options& options,
                            Progress& progress)
{
    const std::string name(preset.name);
    Setup usual;
    usual.preset = preset;
    usual.rate_Hz = options.rate_Hz;
    usual.delayTicks = options.delayTicks;
    std::vector<Sweep> sweeps;
    progress.next(name + ": rate");
    Sweep& rate = sweeps.emplace_back(Sweep{name, "rate", "Hz", {}});
    for (const double hz : {250.0, 500.0, 1000.0, 2000.0, 4000.0}) {
        Setup setup = usual;
        setup.rate_Hz = hz;
        rate.points.push_back(pointOf(hz, wall, setup));
    }
    progress.next(name + ": delay");
    Sweep& delay = sweeps.emplace_back(Sweep{name, "delay", "ticks", {}});
    for (const int ticks : {0, 1, 2, 3, 4}) {
        Setup setup = usual;
        setup.delayTicks = ticks;
        delay.points.push_back(pointOf(ticks, wall, setup));
    }
    progress.next(name + ": resolution");
    Sweep& resolution = sweeps.emplace_back(Sweep{name, "resolution", "mm", {}});
    for (const double share : {0.25, 0.5, 1.0, 2.0, 4.0}) {
        Setup setup = usual;
        setup.preset.mechanics.resolution_mm *= share;
        resolution.points.push_back(pointOf(setup.preset.mechanics.resolution_mm, wall, setup));
    }
    progress.next(name + ": damping");
    Sweep& damping = sweeps.emplace_back(Sweep{name, "damping of the device", "N·s/m", {}});
    for (const double share : {0.0, 1.0, 2.0, 4.0, 8.0}) {
        Setup setup = usual;
        setup.preset.mechanics.damping_Ns_per_mm *= share;
        damping.points.push_back(pointOf(1000.0 * setup.preset.mechanics.damping_Ns_per_mm, wall, setup));
    }
    return sweeps;
}

} // namespace

double largestStiffness(const Shape& shape, const Setup& setup)
{
    double held = 0.0;
    double lost = kSoftest_N_per_mm;
    for (;;) {
        const double moved = restOscillation_mm(shape, lost, setup);
        const bool isHeld = moved < kLimitCycle_mm;
        if (!isHeld && (held > 0.0 || std::isfinite(moved))) {
            break;
        }
        // Too soft: every hold slipped off. Continue with a stiffer setting.
        held = isHeld ? lost : 0.0;
        if (lost >= kStiffest_N_per_mm) {
            return held;
        }
        lost = std::min(kStiffest_N_per_mm, lost * kStep);
    }
    while (held > 0.0 && lost / held > kPrecision) {
        const double middle = std::sqrt(held * lost);
        (restOscillation_mm(shape, middle, setup) < kLimitCycle_mm ? held : lost) = middle;
    }
    return held;
}

Result measure(const std::string& subject, const std::vector<Shape>& shapes, const Options& options)
{
    constexpr std::size_t kSweeps = 4;
    const auto began = std::chrono::steady_clock::now();
    Result result;
    result.subject = subject;
    result.rate_Hz = options.rate_Hz;
    result.delayTicks = options.delayTicks;
    Progress progress(options, options.presets.size() * (shapes.size() + (options.hasSweeps ? kSweeps : 0)));
    const Shape wall = standardShapes().front();
    for (const device::DevicePreset& preset : options.presets) {
        for (const Shape& shape : shapes) {
            progress.next(std::string(preset.name) + ": " + shape.name);
            Setup setup;
            setup.preset = preset;
            setup.rate_Hz = options.rate_Hz;
            setup.delayTicks = options.delayTicks;
            Row row;
            row.device = preset.name;
            row.shape = shape.name;
            row.stated_N_per_mm = preset.maxStiffness_N_per_mm;
            row.with_N_per_mm = largestStiffness(shape, setup);
            row.restless_mm = restOscillation_mm(shape, preset.maxStiffness_N_per_mm, setup);
            row.cost = controllerCost(shape, preset.maxStiffness_N_per_mm, setup);
            row.costSoft = controllerCost(shape, std::min(kSoftTissue_N_per_mm, preset.maxStiffness_N_per_mm), setup);
            setup.isControlled = false;
            row.without_N_per_mm = largestStiffness(shape, setup);
            result.rows.push_back(std::move(row));
        }
        if (options.hasSweeps) {
            for (Sweep& sweep : sweepsOf(preset, wall, options, progress)) {
                result.sweeps.push_back(std::move(sweep));
            }
        }
    }
    result.duration_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    return result;
}

} // namespace palpate::evaluation::stability
