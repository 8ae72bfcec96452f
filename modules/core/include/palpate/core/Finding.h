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

/// One of several layers that were felt in one place.
struct FeltLayer
{
    std::string structure{}; ///< its name
    double force_N = 0.0;    ///< its share
    double depth_mm = 0.0;   ///< to which it was pressed in

    friend bool operator==(const FeltLayer&, const FeltLayer&) = default;
};

/// What a person takes a finding for.
enum class FindingType : std::uint8_t
{
    Lump,
    HardArea,
    SoftArea,
    Landmark,
    KeepAway,
    Other
};
/// As files say them, in the order of the type.
inline constexpr std::array<std::string_view, 6> kFindingTypeNames{"lump",     "hard area", "soft area",
                                                                   "landmark", "keep away", "other"};
[[nodiscard]] constexpr std::string_view nameOf(FindingType type) noexcept
{
    return kFindingTypeNames[static_cast<std::size_t>(type)];
}
/// @return nothing for a name that is none.
[[nodiscard]] constexpr std::optional<FindingType> findingType(std::string_view name) noexcept
{
    for (std::size_t i = 0; i < kFindingTypeNames.size(); ++i) {
        if (kFindingTypeNames[i] == name) {
            return static_cast<FindingType>(i);
        }
    }
    return std::nullopt;
}
/// The colour of each type, red, green, blue in 0 … 1, told apart by any eye: Okabe and Ito, "Color Universal Design",
/// 2008. Each type has a shape of its own as well.
inline constexpr std::array<std::array<double, 3>, 6> kFindingColours{{{0.902, 0.624, 0.000},
                                                                       {0.835, 0.369, 0.000},
                                                                       {0.337, 0.706, 0.914},
                                                                       {0.000, 0.620, 0.451},
                                                                       {0.800, 0.475, 0.655},
                                                                       {0.941, 0.894, 0.259}}};

/// The moment of a recording in which something was marked.
struct RecordedMoment
{
    std::string file{};    ///< path of the recording, in memory absolute
    std::string sha256{};  ///< of the file when it was whole, 64 hex digits; empty: not known
    std::int64_t tick = 0; ///< of the recording
    double time_s = 0.0;   ///< since its first tick

    friend bool operator==(const RecordedMoment&, const RecordedMoment&) = default;
};

/// A place on tissue that a person marked, or a note without a place; scene files and recordings hold the same.
struct Finding
{
    std::string name{};
    Vec3 p_W = Vec3::Zero();          ///< god-object when it was marked [mm]; says nothing without `hasPlace`
    std::string note{};               ///< what a person wrote about it
    std::string structure{};          ///< name of the one that was touched there, may be empty
    std::optional<double> force_N{};  ///< with which it was touched
    std::optional<double> depth_mm{}; ///< to which
    std::vector<FeltLayer> layers{};  ///< the outermost first, where more than one was felt
    std::string extra{};              ///< fields of a scene file that this version does not know, as a JSON object
    std::string id{};                 ///< stays the same when all else is edited; empty in older files
    FindingType type = FindingType::Other;
    bool hasPlace = true;             ///< false: a note
    std::optional<double> size_mm{};  ///< across, as a person judges it
    std::optional<ViewPose> camera{}; ///< the view when it was marked
    std::optional<RecordedMoment> recording{};
    std::string marked_utc{}; ///< "2026-11-23T00:24:54Z"; empty in older files

    friend bool operator==(const Finding&, const Finding&) = default;
};

/// The least depth at which force over depth says something. [mm]
inline constexpr double kLeastFeltDepth_mm = 1.0;
/// Force over depth when it was marked. [N/mm] @return nothing where one is not known, or less deep than 1 mm
[[nodiscard]] inline std::optional<double> felt_N_per_mm(const Finding& finding) noexcept
{
    if (!finding.force_N || !finding.depth_mm || *finding.depth_mm < kLeastFeltDepth_mm) {
        return std::nullopt;
    }
    return *finding.force_N / *finding.depth_mm;
}

} // namespace palpate::core
