// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// Touch in real time: a device, the servo loop that serves it, what it feels, and the recorder of it.
/// @par Thread All functions from one thread.
class LiveSession
{
  public:
    LiveSession() = default;
    ~LiveSession() { stop(); }
    LiveSession(const LiveSession&) = delete;
    LiveSession& operator=(const LiveSession&) = delete;

    /// Hands a scene to the servo, which feels it from its next tick on, and tells a recording that runs.
    /// @param sources  where its structures came from, in their order, each with the surface to embed if it can be felt
    void setScene(std::shared_ptr<const haptics::HapticScene> scene, std::vector<session::StructureSource> sources);

    /// Starts the servo thread on a device. @param device  must outlive the run. @return as ServoLoop::start
    core::Status start(device::HapticDevice& device, const servo::ServoOptions& options);
    /// Ends a recording, then the servo thread. What was lost is in the file.
    void stop();

    /// The loop; its scene and its recorded ticks are this object's business.
    [[nodiscard]] servo::ServoLoop& loop() noexcept { return m_loop; }
    [[nodiscard]] const servo::ServoLoop& loop() const noexcept { return m_loop; }

    /// Records from the next tick on.
    /// @param scene   file that was opened; empty when it is several
    /// @param embeds  put the surfaces into the recording too
    /// @param looks   how they look, see `looksText`; empty: not said
    /// @return one line when the file cannot be made or the loop is not running
    core::Status startRecording(const std::filesystem::path& path, const std::filesystem::path& scene = {},
                                bool embeds = false, std::string looks = {});
    /// Notes something in the recording, at this tick; nothing when there is none. @param json  an object
    void note(const std::string& kind, const std::string& json) { m_recorder.addEvent(kind, json); }
    /// @return what was lost, if anything
    core::Status stopRecording() { return m_recorder.stop(); }
    [[nodiscard]] session::RecorderStatus recording() const { return m_recorder.status(); }

    /// For a caller that takes the ticks without a recorder: from the next tick on `loop().popTick` gives each.
    /// @return what that tick began from, or Internal when the servo thread does not answer
    [[nodiscard]] core::Result<servo::RecordingStart> takeTicks();

  private:
    [[nodiscard]] session::SceneRecord sceneRecord() const;

    servo::ServoLoop m_loop;
    session::Recorder m_recorder{m_loop};
    device::DeviceInfo m_device;
    std::shared_ptr<const haptics::HapticScene> m_scene;
    std::vector<session::StructureSource> m_sources;
    std::uint32_t m_generation = 0; ///< of `m_scene`
    bool m_embeds = false;          ///< of the present recording
};

} // namespace palpate::study
