// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "commands/LiveReplay.h"
#include "reports/ReplaySummary.h"
#include "shared/SurfaceOptions.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/core/Status.h>
#include <palpate/device/PluginHost.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/RecordingWriter.h>
#include <palpate/session/Replay.h>
#include <palpate/session/TickCsv.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::app {

/// Command line options of a replay.
struct ReplayOptions
{
    std::filesystem::path scene, motion, out, json, record;
    std::string unit = "mm", frame, radius, layers;
    std::array<std::string, core::kTissueTerms.size()> tissue; ///< in the order of kTissueTerms; empty: unchanged
    std::string device; ///< the hand's device in a live replay; empty: plays the motion itself
    std::vector<std::filesystem::path> pluginFolders;
    int cpu = -1; ///< CPU reserved for the servo loop in a live replay; -1: any
    bool isLive = false;
    bool isForced = false;
    bool isPartial = false;
    bool embeds = false;
    SurfaceOptions surfaces;
};

/// One replay, from checking the options to writing the outputs.
class ReplayRun
{
  public:
    explicit ReplayRun(const ReplayOptions& options)
        : m_options(options)
    {
    }
    ~ReplayRun();
    ReplayRun(const ReplayRun&) = delete;
    ReplayRun& operator=(const ReplayRun&) = delete;

    /// Runs the replay. @return the exit code
    int run();

  private:
    core::Status checkOptions();
    core::Status openOutputs();
    core::Status checkRecord() const;
    core::Status loadMotion();
    core::Status loadScene();
    core::Status feel();
    core::Status checkPalpableMatches(const session::SceneRecord& record) const;
    core::Status checkSameGeometry() const;
    core::Status feelRecording();
    core::Status feelLive();
    core::Result<LiveHand> liveHand();
    void limitTissues(const device::DeviceInfo& info);
    /// True if the hand holds a device and reacts to the force.
    bool hasDevice() const { return !m_options.device.empty() && m_options.device != "playback"; }
    core::Status finish();

    core::Status startRecording(const session::RecordingInfo& info);
    bool take(const servo::TickRecord& tick, const session::StructureNames& names);
    std::string_view name(std::uint32_t structure) const { return m_scene->structures()[structure].name; }

    const ReplayOptions& m_options;
    double m_unit_mm = 1.0;
    core::FileFrame m_frame = core::FileFrame::Untagged;
    session::TissueOverride m_tissue;
    std::optional<double> m_radius;
    bool m_isRelayered = false; ///< changed by `--layers auto`
    session::Motion m_motion;
    std::unique_ptr<session::RecordingReader> m_recording; ///< set if the motion is a recording
    std::shared_ptr<const haptics::HapticScene> m_scene;
    std::vector<session::StructureSource> m_sources; ///< set if hashes are needed
    std::string m_looks; ///< for a recording with smoothed or reoriented surfaces; empty: unchanged surfaces
    /// Per structure: a lump palpated through its organ, without a contact surface of its own.
    std::vector<char> m_isTransmitted;
    SceneCost m_cost;
    std::optional<ReplaySummary> m_summary;
    std::optional<session::Resimulation> m_resimulation;
    std::vector<core::Message> m_losses; ///< one line per loss
    core::Status m_writeStatus;
    std::unique_ptr<device::PluginHost> m_plugins; ///< set if the hand's device comes from a plugin
    std::optional<session::TickCsv> m_csv;
    std::optional<core::AtomicFile> m_json;
    std::unique_ptr<session::RecordingWriter> m_writer; ///< null after finishing
};

} // namespace palpate::app
