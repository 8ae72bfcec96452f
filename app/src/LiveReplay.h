// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
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
    std::int64_t lost = 0; ///< rows of the motion that were not felt or whose tick was dropped
    std::uint64_t overruns = 0;
    std::string fault; ///< one line, empty without one
};

/// Plays the motion through the servo thread and the safety gate in real time.
/// @param begin  told once, before the first tick, with what the loop started from; an error ends the replay
/// @param sink   told each tick with a hand, numbered from 0, on the calling thread
/// @param idle   called about every 20 ms, to commit what was recorded
[[nodiscard]] core::Result<LiveResult>
replayLive(std::shared_ptr<const haptics::HapticScene> scene, const session::Motion& motion,
           const std::function<core::Status(const servo::RecordingStart&)>& begin, const session::TickSink& sink,
           const std::function<void()>& idle);

} // namespace palpate::app
