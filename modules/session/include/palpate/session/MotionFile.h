// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>
#include <palpate/core/Types.h>

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

namespace palpate::session {

using core::Vec3;

/// Servo period [s], also used for a motion without time stamps.
inline constexpr double kNominalPeriod_s = 1e-3;

/// Path of the HIP with one sample per servo tick.
struct Motion
{
    std::vector<Vec3> p_WH;         ///< HIP positions [mm]; never empty
    double dt_s = kNominalPeriod_s; ///< sample period: mean spacing of the column `time_s` if present
};

/// Reads a CSV file whose header names the columns `x`, `y`, `z` [mm] and optionally `time_s` [s], in any order. Other
/// columns are ignored. Independent of the numeric locale. Accepts a byte order mark, CRLF and trailing blank lines.
/// The file may be a pipe. Limits: 1 MB per line, one day at 1 kHz (86.4 million rows), mean row spacing 1e-5 s to 1 s.
/// @return the motion, or a one-line error such as `m.csv: line 7, column y: found "abc", expected a number`
/// @par Thread Any; no shared state.
[[nodiscard]] PALPATE_EXPORT core::Result<Motion> readMotion(const std::filesystem::path& path);

/// Parses the same format from memory.
/// @param name  file name for error messages
[[nodiscard]] PALPATE_EXPORT core::Result<Motion> parseMotion(std::string_view text, std::string_view name);

} // namespace palpate::session
