// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/FileFrame.h>
#include <palpate/core/Types.h>
#include <palpate/device/HapticDevice.h>
#include <palpate/geometry/MeshReport.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/haptics/Palpator.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::session {

/// Version of the schema in resources/docs/recording.md, kept as the database's `user_version`.
inline constexpr int kRecordingVersion = 4;
/// "Palp", the database's `application_id`.
inline constexpr std::int32_t kRecordingApplicationId = 0x50616c70;

/// @return version of Palpate, as "0.1.0".
[[nodiscard]] std::string palpateVersion();
/// @return what this build was made from: a commit and compiler, "unknown" without version control.
[[nodiscard]] std::string buildId();
/// @return true when a build id stands for one source: not one with changes that no commit has, nor an unknown one.
[[nodiscard]] bool isExactBuild(std::string_view id);

/// Where the surface of a structure came from; what a HapticScene does not know about itself.
struct StructureSource
{
    std::string mesh;                                  ///< path of the file
    std::string part;                                  ///< structure inside the file, empty: all of it
    double unit_mm = 1.0;                              ///< what one unit of the file was taken as [mm]
    core::FileFrame frame = core::FileFrame::Untagged; ///< chosen for the file; Untagged: as its tag says, else LPS
    bool flipped = false;
    std::string sha256;                                 ///< geometryHash of the repaired mesh in the world frame
    core::Transform X_WM = core::Transform::Identity(); ///< pose
    /// The surface itself, when it shall go into the recording; null: only its name and hash do.
    std::shared_ptr<const geometry::RepairedMesh> embed;
};

/// One structure of a recorded scene.
struct StructureRecord
{
    std::string name;
    StructureSource source;
    haptics::Tissue tissue;
    std::uint32_t layer = 0;
    bool palpable = true;           ///< false: it had no haptic surface then
    std::string lawTable;           ///< bytes of the table that a law other than a linear one was felt by; empty: none
    std::string maps;               ///< what varied over the surface, as JSON with the maps' hashes; empty: nothing
    haptics::TissueMaps tissueMaps; ///< the maps themselves; empty also where the recording has lost them
};

/// What was felt: the structures by the numbers that ticks refer to.
struct SceneRecord
{
    std::uint32_t generation = 0; ///< see servo::ServoLoop::setScene
    std::vector<StructureRecord> structures;
    double fingertip_mm = 0.0; ///< radius of the ball that touched, 0 = a point
};

/// Describes a haptic scene for a recording.
/// @param sources  one entry a structure of `scene`, in its order; missing ones are left empty
[[nodiscard]] SceneRecord describeScene(std::uint32_t generation, const haptics::HapticScene& scene,
                                        std::span<const StructureSource> sources);

/// Something that happened at a tick. The writer adds "scene" (first tick of a generation), "tissue", "hidden",
/// "shown", "layer" and "structures" (what changed with it), "clutch" (the hand let go or came back); the recorder
/// "dropped", "disk", "timing" (how the loop kept time) and "ended" (why it ended by itself); the window "note",
/// "finding", "finding-edited", "finding-undone", "device-lost" and "fault"; recovery "recovered".
struct RecordingEvent
{
    std::int64_t tick = 0;
    std::string kind;
    std::string json = "{}"; ///< an object with what belongs to the kind
};

/// What is said once about a recording.
struct RecordingInfo
{
    int version = kRecordingVersion;
    /// Version whose rules its ticks were computed by: less than `version` in a recovered copy of an older recording.
    int tickVersion = kRecordingVersion;
    std::string palpate = palpateVersion();
    std::string build = buildId();
    std::string startedUtc; ///< ISO 8601; filled by the writer
    std::string scene;      ///< path of the scene or mesh that was opened, empty when there is none
    /// The same from the recording's folder, where it lay in it or below: with it a moved pair is found.
    std::string sceneBeside;
    std::string sceneSha256; ///< of the scene file when recording began, 64 hex digits; empty: not said
    std::string looks;       ///< how the structures of the first scene looked, JSON; empty: not said
    double rate_Hz = 1000.0;
    double dt_s = 1e-3; ///< period that the solver was given [s]
    device::DeviceInfo device;
    std::int64_t firstTick = 0;        ///< tick that `start` precedes
    std::uint32_t firstGeneration = 0; ///< scene at `start`
    haptics::PalpatorState start;
};

} // namespace palpate::session
