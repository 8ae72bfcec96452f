// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/meshio/SceneMotion.h"

#include <palpate/core/Export.h>
#include <palpate/core/FileFrame.h>
#include <palpate/core/Finding.h>
#include <palpate/core/Status.h>
#include <palpate/core/Tape.h>
#include <palpate/core/Tissue.h>
#include <palpate/core/TissueMapping.h>
#include <palpate/core/Types.h>
#include <palpate/core/ViewPose.h>
#include <palpate/geometry/VoxelVolume.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::meshio {

/// Surface model of a structure.
enum class SurfaceKind : std::uint8_t
{
    Facets,         ///< the triangles of the mesh as they are
    Smooth,         ///< curved facets: see geometry::pnTriangles
    Smoothed,       ///< the mesh after a low-pass filter against voxel steps: see shapeSurface
    SmoothedSmooth, ///< curved facets of the filtered mesh
};
inline constexpr std::array<std::string_view, 4> kSurfaceNames{"facets", "smooth", "smoothed", "smoothed and smooth"};
[[nodiscard]] constexpr bool isSmoothed(SurfaceKind kind) noexcept
{
    return kind == SurfaceKind::Smoothed || kind == SurfaceKind::SmoothedSmooth;
}
[[nodiscard]] constexpr bool isCurved(SurfaceKind kind) noexcept
{
    return kind == SurfaceKind::Smooth || kind == SurfaceKind::SmoothedSmooth;
}
[[nodiscard]] constexpr SurfaceKind surfaceKind(bool isSmoothed, bool isCurved) noexcept
{
    return isSmoothed ? (isCurved ? SurfaceKind::SmoothedSmooth : SurfaceKind::Smoothed)
                      : (isCurved ? SurfaceKind::Smooth : SurfaceKind::Facets);
}
/// Facets that meet at a larger angle have a sharp edge, if curved [degree].
inline constexpr double kDefaultCrease_deg = 40.0;
/// 3D Slicer's own default, 0.5, leaves more ripple on voxels that are three times as high as wide.
inline constexpr double kDefaultSmoothing = 0.7;
inline constexpr double kLabelSmoothing = 0.5; ///< of the surfaces of label maps, as in 3D Slicer

/// Description of a structure in a scene file.
struct SceneStructure
{
    std::filesystem::path mesh; ///< in memory absolute, in the file relative to the scene file
    std::string sha256;         ///< of the mesh file when the scene was saved, 64 hex digits; empty: unknown
    std::string part;           ///< name of the structure inside the mesh file; empty: the whole file
    double unit_mm = 1.0;       ///< size of one unit of the mesh file [mm]
    core::FileFrame frame =
        core::FileFrame::Untagged; ///< chosen for the mesh file; Untagged: by the tag of the file, otherwise LPS
    std::string name;
    std::array<double, 3> colour{0.85, 0.6, 0.5}; ///< red, green, blue in 0 … 1
    double opacity = 1.0;                         ///< 0 … 1
    bool visible = true;
    bool palpable = true;
    /// Target of an exercise that has not ended: felt whatever `visible` is, but neither drawn nor named. Follows from
    /// SceneFile::exercise on reading and is not written.
    bool isHiddenTarget = false;
    bool flipped = false;       ///< turn the surface inside out on import
    bool outwards = false;      ///< turn inverted closed parts on import, after `flipped` and after closing holes
    double closeHoles_mm = 0.0; ///< close holes up to this size on import (geometry::withHolesClosed); 0: none [mm]
    SurfaceKind surface = SurfaceKind::Facets;
    double smoothing = kDefaultSmoothing;   ///< strength of the low-pass filter, 0 (nearly none) … 1
    double crease_deg = kDefaultCrease_deg; ///< crease angle of curved facets, 0 … 180 [degree]
    core::Tissue tissue;
    std::uint32_t layer = 0;           ///< 0 is the outermost
    std::string inside;                ///< organ that contains this lump; empty: unspecified, and then `layer` is 0
    std::optional<double> young_ratio; ///< Young's modulus of a lump relative to the organ; > 0
    std::optional<double> young_kPa;   ///< Young's modulus [kPa], of a lump and of the organ around
    std::optional<double> felt_contact_radius_mm; ///< contact radius of the palpating finger on an organ [mm]
    /// How arrays or volumes vary the tissue over the surface; empty: by arrays with known names
    /// (core::kKnownMaps).
    std::optional<std::vector<core::TissueMapping>> maps{};
    std::optional<SceneMotion> motion{}; ///< how the structure moves; empty: it rests
    std::optional<ScenePulse> pulse{};
    core::Transform X_WM = core::Transform::Identity(); ///< pose: mesh (mm) to world
    std::string extra;                                  ///< unknown fields of this structure, as a JSON object
};

/// Camera of the scene.
struct SceneCamera : core::ViewPose
{
    std::string extra{}; ///< unknown fields, as a JSON object
};

