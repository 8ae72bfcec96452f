// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Recording.h"

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>
#include <palpate/servo/ServoLoop.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace palpate::session {

/// Enables recording in the servo loop from the next tick. Discards unread ticks and start states of an earlier
/// recording.
/// @return the start state, or nothing if the loop does not respond
[[nodiscard]] PALPATE_EXPORT std::optional<servo::RecordingStart> beginRecording(servo::ServoLoop& loop);

/// Progress of a recording.
struct RecorderStatus
{
    bool isRecording = false;
    std::int64_t ticks = 0;    ///< number of ticks written
    std::uint64_t dropped = 0; ///< ticks lost because the disk was too slow
    std::uint64_t late = 0;    ///< periods skipped by the servo because a tick took too long
    double duration_s = 0.0;   ///< recorded duration
    std::uint64_t fileBytes = 0;
    core::Message problem;  ///< most recent disk error, one line; empty without errors
    bool hasFailed = false; ///< the recording ended after an error; `problem` gives the reason and the loss
};

/// Records the ticks of a servo loop: a background thread moves them from the loop's ring buffer into the file. The
/// servo never waits. On a slow disk the ring fills up, and further ticks are dropped and counted. A full disk ends the
/// recording immediately; other disk errors end the recording if they persist for a minute. The last event in the file
/// gives the reason. Haptic rendering continues in either case.
/// @par Thread All functions from the same thread (the GUI thread). `start` and `stop` may block for a disk access.
class PALPATE_EXPORT Recorder
{
  public:
    /// @param loop  must outlive this object; nothing else may pop ticks during a recording
    explicit Recorder(servo::ServoLoop& loop);
    ~Recorder(); ///< calls stop()
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// Starts recording with the next tick.
    /// @param info  device and rate; the start state is taken from the loop
    /// @param scene  current scene of the loop with its generation
    /// @return a one-line error if the file cannot be created or the loop is not running
    core::Status start(const std::filesystem::path& path, const RecordingInfo& info, const SceneRecord& scene);
    /// Records a new scene. Call directly after ServoLoop::setScene.
    void addScene(const SceneRecord& scene);
    /// Records an event at the most recent tick. @param json  an object
    void addEvent(const std::string& kind, const std::string& json);
    /// Requests the end of the recording without blocking. The ticks until this call are written, later ones are not.
    /// `status().isRecording` becomes false once the file is closed.
    void requestStop();
    /// Stops recording as requestStop and waits until the file is closed: at most until the ticks in the ring
    /// (`ServoOptions::ringCapacity`) are on the disk. @return an error that lists any lost data
    core::Status stop();

    [[nodiscard]] RecorderStatus status() const;

  private:
    struct Private;
    std::unique_ptr<Private> m_d;
};

} // namespace palpate::session
