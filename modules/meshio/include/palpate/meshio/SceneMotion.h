// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/FileFrame.h>
#include <palpate/core/Status.h>
#include <palpate/core/Types.h>
#include <palpate/geometry/SurfaceMotion.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::meshio {

/// Origin of a structure's motion.
enum class MotionKind : std::uint8_t
{
    Breath, ///< a formula, see geometry::Breath
    Frames, ///< mesh files with the vertices of the structure's mesh, at equal steps of a period
    Poses,  ///< a CSV file of rigid poses
};
inline constexpr std::array<std::string_view, 3> kMotionNames{"breath", "frames", "poses"};

/// Description of a motion in a scene file.
struct SceneMotion
{
    MotionKind kind = MotionKind::Breath;
    double period_s = 4.0;                                  ///< of a breath or of all frames
    std::array<double, 3> amplitude_mm{};                   ///< of a breath
    int exponent = 4;                                       ///< of a breath
    std::optional<std::array<double, 3>> still_mm, full_mm; ///< of a breath, both or neither: ends of the ramp
    double lattice_mm = 10.0;                               ///< cells of the lattice fitted to frames
    std::vector<std::filesystem::path> files;               ///< frames, or one file of poses; in memory absolute
    bool repeats = false;                                   ///< the poses repeat

    friend bool operator==(const SceneMotion&, const SceneMotion&) = default;
};

/// Periodic factor on the stored energy, 1 + share · sin²(π t / period): an artery under the finger.
struct ScenePulse
{
    double period_s = 0.8;
    double share = 0.1;

    friend bool operator==(const ScenePulse&, const ScenePulse&) = default;
};

/// What a motion needs to know of its structure.
struct MotionSubject
{
    core::Box bounds; ///< of all surfaces that share the motion, in the world [mm]
    std::filesystem::path mesh;
    std::string part;
    double unit_mm = 1.0;
    core::FileFrame frame = core::FileFrame::Untagged;
    core::Transform X_WM = core::Transform::Identity();
};

/// Makes the motion of a structure. Reads the files of frames and poses.
/// @param motion,pulse  null: none
/// @return null without either; errors name the file, or cell and frame
/// @par Cost seconds for frames. Any thread.
[[nodiscard]] PALPATE_EXPORT geometry::SurfaceMotion::Made
makeMotion(const SceneMotion* motion, const ScenePulse* pulse, const MotionSubject& subject);

/// Reads rigid poses from a CSV file with the columns time_s, x, y and z [mm], and optionally the quaternion qw, qx, qy
/// and qz. A pose takes the rest shape to the world.
[[nodiscard]] PALPATE_EXPORT core::Result<std::vector<geometry::PoseKey>> readPoses(const std::filesystem::path& path);

} // namespace palpate::meshio
