// SPDX-License-Identifier: BSD-3-Clause
#include "stability/StabilityTrial.h"

#include <palpate/device/SimulatedHand.h>
#include <palpate/servo/ServoCore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate::evaluation::stability {

namespace {

constexpr double kEaseIn_s = 0.55; // slightly longer than the ramp of the gate: press with the full force
constexpr double kWatch_s = 0.5;
constexpr double kSlideSpeed_mm_per_s = 50.0;

/// Hand script: approach at a given speed, optional slide, rest.
std::vector<device::HandTarget> pressing(const Hold& hold, double depth_mm, double speed_mm_per_s, double settle_s)
{
    const Vec3 high = hold.p_W + hold.slideFrom_mm - kClearance_mm * hold.d_W;
    const Vec3 deep = hold.p_W + hold.slideFrom_mm + depth_mm * hold.d_W;
    double time_s = kEaseIn_s;
    std::vector<device::HandTarget> script{{0.0, high}, {time_s, high}};
    time_s += (depth_mm + kClearance_mm) / speed_mm_per_s;
    script.push_back({time_s, deep});
    if (!hold.slideFrom_mm.isZero(0.0)) {
        time_s += 0.2;
        script.push_back({time_s, deep});
        time_s += hold.slideFrom_mm.norm() / kSlideSpeed_mm_per_s;
        script.push_back({time_s, deep - hold.slideFrom_mm});
    }
    script.push_back({time_s + settle_s + kWatch_s, script.back().p_W});
    return script;
}

} // namespace

double push_N(const device::DevicePreset& preset)
{
    return study::restingPush_N(preset.maxForce_N);
}

std::shared_ptr<const haptics::HapticScene> sceneOf(const Shape& shape, double stiffness_N_per_mm,
                                                    double damping_Ns_per_mm)
{
    std::vector<haptics::HapticStructure> structures = shape.structures;
    for (std::size_t i = 0; i < structures.size(); ++i) {
        structures[i].tissue.law = {}; // would replace the stiffness under test
        structures[i].law = nullptr;
        structures[i].tissue.stiffness_N_per_mm = shape.share[i] * stiffness_N_per_mm;
        structures[i].tissue.damping_Ns_per_mm = damping_Ns_per_mm;
    }
    return std::make_shared<const haptics::HapticScene>(std::move(structures));
}

void closeLoop(const haptics::HapticScene& scene, const std::vector<device::HandTarget>& script, const Grip& grip,
               const Setup& setup, const std::function<void(const servo::TickRecord&, const Vec3& tip_W)>& each)
{
    const device::DeviceMechanics& mechanics = setup.preset.mechanics;
    device::SimulatedHandOptions held;
    held.preset = setup.preset;
    held.rate_Hz = setup.rate_Hz;
    held.mass_kg = mechanics.mass_kg + grip.mass_kg;
    held.gripStiffness_N_per_mm = grip.stiffness_N_per_mm;
    held.gripDamping_Ns_per_mm = grip.damping_Ns_per_mm;
    held.deviceDamping_Ns_per_mm = mechanics.damping_Ns_per_mm;
    held.friction_N = mechanics.friction_N;
    held.resolution_mm = mechanics.resolution_mm;
    held.delayTicks = setup.delayTicks;
    auto made = device::HandScript::make(script);
    device::SimulatedHand hand(made.isOk() ? std::move(made).value() : device::HandScript(), held);
    if (!hand.start().isOk()) {
        return;
    }
    device::DeviceInfo info = device::deviceInfo(setup.preset);
    info.workspaceRadius_mm = 0.0; // the device is moved with the hand, as documented in SimulatedHand
    servo::PassivityLimits passivity = servo::PassivityLimits::forDevice(info);
    passivity.delayTicks = setup.delayTicks;
    passivity.isOn = passivity.isOn && setup.isControlled;
    servo::ServoCore core(servo::GateLimits::forDevice(info), setup.rate_Hz, passivity);
    core.borrowScene(&scene, 1);
    while (!hand.isFinished()) {
        const auto now_ns = 1'000'000'000 + std::llround(1e9 * static_cast<double>(core.nextTick()) / setup.rate_Hz);
        const servo::TickRecord tick = core.tick(hand.read(now_ns), now_ns);
        hand.write(tick.fSent_W);
        each(tick, hand.tip_W());
    }
}

