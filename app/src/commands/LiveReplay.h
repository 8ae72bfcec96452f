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

/// Result of a real-time replay.
struct LiveResult
{
    std::int64_t lost = 0; ///< rows of the motion not simulated, plus dropped ticks
    std::uint64_t overruns = 0;
    core::Message fault; ///< one line; empty without a fault
};

/// Hand of a real-time replay.
struct LiveHand
{
    std::unique_ptr<device::HapticDevice> device;
    std::function<bool()> hasEnded; ///< polled about every 20 ms
    std::int64_t rows = -1;         ///< number of rows that must be simulated; -1: any
};

/// Makes a hand that plays the motion itself, row by row.
[[nodiscard]] LiveHand playbackHand(const session::Motion& motion);
/// Makes a simulated hand that follows the motion and yields to the contact force.
/// @param preset  the simulated device
[[nodiscard]] core::Result<LiveHand> simulatedHand(const session::Motion& motion, const device::DevicePreset& preset);
/// Makes the hand of a physical `device`, active for the duration of the motion; only the duration of the motion is
/// used.
[[nodiscard]] LiveHand realHand(const session::Motion& motion, std::unique_ptr<device::HapticDevice> device);

/// Runs `hand` through the servo thread and the safety gate in real time.
/// @param begin  called once before the first tick with the start state of the loop; an error ends the replay
/// @param sink   called for each tick with a hand, numbered from 0, on the calling thread
/// @param idle   called about every 20 ms, to commit recorded data
[[nodiscard]] core::Result<LiveResult>
replayLive(std::shared_ptr<const haptics::HapticScene> scene, LiveHand& hand, const servo::ServoOptions& options,
           const std::function<core::Status(const servo::RecordingStart&)>& begin, const session::TickSink& sink,
           const std::function<void()>& idle);

} // namespace palpate::app
