// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/FileFrame.h>
#include <palpate/core/Types.h>
#include <palpate/device/HapticDevice.h>
#include <palpate/geometry/Repair.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/haptics/Palpator.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::session {

/// Version of the schema in docs/recording.md, stored as the database's `user_version`.
inline constexpr int kRecordingVersion = 4;
/// Version of a recording with moving tissue: as 4, with motions among the maps, which older programs would ignore.
inline constexpr int kMovingVersion = 5;
/// "Palp", the database's `application_id`.
inline constexpr std::int32_t kRecordingApplicationId = 0x50616c70;

/// Returns the version of Palpate, such as "0.1.0".
[[nodiscard]] PALPATE_EXPORT std::string palpateVersion();
/// Returns the commit and compiler of this build; "unknown" without version control.
[[nodiscard]] PALPATE_EXPORT std::string buildId();
/// Returns true if a build id identifies the source uniquely: a known commit without uncommitted changes.
[[nodiscard]] PALPATE_EXPORT bool isExactBuild(std::string_view id);

/// Origin of a structure's surface. A HapticScene does not store this information.
struct StructureSource
{
    std::string mesh;     ///< path of the file; the writer stores it relative to the folder of the recording
    std::string part;     ///< structure inside the file; empty: the whole file
    double unit_mm = 1.0; ///< length of one file unit [mm]
    core::FileFrame frame =
        core::FileFrame::Untagged; ///< coordinate frame chosen for the file; Untagged: the file's tag, else LPS
    bool flipped = false;
    /// geometryHash of the repaired mesh in the world frame; if empty, computed from `embed` when recorded
    std::string sha256;
    core::Transform X_WM = core::Transform::Identity(); ///< pose
    /// Surface to embed in the recording; null stores only the name and the hash.
    std::shared_ptr<const geometry::RepairedMesh> embed;
};

/// One structure of a recorded scene.
struct StructureRecord
{
    std::string name;
    StructureSource source;
    haptics::Tissue tissue;
    std::uint32_t layer = 0;
    bool palpable = true;           ///< false: the structure had no haptic surface
    std::string lawTable;           ///< binary table of a nonlinear force law; empty: linear
    std::string maps;               ///< surface maps and motion as JSON with the hashes of their data; empty: neither
    haptics::TissueMaps tissueMaps; ///< map data; also empty if the recording has lost the data
    /// Motion of the surface; null: it rests, or the recording has lost the motion, which `maps` still names.
    std::shared_ptr<const geometry::SurfaceMotion> motion{};
};

/// Haptic scene of a recording. Ticks refer to the structures by index.
struct SceneRecord
{
    std::uint32_t generation = 0; ///< see servo::ServoLoop::setScene
    std::vector<StructureRecord> structures;
    double fingertip_mm = 0.0; ///< radius of the fingertip ball [mm]; 0: point contact
};

/// Describes a haptic scene for a recording.
/// @param sources  one entry per structure of `scene`, in the same order; missing entries are left empty
[[nodiscard]] PALPATE_EXPORT SceneRecord describeScene(std::uint32_t generation, const haptics::HapticScene& scene,
                                                       std::span<const StructureSource> sources);

/// Event at a tick. Event kinds by origin:
/// - writer: "scene" (first tick of a generation), "tissue", "hidden", "shown", "layer", "motion" and "structures"
///   (changes with that scene), "clutch" (hand released or returned)
/// - recorder: "dropped", "disk", "timing" (servo timing), "ended" (reason of an early end)
/// - window: "note", "finding", "finding-edited", "finding-undone", "device-lost", "fault"
/// - recovery: "recovered"
struct RecordingEvent
{
    std::int64_t tick = 0;
    std::string kind;
    std::string json = "{}"; ///< object with the data of this kind
};

/// Metadata of a recording.
struct RecordingInfo
{
    int version = kRecordingVersion;
    /// Schema version whose rules apply to the ticks; less than `version` in a recovered copy of an older recording.
    int tickVersion = kRecordingVersion;
    std::string palpate = palpateVersion();
    std::string build = buildId();
    std::string startedUtc; ///< ISO 8601; set by the writer
    /// Path of the opened scene or mesh; empty if none. The writer stores it relative to the folder of the recording.
    std::string scene;
    std::string sceneBeside; ///< of older recordings with absolute paths: the same, if in that folder or below
    std::string sceneSha256; ///< hash of the scene file at the start of the recording, 64 hex digits; empty: unknown
    std::string looks;       ///< appearance of the structures in the first scene, JSON; empty: unknown
    double rate_Hz = 1000.0;
    double dt_s = 1e-3; ///< integration period of the solver [s]
    device::DeviceInfo device;
    std::int64_t firstTick = 0;        ///< tick that follows `start`
    std::uint32_t firstGeneration = 0; ///< scene generation at `start`
    haptics::PalpatorState start;
};

} // namespace palpate::session
