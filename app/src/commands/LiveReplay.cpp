// SPDX-License-Identifier: BSD-3-Clause
#include "commands/LiveReplay.h"

#include <palpate/device/PlaybackDevice.h>
#include <palpate/device/SimulatedHand.h>
#include <palpate/session/LiveSession.h>

#include <chrono>
#include <optional>
#include <thread>

namespace palpate::app {

using core::Status;
using namespace std::chrono_literals;

namespace {

constexpr double kSettle_s = 0.25; // time without a hand, so that recording has started before the first row is played
constexpr auto kDrainInterval = 20ms;

} // namespace

LiveHand playbackHand(const session::Motion& motion)
{
    std::vector<device::PlaybackRow> rows(static_cast<std::size_t>(kSettle_s / motion.dt_s) + 1);
    for (auto& row : rows) {
        row.isPresent = false;
    }
    for (const auto& p_W : motion.p_WH) {
        rows.emplace_back().p_W = p_W;
    }
    auto device = std::make_unique<device::PlaybackDevice>(std::move(rows));
    const device::PlaybackDevice* const played = device.get();
    return {std::move(device), [played] { return played->hasEnded(); }, static_cast<std::int64_t>(motion.p_WH.size())};
}

core::Result<LiveHand> simulatedHand(const session::Motion& motion, const device::DevicePreset& preset)
{
    std::vector<device::HandTarget> targets{{0.0, motion.p_WH.front()}};
    for (std::size_t i = 0; i < motion.p_WH.size(); ++i) {
        targets.push_back({kSettle_s + static_cast<double>(i) * motion.dt_s, motion.p_WH[i]});
    }
    auto script = device::HandScript::make(std::move(targets));
    if (!script.isOk()) {
        return script.status();
    }
    device::SimulatedHandOptions options;
    options.preset = preset;
    options.rate_Hz = 1.0 / motion.dt_s;
    auto device = std::make_unique<device::SimulatedHand>(std::move(script).value(), options);
    const device::SimulatedHand* const hand = device.get();
    return LiveHand{std::move(device), [hand] { return hand->isFinished(); }};
}

LiveHand realHand(const session::Motion& motion, std::unique_ptr<device::HapticDevice> device)
{
    const auto end = std::chrono::steady_clock::now() +
                     std::chrono::duration<double>(kSettle_s + motion.dt_s * static_cast<double>(motion.p_WH.size()));
    return {std::move(device), [end] { return std::chrono::steady_clock::now() > end; }};
}

core::Result<LiveResult> replayLive(std::shared_ptr<const haptics::HapticScene> scene, LiveHand& hand,
                                    const servo::ServoOptions& options,
                                    const std::function<Status(const servo::RecordingStart&)>& begin,
                                    const session::TickSink& sink, const std::function<void()>& idle)
{
    session::LiveSession live;
    servo::ServoLoop& loop = live.loop();
    (void)live.setScene(std::move(scene), {}); // nothing is recorded
    if (Status status = live.start(*hand.device, options); !status.isOk()) {
        return status;
    }
    const auto start = live.takeTicks();
    if (!start.isOk()) {
        return start.status();
    }
    if (Status status = begin(start.value()); !status.isOk()) {
        return status;
    }

    LiveResult result;
    std::int64_t felt = 0;
    std::optional<std::int64_t> first;
    bool goesOn = true;
    const auto drain = [&] {
        servo::TickRecord tick;
        while (goesOn && loop.popTick(tick)) {
            if ((tick.flags & servo::kNoHand) != 0) {
                continue;
            }
            if (!first) {
                first = tick.tick;
            }
            tick.tick -= *first;
            ++felt;
            goesOn = sink(tick);
        }
    };
    while (goesOn && loop.isRunning() && !hand.hasEnded()) {
        std::this_thread::sleep_for(kDrainInterval);
        drain();
        idle();
    }
    if (const servo::FaultReport report = loop.fault(); report.isFaulted()) {
        result.fault = report.message;
    }
    live.stop();
    drain();
    result.lost = hand.rows < 0 ? static_cast<std::int64_t>(loop.droppedTicks()) : hand.rows - felt;
    result.overruns = loop.timing().overruns;
    return result;
}

} // namespace palpate::app
