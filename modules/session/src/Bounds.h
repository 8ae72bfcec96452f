// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace palpate::session::internal {

// What a recording may hold. Each bound is far beyond what a recorder writes, and near enough that no sum, product or
// index of a reader overflows; resources/docs/recording.md names them.

inline constexpr std::int64_t kMostTick = std::int64_t{1} << 53U; ///< number of a tick, and its time [ns]
inline constexpr double kLeastPeriod_s = 1e-5, kMostPeriod_s = 1.0;
inline constexpr double kMostLength_mm = 1e10;    ///< of a tick's coordinate; a motion's is at most 1e9
inline constexpr double kMostForce_N = 1e30;      ///< of a component
inline constexpr double kMostNormal = 1.0 + 1e-6; ///< of a unit vector, with its rounding
inline constexpr double kMostCoordinate_mm = 1e7; ///< of an embedded surface and of a pose, as of a mesh file
inline constexpr double kMostOfDevice = 1e9;      ///< each number of it
inline constexpr std::int64_t kMostTicksOfCheck = 100'000;

inline constexpr std::size_t kMostMeta = 1000;
inline constexpr std::size_t kMostEvents = 1'000'000;
inline constexpr std::size_t kMostScenes = 1'000'000;
inline constexpr std::size_t kMostStructures = 4'000'000; ///< of all scenes
inline constexpr std::size_t kMostChecks = 10'000'000;
inline constexpr std::size_t kMostSurfaces = 100'000;

} // namespace palpate::session::internal
