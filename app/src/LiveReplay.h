// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <palpate/device/DevicePresets.h>
#include <palpate/device/HapticDevice.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/servo/ServoLoop.h>
#include <palpate/session/Replay.h>

#include <cstdint>
#include <functional>
#include <memory>

namespace palpate::app {

/// How a replay in real time went.
struct LiveResult
{
    std::int64_t lost = 0; ///< rows of the motion that were not felt, or ticks that were dropped
    std::uint64_t overruns = 0;
    std::string fault; ///< one line, empty without one
};

/// The hand of a replay in real time.
struct LiveHand
{
    std::unique_ptr<device::HapticDevice> device;
    std::function<bool()> hasEnded; ///< asked about every 20 ms
    std::int64_t rows = -1;         ///< that must be felt; -1: however many there are
};

/// The motion itself, row by row.
[[nodiscard]] LiveHand playedHand(const session::Motion& motion);
/// A simulated hand that is drawn along the motion and pushed back by what it feels.
/// @param preset  of the device that it holds
[[nodiscard]] core::Result<LiveHand> simulatedHand(const session::Motion& motion, const device::DevicePreset& preset);
/// The hand that holds `device`, for as long as the motion lasts; the motion itself is not used.
[[nodiscard]] LiveHand realHand(const session::Motion& motion, std::unique_ptr<device::HapticDevice> device);

/// Feels with `hand` through the servo thread and the safety gate in real time.
/// @param begin  told once, before the first tick, with what the loop started from; an error ends the replay
/// @param sink   told each tick with a hand, numbered from 0, on the calling thread
/// @param idle   called about every 20 ms, to commit what was recorded
[[nodiscard]] core::Result<LiveResult>
replayLive(std::shared_ptr<const haptics::HapticScene> scene, LiveHand& hand, const servo::ServoOptions& options,
           const std::function<core::Status(const servo::RecordingStart&)>& begin, const session::TickSink& sink,
           const std::function<void()>& idle);

} // namespace palpate::app
