// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>
#include <palpate/device/HapticDevice.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/servo/ServoLoop.h>
#include <palpate/session/Recorder.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace palpate::study {

/// Real-time haptic session: device, servo loop, haptic scene and recorder.
/// @par Thread All functions from the same thread.
class PALPATE_EXPORT LiveSession
{
  public:
    LiveSession() = default;
    ~LiveSession() { stop(); }
    LiveSession(const LiveSession&) = delete;
    LiveSession& operator=(const LiveSession&) = delete;

    /// Passes a scene to the servo, effective from the next tick, and to a running recording.
    /// @param sources  origin of each structure, in order, with the surface to embed if palpable
    void setScene(std::shared_ptr<const haptics::HapticScene> scene, std::vector<session::StructureSource> sources);

    /// Starts the servo thread on a device. @param device  must outlive the run. @return as ServoLoop::start
    core::Status start(device::HapticDevice& device, const servo::ServoOptions& options);
    /// Stops recording, then the servo thread. Losses are noted in the file.
    void stop();

    /// Servo loop. Do not set its scene or pop its ticks during a recording.
    [[nodiscard]] servo::ServoLoop& loop() noexcept { return m_loop; }
    [[nodiscard]] const servo::ServoLoop& loop() const noexcept { return m_loop; }

    /// Starts recording with the next tick.
    /// @param scene  opened file; empty for several files
    /// @param embeds  embed the surfaces in the recording
    /// @param looks  appearance of the structures, see `looksText`; empty: unknown
    /// @return a one-line error if the file cannot be created or the loop is not running
    core::Status startRecording(const std::filesystem::path& path, const std::filesystem::path& scene = {},
                                bool embeds = false, std::string looks = {});
    /// Records an event at the current tick. No effect without a recording. @param json  an object
    void note(const std::string& kind, const std::string& json) { m_recorder.addEvent(kind, json); }
    /// Stops recording. @return an error that lists any lost data
    core::Status stopRecording() { return m_recorder.stop(); }
    [[nodiscard]] session::RecorderStatus recording() const { return m_recorder.status(); }

    /// Enables `loop().popTick` from the next tick, for callers that process ticks without a recorder.
    /// @return the state before that tick, or Internal if the servo thread does not respond
    [[nodiscard]] core::Result<servo::RecordingStart> takeTicks();

  private:
    [[nodiscard]] session::SceneRecord sceneRecord() const;

    servo::ServoLoop m_loop;
    session::Recorder m_recorder{m_loop};
    device::DeviceInfo m_device;
    std::shared_ptr<const haptics::HapticScene> m_scene;
    std::vector<session::StructureSource> m_sources;
    std::uint32_t m_generation = 0; ///< of `m_scene`
    bool m_embeds = false;          ///< for the current recording
};

} // namespace palpate::study
