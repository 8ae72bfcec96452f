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
#include <span>
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
    Field,  ///< displacement fields of a registration
};
inline constexpr std::array<std::string_view, 4> kMotionNames{"breath", "frames", "poses", "field"};

/// What a displacement field maps. A registration writes the field that resamples the moving image: it maps positions
/// of the fixed image to positions of the moving image.
enum class FieldDirection : std::uint8_t
{
    RestToMoved, ///< the rest shape was segmented in the fixed image
    MovedToRest, ///< the rest shape was segmented in the moving image
};
inline constexpr std::array<std::string_view, 2> kFieldDirections{"rest_to_moved", "moved_to_rest"};

/// Description of a motion in a scene file.
struct SceneMotion
{
    MotionKind kind = MotionKind::Breath;
    double period_s = 4.0;                                  ///< of a breath or of all frames
    std::array<double, 3> amplitude_mm{};                   ///< of a breath
    int exponent = 4;                                       ///< of a breath and of a single field
    std::optional<std::array<double, 3>> still_mm, full_mm; ///< of a breath, both or neither: ends of the ramp
    double lattice_mm = 10.0;                               ///< cells of the lattice fitted to frames and fields
    /// Frames, or one file of poses, or fields: a single one is played as a breath, several are the steps after the
    /// rest shape. In memory absolute.
    std::vector<std::filesystem::path> files;
    FieldDirection direction = FieldDirection::RestToMoved; ///< of fields
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
    /// Vertices of all surfaces that share the motion, in the world [mm].
    std::vector<std::span<const core::Vec3>> surfaces{};
};

/// Makes the motion of a structure. Reads the files of frames, poses and fields.
/// @param motion,pulse  null: none
/// @return null without either; errors name the file, or cell and frame
/// @par Cost seconds for frames and fields. Any thread.
[[nodiscard]] PALPATE_EXPORT geometry::SurfaceMotion::Made
makeMotion(const SceneMotion* motion, const ScenePulse* pulse, const MotionSubject& subject);

/// Reads rigid poses from a CSV file with the columns time_s, x, y and z [mm], and optionally the quaternion qw, qx, qy
/// and qz. A pose takes the rest shape to the world.
[[nodiscard]] PALPATE_EXPORT core::Result<std::vector<geometry::PoseKey>> readPoses(const std::filesystem::path& path);

} // namespace palpate::meshio
