// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>
#include <palpate/core/Tape.h>
#include <palpate/geometry/SurfaceDistance.h>
#include <palpate/geometry/SurfaceMargin.h>
#include <palpate/meshio/LoadScene.h>

#include <QJsonObject>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace palpate::study {

/// Reason for a missing or incomplete volume.
enum class VolumeGap : std::uint8_t
{
    None,
    Open,      ///< no part is closed
    InsideOut, ///< a closed part is inside out
    Partial    ///< some parts are closed, others are not
};

/// Size of a structure.
struct StructureSize
{
    std::string name;
    std::optional<double> volume_mm3; ///< of the closed parts; empty with the reason in `note`
    core::Message note;               ///< why there is no volume, or which parts it leaves out; empty otherwise
    double area_mm2 = 0.0;
    core::Vec3 extent_mm = core::Vec3::Zero(); ///< along the axes of the world frame (LPS)
    VolumeGap gap = VolumeGap::None;           ///< kind of `note`

    /// Diameter of the ball with the same volume; empty without a volume. [mm]
    [[nodiscard]] PALPATE_EXPORT std::optional<double> ballDiameter_mm() const;
};

/// Least distance of two structures, by their numbers in the table.
struct PairDistance
{
    std::size_t first = 0, second = 0;
    geometry::SurfaceDistance found;
};

/// Margin of a lump to another structure, by their numbers in the table.
struct LumpMargin
{
    std::size_t lump = 0, structure = 0;
    geometry::SurfaceMargin found;
};

/// Sizes, least distances and margins of the structures of a scene.
struct DistanceTable
{
    std::vector<double> limits_mm;    ///< borders of the bands of the margins
    std::vector<StructureSize> sizes; ///< one for each structure of the scene, in its order
    std::vector<PairDistance> pairs;
    std::vector<LumpMargin> margins;
    std::vector<core::Tape> tapes; ///< of the scene file
};

/// Usual borders of the bands: margins below 5 mm, from 5 to 10 mm, and above. [mm]
inline constexpr double kMarginLimits_mm[] = {5.0, 10.0};

/// Returns the size of a structure. @param report  mesh report of its surface
[[nodiscard]] PALPATE_EXPORT StructureSize sizeOf(std::string name, const geometry::MeshReport& report);

using SharedIndices = std::vector<std::shared_ptr<const geometry::SurfaceIndex>>;

/// Returns one index for each structure of a scene, null for a structure without triangles.
/// @param indices  existing indices by structure; missing ones are built
[[nodiscard]] PALPATE_EXPORT SharedIndices completeIndices(
    const meshio::LoadedScene& scene, std::span<const std::shared_ptr<const geometry::SurfaceIndex>> indices);

/// Returns the numbers of the lumps of a scene, as measureDistances finds them. @param indices  of completeIndices
[[nodiscard]] PALPATE_EXPORT std::vector<std::size_t> lumpsOf(const meshio::LoadedScene& scene,
                                                              const SharedIndices& indices);

/// Measures the structures of a scene. A scene with lumps gets the distance and the margin of each lump to each other
/// structure; a scene without lumps the distance of each two structures. A lump is a structure with the name of one,
/// with a stiffness ratio, or that is felt through an organ by LumpRule. Hidden structures take part.
/// @param indices  one for each structure of the scene; null: built here
/// @param limits_mm  borders of the bands, above 0 and ascending [mm]
/// @param from  structures to be measured as if they were the lumps; empty: the lumps
/// @param progress  receives the share done (0 to 1) on the calling thread; false ends with an incomplete table
/// @par Cost A few milliseconds for each pair, resources/docs/distances.md. Uses all cores; not for the servo thread.
[[nodiscard]] PALPATE_EXPORT DistanceTable measureDistances(
    const meshio::LoadedScene& scene, std::span<const std::shared_ptr<const geometry::SurfaceIndex>> indices,
    std::span<const double> limits_mm = kMarginLimits_mm, std::span<const std::size_t> from = {},
    const std::function<bool(double share)>& progress = {});

/// Returns the size in words: "volume 4.19 ml (a ball of 20 mm), area 12.6 cm², extent 20 × 20 × 20 mm".
[[nodiscard]] PALPATE_EXPORT core::Message sizeText(const StructureSize& size);
/// Returns one sentence for the user: "tumour: volume 4.19 ml (ball of 20 mm), area 12.6 cm², extent 20 × 20 × 20 mm".
[[nodiscard]] PALPATE_EXPORT core::Message sentence(const StructureSize& size);
[[nodiscard]] PALPATE_EXPORT core::Message sentence(const DistanceTable& table, const PairDistance& pair);
/// Returns the length of a tape: "Tape 1: 12.5 mm, from liver at (1, 2, 3) to tumour at (4, 5, 6)".
[[nodiscard]] PALPATE_EXPORT core::Message sentence(const core::Tape& tape);
/// Returns the names of the bands: "< 5 mm", "5 to 10 mm", "> 10 mm".
[[nodiscard]] PALPATE_EXPORT std::vector<core::Message> bandNames(std::span<const double> limits_mm);
/// Returns the shares of a margin, one clause for each band: "< 5 mm: 12.5 %".
[[nodiscard]] PALPATE_EXPORT std::vector<core::Message> clauses(const DistanceTable& table, const LumpMargin& margin);

/// Returns the name of a relation in JSON: apart, crossing, inside, around.
[[nodiscard]] PALPATE_EXPORT const char* relationName(geometry::Relation relation) noexcept;
/// Converts the table to JSON. Fields: resources/docs/distances.md.
[[nodiscard]] PALPATE_EXPORT QJsonObject toJson(const DistanceTable& table);

} // namespace palpate::study