/// Values that colour a structure.
struct ShownMap
{
    std::string structure; ///< name of the structure
    std::string numbers;   ///< "felt:stiffness", "felt:damping", "felt:friction", or "array:" and an array's name
    friend bool operator==(const ShownMap&, const ShownMap&) = default;
};

/// Direction of a section. The first three are planes of the patient, in the world frame LPS.
enum class SectionDirection : std::uint8_t
{
    Axial,    ///< from head to feet: normal along z
    Coronal,  ///< from front to back: normal along y
    Sagittal, ///< from side to side: normal along x
    Free      ///< any normal
};
inline constexpr std::array<std::string_view, 4> kSectionNames{"axial", "coronal", "sagittal", "free"};

/// Plane through which the picture of the scene is cut. The hand feels both sides.
struct SceneSection
{
    SectionDirection direction = SectionDirection::Axial;
    core::Vec3 p_W = core::Vec3::Zero();  ///< a point of the plane [mm]
    core::Vec3 n_W = core::Vec3::UnitZ(); ///< unit normal, towards the hidden side
    std::string extra{};                  ///< unknown fields, as a JSON object
    friend bool operator==(const SceneSection&, const SceneSection&) = default;
};

/// Haptic model of structures inside an organ.
enum class BuriedTouch : std::uint8_t
{
    Layers, ///< contact with the lump's own surface once the HIP has reached that depth
    Felt,   ///< transmitted through the organ's surface as increased stiffness; no contact with the lump's own surface
};
inline constexpr std::array<std::string_view, 2> kBuriedNames{"layers", "felt"};

/// Search exercise: structures of the scene that can be felt, but are neither shown nor named until the end.
struct Exercise
{
    std::vector<std::string> targets;      ///< names of palpable structures, at least one
    std::optional<double> time_s;          ///< time limit, > 0 [s]; empty: none
    std::optional<double> force_ceiling_N; ///< force that should not be exceeded, > 0 [N]; empty: none
    std::optional<double> coverage_goal;   ///< share of the searched surface, above 0 to 1; empty: none
    std::string extra{};                   ///< unknown fields, as a JSON object
    friend bool operator==(const Exercise&, const Exercise&) = default;
};

/// A scene file (`*.palpate.json`): structures, camera, section, findings, tapes. Versioned by the field `version`;
/// unknown fields are preserved.
struct SceneFile
{
    static constexpr int kVersion = 1;
    std::vector<SceneStructure> structures;
    std::optional<SceneCamera> camera;
    std::optional<ShownMap> shownMap; ///< empty: each structure shows a uniform colour
    std::filesystem::path image; ///< volume shown in sections; in memory absolute, in the file relative; empty: none
    std::optional<geometry::GreyWindow> imageWindow; ///< range of the image's numbers; empty: chosen from the image
    std::optional<SceneSection> section;             ///< empty: the picture is not cut
    std::vector<core::Finding> findings;
    std::vector<core::Tape> tapes;
    BuriedTouch buried = BuriedTouch::Layers;
    std::optional<Exercise> exercise; ///< empty: all structures are shown
    std::string sha256;               ///< of the file's bytes at reading, 64 hex digits; empty: no file. Not written
    std::string extra;                ///< top-level fields that this version does not know, as a JSON object
};

/// @return surface of a mesh file without a choice: smoothed for label maps (by the extension), otherwise facets
[[nodiscard]] PALPATE_EXPORT SurfaceKind defaultSurface(const std::filesystem::path& mesh);
/// @return strength of SurfaceKind::Smoothed for a mesh file without a choice
[[nodiscard]] PALPATE_EXPORT double defaultSmoothing(const std::filesystem::path& mesh);

/// @return true for a path with the extension of a scene file (".json").
[[nodiscard]] PALPATE_EXPORT bool isSceneFile(const std::filesystem::path& path);

/// Reads and checks a scene file without the meshes. An error names the invalid field by its path in the document:
/// "liver.palpate.json: structures[2].opacity: found 3, expected 0 to 1".
[[nodiscard]] PALPATE_EXPORT core::Result<SceneFile> readScene(const std::filesystem::path& path);

/// @return the unknown fields of a scene file by their paths in the document: "structures[2].stifness_N_per_mm". They
/// are preserved on writing, but not used.
[[nodiscard]] PALPATE_EXPORT std::vector<std::string> unknownFields(const SceneFile& scene);

/// @return SHA-256 of a file's bytes as 64 hex digits; empty when it cannot be read.
[[nodiscard]] PALPATE_EXPORT std::string fileHash(const std::filesystem::path& path);

/// Writes the scene atomically, mesh paths relative to it.
[[nodiscard]] PALPATE_EXPORT core::Status writeScene(const std::filesystem::path& path, const SceneFile& scene);

} // namespace palpate::meshio
