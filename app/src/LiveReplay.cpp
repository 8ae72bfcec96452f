// SPDX-License-Identifier: BSD-3-Clause
#include "LiveReplay.h"

#include <palpate/device/PlaybackDevice.h>

#include <chrono>
#include <optional>
#include <thread>

namespace palpate::app {

using core::Status;
using core::StatusCode;
using namespace std::chrono_literals;

namespace {

constexpr double kSettle_s = 0.25; // of no hand, so that recording has begun before the first row is played
constexpr auto kDrainInterval = 20ms;
constexpr auto kStartTimeout = 2s;

} // namespace

core::Result<LiveResult> replayLive(std::shared_ptr<const haptics::HapticScene> scene, const session::Motion& motion,
                                    const std::function<Status(const servo::RecordingStart&)>& begin,
                                    const session::TickSink& sink, const std::function<void()>& idle)
{
    servo::ServoOptions options;
    options.rate_Hz = 1.0 / motion.dt_s;
    std::vector<device::PlaybackRow> rows(static_cast<std::size_t>(kSettle_s * options.rate_Hz) + 1);
    for (auto& row : rows) {
        row.isPresent = false;
    }
    for (const auto& p_W : motion.p_WH) {
        rows.emplace_back().p_W = p_W;
    }
    device::PlaybackDevice device(std::move(rows));
    servo::ServoLoop loop; // after the device: it must end first
    loop.setScene(std::move(scene));
    if (Status status = loop.start(device, options); !status.isOk()) {
        return status;
    }
    loop.startRecording();
    servo::RecordingStart start;
    const auto deadline = std::chrono::steady_clock::now() + kStartTimeout;
    while (!loop.fetchRecordingStart(start)) {
        if (std::chrono::steady_clock::now() > deadline) {
            return Status(StatusCode::Internal, "the servo thread does not answer");
        }
        std::this_thread::sleep_for(1ms);
    }
    if (Status status = begin(start); !status.isOk()) {
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
    while (goesOn && loop.isRunning() && !device.hasEnded()) {
        std::this_thread::sleep_for(kDrainInterval);
        drain();
        idle();
    }
    if (const servo::FaultReport report = loop.fault(); report.isFaulted()) {
        result.fault = report.message;
    }
    loop.stop();
    drain();
    result.lost = static_cast<std::int64_t>(motion.p_WH.size()) - felt;
    result.overruns = loop.timing().overruns;
    return result;
}

} // namespace palpate::app
