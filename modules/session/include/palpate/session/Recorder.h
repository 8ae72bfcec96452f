// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Recording.h"

#include <palpate/core/Status.h>
#include <palpate/servo/ServoLoop.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace palpate::session {

/// Lets a loop record from its next tick on. Ticks and beginnings of an earlier recording that were not taken are
/// thrown away.
/// @return where it begins, or nothing when the loop does not answer
[[nodiscard]] std::optional<servo::RecordingStart> beginRecording(servo::ServoLoop& loop);

/// How a recording is going.
struct RecorderStatus
{
    bool isRecording = false;
    std::int64_t ticks = 0;    ///< written
    std::uint64_t dropped = 0; ///< lost because the disk was too slow
    std::uint64_t late = 0;    ///< periods that the servo left out meanwhile, because a tick took too long
    double duration_s = 0.0;   ///< of what is recorded
    std::uint64_t fileBytes = 0;
    std::string problem;    ///< newest disk error, one line; empty while all is well
    bool hasFailed = false; ///< it ended by itself; `problem` says why and what is missing
};

/// Records what the servo loop does, on a thread of its own: drains the loop's ring into a recording. The servo never
/// waits; when the disk is slow the ring fills, drops and counts. A disk that is full ends the recording at once, other
/// errors when they last for a minute; the file says so in its last event. The touch goes on.
/// @par Thread All functions from one thread (the window's), which `start` and `stop` may hold for a disk access.
class Recorder
{
  public:
    /// @param loop  must outlive this; nothing else may pop its ticks meanwhile
    explicit Recorder(servo::ServoLoop& loop);
    ~Recorder(); ///< stops
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// Starts recording from the next tick.
    /// @param info   device and rate; the start state comes from the loop
    /// @param scene  what the loop feels now, with its generation
    /// @return one line when the file cannot be made or the loop is not running
    core::Status start(const std::filesystem::path& path, const RecordingInfo& info, const SceneRecord& scene);
    /// Tells of a scene that was handed to the loop; call it right after ServoLoop::setScene.
    void addScene(const SceneRecord& scene);
    /// Notes an event at the tick that is the newest now. @param json  an object
    void addEvent(const std::string& kind, const std::string& json);
    /// Asks to stop and returns at once; `status().isRecording` turns false when the file is closed.
    void requestStop();
    /// Stops and closes the file. @return what was lost, if anything
    core::Status stop();

    [[nodiscard]] RecorderStatus status() const;

  private:
    struct Private;
    std::unique_ptr<Private> m_d;
};

} // namespace palpate::session