double restOscillation_mm(const Shape& shape, double stiffness_N_per_mm, const Setup& setup)
{
    const auto scene = sceneOf(shape, stiffness_N_per_mm, setup.tissueDamping_Ns_per_mm);
    double worst = 0.0;
    bool isAnyPressed = false;
    for (const Grip& grip : setup.hands.empty() ? grips() : setup.hands) {
        for (const Hold& hold : shape.holds) {
            for (const double speed : {30.0, 200.0}) {
                const auto script =
                    pressing(hold, push_N(setup.preset) / grip.stiffness_N_per_mm, speed, setup.settle_s);
                const double from_s = script.back().time_s - kWatch_s;
                core::Box box;
                bool isTouching = false;
                closeLoop(*scene, script, grip, setup, [&](const servo::TickRecord& tick, const Vec3& tip_W) {
                    isTouching = tick.felt.structure >= 0;
                    if (static_cast<double>(tick.tick) >= from_s * setup.rate_Hz) {
                        box.extend(tip_W);
                    }
                });
                if (box.isEmpty()) {
                    return std::numeric_limits<double>::infinity();
                }
                const double moved = box.sizes().maxCoeff();
                if (!(moved < kLimitCycle_mm)) {
                    return moved; // limit cycle found
                }
                // A tip at rest without contact has slipped off a small, soft object: no result.
                if (isTouching) {
                    isAnyPressed = true;
                    worst = std::max(worst, moved);
                }
            }
        }
    }
    return isAnyPressed ? worst : std::numeric_limits<double>::infinity();
}

Cost controllerCost(const Shape& shape, double stiffness_N_per_mm, const Setup& setup)
{
    const auto scene = sceneOf(shape, stiffness_N_per_mm, setup.tissueDamping_Ns_per_mm);
    std::vector<double> percents;
    double largest_N = 0.0;
    std::vector<std::pair<double, double>> ticks; // force of the model and the force added by the controller
    for (const Grip& grip : setup.hands.empty() ? grips() : setup.hands) {
        for (const Hold& hold : shape.holds) {
            const double depth_mm = push_N(setup.preset) / grip.stiffness_N_per_mm;
            auto script = pressing(hold, depth_mm, 100.0, setup.settle_s);
            script.back().time_s += kEaseIn_s - setup.settle_s; // slide instead of rest
            const Vec3 along = hold.d_W.unitOrthogonal();
            for (const double side : {10.0, -10.0, 0.0}) {
                const Vec3 to = hold.p_W + depth_mm * hold.d_W + side * along;
                const double time_s = (to - script.back().p_W).norm() / 100.0;
                script.push_back({script.back().time_s + time_s, to});
            }
            closeLoop(*scene, script, grip, setup, [&](const servo::TickRecord& tick, const Vec3&) {
                // Skip ticks in which the gate also limits the force: that reduction is not due to the controller.
                const double force_N = tick.felt.f_W.norm();
                const bool isEasedIn = static_cast<double>(tick.tick) > kEaseIn_s * setup.rate_Hz;
                if (tick.felt.structure >= 0 && isEasedIn && force_N < setup.preset.maxForce_N) {
                    ticks.emplace_back(force_N, tick.fDamping_W.norm());
                    largest_N = std::max(largest_N, force_N);
                }
            });
        }
    }
    Cost cost;
    for (const auto& [force_N, added_N] : ticks) {
        if (force_N >= 0.02 * largest_N && force_N > 0.0) {
            percents.push_back(100.0 * added_N / force_N);
            cost.mean_percent += percents.back();
        }
    }
    if (!percents.empty()) {
        cost.mean_percent /= static_cast<double>(percents.size());
        const std::size_t p99 = percents.size() * 99 / 100;
        std::nth_element(percents.begin(), percents.begin() + static_cast<std::ptrdiff_t>(p99), percents.end());
        cost.p99_percent = percents[p99];
    }
    return cost;
}

} // namespace palpate::evaluation::stability
