// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Recorder.h"

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>
#include <palpate/device/HapticDevice.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/servo/ServoLoop.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate::session {

/// Whether a recording contains the surfaces, so that it can be opened and verified without the scene.
enum class Embed : std::uint8_t
{
    No, ///< only the hashes of the surfaces
    Yes
};

/// Real-time haptic session: device, servo loop, haptic scene and recorder.
///
/// @code
/// session::LiveSession live;
/// live.setScene(scene, sources);
/// if (Status status = live.start(device, {}); !status.isOk()) { … }
/// if (Status status = live.startRecording("session.palpate", session::Embed::Yes); !status.isOk()) { … }
/// while (…) { // a few times per second
///     if (const auto fault = live.poll()) {
///         show(fault->message);  // the force is off
///         live.loop().rearm();   // when the user confirms
///     }
/// }
/// @endcode
/// @par Thread All functions from the same thread.
class PALPATE_EXPORT LiveSession
{
  public:
    LiveSession() = default;
    ~LiveSession() { stop(); }
    LiveSession(const LiveSession&) = delete;
    LiveSession& operator=(const LiveSession&) = delete;

    /// Passes a scene to the servo, effective from the next tick, and to a running recording.
    /// @param sources  origin of each structure, in order; for Embed::Yes with the surface of each palpable structure.
    /// An empty hash of such a surface is computed
    /// @return Mismatch, if the running recording should embed a surface that `sources` lacks; the scene is effective
    /// and recorded without this surface
    core::Status setScene(std::shared_ptr<const haptics::HapticScene> scene, std::vector<StructureSource> sources);

    /// Starts the servo thread on a device. @param device  must outlive the run. @return as ServoLoop::start
    core::Status start(device::HapticDevice& device, const servo::ServoOptions& options);
    /// Stops recording, then the servo thread. Losses are noted in the file.
    void stop();

    /// Servo loop. Do not set its scene or pop its ticks during a recording.
    [[nodiscard]] servo::ServoLoop& loop() noexcept { return m_loop; }
    [[nodiscard]] const servo::ServoLoop& loop() const noexcept { return m_loop; }

    /// Starts recording with the next tick.
    /// @param info  origin and appearance of the scene, if known; device and start state are taken from the session
    /// @return a one-line error if the file cannot be created or the loop is not running; Mismatch for Embed::Yes if a
    /// palpable structure has no surface to embed: nothing is recorded
    core::Status startRecording(const std::filesystem::path& path, Embed embed = Embed::No, RecordingInfo info = {});
    /// Records an event at the current tick. No effect without a recording. @param json  an object
    void note(const std::string& kind, const std::string& json) { m_recorder.addEvent(kind, json); }
    /// Stops recording. @return an error that lists any lost data
    core::Status stopRecording() { return m_recorder.stop(); }
    [[nodiscard]] RecorderStatus recording() const { return m_recorder.status(); }

    /// Frees scenes that the servo has returned, and looks for a fault since the last call, which also becomes an event
    /// of the recording. After a fault the force stays off until `loop().rearm()`. Call a few times per second.
    /// @return the new fault with its message
    [[nodiscard]] std::optional<servo::FaultReport> poll();

    /// Enables `loop().popTick` from the next tick, for callers that process ticks without a recorder.
    /// @return the state before that tick, or Internal if the servo thread does not respond
    [[nodiscard]] core::Result<servo::RecordingStart> takeTicks();

  private:
    [[nodiscard]] SceneRecord sceneRecord() const;
    [[nodiscard]] core::Status checkEmbedded() const;

    servo::ServoLoop m_loop;
    Recorder m_recorder{m_loop};
    device::DeviceInfo m_device;
    std::shared_ptr<const haptics::HapticScene> m_scene;
    std::vector<StructureSource> m_sources;
    std::uint32_t m_generation = 0; ///< of `m_scene`
    Embed m_embed = Embed::No;      ///< for the current recording
    std::int64_t m_faultTick = -1;  ///< tick of the fault that `poll` returned last
};

} // namespace palpate::session
