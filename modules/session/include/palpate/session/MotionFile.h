// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <palpate/core/Types.h>

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

namespace palpate::session {

using core::Vec3;

/// Period of the servo, and of a motion that says no other. [s]
inline constexpr double kNominalPeriod_s = 1e-3;

/// A path of the HIP, one sample a servo tick.
struct Motion
{
    std::vector<Vec3> p_WH;         ///< [mm]; never empty
    double dt_s = kNominalPeriod_s; ///< time between samples: mean spacing of the column `time_s`, when there is one
};

/// Reads a CSV whose header names the columns `x`, `y`, `z` [mm] and optionally `time_s` [s], in any order; other
/// columns are ignored. The numeric locale does not matter. A byte order mark, CRLF and blank lines at the end are
/// fine. The file may be a pipe. A line holds at most 1 MB and a motion at most a day at 1 kHz (86.4 million rows);
/// rows are 1e-5 s to 1 s apart on average.
/// @return one line such as `m.csv: line 7, column y: found "abc", expected a number`, if anything is wrong
/// @par Thread Any; no shared state.
[[nodiscard]] core::Result<Motion> readMotion(const std::filesystem::path& path);

/// The same from memory. @param name  what messages call the file
[[nodiscard]] core::Result<Motion> parseMotion(std::string_view text, std::string_view name);

} // namespace palpate::session
