// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace palpate::session::internal {

// Limits for the content of a recording. Each limit is far above values written by a recorder, but low enough that no
// sum, product or index in a reader overflows. Listed in resources/docs/recording.md.

inline constexpr std::int64_t kMaxTick = std::int64_t{1} << 53U; ///< tick number, and tick time [ns]
inline constexpr double kMinPeriod_s = 1e-5, kMaxPeriod_s = 1.0;
inline constexpr double kMaxLength_mm = 1e10;    ///< coordinate of a tick; the limit of a motion is 1e9
inline constexpr double kMaxForce_N = 1e30;      ///< force component
inline constexpr double kMaxNormal = 1.0 + 1e-6; ///< component of a unit vector, with rounding
inline constexpr double kMaxCoordinate_mm =
    1e7; ///< coordinate of an embedded surface or a pose; same limit as in mesh files
inline constexpr double kMaxDeviceNumber = 1e9; ///< every number in the device description
inline constexpr std::int64_t kMaxTicksPerCheck = 100'000;

inline constexpr std::size_t kMaxMeta = 1000;
inline constexpr std::size_t kMaxEvents = 1'000'000;
inline constexpr std::size_t kMaxScenes = 1'000'000;
inline constexpr std::size_t kMaxStructures = 4'000'000; ///< over all scenes
inline constexpr std::size_t kMaxChecks = 10'000'000;
inline constexpr std::size_t kMaxSurfaces = 100'000;

} // namespace palpate::session::internal
