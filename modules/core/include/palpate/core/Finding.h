// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Types.h"
#include "palpate/core/ViewPose.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::core {

/// Contribution of one layer where several overlapping layers were in contact.
struct FindingLayer
{
    std::string structure{}; ///< name of the structure
    double force_N = 0.0;    ///< share of the contact force
    double depth_mm = 0.0;   ///< penetration depth

    friend bool operator==(const FindingLayer&, const FindingLayer&) = default;
};

/// Category of a finding, chosen by the user.
enum class FindingType : std::uint8_t
{
    Lump,
    HardArea,
    SoftArea,
    Landmark,
    KeepAway,
    Other
};
/// Names in files, in the order of FindingType.
inline constexpr std::array<std::string_view, 6> kFindingTypeNames{"lump",     "hard area", "soft area",
                                                                   "landmark", "keep away", "other"};
[[nodiscard]] constexpr std::string_view nameOf(FindingType type) noexcept
{
    return kFindingTypeNames[static_cast<std::size_t>(type)];
}
/// @return std::nullopt for an unknown name.
[[nodiscard]] constexpr std::optional<FindingType> findingType(std::string_view name) noexcept
{
    for (std::size_t i = 0; i < kFindingTypeNames.size(); ++i) {
        if (kFindingTypeNames[i] == name) {
            return static_cast<FindingType>(i);
        }
    }
    return std::nullopt;
}
/// Colour of each type as red, green, blue (0 to 1), distinguishable with colour vision deficiency: Okabe and Ito,
/// "Color Universal Design", 2008. Each type also has a distinct marker shape.
inline constexpr std::array<std::array<double, 3>, 6> kFindingColours{{{0.902, 0.624, 0.000},
                                                                       {0.835, 0.369, 0.000},
                                                                       {0.337, 0.706, 0.914},
                                                                       {0.000, 0.620, 0.451},
                                                                       {0.800, 0.475, 0.655},
                                                                       {0.941, 0.894, 0.259}}};

/// Time in a recording at which a finding was marked.
struct RecordedMoment
{
    std::string file{};    ///< path of the recording; absolute in memory
    std::string sha256{};  ///< hash of the complete file, 64 hex digits; empty: unknown
    std::int64_t tick = 0; ///< tick number in the recording
    double time_s = 0.0;   ///< time since the first tick of the recording

    friend bool operator==(const RecordedMoment&, const RecordedMoment&) = default;
};

/// Marked place on tissue, or a note without a place. Used in scene files and recordings.
struct Finding
{
    std::string name{};
    Vec3 p_W = Vec3::Zero();          ///< marked god-object, at rest if tissue moves [mm]; unused without `hasPlace`
    std::string note{};               ///< free text of the user
    std::string structure{};          ///< name of the touched structure; may be empty
    std::optional<double> force_N{};  ///< contact force
    std::optional<double> depth_mm{}; ///< penetration depth
    std::vector<FindingLayer>
        layers{};        ///< contributions of overlapping layers, outermost first; empty for a single layer
    std::string extra{}; ///< unknown fields of a scene file as a JSON object, preserved for newer versions
    std::string id{};    ///< persistent identifier, unchanged by edits; empty in older files
    FindingType type = FindingType::Other;
    bool hasPlace = true;             ///< false: note only
    std::optional<double> size_mm{};  ///< diameter estimated by the user
    std::optional<ViewPose> camera{}; ///< camera at the time of marking
    std::optional<RecordedMoment> recording{};
    std::string marked_utc{}; ///< UTC time, "2026-11-23T00:24:54Z"; empty in older files

    friend bool operator==(const Finding&, const Finding&) = default;
};

/// Minimum depth for a meaningful quotient of force and depth. [mm]
inline constexpr double kMinStiffnessDepth_mm = 1.0;
/// Computes the secant stiffness (force divided by depth) at the time of marking. [N/mm]
/// @return std::nullopt if force or depth is unknown, or if the depth is below 1 mm
[[nodiscard]] inline std::optional<double> felt_N_per_mm(const Finding& finding) noexcept
{
    if (!finding.force_N || !finding.depth_mm || *finding.depth_mm < kMinStiffnessDepth_mm) {
        return std::nullopt;
    }
    return *finding.force_N / *finding.depth_mm;
}

} // namespace palpate::core
