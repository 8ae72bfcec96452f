// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/FileFrame.h>
#include <palpate/core/Finding.h>
#include <palpate/core/Status.h>
#include <palpate/core/Tissue.h>
#include <palpate/core/TissueMapping.h>
#include <palpate/core/Types.h>
#include <palpate/core/ViewPose.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::meshio {

/// What a structure's surface is made of.
enum class SurfaceKind : std::uint8_t
{
    Facets,   ///< the triangles of the mesh as they are
    Smooth,   ///< curved facets: reserved, drawn and felt as facets for now
    Smoothed, ///< the mesh after a low-pass filter against the steps of voxels: see shapeSurface
};
inline constexpr std::array<std::string_view, 3> kSurfaceNames{"facets", "smooth", "smoothed"};
/// 3D Slicer's own default, 0.5, leaves more ripple on voxels that are three times as high as wide.
inline constexpr double kUsualSmoothing = 0.7;

/// A structure as a scene file describes it.
struct SceneStructure
{
    std::filesystem::path mesh; ///< in memory absolute, in the file relative to the scene file
    std::string sha256;         ///< of the mesh file when the scene was saved, 64 hex digits; empty: not said
    std::string part;           ///< name of the structure inside the mesh file; empty: all of the file
    double unit_mm = 1.0;       ///< what one unit of the mesh file is [mm]
    core::FileFrame frame =
        core::FileFrame::Untagged; ///< chosen for the mesh file; Untagged: as its tag says, else LPS
    std::string name;
    std::array<double, 3> colour{0.85, 0.6, 0.5}; ///< red, green, blue in 0 … 1
    double opacity = 1.0;                         ///< 0 … 1
    bool visible = true;
    bool palpable = true;
    bool flipped = false;  ///< turn the surface inside out on import
    bool outwards = false; ///< turn closed parts that are inside out on import, after `flipped`
    SurfaceKind surface = SurfaceKind::Facets;
    double smoothing = kUsualSmoothing; ///< strength of SurfaceKind::Smoothed, 0 (nearly none) … 1
    core::Tissue tissue;
    std::uint32_t layer = 0; ///< 0 is the outermost
    std::string inside;      ///< name of the organ that this is a lump in; empty: not said, and then `layer` is 0
    std::optional<double> young_ratio;            ///< of a lump: its modulus by the organ's; > 0
    std::optional<double> young_kPa;              ///< Young's modulus [kPa], of a lump and of its organ
    std::optional<double> felt_contact_radius_mm; ///< of an organ: of the finger that feels lumps in it [mm]
    /// How arrays or volumes vary the tissue over the surface; nothing: by the arrays whose names say it
    /// (core::kKnownMaps).
    std::optional<std::vector<core::TissueMapping>> maps{};
    core::Transform X_WM = core::Transform::Identity(); ///< pose: mesh (mm) to world
    std::string extra; ///< fields of this structure that this version does not know, as a JSON object
};

/// Where the view stands.
struct SceneCamera : core::ViewPose
{
    std::string extra{}; ///< fields that this version does not know, as a JSON object
};

/// Numbers that a structure is coloured by.
struct ShownMap
{
    std::string structure; ///< its name
    std::string numbers;   ///< "felt:stiffness", "felt:damping", "felt:friction", or "array:" and an array's name
    friend bool operator==(const ShownMap&, const ShownMap&) = default;
};

/// How what lies in an organ is felt.
enum class BuriedTouch : std::uint8_t
{
    Layers, ///< by its own surface, once the hand has gone in so far
    Felt,   ///< through the organ's surface, which it makes stiffer; its own is not touched
};
inline constexpr std::array<std::string_view, 2> kBuriedNames{"layers", "felt"};

/// A scene file (`*.palpate.json`): structures, camera, findings. Versioned by its field `version`; unknown fields are
/// kept.
struct SceneFile
{
    static constexpr int kVersion = 1;
    std::vector<SceneStructure> structures;
    std::optional<SceneCamera> camera;
    std::optional<ShownMap> shownMap; ///< nothing: each structure has its own colour
    std::vector<core::Finding> findings;
    BuriedTouch buried = BuriedTouch::Layers;
    std::string sha256; ///< of the file's bytes when it was read, 64 hex digits; empty: of no file. Not written
    std::string extra;  ///< top-level fields that this version does not know, as a JSON object
};

/// @return true for a path that is named as a scene file (".json").
[[nodiscard]] bool isSceneFile(const std::filesystem::path& path);

/// Reads and checks a scene file. The meshes are not read. A wrong field is an error that names it by its path in the
/// document: "liver.palpate.json: structures[2].opacity: found 3, expected 0 to 1".
[[nodiscard]] core::Result<SceneFile> readScene(const std::filesystem::path& path);

/// @return the fields of a scene file that this version does not know, by their paths in the document:
/// "structures[2].stifness_N_per_mm". They are kept and written back, but not used.
[[nodiscard]] std::vector<std::string> unknownFields(const SceneFile& scene);

/// @return SHA-256 of a file's bytes as 64 hex digits; empty when it cannot be read.
[[nodiscard]] std::string fileHash(const std::filesystem::path& path);

/// Writes the scene atomically, mesh paths relative to it.
[[nodiscard]] core::Status writeScene(const std::filesystem::path& path, const SceneFile& scene);

} // namespace palpate::meshio
